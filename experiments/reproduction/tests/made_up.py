"""A small database of results. `empty` is the program that makes one without rows."""
import json
import sqlite3
import subprocess


class MadeUp:
    """Inserts the given rows; call close() before reading."""

    def __init__(self, file, empty, factors=("world", "coordinator")):
        subprocess.run([empty, file], check=True)
        self.database = sqlite3.connect(file)
        self.add("about", id=1, elsie_version="9.8.7", abi="", experiment="made up", description="", file="", text="", fingerprint="", shard="1/1",
                 runs=0, wall_limit_s=1, trajectory_period_s=1, created="2026-01-01T00:00:00Z")
        for k, name in enumerate(factors):
            self.add("factors", id=k, name=name)
        self.factors = factors
        for name in ("path_length_m", "time_s", "collected", "collisions"):
            self.add("measures", name=name, unit="", meaning="")
        self.runs = 0

    def add(self, table, **row):
        self.database.execute(f"INSERT INTO {table} ({', '.join(row)}) VALUES ({', '.join('?' * len(row))})", list(row.values()))

    def cell(self, cell, *levels, world_text="<world/>"):
        self.add("cells", id=cell, label=f"cell {cell}", world=levels[0], world_text=world_text, world_file="", sha256="")
        for factor, level in enumerate(levels):
            self.add("cell_levels", cell_id=cell, factor_id=factor, label=level, place=0)
        return self

    def run(self, cell, seed, path_m=1.0, time_s=10.0, outcome="success", collected=1, state_hash="00", note=None, robots=()):
        """robots: (id, its poses)."""
        self.runs += 1
        self.add("runs", id=self.runs, cell_id=cell, seed=seed, repetition=1, state="done", outcome=outcome, state_hash=state_hash, ended="")
        for name, value in (("path_length_m", path_m), ("time_s", time_s), ("collected", collected), ("collisions", 0)):
            self.add("run_measures", run_id=self.runs, measure=name, value=value)
        if note:
            self.add("notes", run_id=self.runs, place=0, robot="", plugin="", text=note)
        for robot, poses in robots:
            self.add("run_robots", run_id=self.runs, robot=robot, team="", distance_m=0, collected=0, energy=0, collisions=0, x_m=poses[-1][0],
                     y_m=poses[-1][1], heading_rad=0)
            self.add("trajectories", run_id=self.runs, robot=robot, from_s=0, period_s=1, poses=json.dumps(poses), touches="[]")
        return self

    def pending(self, cell, seed):
        self.runs += 1
        self.add("runs", id=self.runs, cell_id=cell, seed=seed, repetition=1)
        return self

    def close(self):
        self.database.commit()
        self.database.close()
