import signal
import warnings

import pytest

import elsie
from worlds import ARENA


signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell has it ignored by what runs in the background


@pytest.fixture(autouse=True)
def no_note_of_bits():
    """One warning in each process, about its arithmetic, is no news here."""
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="This process was not started with the settings")
        yield


@pytest.fixture
def world():
    return elsie.World.parse(ARENA)


@pytest.fixture
def run(world):
    return elsie.Simulation(world)
