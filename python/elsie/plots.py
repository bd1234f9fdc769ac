"""Charts in the look of Elsie's own figures, for scripts that need no more."""
from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from elsie import _elsie
from elsie.errors import InputError


def plot(file: Union[str, "os.PathLike[str]"], curves: Mapping[str, ArrayLike], x: Optional[ArrayLike] = None, *, xlabel: str = "",
         ylabel: str = "", title: str = "") -> None:
    """Draws curves into a .png, .svg or .pdf file.

        elsie.plot("curve.svg", {"mean": means, "best": bests}, xlabel="generation", ylabel="reward")

    curves: numbers by the names of the curves, as many in each. x: what they are drawn over; None: 1, 2, ... NaN interrupts a curve.
    """
    rows = {name: np.asarray(values, np.float64) for name, values in curves.items()}
    if not rows:
        raise InputError("plot: there is no curve")
    across = np.arange(1.0, 1.0 + next(iter(rows.values())).size) if x is None else np.asarray(x, np.float64)
    for name, values in rows.items():
        if values.ndim != 1 or values.shape != across.shape:
            raise InputError(f"plot: the curve {name!r} has the shape {values.shape}; expected {(across.size,)}")
    _elsie.save_chart(os.fspath(file), list(across), [(name, list(values)) for name, values in rows.items()],
                      [xlabel, ylabel, title])
