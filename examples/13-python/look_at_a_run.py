# %% [markdown]
# # Look at a run
#
# A robot wanders among boxes with a small battery. Who decided when, how near did it come to things, and what would it
# have done with another speed limit? Open this file in an editor that knows cells (`# %%`), or turn it into a notebook with jupytext.

# %%
import numpy as np

import elsie

world = elsie.World("worlds/scattered/recharge.xml")
print(world.robots, world["robot[r1]/@battery"], "units of energy")

# %% [markdown]
# ## Make steps and look
#
# Arrays are views: taken once, they show every later step. In a notebook, `run` as the last line of a cell is the picture.

# %%
run = elsie.Simulation(world, seed=7, time_limit=90)
beams = run.readings("range")
rows: list[tuple[float, float, float]] = []


@run.observe
def look(now: elsie.Simulation) -> None:
    rows.append((now.time, now.energies[0], beams["distance_m"].min()))


result = run.run()
time, energy, nearest = np.array(rows).T
print(result)
print(f"{result.measures['path_length_m']:.1f} m, never nearer than {nearest.min():.2f} m, {energy.min():.0f} units left at the least")

# %%
run.picture("look_at_a_run.png")
run

# %% [markdown]
# ## Who decided
#
# A row for each episode, with the behaviour whose share in the command was the largest.

# %%
episodes = result.trace("r1")
for episode in episodes[:5]:
    print(f"{episode['from_s']:6.2f} s to {episode['to_s']:6.2f} s: {episode['decider']} ({episode['share']:.0%})")
for row in result.behaviors("r1"):
    print(f"{row['path']}: decided for {row['decided_s']:.1f} s, mean weight {row['weight']:.2f}")

# %% [markdown]
# How near were things while it avoided them, and otherwise?

# %%
avoiding = np.zeros(len(time), dtype=bool)
for episode in episodes[episodes["decider"] == "avoid_obstacle"]:
    avoiding |= (time > episode["from_s"]) & (time <= episode["to_s"])
print(f"mean of the nearest beam: {nearest[avoiding].mean():.2f} m while it avoids, {nearest[~avoiding].mean():.2f} m otherwise")

# %% [markdown]
# ## The same run with an edit
#
# At 30 s the robot becomes slower. Until then both runs are the same, bit for bit.

# %%
slower = elsie.Simulation(world, seed=7, time_limit=90)
slower.run(until=30)
slower["robot[r1]/@max_speed"] = 0.2
after = slower.run()
print(f"{after.measures['path_length_m']:.1f} m instead of {result.measures['path_length_m']:.1f} m")
assert after.measures["path_length_m"] != result.measures["path_length_m"]
