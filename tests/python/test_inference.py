"""elsie.Fuzzy and elsie.Network."""
import numpy as np
import pytest

import elsie

FCL = """FUNCTION_BLOCK brake
VAR_INPUT range : REAL; END_VAR
VAR_OUTPUT speed : REAL; END_VAR
FUZZIFY range
  TERM near := (0, 1) (1, 0);
  TERM far := (0, 0) (1, 1);
END_FUZZIFY
DEFUZZIFY speed
  TERM slow := 0;
  TERM fast := 10;
  METHOD : COGS;
END_DEFUZZIFY
RULEBLOCK all
  RULE 1 : IF range IS near THEN speed IS slow;
  RULE 2 : IF range IS far THEN speed IS fast;
END_RULEBLOCK
END_FUNCTION_BLOCK
"""


def test_a_model_answers_numbers_and_arrays():
    model = elsie.Fuzzy.parse(FCL)
    assert [each.name for each in model.inputs] == ["range"] and len(model.rules) == 2
    assert model(range=0.25) == {"speed": pytest.approx(2.5)}
    assert model(range=[[0, 0.5], [1, 2]])["speed"] == pytest.approx(np.array([[0, 5], [10, 10]]))
    assert model.evaluate([[0.1], [0.2]]) == pytest.approx(np.array([[1], [2]]))
    assert model.degrees([0.25]) == pytest.approx([0.75, 0.25])


def test_a_model_names_what_is_wrong_with_its_inputs():
    model = elsie.Fuzzy.parse(FCL)
    with pytest.raises(elsie.InputError, match="range missing; there is no distance"):
        model(distance=1)
    with pytest.raises(elsie.InputError, match="rows of 1"):
        model.evaluate([[1, 2]])
    with pytest.raises(ValueError):
        model(range=float("nan"))


def test_all_mistakes_of_a_model_have_their_lines():
    with pytest.raises(elsie.ModelError) as caught:
        elsie.Fuzzy.parse(FCL.replace("IS near", "IS nera").replace("IS fast", "IS fats"), file="brake.fcl")
    assert [each.line for each in caught.value.problems] == [14, 15]


XOR = np.array([[0, 0], [0, 1], [1, 0], [1, 1]])


def test_a_network_learns_and_repeats():
    network = elsie.Network([2, 4, 1], seed=3)
    training = network.train(XOR, [[0], [1], [1], [0]], threshold=1e-3)
    assert training.ending == "threshold" and training.curve[-1, 1] < 1e-3
    assert np.round(network.evaluate(XOR)).ravel().tolist() == [0, 1, 1, 0]
    again = elsie.Network([2, 4, 1], seed=3)
    again.train(XOR, [[0], [1], [1], [0]], threshold=1e-3)
    assert all(np.array_equal(a, b) for a, b in zip(network.weights, again.weights))


def test_weights_are_saved_with_every_bit(tmp_path):
    network = elsie.Network([2, 3, 1])
    network.save(tmp_path / "net.weights")
    read = elsie.Network.load(tmp_path / "net.weights")
    assert read.sizes == (2, 3, 1)
    assert all(np.array_equal(a, b) for a, b in zip(network.weights, read.weights))
    with pytest.raises(elsie.ModelError):
        elsie.Network.load(tmp_path / "none.weights")


def test_weights_can_be_set():
    network = elsie.Network([1, 1])
    network.weights = [[[0, 0]]]
    assert network.evaluate([5]) == pytest.approx([0.5])
    for wrong in ([], [[[0]]], [[[0, 0], [0, 0]]], [[[0, float("nan")]]]):
        with pytest.raises(elsie.InputError):
            network.weights = wrong


def test_misuse_of_a_network_is_an_error():
    network = elsie.Network([2, 1])
    for inputs, targets in (([[1, 2]], [[1, 2]]), ([[1]], [[1]]), ([[1, 2]], [[2]]), ([], []), ([[1, 2]], [[0], [1]])):
        with pytest.raises((elsie.Error, ValueError)):
            network.train(inputs, targets)
    for sizes in ([], [2], [0, 1], [2, -1]):
        with pytest.raises(ValueError):
            elsie.Network(sizes)
    with pytest.raises(elsie.InputError):
        network.evaluate(3)
    with pytest.raises(elsie.InputError):
        network.evaluate([float("inf"), 0])
