"""The constraint program as data: the safe reader of program text, and the self-consistency filter."""

from robolayout.program._program import Guess, Limits, Program, Statement
from robolayout.program._reader import read_program

__all__ = ["Guess", "Limits", "Program", "Statement", "read_program"]
