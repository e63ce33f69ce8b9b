"""The command ``virote``, which the wheel brings along."""

from __future__ import annotations

import signal
import sys

from . import _virote


def main() -> int:
    """Runs the command with the arguments of the process."""
    # The command has a handler of its own.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _virote.command(["virote", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
