"""Environments: the rules of Gymnasium's and PettingZoo's checkers, the same bits in any company, and actions as edits."""
import gc
import subprocess
import sys
import threading
import weakref
from pathlib import Path

import numpy as np
import pytest

import elsie
from elsie.spaces import Box, Discrete, MultiDiscrete

ROBOT = """<robot id="{id}" team="red" x="{x}" y="{y}" heading_deg="{heading}" battery="{battery}">
  <sensors>
    <beam_range id="left" yaw_deg="30"/><beam_range id="right" yaw_deg="-30"><noise on="distance_m" gaussian="0.01"/></beam_range>
    <lidar id="scan" rays="5"/>
  </sensors>
  <actuators><gripper/><led id="lamp"/></actuators>
  <behaviors><avoid_obstacle/><wander priority="0.5"/></behaviors>
  <coordinator><fusion_vector_summation weighted="true"/></coordinator>
</robot>"""
PLACES = [(-1.5, -1.5, 40), (1.5, -1.5, 130), (0, 1.5, -80)]


def parsed(robots=1, engine="planar", time=20, battery=5000, extra="", control_steps=1):
    made = "".join(ROBOT.format(id=f"r{i + 1}", x=x, y=y, heading=heading, battery=battery)
                   for i, (x, y, heading) in enumerate(PLACES[:robots]))
    return elsie.World.parse(f"""<world format="1" name="room">
      <arena length="5" width="5"/><physics engine="{engine}" control_steps="{control_steps}"/>
      <obstacles><static_box x="0.3" y="0.2"/><dynamic_box x="-0.8" y="0.5"/></obstacles>
      <robots>{made}</robots><limits time="{time}"/>{extra}</world>""")


REWARD = {"path_length_m": 1.0}


def sampled(env, count, seed=1):
    env.action_space.seed(seed)
    return [env.action_space.sample() for _ in range(count)]


# What Gymnasium's checker asks of Env.

@pytest.mark.parametrize("act", ["motion", "priorities", "choice", "lamp", ["motion", "gripper.closed"]])
def test_observations_are_in_their_space_and_actions_are_symmetric(act):
    env = elsie.Env(parsed(), act=act, observe=["readings", "pose", "motion", "energy", "charging"], reward=REWARD, steps=5)
    observation, info = env.reset(seed=1)
    assert isinstance(info, dict)
    assert np.all(np.isfinite(env.observation_space.low)) and np.all(np.isfinite(env.observation_space.high))
    if act != "choice":
        assert np.all(env.action_space.low == -1) and np.all(env.action_space.high == 1)
    for action in sampled(env, 100):
        assert observation.dtype == env.observation_space.dtype == np.float32
        assert observation.shape == env.observation_space.shape
        assert env.observation_space.contains(observation), observation
        observation, reward, terminated, truncated, info = env.step(action)
        assert type(reward) is float and type(terminated) is bool and type(truncated) is bool and isinstance(info, dict)


def test_the_same_seed_gives_the_same_observations_and_none_goes_on():
    def episodes(env):
        env.reset(seed=5)
        made = []
        for _ in range(2):
            made.append(np.array([env.step(action)[0] for action in sampled(env, 30)]))
            env.reset()
        return made
    first, second = elsie.Env(parsed()), elsie.Env(parsed())
    a, b = episodes(first), episodes(second)
    assert np.array_equal(a[0], b[0]) and np.array_equal(a[1], b[1])
    assert not np.array_equal(a[0], a[1])  # the noise of the next episode is another one
    assert first.seed_now == second.seed_now != 5


def test_a_seed_renews_the_random_numbers_of_python():
    env = elsie.Env(parsed())
    env.reset(seed=3)
    first = env.np_random.random()
    env.reset()
    assert env.np_random.random() != first
    env.reset(seed=3)
    assert env.np_random.random() == first


def test_a_seed_renews_them_for_agents_too():
    env = elsie.ParallelEnv(parsed())
    env.reset(seed=3)
    first = env.np_random.random()
    env.reset(seed=3)
    assert env.np_random.random() == first


def test_an_observation_is_the_users_own():
    env = elsie.Env(parsed(), observe="pose", steps=10)
    before, _ = env.reset(seed=1)
    kept = before.copy()
    after = env.step(np.array([1, 0]))[0]
    assert np.array_equal(before, kept) and not np.array_equal(before, after)


def test_truncated_is_the_limit_of_time_and_terminated_a_goal():
    env = elsie.Env(parsed(time=1), steps=30)
    env.reset(seed=1)
    ends = []
    while not ends or not (ends[-1][2] or ends[-1][3]):
        ends.append(env.step([0, 0]))
    assert ends[-1][2:4] == (False, True) and ends[-1][4]["outcome"] == "time_limit"
    with pytest.raises(elsie.InputError, match="has ended"):
        env.step([0, 0])
    goal = '<goals><travel robot="r1" distance="0.2"/></goals>'
    env = elsie.Env(parsed(extra=goal), steps=30)
    env.reset(seed=1)
    while not (end := env.step([1, 0]))[2]:
        assert not end[3]
    assert end[4]["outcome"] == "success"


def test_an_empty_battery_ends_the_episode_of_its_robot():
    env = elsie.Env(parsed(battery=3), steps=10)
    env.reset(seed=1)
    steps = 1
    while not env.step([1, 1])[2]:
        steps += 1
    assert 5 < steps < 100


def test_duration_replaces_the_limit_of_the_world():
    env = elsie.Env(parsed(), steps=10, duration=0.5)
    env.reset(seed=1)
    steps = 1
    while not env.step([0, 0])[3]:
        steps += 1
    assert steps == 5


def test_pictures_are_rgb():
    env = elsie.Env(parsed(), render_mode="rgb_array")
    env.reset(seed=1)
    picture = env.render()
    assert picture.dtype == np.uint8 and picture.ndim == 3 and picture.shape[2] == 3
    assert "rgb_array" in env.metadata["render_modes"] and env.metadata["render_fps"] == 100
    assert picture.min() < picture.max()
    assert elsie.Env(parsed()).render() is None


def test_close_may_be_called_twice():
    for env in (elsie.Env(parsed()), elsie.VectorEnv(parsed(), 2), elsie.ParallelEnv(parsed())):
        env.reset(seed=1)
        env.close()
        env.close()
        with pytest.raises(elsie.InputError, match="closed"):
            env.reset(seed=1)
        with pytest.raises(elsie.InputError, match="closed"):
            env.step([0, 0])


@pytest.mark.parametrize("duration, steps", [(2.0, 30), (None, 30)])
def test_a_saved_world_ends_when_its_episode_did(tmp_path, duration, steps):
    env = elsie.Env("worlds/maze.xml", observe="range.distance_m", steps=10, duration=duration)
    env.reset(seed=7)
    for _ in range(steps):
        if any(env.step(np.array([1, 0.2], np.float32))[2:4]):
            break
    env.save(tmp_path / "kept.xml")
    kept = elsie.Simulation(tmp_path / "kept.xml", seed=7)
    kept.run()
    assert kept.time == pytest.approx(env.time_s)
    assert kept.state_hash == env.state_hash


def test_a_goal_that_outlasts_a_saved_episode_is_told(tmp_path):
    env = elsie.Env("worlds/clutter.xml", steps=10)
    env.reset(seed=7)
    env.step(env.action_space.sample())
    with pytest.warns(UserWarning, match="--duration 0.1"):
        env.save(tmp_path / "kept.xml")
    again = elsie.Simulation(tmp_path / "kept.xml", seed=7, time_limit=env.time_s)
    again.run()
    assert again.state_hash == env.state_hash


def test_a_world_is_not_written_over_by_its_episode(tmp_path):
    elsie.World("worlds/clutter.xml").save(tmp_path / "own.xml")
    env = elsie.Env(tmp_path / "own.xml")
    env.reset(seed=1)
    with pytest.raises(elsie.InputError, match="would be lost"):
        env.save(tmp_path / "own.xml")


@pytest.mark.parametrize("reward", [float("nan"), None, "much"])
def test_a_reward_is_a_finite_number(reward):
    env = elsie.Env("worlds/clutter.xml", reward=lambda *_: reward)
    env.reset(seed=1)
    with pytest.raises(elsie.InputError, match="The reward function returned"):
        env.step(env.action_space.sample())


def test_a_world_declares_what_is_learned_in_it():
    world = elsie.World("worlds/clutter.xml")
    world["learning/@observe"] = "pose.x:-2:2 range.hit"
    world["learning/@act"] = "priorities"
    world["learning/@steps"] = 5
    env = elsie.Env(world)
    names, = env.observation_names
    assert names[0] == "pose.x" and all(".hit" in name for name in names[1:])
    assert (env.observation_space.low[0], env.observation_space.high[0]) == (-2.0, 2.0)
    assert env.action_names == elsie.Env("worlds/clutter.xml", act="priorities").action_names
    env.reset(seed=1)
    before = env.time_s
    env.step(env.action_space.sample())
    assert env.time_s - before == pytest.approx(5 * world.step_s)
    assert elsie.Env(world, observe="energy").observation_space.shape == (1,)


@pytest.mark.parametrize("text", ["pose.x:1", "pose.x:0:1:2", "pose.x:low:high"])
def test_a_declaration_that_says_nothing_is_refused(text):
    world = elsie.World("worlds/clutter.xml")
    world["learning/@observe"] = text
    with pytest.raises(elsie.InputError, match="NAME:LEAST:GREATEST"):
        elsie.Env(world)


def test_robots_of_a_world_that_learn_are_declared():
    world = elsie.World("worlds/ten_robots.xml")
    world["learning/@robots"] = "r2 r1"
    assert elsie.Env(world).observation_space.shape[0] == 2
    assert elsie.ParallelEnv(world).possible_agents == ["r2", "r1"]
    world["learning/@robots"] = "all"
    assert len(elsie.ParallelEnv(world).possible_agents) == 10


@pytest.mark.parametrize("make", [elsie.Env, lambda world: elsie.VectorEnv(world, 2), elsie.ParallelEnv])
def test_a_closed_environment_has_given_its_worlds_up(make):
    env = make(parsed())
    worlds = weakref.ref(env._setup.worlds)
    env.reset(seed=1)
    env.close()
    gc.collect()
    assert worlds() is None


# What is observed and done.

def test_names_of_observations():
    env = elsie.Env(parsed(), observe=["range.distance_m", "left.hit", "scan.ranges.2", "pose", "energy", ("motion.turn", -2, 2)])
    assert env.observation_names == [["left.distance_m", "right.distance_m", "left.hit", "scan.ranges.2", "pose.x", "pose.y",
                                      "pose.heading", "energy", "motion.turn"]]
    high = env.observation_space.high
    assert high[:3].tolist() == [1, 1, 1] and high[4] == 2.5 and high[7] == 5000 and high[8] == 2
    observation, _ = env.reset(seed=1)
    assert observation[0] == pytest.approx(1.0) and observation[4:6] == pytest.approx([-1.5, -1.5], abs=1e-3)
    assert observation[7] == pytest.approx(5000, abs=1)


def test_published_numbers_of_behaviours_and_measures():
    world = elsie.World("worlds/scattered/bug.xml")
    with pytest.raises(elsie.InputError, match="observe: robot"):
        elsie.Env(world, observe="bug.nonsense", act="priorities")
    env = elsie.Env(parsed(extra='<measures><reward id="gain" of="distance"/></measures>'), observe=["gain.reward", "pose.x"], steps=1)
    env.reset(seed=1)
    observation, reward = env.step([1, 0])[:2]
    assert observation[0] == pytest.approx(reward)


def test_a_motion_is_a_part_of_what_the_robot_can_do():
    env = elsie.Env(parsed(), observe="motion", steps=100)
    assert env.action_ranges[0][1] == pytest.approx([0.5, 0.5 / 0.045])
    env.reset(seed=1)
    observation = env.step([0.4, 0])[0]
    assert observation[0] == pytest.approx(0.2, abs=1e-3)
    env.reset(seed=1)
    observation = env.step([7, 0])[0]  # as 1
    assert observation[0] == pytest.approx(0.5, abs=1e-2)


def test_a_choice_of_a_behaviour_is_its_priority_alone():
    env = elsie.Env(parsed(), act="choice", steps=5, observe="pose")
    assert env.action_space == Discrete(2)
    priorities = elsie.Env(parsed(), act="priorities", steps=5, observe="pose")
    env.reset(seed=1), priorities.reset(seed=1)
    for choice in [0, 1, np.int64(1), 0]:
        one = env.step(choice)[0]
        other = priorities.step(np.where(np.arange(2) == choice, 1.0, -1.0))[0]
        assert np.array_equal(one, other)
    with pytest.raises(elsie.InputError, match="not in Discrete"):
        env.step(2)


def test_several_robots_in_one_environment():
    env = elsie.Env(parsed(3), robots="all", reward=REWARD, steps=10)
    assert env.observation_space.shape == (3, 9) and env.action_space.shape == (3, 2)
    observation, _ = env.reset(seed=1)
    assert observation.shape == (3, 9)
    for action in sampled(env, 20):
        assert env.step(action)[0] in env.observation_space
    alone = elsie.Env(parsed(3), robot="r2")  # the others go on as in the file
    assert alone.observation_space.shape == (9,)


# Rewards.

def test_rewards_that_the_world_declares():
    measures = ('<measures><reward id="far" of="distance" robot="r1"/><reward id="bump" of="0 - collisions"/></measures>')
    world = parsed(2, extra=measures)
    env = elsie.ParallelEnv(world, steps=10)
    env.reset(seed=1)
    rewards = env.step({"r1": [1, 0], "r2": [1, 0]})[1]
    assert rewards["r1"] > 0.02 and rewards["r2"] == 0
    one = elsie.Env(world, robot="r1", reward="far", steps=10)
    double = elsie.Env(world, robot="r1", reward={"far": 2}, steps=10)
    one.reset(seed=1), double.reset(seed=1)
    assert double.step([1, 0])[1] == 2 * one.step([1, 0])[1] > 0


@pytest.mark.parametrize("control_steps", [1, 3])
def test_rewards_of_all_control_periods_are_the_total(control_steps):
    extra = '<measures><reward id="far" of="distance"/></measures>'
    env = elsie.Env(parsed(time=3, extra=extra, control_steps=control_steps), steps=4)
    grown = elsie.Env(parsed(time=3, extra=extra, control_steps=control_steps), steps=4, reward={"path_length_m": 1})
    env.reset(seed=1), grown.reset(seed=1)
    earned, growth, ended = 0.0, 0.0, False
    while not ended:
        _, reward, _, ended, _ = env.step([0.5, 0.1])
        assert reward == sum(env.robot_rewards().values())
        earned += reward
        growth += grown.step([0.5, 0.1])[1]
    assert earned == pytest.approx(growth) and earned > 0.5


def test_a_function_as_reward():
    def closer(observation, action, following):
        return observation[..., 0] - following[..., 0]
    env = elsie.Env(parsed(), observe="pose.x", reward=closer, steps=10)
    before, _ = env.reset(seed=1)
    after, reward = env.step([-1, 0])[:2]
    assert reward == pytest.approx(before[0] - after[0]) and reward != 0
    envs = elsie.VectorEnv(parsed(), 3, observe="pose.x", reward=closer, steps=10)
    envs.reset(seed=1)
    assert envs.step(np.full((3, 2), [-1, 0]))[1] == pytest.approx([reward] * 3, abs=1e-3)


# Actions are edits.

SCRIPT = """
import sys, elsie, numpy as np
world, act, steps, folder = elsie.World.parse(open(sys.argv[1]).read()), eval(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
env = elsie.Env(world, robots="all", act=act, steps=steps)
env.reset(seed=9)
random = np.random.default_rng(4)
for k in range(40):
    end = env.step(random.uniform(-1.2, 1.2, env.action_space.shape).astype(np.float32))
    if end[2] or end[3]: break
env.save(folder + "/episode.xml")
env.save(folder + "/episode.mcap")
print(env.state_hash, env.time_s)
"""
CHANGES_OF_MOTION = '<changes><change time="0.4" path="robot[r1]/@max_speed" value="0.25"/></changes>'


@pytest.mark.parametrize("act, steps, engine, extra", [
    ("'motion'", 10, "planar", ""), ("'motion'", 7, "ode", ""), ("'priorities'", 10, "planar", ""), ("'priorities'", 3, "ode", ""),
    ("['motion', 'gripper.closed', ('lamp.brightness', 0, 1), 'lamp.red']", 10, "planar", ""),
    ("['behavior[wander]/@priority', ('behavior[wander]/@speed', 0, 10)]", 5, "planar", ""),
    ("'priorities'", 10, "planar", CHANGES_OF_MOTION), ("'motion'", 10, "planar", CHANGES_OF_MOTION)])
def test_saved_episodes_are_the_same_run_to_the_last_bit(act, steps, engine, extra, tmp_path):
    """The fast path gives the bits of the edits that `elsie run` and `elsie replay` make."""
    (tmp_path / "world.xml").write_text(parsed(2, engine, 3, extra=extra, control_steps=2).text)
    environment = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX,-AVX2,-FMA,-FMA4", "PATH": "/usr/bin:/bin",
                   "PYTHONPATH": str(Path(elsie.__file__).parents[1])}
    made = subprocess.run([sys.executable, "-c", SCRIPT, tmp_path / "world.xml", act, str(steps), tmp_path], env=environment,
                          capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    state, time_s = made.stdout.split()
    ran = subprocess.run([elsie.program(), "run", tmp_path / "episode.xml", "--seed", "9", "--duration", time_s, "--json"],
                         capture_output=True, text=True)
    assert f'"state_hash":"{state}"' in ran.stdout, ran.stderr
    told = subprocess.run([elsie.program(), "replay", tmp_path / "episode.mcap", "--world", tmp_path / "again.xml"],
                          capture_output=True, text=True)
    assert told.returncode == 0, told.stderr
    again = subprocess.run([elsie.program(), "run", tmp_path / "again.xml", "--seed", "9", "--duration", time_s, "--json"],
                           capture_output=True, text=True)
    assert f'"state_hash":"{state}"' in again.stdout, again.stderr


def test_a_world_with_rules_takes_actions_as_edits(tmp_path):
    env = elsie.Env(parsed(extra='<rules><respawn after="1"/></rules>'), steps=10)
    env.reset(seed=1)
    for action in sampled(env, 20):
        env.step(action)
    env.save(tmp_path / "episode.mcap")  # raises if the run is another one


def test_edits_of_the_world_itself_are_made_and_names_are_found_again(tmp_path):
    env = elsie.Env(parsed(2, extra='<changes><change time="0.3" path="robot[r2]/sensor[left]/@remove" value="true"/>'
                                    '<change time="0.5" path="robot[r1]/@max_speed" value="0.1"/></changes>'),
                    robot="r1", observe=["range.distance_m", "motion.forward"], steps=10)
    env.reset(seed=1)
    speeds = [env.step([1, 0])[0][2] for _ in range(10)]
    assert speeds[3] == pytest.approx(0.5, abs=0.05) and speeds[9] == pytest.approx(0.1, abs=0.02)
    env.save(tmp_path / "episode.mcap")


@pytest.mark.parametrize("act", ["motion", "priorities", ["motion", "gripper.closed"], ["behavior[wander]/@speed", "priorities"]])
def test_an_episode_knows_nothing_of_the_one_before(act, tmp_path):
    env = elsie.Env(parsed(time=1), act=act, steps=10)
    first = env.reset(seed=1)[0]
    states = []
    for _ in range(2):
        for action in sampled(env, 8):
            env.step(action)
        states.append(env.state_hash)
        env.save(tmp_path / "episode.mcap")
        assert np.array_equal(env.reset(seed=1)[0], first)
    assert states[0] == states[1]


def test_layouts_are_drawn_by_the_seed_of_each_episode():
    env = elsie.Env("worlds/scattered/clutter.xml", observe="readings", act="motion")
    first = env.reset(seed=1)[0]
    assert not np.array_equal(env.reset(seed=2)[0], first)
    assert np.array_equal(env.reset(seed=1)[0], first)


# VectorEnv.

def hashes(count, threads, engine, **options):
    envs = elsie.VectorEnv(parsed(3, engine, time=0.8), count, threads=threads, robots="all", steps=10, **options)
    envs.reset(seed=11)
    made = []
    for k in range(14):  # over the end of an episode
        actions = np.stack([np.random.default_rng(1000 * k + i).uniform(-1, 1, (3, 2)) for i in range(count)])
        observations, rewards = envs.step(actions)[:2]
        made.append([(hash_, observation.tobytes(), reward)
                     for hash_, observation, reward in zip(envs.state_hashes(), observations, rewards)])
    return [[row[i] for row in made] for i in range(count)]


@pytest.mark.parametrize("engine", ["planar", "ode"])
@pytest.mark.parametrize("autoreset", ["NextStep", "SameStep"])
def test_the_same_bits_for_any_number_of_worlds_and_threads(engine, autoreset):
    alone = hashes(7, 1, engine, autoreset_mode=autoreset)
    for count, threads in [(1, 1), (2, 2), (7, 2), (7, 3)]:
        assert hashes(count, threads, engine, autoreset_mode=autoreset) == alone[:count], (count, threads)


def test_worlds_with_cameras_in_threads():
    def seen(threads):
        envs = elsie.VectorEnv("worlds/find_resource.xml", 3, threads=threads, steps=5,
                               observe=["vision.found", ("vision.column", 0, 100)])
        envs.reset(seed=1)
        return [envs.step(np.full((3, 2), [0.1, 0.2]))[0].tobytes() for _ in range(10)]
    assert seen(3) == seen(1)


def test_a_world_of_a_vector_is_an_env():
    envs, env = elsie.VectorEnv(parsed(), 3, steps=10), elsie.Env(parsed(), steps=10)
    observations, infos = envs.reset(seed=4)
    assert infos["seed"].tolist() == [4, 5, 6] and infos["_seed"].all()
    assert np.array_equal(env.reset(seed=6)[0], observations[2])
    for action in sampled(env, 10):
        step = envs.step(np.stack([action] * 3))
        assert np.array_equal(env.step(action)[0], step[0][2])
        assert all(part.shape == (3,) for part in step[1:4]) and step[1].dtype == np.float64 and step[2].dtype == np.bool_


def test_spaces_of_a_vector():
    envs = elsie.VectorEnv(parsed(), 4)
    assert envs.num_envs == 4 and envs.single_action_space.shape == (2,) and envs.action_space.shape == (4, 2)
    assert envs.observation_space.shape == (4,) + envs.single_observation_space.shape
    assert envs.reset(seed=1)[0] in envs.observation_space
    choices = elsie.VectorEnv(parsed(2), 3, robots="all", act="choice")
    assert choices.single_action_space == MultiDiscrete([2, 2]) and choices.action_space.shape == (3, 2)
    choices.reset(seed=1)
    choices.step(choices.action_space.sample())


def test_autoreset_in_the_next_step():
    envs = elsie.VectorEnv(parsed(time=0.3), 2, steps=10, reward=REWARD)
    assert envs.metadata["autoreset_mode"] == elsie.AutoresetMode.NEXT_STEP
    envs.reset(seed=1)
    go = np.full((2, 2), [1.0, 0.0])
    while not (step := envs.step(go))[3].all():
        assert (step[1] > 0).all()
    assert step[4]["_outcome"].all() and step[4]["outcome"].tolist() == ["time_limit"] * 2
    last = step[0]
    step = envs.step(go)
    assert step[1].tolist() == [0, 0] and not step[2].any() and not step[3].any()
    assert step[4]["_seed"].all() and step[4]["seed"][0] not in (1, 2)
    assert not np.array_equal(step[0], last)
    assert envs.time_s() == pytest.approx([0.01, 0.01])


def test_autoreset_in_the_same_step():
    envs = elsie.VectorEnv(parsed(time=0.3), 2, steps=10, reward=REWARD, observe="pose", autoreset_mode="SameStep")
    fresh = envs.reset(seed=1)[0]
    go = np.full((2, 2), [1.0, 0.0])
    steps = [envs.step(go) for _ in range(3)]
    observations, rewards, terminated, truncated, infos = steps[-1]
    assert truncated.all() and (rewards > 0).all()
    assert np.allclose(observations, fresh, atol=1e-6)  # those of the next episode
    assert infos["_final_obs"].all() and not np.allclose(infos["final_obs"][0], fresh[0], atol=1e-3)
    assert infos["final_info"]["outcome"][1] == "time_limit" and infos["_final_info"].all()
    assert envs.time_s() == pytest.approx([0.01, 0.01])


def test_without_autoreset_a_mask_says_who_begins_again():
    envs = elsie.VectorEnv(parsed(time=0.3), 3, steps=10, autoreset_mode="Disabled")
    envs.reset(seed=1)
    stay = np.zeros((3, 2))
    while not envs.step(stay)[3].all():
        pass
    with pytest.raises(elsie.InputError, match="world 0: This episode has ended"):
        envs.step(stay)
    infos = envs.reset(options={"reset_mask": np.array([True, False, True])})[1]
    assert infos["_seed"].tolist() == [True, False, True]
    with pytest.raises(elsie.InputError, match="world 1"):
        envs.step(stay)
    with pytest.raises(elsie.InputError, match="reset_mask"):
        envs.reset(options={"reset_mask": [1, 0]})


# ParallelEnv.

def test_agents_of_a_parallel_environment():
    env = elsie.ParallelEnv(parsed(3, time=1), steps=10, reward=REWARD)
    assert env.possible_agents == ["r1", "r2", "r3"] and env.metadata["name"] == "room"
    for agent in env.possible_agents:
        assert env.observation_space(agent) is env.observation_space(agent)
        assert env.action_space(agent) is env.action_space(agent)
    observations, infos = env.reset(seed=1)
    assert set(observations) == set(infos) == set(env.agents) == set(env.possible_agents)
    while env.agents:
        before = list(env.agents)
        made = env.step({agent: env.action_space(agent).sample() for agent in env.agents})
        for part in made:
            assert list(part) == before
        assert all(made[0][agent] in env.observation_space(agent) for agent in before)
        assert env.state() in env.state_space
        assert [agent for agent in before if not made[2][agent] and not made[3][agent]] == env.agents
    assert all(made[3].values()) and not any(made[2].values())
    with pytest.raises(elsie.InputError, match="no agents"):
        env.step({})


def test_agents_with_empty_batteries_leave_and_never_return():
    text = parsed(2).text.replace('battery="5000"', 'battery="3"', 1)
    env = elsie.ParallelEnv(elsie.World.parse(text), steps=10)
    env.reset(seed=1)
    while "r1" in env.agents:
        terminations = env.step({agent: [0, 0] for agent in env.agents})[2]
    assert terminations == {"r1": True, "r2": False} and env.agents == ["r2"]
    assert list(env.step({"r2": [0, 0]})[0]) == ["r2"]
    with pytest.raises(elsie.InputError, match="expected those of r2"):
        env.step({"r1": [0, 0], "r2": [0, 0]})


# Names.

@pytest.mark.parametrize("name", list(elsie.registry.REGISTERED))
def test_registered_environments_are_made(name):
    env = elsie.make(name, duration=1)
    env.reset(seed=1)
    assert env.step(env.action_space.sample())[0] in env.observation_space
    envs = elsie.make_vec(name, 2, duration=1)
    assert envs.reset(seed=1)[0] in envs.observation_space


def test_a_wrong_name_gets_the_nearest():
    with pytest.raises(elsie.InputError, match="elsie/Clutter-v0"):
        elsie.make("elsie/Cluter-v0")


# Misuse: a sentence each time.

@pytest.mark.parametrize("arguments, sentence", [
    (dict(observe="rage.distance_m"), "did you mean 'range.distance_m'"), (dict(observe=[]), "nothing is named"),
    (dict(observe=("pose", 1, 0)), "no interval"), (dict(observe=3), "observe"), (dict(observe=[("pose", 1)]), "is no name"),
    (dict(act="gripper.clsed"), "did you mean 'gripper.closed'"), (dict(act="dance"), "has nothing that is named 'dance'"),
    (dict(act=["motion", "priorities"]), "one or the other"), (dict(act="behavior[wander]/@sped"), "did you mean 'speed'"),
    (dict(act="behavior[wander]/@id"), "no number that may change"), (dict(robot="r2"), "no robot 'r2'"),
    (dict(robot="all"), "no robot 'all'"), (dict(robot="r1", robots="all"), "exclude each other"),
    (dict(robots=[]), "each once"), (dict(reward="foo"), "'foo'"),
    (dict(reward={"success": float("nan")}), "weight"), (dict(steps=0), "steps: .* not 0"), (dict(steps=1.5), "steps: .* not 1.5"),
    (dict(duration=-1), "duration"), (dict(duration=float("nan")), "duration"), (dict(render_mode="human"), "render_mode")])
def test_wrong_arguments(arguments, sentence):
    with pytest.raises((elsie.InputError, TypeError), match=sentence.replace("[", r"\[") if "[" in sentence else sentence):
        elsie.Env(parsed(), **arguments)


def test_wrong_arguments_of_a_vector():
    for arguments in (dict(num_envs=0), dict(num_envs=2, threads=-1), dict(num_envs=2, threads=0), dict(num_envs=2, threads=10**6),
                      dict(num_envs=2, autoreset_mode="Never")):
        with pytest.raises(elsie.InputError):
            elsie.VectorEnv(parsed(), **arguments)
    envs = elsie.VectorEnv(parsed(), 2)
    for seed in (-1, [1], 2**70, 1.5, "a"):
        with pytest.raises((elsie.InputError, TypeError)):
            envs.reset(seed=seed)


@pytest.mark.parametrize("action", [[1, 2, 3], np.zeros((1, 2)), [np.nan, 0], [np.inf, 0], "ab", None, [1, [2]], {}, np.zeros(2, complex),
                                    np.zeros((2, 0)), object()])
def test_wrong_actions(action):
    env = elsie.Env(parsed())
    with pytest.raises(elsie.InputError, match="not begun"):
        env.step([0, 0])
    env.reset(seed=1)
    with pytest.raises(elsie.InputError, match="action"):
        env.step(action)
    env.step([0, 0])  # it goes on
    envs = elsie.VectorEnv(parsed(), 2)
    envs.reset(seed=1)
    with pytest.raises(elsie.InputError, match="action"):
        envs.step(action)


def test_a_fault_names_its_world_and_reset_begins_again():
    """At 0.1 s, each robot gives its gripper a command that has no such number."""
    text = parsed().text.replace("<avoid_obstacle/>", '<avoid_obstacle/><commanded id="bad" commands="gripper.shut"/>')
    late = '<changes><change time="0.1" path="behavior[bad]/@values" value="1"/></changes></world>'
    world = elsie.World.parse(text.replace("</world>", late))
    envs = elsie.VectorEnv(world, 3, threads=2, act="priorities", steps=10)
    envs.reset(seed=1)
    with pytest.raises(elsie.PluginFault, match="world 0: .*'shut'"):
        for _ in range(3):
            envs.step(np.zeros((3, 3)))
    with pytest.raises(elsie.InputError, match="A fault has ended this episode"):
        envs.step(np.zeros((3, 3)))
    envs.reset(seed=1)


def test_one_environment_in_two_threads_is_refused_not_broken():
    envs = elsie.VectorEnv(parsed(3), 8, robots="all", steps=200, threads=2)
    envs.reset(seed=1)
    errors = []

    def work():
        for _ in range(5):
            try:
                envs.step(np.zeros((8, 3, 2)))
            except elsie.InputError as error:
                errors.append(str(error))
    threads = [threading.Thread(target=work) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all("at work in another thread" in error for error in errors)


def test_one_environment_is_looked_at_between_steps_only():
    envs = elsie.VectorEnv(parsed(3), 2, robots="all", steps=300, render_mode="rgb_array")
    envs.reset(seed=1)
    errors = []

    def attempt(call):
        try:
            call()
        except elsie.InputError as error:
            errors.append(str(error))
    stepping = threading.Thread(target=lambda: [attempt(lambda: envs.step(np.zeros((2, 3, 2)))) for _ in range(5)])
    stepping.start()
    while stepping.is_alive():
        for look in (envs.render, envs.state_hashes, envs.time_s, envs.seeds_now):
            attempt(look)
    stepping.join()
    assert all("at work in another thread" in error for error in errors)


def test_environments_of_several_threads_do_not_disturb_each_other():
    def episode(results, i):
        env = elsie.Env(parsed(engine="ode" if i % 2 else "planar"), steps=10)
        env.reset(seed=3)
        for action in sampled(env, 40):
            env.step(action)
        results[i] = env.state_hash
    results = {}
    threads = [threading.Thread(target=episode, args=(results, i)) for i in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(results.values())) == 2


NONSENSE = [None, -1, 0, 1, 3, 2**70, 1.5, float("nan"), "", "r1", b"x", [], [0], [0, 0], [[1.0, 2.0]], {}, {"r1": [0, 0]}, object(),
            np.zeros(3), np.zeros((2, 2)), (2,), lambda: 0]
METHODS = ["reset", "step", "save", "begin", "step_alone", "set_shapes", "observed", "acted", "outcome", "seed", "time_s",
           "state_hash", "picture", "observation_space", "action_space"]


@pytest.mark.parametrize("method", METHODS)
def test_random_misuse_is_an_exception_never_a_crash(method, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    made = [elsie.Env(parsed()), elsie.VectorEnv(parsed(), 2, threads=2), elsie.ParallelEnv(parsed(2))]
    for thing in made + [env._setup.worlds for env in made] + [type(made[0]._setup.worlds).__new__(type(made[0]._setup.worlds))]:
        random = np.random.default_rng(len(method))
        for _ in range(40):
            arguments = [NONSENSE[i] for i in random.integers(0, len(NONSENSE), random.integers(0, 4))]
            try:
                getattr(thing, method)(*arguments)
            except Exception:  # noqa: BLE001: any exception is right
                pass
    for env in made[:2]:
        env.reset(seed=1)


# Spaces of our own.

def test_spaces_have_gymnasiums_attributes():
    box = Box(np.array([-1, 0], np.float32), np.array([1, 2], np.float32), dtype=np.float32)
    assert box.shape == (2,) and box.dtype == np.float32 and box.is_bounded()
    box.seed(1)
    first = box.sample()
    box.seed(1)
    assert np.array_equal(box.sample(), first) and first in box and first.dtype == np.float32
    assert np.array([2, 0], np.float32) not in box and [0, 0] not in box and np.zeros(3, np.float32) not in box
    assert box == Box(box.low, box.high, dtype=np.float32)
    assert 1 in Discrete(2) and 2 not in Discrete(2) and 0.5 not in Discrete(2)
    assert MultiDiscrete([2, 3]).sample() in MultiDiscrete([2, 3])


@pytest.mark.parametrize("make", [elsie.Env, elsie.ParallelEnv])
def test_a_world_without_robots_teaches_nobody(make):
    with pytest.raises(elsie.InputError, match="no robots"):
        make(elsie.World.parse('<world format="1"/>'))


@pytest.mark.parametrize("actions", [None, [0, 0]])
def test_agents_act_by_their_names(actions):
    env = elsie.ParallelEnv(parsed(2), steps=10)
    env.reset(seed=1)
    with pytest.raises(elsie.InputError, match="expected a dictionary"):
        env.step(actions)
