"""Charts of a script's own numbers."""
import numpy as np
import pytest

import elsie


@pytest.mark.parametrize("suffix, begins", [("svg", b"<svg"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
def test_curves_are_drawn_with_their_names(tmp_path, suffix, begins):
    file = tmp_path / f"curve.{suffix}"
    elsie.plot(file, {"mean": [1.0, 2.0, np.nan, 2.5], "best": np.arange(4)}, xlabel="generation", ylabel="reward", title="a run")
    drawn = file.read_bytes()
    assert drawn.lstrip().startswith((begins, b"<?xml"))
    if suffix == "svg":
        assert all(word in drawn.decode() for word in ("mean", "best", "generation", "reward", "a run"))


@pytest.mark.parametrize("curves, x", [({}, None), ({"a": [1, 2], "b": [1]}, None), ({"a": [1, 2]}, [1]), ({"a": [[1, 2]]}, None)])
def test_curves_that_do_not_fit_are_refused(tmp_path, curves, x):
    with pytest.raises(elsie.InputError, match="plot: "):
        elsie.plot(tmp_path / "curve.svg", curves, x)


def test_another_suffix_is_refused(tmp_path):
    with pytest.raises(elsie.InputError):
        elsie.plot(tmp_path / "curve.gif", {"a": [1, 2]})
    assert not (tmp_path / "curve.gif").exists()
