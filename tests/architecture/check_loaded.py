"""Compares what `elsie run` loads with what it may load.

  check_loaded.py ELSIE WORLD WORLD_WITH_CAMERAS WORLD_WITH_LAYOUTS
"""
import os
import re
import subprocess
import sys
import tempfile

ELSIE, WORLD, WORLD_WITH_CAMERAS, WORLD_WITH_LAYOUTS = sys.argv[1:]
UNWANTED = ("libelsie-editing", "libelsie-render", "libelsie-views", "libelsie-studies", "libelsie-testing", "libelsie-experiments", "elsie-commands",
            "libepoxy", "libEGL", "libGL", "libOpenGL", "libcairo", "libsqlite3", "libcrypto", "libzstd", "libelsie-vision", "libopencv",
            "images.so", "layouts.so", "libpng")


def loaded_by(*words):
    """The unwanted libraries that the program and its child initialise."""
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, LD_DEBUG="libs", LD_DEBUG_OUTPUT=os.path.join(folder, "log"))
        run = subprocess.run([ELSIE, *words], env=environment, capture_output=True, text=True)
        if run.returncode not in (0, 1):
            sys.exit(f"{words} failed: {run.stderr}")
        text = "".join(open(os.path.join(folder, name)).read() for name in os.listdir(folder))
    files = re.findall(r"calling init: (\S+)", text)
    if not any(os.path.basename(file).startswith("libelsie.so") for file in files):
        sys.exit("the loader's log does not name libelsie: nothing can be concluded from it")
    return sorted({name for name in UNWANTED for file in files if os.path.basename(file).startswith(name)})


found = loaded_by("run", WORLD, "--duration", "1", "--quiet")
if found:
    sys.exit(f"a run of {WORLD}, which has no cameras, loads {', '.join(found)}")
found = loaded_by("run", WORLD_WITH_CAMERAS, "--duration", "1", "--quiet")
if not {"libelsie-render", "libepoxy"} <= set(found):
    sys.exit(f"a run of {WORLD_WITH_CAMERAS} should load what takes pictures, but loads only: {', '.join(found) or 'nothing'}")
found = loaded_by("run", WORLD_WITH_LAYOUTS, "--duration", "1", "--quiet")
if found != ["layouts.so"]:
    sys.exit(f"a run of {WORLD_WITH_LAYOUTS} should load what draws layouts and nothing more, but loads {', '.join(found) or 'nothing'}")
