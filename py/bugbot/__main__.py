"""The command line: `python -m bugbot run program.py --world post-and-shelf`."""

import sys

from bugbot.cli import main

sys.exit(main(sys.argv[1:], in_child=True))
