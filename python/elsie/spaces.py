"""The spaces of observations and actions: Gymnasium's if it is installed, else these, which have the same attributes."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Generic, Optional, TypeVar

import numpy as np
from numpy.typing import NDArray

T = TypeVar("T")


class _Space(Generic[T]):
    """What all spaces have: a shape, a type, and random numbers for `sample`."""

    def __init__(self, shape: tuple[int, ...], dtype: Any, seed: Optional[int] = None) -> None:
        self._shape = shape
        self.dtype = np.dtype(dtype)
        self._np_random: Optional[np.random.Generator] = None
        if seed is not None:
            self.seed(seed)

    @property
    def shape(self) -> tuple[int, ...]:
        return self._shape

    @property
    def np_random(self) -> np.random.Generator:
        if self._np_random is None:
            self.seed()
        assert self._np_random is not None
        return self._np_random

    def seed(self, seed: Optional[int] = None) -> int:
        """Begins the random numbers of `sample` anew, with this seed or a random one, which is returned."""
        sequence = np.random.SeedSequence(seed)
        self._np_random = np.random.Generator(np.random.PCG64(sequence))
        return int(np.asarray(sequence.entropy).flat[0]) if seed is None else seed

    def contains(self, x: Any) -> bool:
        raise NotImplementedError

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)


class _Box(_Space[NDArray[Any]]):
    """Arrays of numbers, each within its bounds."""

    def __init__(self, low: Any, high: Any, shape: Optional[tuple[int, ...]] = None, dtype: Any = np.float32,
                 seed: Optional[int] = None) -> None:
        if shape is None:
            shape = np.broadcast_shapes(np.shape(low), np.shape(high))
        super().__init__(tuple(shape), dtype, seed)
        self.low: NDArray[Any] = np.full(shape, low, dtype)
        self.high: NDArray[Any] = np.full(shape, high, dtype)

    def is_bounded(self, manner: str = "both") -> bool:
        below, above = bool(np.all(self.low > -np.inf)), bool(np.all(self.high < np.inf))
        return {"both": below and above, "below": below, "above": above}[manner]

    def contains(self, x: Any) -> bool:
        """Whether it is an array of this shape, of a type that fits, within the bounds."""
        return (isinstance(x, np.ndarray) and np.can_cast(x.dtype, self.dtype) and x.shape == self.shape
                and bool(np.all(x >= self.low)) and bool(np.all(x <= self.high)))

    def sample(self, mask: None = None) -> NDArray[Any]:
        return self.np_random.uniform(self.low, self.high, self.shape).astype(self.dtype)

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, _Box) and self.shape == other.shape and self.dtype == other.dtype
                and np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))

    def __repr__(self) -> str:
        return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"


class _Discrete(_Space[np.int64]):
    """The whole numbers from 0 to n - 1."""

    def __init__(self, n: int, seed: Optional[int] = None) -> None:
        super().__init__((), np.int64, seed)
        self.n = np.int64(n)
        self.start = np.int64(0)

    def contains(self, x: Any) -> bool:
        is_whole = isinstance(x, (int, np.integer)) or (isinstance(x, np.ndarray) and x.shape == () and x.dtype.kind in "iu")
        return bool(is_whole and 0 <= int(x) < self.n)

    def sample(self, mask: None = None) -> np.int64:
        return np.int64(self.np_random.integers(self.n))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Discrete) and self.n == other.n

    def __repr__(self) -> str:
        return f"Discrete({self.n})"


class _MultiDiscrete(_Space[NDArray[np.int64]]):
    """Arrays of whole numbers, each from 0 to nvec - 1."""

    def __init__(self, nvec: Any, dtype: Any = np.int64, seed: Optional[int] = None) -> None:
        self.nvec: NDArray[np.int64] = np.array(nvec, dtype=np.int64)
        super().__init__(self.nvec.shape, dtype, seed)
        self.start = np.zeros_like(self.nvec)

    def contains(self, x: Any) -> bool:
        return (isinstance(x, np.ndarray) and x.shape == self.shape and x.dtype.kind in "iu"
                and bool(np.all(x >= 0)) and bool(np.all(x < self.nvec)))

    def sample(self, mask: None = None) -> NDArray[np.int64]:
        return self.np_random.integers(self.nvec).astype(self.dtype)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _MultiDiscrete) and np.array_equal(self.nvec, other.nvec)

    def __repr__(self) -> str:
        return f"MultiDiscrete({self.nvec.tolist()})"


if TYPE_CHECKING:
    Space = _Space
    Box = _Box
    Discrete = _Discrete
    MultiDiscrete = _MultiDiscrete
else:
    try:
        from gymnasium.spaces import Box, Discrete, MultiDiscrete, Space
    except ImportError:
        Space, Box, Discrete, MultiDiscrete = _Space, _Box, _Discrete, _MultiDiscrete
        for _made in (Space, Box, Discrete, MultiDiscrete):
            _made.__name__ = _made.__qualname__ = _made.__name__[1:]

__all__ = ["Box", "Discrete", "MultiDiscrete", "Space"]
