"""The command line: arguments in, exit code out."""

from robolayout.cli.app import main

__all__ = ["main"]
