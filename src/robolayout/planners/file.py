"""The planner that reads its program from a file."""

from __future__ import annotations

from pathlib import Path

from robolayout._errors import ProgramError
from robolayout._reading import Checker
from robolayout.planners._types import Group, PlanRequest
from robolayout.scene import Scene

MAX_BYTES = 2_000_000  # largest program file in bytes that is read
_CHECK = Checker(ProgramError)


class FilePlanner:
    """Answers every request with the text of one file.

    Args:
        path: A program, as `solver.<relation>(...)` statements.
    """

    def __init__(self, path: str | Path) -> None:
        self.path = Path(path)

    def group(self, scene: Scene) -> tuple[Group, ...]:
        """Return all assets as one group."""
        return (Group("program", f"All assets, as {self.path.name} says.", tuple(a.name for a in scene.assets)),)

    def plan(self, request: PlanRequest) -> str:
        """Return the file's text."""
        return _CHECK.read_text(self.path, "the program", MAX_BYTES)
