"""The command line: arguments in, exit code out."""

from __future__ import annotations

import sys


def main() -> None:
    """Run the command line and leave with its exit code; an interrupt counts from the first import on."""
    try:
        from robolayout.cli.guard import main as guarded_main
    except KeyboardInterrupt:
        sys.stderr.write("robolayout: interrupted; nothing was left half-written.\n")
        raise SystemExit(130) from None
    guarded_main()
