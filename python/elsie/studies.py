"""Many runs: as frames of pandas, here or from the databases of `elsie batch`."""
from __future__ import annotations

import contextlib
import itertools
import os
import re
import shutil
import sqlite3
import subprocess
import tempfile
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

from elsie import _elsie
from elsie.checks import whole
from elsie.errors import Error, InputError, PluginError, Problem
from elsie.plugins import errors_of_numpy, take_errors
from elsie.results import Result
from elsie.simulations import Simulation, note_of_bits
from elsie.worlds import File, Value, World

if TYPE_CHECKING:
    import pandas

_STEPS_BETWEEN_LOOKS = 5000


def run(world: Union[World, File], seeds: Iterable[int] = range(1, 2), *,
        edits: Optional[Mapping[str, Union[Value, Sequence[Value]]]] = None, workers: Optional[int] = None,
        time_limit: Optional[float] = None) -> pandas.DataFrame:
    """Runs a world once for each seed, and returns a frame with a row for each run.

        elsie.run("worlds/maze.xml", seeds=range(20))
        elsie.run(world, range(10), edits={"robot[r1]/@max_speed": [0.1, 0.2]})

    edits: values by paths, as of `--set`; a list of values is a factor: all combinations are run. workers: runs at the same time, in
    threads; None: one for each processor. time_limit: simulated seconds, instead of the world's.

    Columns: a column for each edit, by its path; seed, outcome, success, time_s (simulated), the measures by name, steps,
    state_hash, reason. Rows are in the order of the edits, then of the seeds, and the same with any number of workers. The
    first error of a run ends all. Studies that last longer than a coffee belong into `elsie.batch`, which survives crashes.
    """
    import pandas

    read = world if isinstance(world, World) else World(world)
    cells = list(_cells(edits or {}))
    if isinstance(seeds, (str, int)) or not isinstance(seeds, Iterable):
        raise InputError(f"seeds: expected several whole numbers, such as range(1, 6), not {seeds!r}")
    seeds = list(seeds)
    processors = len(os.sched_getaffinity(0))
    count = processors if workers is None else whole("workers", workers, 1)
    stop = threading.Event()
    note_of_bits()

    def one(place: int, seed: int) -> dict[str, Any]:
        made = Simulation(read, seed, time_limit=time_limit, edits=cells[place], watch=False)
        while made.outcome == "running" and not stop.is_set():
            made.step(_STEPS_BETWEEN_LOOKS)
        return {**cells[place], **_row(made.result())}

    with ThreadPoolExecutor(count, initializer=take_errors, initargs=errors_of_numpy()) as pool:
        jobs = [pool.submit(one, place, seed) for place in range(len(cells)) for seed in seeds]
        try:
            rows = [job.result() for job in jobs]
        except BaseException:
            stop.set()
            pool.shutdown(cancel_futures=True)
            raise
    return pandas.DataFrame(rows)


def _cells(edits: Mapping[str, Union[Value, Sequence[Value]]]) -> Iterator[dict[str, Value]]:
    levels: list[list[Any]] = [
        [value] if isinstance(value, (str, bool, int, float)) or not hasattr(value, "__iter__") else list(value)
        for value in edits.values()]
    for values in itertools.product(*levels):
        yield dict(zip(edits, values))


def _row(result: Result) -> dict[str, Any]:
    measures = {name: value for name, value in result.measures.items() if name not in ("success", "time_s")}
    return {"seed": result.seed, "outcome": result.outcome, "success": result.success, "time_s": result.time_s, **measures,
            "steps": result.steps, "state_hash": result.state_hash, "reason": result.reason}


def program() -> str:
    """The program `elsie` of this installation. Raises `elsie.Error` if there is none."""
    package = Path(_elsie.__file__).parent
    for folder in (package / "_root", *package.parents):  # the first: pip keeps all of Elsie in the package
        candidate = folder / "bin" / "elsie"
        if os.access(candidate, os.X_OK) and candidate.is_file():
            return str(candidate)
    found = shutil.which("elsie")
    if found is None:
        raise Error("the program 'elsie' is neither next to this package nor in the PATH; install it")
    return found


def _call(arguments: Sequence[str], fine: Sequence[int] = (0,)) -> str:
    """What the program prints. Its complaints become an exception."""
    done = subprocess.run([program(), *arguments], capture_output=True, encoding="utf-8", errors="replace", check=False)
    if done.returncode in fine:
        return done.stdout
    raise _error(done.returncode, done.stderr)


def _error(code: int, complaints: str) -> Error:
    sentence = complaints.strip().removeprefix("elsie: ")
    error = {2: InputError, 3: PluginError}.get(code, Error)(sentence or f"elsie ended with code {code}")
    error.exit_code = code
    places = [re.match(r"(.+?):(\d+): (.*)", line) for line in sentence.splitlines()]
    error.problems = tuple(Problem(place[1], int(place[2]), place[3]) for place in places if place)
    return error


def batch(experiment: File, out: Optional[File] = None, *, workers: Optional[int] = None, resume: bool = False,
          extend: bool = False) -> Results:
    """Does all runs of an experiment file, each in a process of its own, as `elsie batch` does. Returns the results.

    out: the database; None: the experiment's name with .sqlite, in the current folder. An existing one is refused, unless
    resume: does the runs that are still to be done, or extend: adds what the experiment has more. Runs that fail are rows
    of the results, and no errors.
    """
    file = Path(os.fspath(out) if out is not None else Path(experiment).stem + ".sqlite")
    arguments = ["batch", os.fspath(experiment), "--database", str(file), "--quiet"]
    if workers is not None:
        arguments += ["--workers", str(workers)]
    if resume:
        arguments.append("--resume")
    if extend:
        arguments.append("--extend")
    _call(arguments, fine=(0, 3))
    return Results(file)


class Results:
    """The results of an experiment: the database that `elsie batch` has written, or is writing.

        results = elsie.batch("experiments/top_speed.xml")
        results.runs.groupby("max_speed").time_s.mean()
    """

    def __init__(self, file: File) -> None:
        """Opens a database for reading. Raises `elsie.InputError` if it is none, or damaged."""
        self.file = os.fspath(file)
        _call(["report", self.file, "--quiet"], fine=(0, 1, 4))

    @property
    def runs(self) -> pandas.DataFrame:
        """A row for each run that has ended, with the columns of `elsie report --csv`: factors, seed, outcome, measures. Read anew each time."""
        return self._frame("--csv")

    @property
    def cells(self) -> pandas.DataFrame:
        """A row for each cell, with the columns of `elsie report --cells-csv`. Read anew each time."""
        return self._frame("--cells-csv")

    def report(self) -> str:
        """The table of `elsie report`: cells, effects of factors, expectations."""
        return _call(["report", self.file], fine=(0, 1, 4))

    def table(self, name: str) -> pandas.DataFrame:
        """A whole table of the database, such as "run_events" or "trajectories": see docs/results-database.md."""
        import pandas

        with self._opened() as connection:
            known = [row[0] for row in connection.execute("SELECT name FROM sqlite_master WHERE type IN ('table', 'view')")]
            if name not in known:
                raise InputError(f"{self.file}: there is no table '{name}'; there are: {', '.join(sorted(known))}")
            return pandas.read_sql(f'SELECT * FROM "{name}"', connection)

    def replay(self, run: int) -> Simulation:
        """A simulation of a run, by its number in `runs`, at its start: to be watched, recorded, changed.

        Its world is that of the database. Data files are those on disk now; `elsie replay` restores them, and checks that
        the run is the same.
        """
        with self._opened() as connection:
            row = connection.execute("SELECT run_worlds.world_text, world_file, seed FROM run_worlds JOIN runs ON runs.id = run_id "
                                     "JOIN cells ON cells.id = cell_id WHERE run_id = ?", (run,)).fetchone()
        if row is None:
            raise InputError(f"{self.file}: there is no run {run}")
        text, file, seed = row
        return Simulation(World.parse(text, file=file), seed % 2**64)

    def _opened(self) -> contextlib.closing[sqlite3.Connection]:
        return contextlib.closing(sqlite3.connect(f"{Path(self.file).resolve().as_uri()}?mode=ro", uri=True))

    def __repr__(self) -> str:
        return f"<elsie.Results {self.file!r}>"

    def _repr_html_(self) -> str:
        return str(self.cells.to_html())

    def _frame(self, option: str) -> pandas.DataFrame:
        import pandas

        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "frame.csv")
            _call(["report", self.file, "--quiet", option, file], fine=(0, 1, 4))
            return pandas.read_csv(file)
