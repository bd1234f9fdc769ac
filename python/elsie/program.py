"""The program `elsie`, for installations by pip."""
from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path
from typing import NoReturn

from elsie.errors import InputError


def path() -> str:
    """The file of the program: the one that belongs to this module, else the first of the search path."""
    here = Path(__file__).resolve().parent
    for root in (here / "_root", here.parents[2], here.parents[3]):
        if (root / "bin" / "elsie").exists():
            return str(root / "bin" / "elsie")
    found = shutil.which("elsie")
    if found is None:
        raise InputError("the program elsie is not installed; Debian's package elsie has it, or `make program`")
    return found


def main() -> NoReturn:
    """Becomes the program, with the words of the command line."""
    os.environ.setdefault("ELSIE_PYTHON", sys.executable)
    program = path()
    os.execv(program, [program, *sys.argv[1:]])
