# %% [markdown]
# # A study, as frames
#
# Does a robot in a maze get further with a higher speed limit, and does that depend on how it decides? Twelve mazes, one from
# each seed, two coordinators, three limits: 72 runs in a second or two. Mazes differ, and all treatments meet the same ones:
# seeds are the blocks of the design, and a mixed model with a random intercept for each seed compares like with like.

# %%
import elsie

SPEED = "robot[r1]/@max_speed"
COORDINATOR = "robot[r1]/coordinator"
COORDINATORS = {'<fusion_vector_summation weighted="true"/>': "fusion", "<arbiter_suppression/>": "arbiter"}

runs = elsie.run("worlds/scattered/maze.xml", seeds=range(1, 13), time_limit=20,
                 edits={SPEED: [0.2, 0.275, 0.35], COORDINATOR: list(COORDINATORS)})
runs = runs.rename(columns={SPEED: "speed"})
runs["coordinator"] = runs[COORDINATOR].map(COORDINATORS)
print(runs.groupby(["coordinator", "speed"]).path_length_m.agg(["mean", "std", "count"]))

# %% [markdown]
# ## The mixed model
#
# The path length by speed, coordinator and their interaction, with a random intercept for each seed (Laird and Ware, 1982).

# %%
import statsmodels.formula.api as smf

model = smf.mixedlm("path_length_m ~ speed * coordinator", runs, groups=runs["seed"]).fit()
print(model.summary())
slope = model.params["speed"]
print(f"With the arbiter, 0.1 m/s more gives {0.1 * slope:.2f} m more in 20 s; "
      f"mazes vary by {model.cov_re.iloc[0, 0] ** 0.5:.2f} m (standard deviation)")
assert slope > 0

# %% [markdown]
# ## A study that is kept
#
# `elsie.batch` does the runs of an experiment file, each in a process of its own, and stores them with worlds, files and
# plugins: a crash ends one run, a study can go on later, and every run can be done again.

# %%
results = elsie.batch("experiments/top_speed.xml", "top_speed.sqlite")
print(results.runs.groupby("max_speed")[["time_s", "path_length_m"]].mean())
print(results.report().splitlines()[2])

# %%
again = results.replay(5)
print(again.run())
