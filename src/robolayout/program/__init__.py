"""The constraint program as data: the safe reader of program text, and the self-consistency filter."""

from robolayout.program._arguments import HEAVIEST
from robolayout.program._program import CUSTOM, Guess, Program, ProgramLimits, Statement
from robolayout.program._reader import read_program, read_salvaged
from robolayout.program._reconcile import Decision, Reconciled, reconcile

__all__ = [
    "CUSTOM",
    "HEAVIEST",
    "Decision",
    "Guess",
    "Program",
    "ProgramLimits",
    "Reconciled",
    "Statement",
    "read_program",
    "read_salvaged",
    "reconcile",
]  # fmt: skip
