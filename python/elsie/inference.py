"""Fuzzy models and neural networks, without a simulation."""
from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from elsie import _elsie
from elsie.checks import GREATEST_SEED, whole
from elsie.errors import InputError
from elsie.worlds import File

Numbers = Union[float, Sequence[Any], npt.NDArray[Any]]


class Variable(NamedTuple):
    """An input or output of a fuzzy model."""

    name: str
    lowest: float
    highest: float
    """The range of the file, or that of the terms."""


class Fuzzy(_elsie.Fuzzy):
    """A fuzzy model from a file in Fuzzy Control Language (FCL).

        model = elsie.Fuzzy("fuzzy_models/turn_left_left.fcl")
        model(range=0.3, azimuth=[10, 20, 30])

    All mistakes of a file are in one `elsie.ModelError`, each with its line.
    """

    def __init__(self, file: File, block: str = "") -> None:
        """Reads a file. block: the name of its function block, if it has several."""
        _elsie.Fuzzy.__init__(self, None, os.fspath(file), block)

    @classmethod
    def parse(cls, text: str, block: str = "", *, file: str = "model.fcl") -> Fuzzy:
        """The model of a text; `file`: its name in messages."""
        model = cls.__new__(cls)
        _elsie.Fuzzy.__init__(model, text, file, block)
        return model

    @property
    def inputs(self) -> list[Variable]:
        """In the order of the file."""
        return [Variable(*each) for each in self._all_inputs()]

    @property
    def outputs(self) -> list[Variable]:
        """In the order of the file."""
        return [Variable(*each) for each in self._all_outputs()]

    @property
    def rules(self) -> list[str]:
        """As text, in the order of the file."""
        return self._all_rules()

    def __call__(self, **inputs: Numbers) -> dict[str, Any]:
        """The outputs by name, for inputs by name: numbers, or arrays that numpy can broadcast against each other.

        NaN: no rule decides the output, and it has no default.
        """
        names = [each.name for each in self.inputs]
        lower = {name.lower(): value for name, value in inputs.items()}
        missing = [name for name in names if name.lower() not in lower]
        extra = [name for name in inputs if name.lower() not in [each.lower() for each in names]]
        if missing or extra:
            raise InputError(f"the model {self.name} has the inputs {', '.join(names)}"
                             + (f"; {', '.join(missing)} missing" if missing else "")
                             + (f"; there is no {', '.join(extra)}" if extra else ""))
        columns = np.broadcast_arrays(*[np.asarray(lower[name.lower()], dtype=float) for name in names])
        shape = columns[0].shape
        answers = self._rows(np.stack([column.ravel() for column in columns], axis=1))
        return {output.name: answers[:, i].reshape(shape) if shape else float(answers[0, i])
                for i, output in enumerate(self.outputs)}

    def evaluate(self, inputs: Numbers) -> npt.NDArray[np.float64]:
        """The outputs for an array whose last axis is the inputs, in their order; the last axis of the answer is the outputs."""
        return _by_rows(self._rows, inputs)

    def degrees(self, inputs: Numbers) -> npt.NDArray[np.float64]:
        """How far each rule applies, from 0 to 1, likewise."""
        return _by_rows(self._degrees_of_rows, inputs)

    def __repr__(self) -> str:
        return (f"<elsie.Fuzzy {self.name!r}: {', '.join(each.name for each in self.inputs)} -> "
                f"{', '.join(each.name for each in self.outputs)}, {len(self.rules)} rules>")


@dataclass(frozen=True)
class Training:
    """How a training went."""

    ending: str
    """"threshold": the error fell below it; "presentations": their number was reached."""
    presentations: int
    """Of samples."""
    curve: npt.NDArray[np.float64]
    """A row for each epoch, or for means over several: presentations so far, mean error."""


class Network(_elsie.Network):
    """A feed-forward network of logistic neurons, as coordinators and behaviours use it.

        network = elsie.Network([2, 4, 1], seed=1)
        network.train(inputs, targets)
        network.save("xor.weights")

    The same seed, samples and options give the same weights, bit for bit.
    """

    def __init__(self, sizes: Sequence[int], seed: int = 1, *, method: str = "standard") -> None:
        """First weights, drawn from a seed. sizes: inputs, neurons of each hidden layer, outputs.

        method: "standard", or "original", that of the published experiments (docs/training.md).
        """
        _elsie.Network.__init__(self, list(sizes), whole("seed", seed, 0, GREATEST_SEED), method)

    @classmethod
    def load(cls, file: File) -> Network:
        """Reads a weight file. Raises `elsie.ModelError`."""
        network = cls.__new__(cls)
        _elsie.Network.__init__(network, os.fspath(file))
        return network

    def save(self, file: File) -> None:
        """Writes a weight file, which plugins and `elsie train` read; every bit is kept."""
        self._save_as(os.fspath(file))

    @property
    def weights(self) -> list[npt.NDArray[np.float64]]:
        """A copy of the weights: for each layer an array with a row for each neuron, its inputs' weights, then its bias.

        To change them, set this property.
        """
        return [self._layer(i) for i in range(len(self.sizes) - 1)]

    @weights.setter
    def weights(self, layers: Sequence[Numbers]) -> None:
        if len(layers) != len(self.sizes) - 1:
            raise InputError(f"weights: expected an array for each of {len(self.sizes) - 1} layers, found {len(layers)}")
        for i, layer in enumerate(layers):
            self._set_layer(i, np.asarray(layer, dtype=float))

    def evaluate(self, inputs: Numbers) -> npt.NDArray[np.float64]:
        """The answers, from 0 to 1, to an array whose last axis is the inputs; the last axis of the answer is the outputs."""
        return _by_rows(self._rows, inputs)

    def train(self, inputs: Numbers, targets: Numbers, *, learning_rate: float = 0.8, momentum: float = 0.3,
              threshold: float = 1e-11, presentations: int = 200_000, method: str = "standard") -> Training:
        """Learns from samples, a row for each, by back-propagation with momentum, from its present weights on.

        It ends when the mean error of an epoch is below `threshold`, or after so many presentations. Targets are from 0 to 1.
        """
        presentations = whole("presentations", presentations, 1)
        ending, done, curve = self._train_rows(np.asarray(inputs, dtype=float), np.asarray(targets, dtype=float),
                                              learning_rate, momentum, method, threshold, presentations)
        return Training(ending, done, np.asarray(curve, dtype=float).reshape(-1, 2))

    def __repr__(self) -> str:
        return f"<elsie.Network {'-'.join(map(str, self.sizes))}>"


def _by_rows(answer: Any, inputs: Numbers) -> npt.NDArray[np.float64]:
    array = np.asarray(inputs, dtype=float)
    if array.ndim == 0:
        raise InputError("inputs: expected an array whose last axis is the inputs, not a single number")
    answers: npt.NDArray[np.float64] = answer(array.reshape(-1, array.shape[-1]))
    return answers.reshape(*array.shape[:-1], answers.shape[-1])
