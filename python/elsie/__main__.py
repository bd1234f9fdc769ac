"""`python -m elsie`: the program of this installation, also what pip installs as `elsie`."""
from __future__ import annotations

import os
import sys
from typing import NoReturn

from elsie.studies import program


def main() -> NoReturn:
    """Becomes the program, with the words of the command line."""
    os.environ.setdefault("ELSIE_PYTHON", sys.executable)
    file = program()
    os.execv(file, [file, *sys.argv[1:]])


if __name__ == "__main__":
    main()
