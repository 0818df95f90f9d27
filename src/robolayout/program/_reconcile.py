"""The self-consistency filter: keeps what can be true together, mends what is impossible, and says why.

It works on statements alone. First come statements about what stands on what (they decide heights, and who can be in
whose way), then all others, then distances; within each of these, the first one in the program wins.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from typing import Literal

from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.program._program import Program, Statement
from robolayout.program._rules import RULES, Accepted
from robolayout.scene import Scene

Verdict = Literal["accepted", "updated", "rejected"]


@dataclass(frozen=True)
class Decision:
    """What the filter made of one statement."""

    statement: Statement  # the statement as asked
    verdict: Verdict  # "accepted", "updated" or "rejected"
    reason: str  # why, in words
    replacement: Statement | None = None  # the statement that is solved instead, for an update

    @property
    def kept(self) -> Statement | None:
        """The statement to solve, None if it was rejected."""
        return None if self.verdict == "rejected" else self.replacement or self.statement

    @property
    def sentence(self) -> str:
        """What became of it and why, with its line."""
        statement = self.statement
        return f"line {statement.line}: {statement.source or statement.relation.sentence()}: {self.reason}."

    def to_dict(self) -> dict[str, object]:
        """Return one row of `constraints.json`."""
        asked = self.statement
        row: dict[str, object] = {"number": asked.number, "line": asked.line, "source": asked.source}
        row |= {"asked": asked.relation.sentence(), "verdict": self.verdict, "reason": self.reason}
        return row | {"replacement": self.replacement.relation.sentence() if self.replacement else None}


@dataclass(frozen=True)
class Reconciled:
    """A program after the filter."""

    program: Program  # the program with the statements to solve
    decisions: tuple[Decision, ...]  # one decision for every statement asked, in the program's order

    @property
    def rejections(self) -> tuple[str, ...]:
        """One sentence for every statement that was rejected, for the planner."""
        return tuple(decision.sentence for decision in self.decisions if decision.verdict == "rejected")

    def to_dict(self) -> dict[str, object]:
        """Return the content of `constraints.json`."""
        counts = Counter(decision.verdict for decision in self.decisions)
        return {
            "counts": {verdict: counts[verdict] for verdict in ("accepted", "updated", "rejected")},
            "expressions": dict(self.program.expressions),
            "statements": [decision.to_dict() for decision in self.decisions],
        }


def reconcile(program: Program, scene: Scene, *, paper: bool = False) -> Reconciled:
    """Return the program without statements that contradict the room or earlier statements.

    With `paper`, things are put at the wall nearest to their first guess, as the paper does.
    """
    so_far = Accepted(scene, program, paper)
    decisions: dict[int, Decision] = {}
    early = [isinstance(s.relation, OnTopOf) - isinstance(s.relation, DistanceConstraint) for s in program.statements]
    for i in sorted(range(len(early)), key=lambda i: -early[i]):
        decisions[i] = _decide(so_far, program.statements[i])
    ordered = tuple(decisions[i] for i in range(len(program.statements)))
    kept = tuple(statement for decision in ordered if (statement := decision.kept) is not None)
    return Reconciled(replace(program, statements=kept), ordered)


def _decide(so_far: Accepted, statement: Statement) -> Decision:
    """Ask all rules about one statement, and about what a rule puts in its place, until no rule has anything against it."""
    now, reasons = statement, list[str]()
    while answer := next((answer for rule in RULES if (answer := rule(so_far, now.relation))), None):
        if isinstance(answer, str):
            return Decision(statement, "rejected", "; ".join([*reasons, answer]))
        now = replace(now, relation=answer.relation)
        reasons.append(answer.reason)
    so_far.add(now)
    if now is statement:
        return Decision(statement, "accepted", "as asked")
    return Decision(statement, "updated", "; ".join(reasons), now)
