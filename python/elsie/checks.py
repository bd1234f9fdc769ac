"""Checks of numbers that users give."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np

from elsie.errors import InputError

GREATEST_SEED = 2**64 - 1


def is_number(value: object) -> bool:
    return isinstance(value, (int, float, np.number)) and not isinstance(value, bool)


def whole(name: str, value: Any, least: int, most: Optional[int] = None) -> int:
    """The value of an argument with this name, if it is a whole number of Python or numpy in this range."""
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool) and least <= value and (most is None or value <= most):
        return int(value)
    limits = f"of at least {least}" if most is None else f"from {least} to {most}"
    raise InputError(f"{name}: expected a whole number {limits}, not {value!r}")
