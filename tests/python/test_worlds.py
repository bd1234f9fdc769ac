"""elsie.World: reading, editing by paths, saving, and mistakes with their lines."""
import numpy as np
import pytest

import elsie
from worlds import ARENA


def test_a_shipped_world_is_found_by_its_name():
    world = elsie.World("worlds/open_arena.xml")
    assert world.name == "open arena"
    assert world.robots == ["r1"]
    assert world.check() == []


def test_all_mistakes_of_a_file_are_in_one_exception_each_with_its_line():
    text = ARENA.replace('max_speed="0.3"', 'max_speed="fast"').replace('<wander priority="1"/>', "<wonder/>")
    with pytest.raises(elsie.WorldError) as caught:
        elsie.World.parse(text, file="mine.xml")
    problems = caught.value.problems
    assert [(each.file, each.line) for each in problems] == [("mine.xml", 10), ("mine.xml", 16)]
    assert "wander" in problems[1].sentence
    assert str(problems[0]).startswith("mine.xml:10: ")
    assert caught.value.exit_code == 2
    assert isinstance(caught.value, (elsie.InputError, elsie.Error, ValueError))


def test_a_missing_file_is_an_error_with_the_nearest_name():
    with pytest.raises(elsie.WorldError, match="worlds/maze.xml"):
        elsie.World("worlds/mase.xml")


def test_attributes_are_read_with_their_types_and_defaults(world):
    assert world["robot[r1]/@max_speed"] == 0.3
    assert world["robot[r2]/@max_speed"] == 0.5
    assert world["robot[r1]/behavior[wander]/@priority"] == 1.0
    assert isinstance(world["robot[r1]/behavior[wander]/@speed"], float)
    assert world["robot[r1]/@id"] == "r1"
    assert world["robot[r2]/coordinator/@weighted"] is False
    assert world["robot[*]/@max_speed"] == [0.3, 0.5]


def test_an_edit_changes_the_text_only_where_it_must(world):
    world["robot[r1]/@max_speed"] = 0.25
    assert str(world) == ARENA.replace('max_speed="0.3"', 'max_speed="0.25"')


@pytest.mark.parametrize("value, text", [(0.25, "0.25"), (np.float32(0.5), "0.5"), (np.int64(1), "1"), (1, "1"), ("0.125", "0.125")])
def test_values_may_be_numbers_of_python_and_numpy_and_texts(world, value, text):
    world["robot[r1]/@max_speed"] = value
    assert f'max_speed="{text}"' in str(world)


def test_elements_are_replaced_added_and_removed(world):
    world["robot[r1]/coordinator"] = '<fusion_vector_summation weighted="true"/>'
    world.add("robots", '<robot id="r3" x="1" y="-1"/>')
    world.add("robot[r1]/sensors", '<beam_range id="back" yaw_deg="180"/>')
    del world["obstacle[block]"]
    assert world.robots == ["r1", "r2", "r3"]
    assert world["robot[r1]/coordinator/@weighted"] is True
    assert 'id="back"' in str(world) and "static_box" not in str(world)
    assert "<!-- A comment that edits keep. -->" in str(world)


def test_a_removed_attribute_has_its_default(world):
    del world["robot[r1]/@max_speed"]
    assert world["robot[r1]/@max_speed"] == 0.5


def test_edits_that_depend_on_each_other_are_made_together_or_not_at_all(world):
    with pytest.raises(elsie.WorldError):
        world.edit({"robot[r1]/@x": 0.7, "robot[r1]/@y": "north"})
    assert str(world) == ARENA
    world.edit({"robot[r1]/@x": -1, "robot[r1]/@y": 1})
    assert world["robot[r1]/@x"] == -1


def test_a_refused_edit_says_why_and_changes_nothing(world):
    with pytest.raises(elsie.WorldError, match="at most") as caught:
        world["robot[r1]/@max_speed"] = 1e6
    assert "--set robot[r1]/@max_speed" in caught.value.problems[0].file
    assert str(world) == ARENA


def test_a_path_that_leads_nowhere_lists_what_there_is(world):
    with pytest.raises(elsie.InputError, match="r1"):
        world["robot[r7]/@max_speed"]
    with pytest.raises(elsie.InputError, match="max_speed"):
        world["robot[r1]/@maxspeed"]


def test_values_of_other_types_are_refused(world):
    for nonsense in (None, [0.3], {"a": 1}, object(), np.zeros(3)):
        with pytest.raises(TypeError):
            world["robot[r1]/@max_speed"] = nonsense


def test_a_saved_world_is_the_text_and_reads_again(world, tmp_path):
    world["robot[r1]/@max_speed"] = 0.2
    world.save(tmp_path / "slow.xml")
    assert (tmp_path / "slow.xml").read_text() == str(world)
    assert elsie.World(tmp_path / "slow.xml")["robot[r1]/@max_speed"] == 0.2


def test_a_saved_world_finds_its_template_from_another_folder(tmp_path):
    elsie.World("worlds/open_arena.xml").save(tmp_path / "copy.xml")
    assert elsie.World(tmp_path / "copy.xml").robots == ["r1"]


def test_a_world_that_cannot_be_saved_is_an_error(world, tmp_path):
    with pytest.raises(elsie.Error):
        world.save(tmp_path / "nowhere" / "x.xml")


def test_a_copy_is_edited_apart(world):
    other = world.copy()
    other["robot[r1]/@max_speed"] = 0.1
    assert world["robot[r1]/@max_speed"] == 0.3
    assert type(other) is elsie.World


def test_check_says_what_is_doubtful(world):
    world.edit({"physics/@engine": "ode", "physics/@cfm": 0})
    (problem,) = world.check()
    assert problem.file == "world.xml" and "cfm is 0" in problem.sentence


def test_check_doubts_goals_that_cannot_be_meant(world):
    world.add("goals", '<travel distance="1e6"/>')
    assert [problem.line for problem in world.check()] == [str(world).splitlines().index('    <travel distance="1e6"/>') + 1]


def test_pictures_of_a_world(world, tmp_path):
    assert world._repr_svg_().startswith("<svg") or "<svg" in world._repr_svg_()[:200]
    world.picture(tmp_path / "world.png")
    assert (tmp_path / "world.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(ValueError, match="suffix"):
        world.picture(tmp_path / "world.jpeg")


def test_plugins_that_do_not_exist_are_named(tmp_path):
    with pytest.raises(elsie.InputError, match="nowhere.so"):
        elsie.World("worlds/open_arena.xml", plugins=["nowhere.so"])
    (tmp_path / "text.txt").write_text("no plugin")
    with pytest.raises(elsie.InputError, match="text.txt"):
        elsie.World("worlds/open_arena.xml", plugins=[tmp_path / "text.txt"])
