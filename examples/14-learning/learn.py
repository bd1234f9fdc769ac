"""Who decides when? The cross-entropy method (Rubinstein 1999) learns it: python3 learn.py case1|foraging [GENERATIONS]"""
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import elsie

Floats = NDArray[np.float64]
Curve = list[tuple[float, float]]
HERE, POPULATION, ELITE, EPISODES = Path(__file__).parent, 24, 6, 2  # candidates, those that go on, episodes of each


def earned_by(envs: elsie.VectorEnv, candidates: Floats, seed: int) -> Floats:
    """What each candidate earns: a matrix from what a robot observes, and 1, to the priorities of its behaviours."""
    observed, _ = envs.reset(seed=[seed + i % EPISODES for i in range(envs.num_envs)])
    weights = np.repeat(candidates, EPISODES, axis=0)
    earned, going = np.zeros(envs.num_envs), np.ones(envs.num_envs, bool)
    while going.any():
        inputs = np.concatenate([observed[..., :candidates.shape[2] - 1], np.ones((*observed.shape[:2], 1))], axis=2)
        actions = np.tanh(0.5 * np.einsum("wri,wbi->wrb", inputs, weights))
        observed, rewards, terminated, truncated, _ = envs.step(actions)
        earned += rewards * going
        going &= ~(terminated | truncated)
    means: Floats = earned.reshape(-1, EPISODES).mean(axis=1)
    return means


def learn(world: Path, inputs: int, generations: int, seed: int = 1, **environment: Any) -> tuple[Floats, Curve]:
    """The mean of the last generation, and the curve: the mean and the greatest of what the candidates of each one earn."""
    envs = elsie.VectorEnv(world, POPULATION * EPISODES, robots="all", act="priorities", **environment)
    random = np.random.default_rng(seed)
    mean = np.zeros((envs.single_action_space.shape[1], inputs + 1))
    spread = np.full_like(mean, 2.0)
    curve: Curve = []
    for generation in range(generations):
        candidates = mean + spread * random.standard_normal((POPULATION, *mean.shape))
        earned = earned_by(envs, candidates, 1000 * (generation + 1))
        best = candidates[np.argsort(-earned, kind="stable")[:ELITE]]
        mean, spread = best.mean(axis=0), best.std(axis=0) + 0.1
        curve.append((float(earned.mean()), float(earned.max())))
        print(f"generation {generation + 1}: mean {curve[-1][0]:.2f}, best {curve[-1][1]:.2f}", flush=True)
    return mean, curve


def case1(generations: int) -> tuple[elsie.World, Curve]:
    """Two beams say whether avoiding or searching decides; the weights become the network of a coordinator."""
    weights, curve = learn(HERE / "case1.xml", 2, generations, reward={"collected": 1, "time_s": -0.005})
    network = elsie.Network([2, 2])
    network.weights = [weights]
    network.save("case1.weights")
    world = elsie.World(HERE / "case1.xml")
    world["robot[collector]/coordinator"] = f'<arbiter_neural_network weights="{Path("case1.weights").resolve()}"/>'
    return world, curve


def foraging(generations: int) -> tuple[elsie.World, Curve]:
    """The same priorities for all robots of a swarm, whatever they see."""
    weights, curve = learn(HERE / "foraging.xml", 0, generations, observe="energy", steps=2400, reward={"collected": 1})
    world = elsie.World(HERE / "foraging.xml")
    for behavior, priority in zip(["wander", "avoid_obstacle", "escape", "forage"], 1 / (1 + np.exp(-weights[:, 0]))):
        world[f"behavior[{behavior}]/@priority"] = float(priority)
    return world, curve


if __name__ == "__main__":
    task = {"case1": case1, "foraging": foraging}[sys.argv[1]]
    learned, steps = task(int(sys.argv[2]) if len(sys.argv) > 2 else 10)
    learned.save(f"{task.__name__}_learned.xml")
    np.savetxt(f"{task.__name__}_curve.csv", steps, "%.17g", ",", header="mean,best", comments="")
    elsie.plot(f"{task.__name__}_curve.svg", dict(zip(["mean", "best"], np.array(steps).T)), xlabel="generation", ylabel="earned")
