"""What the solver needs to know of the judge: an order on layouts and who is to blame.

The solver never measures its own success: the pipeline hands it a judge that is built on the exact verifier.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from robolayout.scene import Layout


@dataclass(frozen=True)
class Verdict:
    """What an exact check says of a layout.

    Attributes:
        hard: Violations of hard demands (collisions, boundary, support, doors), counted in assets.
        access: What the agents cannot get to or use, in assets, plus the share of free space that is cut off.
        soft: Weight of unmet statements.
        culprits: Assets to move, the most pressing first.
    """

    hard: float
    access: float
    soft: float
    culprits: tuple[str, ...] = ()

    @property
    def merit(self) -> float:
        """Smaller is better: a hard violation outweighs everything, an asset out of reach two statements."""
        return 100.0 * self.hard + 2.0 * self.access + self.soft

    @property
    def ok(self) -> bool:
        """Whether nothing is left to do."""
        return self.merit == 0.0


Judge = Callable[[Layout], Verdict]
