"""What compiling costs with and without the precompiled headers, and at -O3: processor time for the same sources, in turn.

  build_cost.py BUILD_FOLDER [COUNT]     COUNT sources (default 24), evenly from those of the libraries and the program
"""
import json
import resource
import shlex
import subprocess
import sys
from pathlib import Path

BUILD = Path(sys.argv[1])
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 24
VARIANTS = {"-O2, precompiled headers": ("-O2", True), "-O2": ("-O2", False), "-O3": ("-O3", False)}


def words_of(entry, level, precompiled):
    """The compiler's command for one source: without a cache, its output thrown away."""
    words = shlex.split(entry["command"])
    words = words[next(i for i, word in enumerate(words) if Path(word).name in ("c++", "g++", "clang++")):]
    kept = []
    skip = 0
    for i, word in enumerate(words):
        if skip:
            skip -= 1
        elif word in ("-o", "-MF", "-MT"):
            skip = 1
        elif word == "-include" and not precompiled:
            skip = 1
        elif word in ("-O2", "-O3"):
            kept.append(level)
        elif word not in ("-MD", "-Winvalid-pch", "-Werror"):
            kept.append(word)
    return kept + ["-w", "-o", "/dev/null"]


def seconds(words, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(words, cwd=folder, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


entries = [entry for entry in json.loads((BUILD / "compile_commands.json").read_text())
           if "cmake_pch" not in entry["file"] and any(f"/{part}/" in entry["file"] for part in ("core", "libraries", "apps"))
           and "-include" in entry["command"]]
chosen = entries[:: max(1, len(entries) // COUNT)][:COUNT]
cost = dict.fromkeys(VARIANTS, 0.0)
for entry in chosen:
    for name, (level, precompiled) in VARIANTS.items():
        cost[name] += seconds(words_of(entry, level, precompiled), entry["directory"])
least = cost["-O2, precompiled headers"]
print(f"{len(chosen)} of {len(entries)} sources.\n\n| build | processor time, s | ratio |\n|---|---|---|")
for name, value in cost.items():
    print(f"| {name} | {value:.1f} | {value / least:.2f} |")
