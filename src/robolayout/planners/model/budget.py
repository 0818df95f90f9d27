"""The money that a model may cost: what a question will most likely cost is set aside before it is asked.

An answer that was paid for is always used, so a job overspends by at most what its last answer costs above its estimate.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from decimal import Decimal

from robolayout._errors import BudgetError
from robolayout.planners.model.exchange import Question

CHARACTERS_PER_TOKEN = 4  # characters of English or program text that make one token, where nobody counts them

TOKENS_PER_PICTURE = 1_100
"""Tokens of one of our pictures (768 pixels a side) at the providers that count them in tiles."""

FIRST_ANSWER = 1_200  # tokens that an answer is expected to have before one has come: a program for a dozen things

Price = Callable[[int, int], Decimal | None]
"""Dollars for so many tokens sent and received; None where no price is known."""


def tokens_of(question: Question) -> int:
    """Return about how many tokens a question has."""
    words = sum(map(len, (question.instructions, *question.texts)))
    return words // CHARACTERS_PER_TOKEN + TOKENS_PER_PICTURE * len(question.images)


@dataclass
class Budget:
    """What may be spent, what is spent, and what is set aside for questions that are being answered."""

    most: Decimal | None  # US dollars; None is without limit
    price: Price  # what tokens cost
    spent: Decimal = Decimal(0)  # US dollars so far
    reserved: Decimal = Decimal(0)  # US dollars set aside
    _received: list[int] = field(default_factory=list[int])
    _dearest: Decimal = Decimal(0)

    def estimate(self, question: Question) -> Decimal:
        """Return what a question will most likely cost: by the price list, or as the dearest answer so far."""
        expected = sum(self._received) // len(self._received) if self._received else FIRST_ANSWER
        priced = self.price(tokens_of(question), expected)
        return self._dearest if priced is None else priced

    def reserve(self, question: Question, name: str) -> Decimal:
        """Set aside what a question will most likely cost, and return it; raises `BudgetError` if it does not fit."""
        cost = self.estimate(question)
        if self.most is not None and self.spent + self.reserved + cost > self.most:
            raise BudgetError(
                f"stopped at the budget: {name} has cost ${self.spent:.4f}, the next answer would most likely cost ${cost:.4f}, "
                f"--max-cost allows ${self.most:.4f}. Raise it to go on."
            )
        self.reserved += cost
        return cost

    def settle(self, reserved: Decimal, cost: Decimal | None, received: int) -> None:
        """Give back what was set aside for a question and count what its answer cost; nothing if it never came."""
        self.reserved -= reserved
        if received:
            self._received.append(received)
        if cost is not None:
            self.spent += cost
            self._dearest = max(self._dearest, cost)
