"""The command line: arguments in, exit code out."""

from robolayout.cli.guard import main

__all__ = ["main"]
