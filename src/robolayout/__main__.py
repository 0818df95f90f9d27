"""`python -m robolayout` is the command line."""

from robolayout.cli import main

if __name__ == "__main__":
    main()
