"""The planner that reads its program from a file."""

from __future__ import annotations

from pathlib import Path

from robolayout._errors import ProgramError
from robolayout.planners._types import Group, PlanRequest
from robolayout.scene import Scene

MAX_BYTES = 2_000_000
"""Largest program file in bytes that is read."""


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
        try:
            with self.path.open("rb") as stream:
                data = stream.read(MAX_BYTES + 1)
        except OSError as error:
            raise ProgramError(
                f"cannot read the program {self.path}: {error.strerror}. Give a readable file."
            ) from None
        if len(data) > MAX_BYTES:
            raise ProgramError(f"the program {self.path} is larger than {MAX_BYTES // 1_000_000} MB, the most allowed.")
        try:
            return data.decode("utf-8")
        except UnicodeDecodeError:
            raise ProgramError(f"the program {self.path} is not UTF-8 text. Save it as UTF-8.") from None
