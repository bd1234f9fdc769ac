"""Who takes how much of a run's processor time, by Linux' perf: shares of the samples.

  profile.py BUILD_FOLDER [SECONDS]     SECONDS: of processor time for each column, about (default 10)

World: worlds/scattered/swarm.xml. Prints a table in Markdown.
"""
import math
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(sys.argv[1]).resolve()
SECONDS = float(sys.argv[2]) if len(sys.argv) > 2 else 10.0
RUNS = [("planar", 100), ("planar", 10_000), ("ode", 100), ("ode", 10_000)]
RATE = {"planar": 4e5, "ode": 1e5}  # robot-steps a second, roughly: how long to run
STEPS_A_SECOND = 100  # simulated
PARTS = ["sensing", "behaviours", "coordination", "drives", "physics", "the rest of the step", "reading, and making the simulation"]
PLUGINS = {"sensors": "sensing", "behaviors": "behaviours", "coordinators": "coordination", "drives": "drives"}
KINDS = {folder.name: part for kind, part in PLUGINS.items() for folder in (ROOT / "plugins" / kind).iterdir()}
SENSING = re.compile(r"sens|ray|beam|volume|look|cast", re.IGNORECASE)
DECIDING = re.compile(r"decide|Controller", re.IGNORECASE)
STEP = re.compile(r"Simulation(::Impl)?::(step|run)\b")


def part_of(stack):
    """The part of a stack of (function, library), outermost first."""
    at = next((i for i, (function, _) in enumerate(stack) if STEP.search(function)), None)
    if at is None:
        return PARTS[-1]
    part = None
    for function, library in stack[at + 1:]:
        plugin = KINDS.get(Path(library).stem) if "/plugins/" in library else None
        if plugin == "sensing" or SENSING.search(function):
            return "sensing"
        if plugin:
            part = plugin  # a behaviour inside of its coordinator
        elif "/engines/" in library:
            return part or "physics"
        elif DECIDING.search(function):
            part = part or "coordination"
    return part or "the rest of the step"


def stacks(text):
    """The stacks of `perf script`, outermost function first."""
    for sample in text.split("\n\n"):
        frames = re.findall(r"^\s+[0-9a-f]+ (.*) \((.*)\)$", sample, re.MULTILINE)
        if frames:
            yield [(function.rsplit("+0x", 1)[0], library) for function, library in reversed(frames)]


def profile(engine, robots, folder):
    side = math.sqrt(robots)
    steps = max(30, SECONDS * RATE[engine] / robots)
    data = folder / "perf.data"
    time = f"{steps / STEPS_A_SECOND:.2f}"
    settings = {"arena/@length": side, "arena/@width": side, "physics/@engine": engine, "goals/endure/@time": time, "limits/@time": time}
    run = [BUILD / "bin/elsie", "run", ROOT / "worlds/scattered/swarm.xml", "--quiet"]
    for path, value in settings.items():
        run += ["--set", f"{path}={value}"]
    # A run that reaches its limit of time ends with 1, which perf returns.
    recorded = subprocess.run(["perf", "record", "-q", "-e", "cpu-clock", "-F", "250", "--call-graph", "dwarf,4096", "-o", data, "--", *run], capture_output=True, text=True)
    if not data.exists() or recorded.returncode > 1:
        sys.exit(f"profile: perf record: {recorded.stderr.strip()}")
    script = subprocess.run(["perf", "script", "-i", data, "--no-inline", "-F", "ip,sym,dso"], capture_output=True, text=True, check=True)
    counts = Counter(part_of(stack) for stack in stacks(script.stdout))
    data.unlink()
    return counts


def main():
    if not shutil.which("perf"):
        print("Not measured: perf is missing.")
        return
    with tempfile.TemporaryDirectory() as made:
        columns = [profile(engine, robots, Path(made)) for engine, robots in RUNS]
    print("| part | " + " | ".join(f"`{engine}`, {robots:,} robots" for engine, robots in RUNS) + " |\n|---|" + "---|" * len(RUNS))
    for part in PARTS[:-1]:
        shares = [f"{100 * counts[part] / max(1, counts.total() - counts[PARTS[-1]]):.0f} %" for counts in columns]
        print(f"| {part} | " + " | ".join(shares) + " |")
    print("\nShares of the time of steps; samples: " + ", ".join(f"{counts.total() - counts[PARTS[-1]]:,}" for counts in columns) + ".")


main()
