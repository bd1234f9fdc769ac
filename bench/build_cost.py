"""What compiling costs in batches (ELSIE_UNITY), one source after the other, and without the precompiled headers: processor time.

  build_cost.py BUILD_FOLDER [COUNT]     COUNT batches (default 6), evenly from those of the libraries and the program
"""
import json
import re
import resource
import shlex
import subprocess
import sys
from pathlib import Path

BUILD = Path(sys.argv[1])
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 6


def words_of(entry, source, precompiled):
    """The compiler's command of a batch for one source: without a cache, its output thrown away."""
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if Path(word).name in ("c++", "g++", "clang++")):]
    kept = []
    skip = 0
    for word in words:
        if skip:
            skip -= 1
        elif word in ("-o", "-MF", "-MT") or word == "-include" and not precompiled:
            skip = 1
        elif word == entry["file"]:
            kept.append(source)
        elif word not in ("-MD", "-Winvalid-pch", "-Werror"):
            kept.append(word)
    return kept + ["-w", "-o", "/dev/null"]


def seconds(entry, sources, precompiled=True):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    for source in sources:
        subprocess.run(words_of(entry, source, precompiled), cwd=entry["directory"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


entries = [entry for entry in json.loads((BUILD / "compile_commands.json").read_text()) if "/Unity/" in entry["file"]]
if not entries:
    sys.exit(f"build_cost: {BUILD} was not built in batches; configure it with -DELSIE_UNITY=ON")
chosen = entries[:: max(1, len(entries) // COUNT)][:COUNT]
cost = {"in batches, precompiled headers": 0.0, "one by one, precompiled headers": 0.0, "one by one": 0.0}
count = 0
for entry in chosen:
    sources = re.findall(r'#include "(.+)"', Path(entry["file"]).read_text())
    count += len(sources)
    for name, value in zip(cost, (seconds(entry, [entry["file"]]), seconds(entry, sources), seconds(entry, sources, False))):
        cost[name] += value
least = cost["in batches, precompiled headers"]
print(f"{len(chosen)} of {len(entries)} batches, {count} sources.\n\n| build | processor time, s | ratio |\n|---|---|---|")
for name, value in cost.items():
    print(f"| {name} | {value:.1f} | {value / least:.2f} |")
