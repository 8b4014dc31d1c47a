"""`python -m grader`; `grader.cli` says what it does."""

import sys

from grader.cli import main

if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
