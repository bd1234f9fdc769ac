# %% [markdown]
# # Learn when to turn
#
# A robot among boxes has two numbers to learn: from how near on its beams make it turn, and how fast. An evolution strategy
# (Rechenberg 1973) tries a handful of neighbours of the best so far, in worlds that are stepped side by side, and keeps the better ones.

# %%
import numpy as np
from numpy.typing import NDArray

import elsie

WORLDS, GENERATIONS = 8, 10
envs = elsie.VectorEnv("worlds/clutter.xml", WORLDS, observe="range.distance_m", reward={"path_length_m": 1, "collisions": -2}, steps=20,
                       duration=20)
print(envs.single_observation_space, envs.single_action_space)

# %% [markdown]
# ## What a pair of numbers earns
#
# One row of `weights` for each world; all worlds have the same seed, so that only the numbers differ.


# %%
def earned(weights: NDArray[np.float64]) -> NDArray[np.float64]:
    observations, _ = envs.reset(seed=[3] * WORLDS)
    total, going = np.zeros(WORLDS), np.ones(WORLDS, bool)
    left = np.arange(observations.shape[1]) < observations.shape[1] // 2
    while going.any():
        near = np.clip(weights[:, :1] - observations, 0, None)
        turn = weights[:, 1] * (near[:, ~left].sum(axis=1) - near[:, left].sum(axis=1))
        forward = 1 - np.clip(near.max(axis=1), 0, 1)
        observations, rewards, terminated, truncated, _ = envs.step(np.tanh(np.stack([forward, turn], axis=1)).astype(np.float32))
        total += rewards * going
        going &= ~(terminated | truncated)
    return total


# %% [markdown]
# ## Generations

# %%
random = np.random.default_rng(1)
best, spread, curve = np.array([0.3, 0.1]), 0.1, []
for generation in range(GENERATIONS):
    candidates = best + spread * random.standard_normal((WORLDS, 2))
    candidates[0] = best
    gains = earned(candidates)
    best = candidates[np.argmax(gains)]
    curve.append(float(gains.max()))
    print(f"generation {generation + 1}: {curve[-1]:.2f} with {best.round(2)}")

# %% [markdown]
# ## The curve
#
# In a picture of its own; matplotlib draws it as well.

# %%
elsie.plot("learning.png", {"the best so far": curve}, xlabel="generation", ylabel="earned in 20 s", title="Learning when to turn")
assert curve[-1] >= curve[0], "the best so far is never forgotten"
envs.close()
