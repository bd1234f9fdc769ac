"""Many runs as frames."""
import json
import subprocess

import pytest

import elsie
from worlds import ARENA

EXPERIMENT = """<experiment format="1" name="speeds">
  <worlds><world file="arena.xml"/></worlds>
  <vary name="speed" path="robot[r1]/@max_speed" values="0.1; 0.3"/>
  <seeds from="1" to="2"/>
</experiment>
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "arena.xml").write_text(ARENA)
    (tmp_path / "speeds.xml").write_text(EXPERIMENT)
    return tmp_path


def test_a_row_for_each_run_in_the_order_of_edits_and_seeds(world):
    frame = elsie.run(world, seeds=range(3), edits={"robot[r1]/@max_speed": [0.1, 0.3]}, workers=2, time_limit=1)
    assert list(frame.seed) == [0, 1, 2] * 2
    assert list(frame["robot[r1]/@max_speed"]) == [0.1] * 3 + [0.3] * 3
    assert set(frame.outcome) == {"time_limit"} and frame.success.dtype == bool
    assert frame.path_length_m[3:].mean() > frame.path_length_m[:3].mean()


def test_the_number_of_workers_changes_nothing(world):
    one, two = (elsie.run(world, range(4), workers=workers, time_limit=2) for workers in (1, 2))
    assert one.equals(two)
    assert list(one.state_hash) == [elsie.Simulation(world, seed, time_limit=2).run().state_hash for seed in range(4)]


def test_a_run_that_fails_ends_the_study(world):
    with pytest.raises(elsie.WorldError):
        elsie.run(world, range(3), edits={"robot[r1]/@max_speed": "fast"})
    with pytest.raises(elsie.InputError, match="workers"):
        elsie.run(world, workers=0)


def test_a_batch_and_its_results(folder):
    results = elsie.batch(folder / "speeds.xml", folder / "speeds.sqlite", workers=2)
    assert len(results.runs) == 4 and len(results.cells) == 2
    assert set(results.runs["speed"]) == {0.1, 0.3}
    assert results.runs.groupby("speed").path_length_m.mean()[0.3] > 0
    assert "speeds" in results.report()
    assert list(results.table("factors")["name"]) == ["world", "speed"]
    with pytest.raises(elsie.InputError, match="run_events"):
        results.table("run_event")
    assert "<table" in results._repr_html_()


def test_a_run_of_a_database_is_replayed(folder):
    results = elsie.batch(folder / "speeds.xml", folder / "speeds.sqlite")
    run = results.replay(3)
    assert run["robot[r1]/@max_speed"] == 0.3 and run.seed == 1
    if elsie.same_bits():
        assert run.run().state_hash == results.table("runs").set_index("id").state_hash[3]
    with pytest.raises(elsie.InputError, match="no run 99"):
        results.replay(99)


def test_the_errors_of_the_program_are_exceptions(folder):
    with pytest.raises(elsie.InputError):
        elsie.Results(folder / "arena.xml")
    (folder / "wrong.xml").write_text(EXPERIMENT.replace("@max_speed", "@maxspeed"))
    with pytest.raises(elsie.InputError) as caught:
        elsie.batch(folder / "wrong.xml", folder / "wrong.sqlite")
    assert caught.value.problems and caught.value.problems[0].line > 0
    elsie.batch(folder / "speeds.xml", folder / "speeds.sqlite")
    with pytest.raises(elsie.InputError, match="resume"):
        elsie.batch(folder / "speeds.xml", folder / "speeds.sqlite")
    assert len(elsie.batch(folder / "speeds.xml", folder / "speeds.sqlite", resume=True).runs) == 4
