"""Arrays of a run: views that each step fills again, and that outlive it."""
import gc

import numpy as np
import pytest

import elsie

SWARM = """<world format="1" name="swarm">
  <arena length="120" width="120"/>
  <physics engine="planar"/>
  <robots>{}</robots>
</world>"""


def test_poses_have_a_row_for_each_robot(run):
    assert run.poses.shape == (2, 3) and run.poses.dtype == np.float64
    assert run.poses[1] == pytest.approx([-1, -1, np.pi / 2])
    assert run.energies.shape == run.distances.shape == run.collisions.shape == (2,)
    assert run.motions.shape == run.commands.shape == run.beliefs.shape == (2, 3)
    assert run.collisions.dtype == np.int64


def test_a_view_is_the_same_memory_after_each_step(run):
    poses = run.poses
    before = poses.copy()
    run.step(50)
    assert not np.array_equal(poses, before)
    assert np.shares_memory(poses, run.poses)
    assert np.shares_memory(run.readings("left"), run.readings("left"))


def test_ten_thousand_poses_are_not_copied():
    robots = "".join(f'<robot id="r{i}" x="{i % 100 - 50}" y="{i // 100 - 50}"/>' for i in range(10_000))
    run = elsie.Simulation(elsie.World.parse(SWARM.format(robots)))
    poses = run.poses
    assert poses.shape == (10_000, 3)
    for _ in range(3):
        run.step()
        assert np.shares_memory(poses, run.poses)
    assert poses[9_999, 0] == pytest.approx(49, abs=0.1)


def test_views_cannot_be_written_to_and_outlive_their_simulation(world):
    run = elsie.Simulation(world)
    run.step(10)
    poses, readings = run.poses, run.readings("range")
    last = poses.copy()
    with pytest.raises(ValueError):
        poses[0, 0] = 1
    with pytest.raises(ValueError):
        poses.flags.writeable = True
        poses[0, 0] = 1
    del run
    gc.collect()
    assert np.array_equal(poses, last)
    assert readings["distance_m"].shape == (2,)


def test_readings_by_id_plugin_and_kind(run):
    run.step(2)
    one = run.readings("left")
    assert one.shape == (1,) and list(one.dtype.names) == ["robot", "sensor", "distance_m", "hit"]
    assert one["sensor"][0] == "left" and run.robots[one["robot"][0]] == "r1"
    assert one["distance_m"][0] > 0 and one["hit"].dtype == bool
    assert run.readings("beam_range").shape == run.readings("range").shape == (2,)
    with pytest.raises(elsie.InputError, match="left"):
        run.readings("lift")


def test_readings_with_arrays_have_a_second_axis(world):
    world.add("robot[r2]/sensors", '<lidar id="lidar"/>')
    run = elsie.Simulation(world)
    run.step(2)
    ranges = run.readings("lidar")["ranges"]
    assert ranges.ndim == 2 and ranges.shape[0] == 1 and np.isfinite(ranges).all()


def test_obstacles_have_poses_until_they_are_collected(world):
    world.add("resources", '<resource id="food" x="0.5" y="1.5"/>')
    run = elsie.Simulation(world)
    obstacles = run.obstacles
    assert run.obstacle_ids == ["block", "food"]
    assert obstacles[0] == pytest.approx([1, 0.5, 0])
    del run["resource[food]"]
    assert run.obstacles.shape == (1, 3) and obstacles.shape == (2, 3)


def test_a_field_is_a_grid(world):
    world.add("fields", '<field id="ink" cell="0.5" start="2"/>')
    run = elsie.Simulation(world)
    ink = run.field("ink")
    assert ink.shape == (8, 8) and (ink == 2).all()
    run.step(10)
    assert np.shares_memory(ink, run.field("ink"))
    with pytest.raises(elsie.InputError, match="ink"):
        run.field("inc")


def test_published_numbers_by_name():
    run = elsie.Simulation("worlds/flock.xml", time_limit=2)
    run.step(10)
    order = run.published("order")
    assert list(order.dtype.names) == ["robot", "plugin", "value"]
    assert len(order) == len(run.robots)
    with pytest.raises(elsie.InputError, match="order"):
        run.published("odrer")


def test_after_an_edit_of_the_robots_arrays_are_taken_again(run):
    old, readings = run.poses, run.readings("range")
    run.add("robots", '<robot id="r3" x="-1" y="1"><sensors><beam_range/></sensors></robot>')
    run.step(10)
    assert old.shape == (2, 3) and run.poses.shape == (3, 3)
    assert readings.shape == (2,) and run.readings("range").shape == (3,)


def test_an_edit_in_place_keeps_the_memory(run):
    poses, readings = run.poses, run.readings("range")
    run["robot[r1]/@max_speed"] = 0.2
    run.step()
    assert np.shares_memory(poses, run.poses) and np.shares_memory(readings, run.readings("range"))


def test_an_image_of_a_camera():
    run = elsie.Simulation("worlds/find_resource.xml", time_limit=1)
    run.step(2)
    image = run.image("vision")
    assert image.ndim == 3 and image.shape[2] == 3 and image.dtype == np.uint8
    with pytest.raises(elsie.InputError, match="no sensor"):
        run.image("lens")
