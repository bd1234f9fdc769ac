"""Compares what each library and each plugin asks the system's loader for with what its storey may use.

  check_storeys.py LIBRARY_FOLDER SOURCE_FOLDER
"""
import re
import subprocess
import sys
from pathlib import Path

LIBRARIES = Path(sys.argv[1])
SOURCES = Path(sys.argv[2])

# The C++ runtime, which everything may use; the sanitizers' libraries belong to it.
RUNTIME = {"libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64", "ld-linux-aarch64", "libasan", "libubsan"}

# What each storey may name in its link line, besides the runtime.
STOREYS = {
    "libelsie-base": set(),
    "libelsie": {"libelsie-base", "libtinyxml2"},
    "libelsie-inference": {"libelsie-base"},
    "libelsie-workshop": {"libelsie-base", "libelsie", "libelsie-inference"},
    "libelsie-render": {"libelsie-base", "libelsie", "libepoxy"},
    "libelsie-views": {"libelsie-base", "libelsie", "libcairo", "libzstd", "libz"},
    "libelsie-editing": {"libelsie-base", "libelsie"},
    "libelsie-session": {"libelsie-base"},
    "libelsie-server": {"libelsie-base", "libelsie", "libelsie-editing", "libelsie-session", "libelsie-render", "libelsie-views",
                        "libelsie-workshop"},
    "libelsie-studies": {"libelsie-base", "libelsie", "libelsie-render", "libelsie-views", "libelsie-workshop", "libsqlite3", "libcrypto",
                         "libmuparser"},
    "libelsie-vision": {"libelsie-base", "libelsie", "libopencv_core", "libopencv_imgproc"},
    "libelsie-testing": {"libelsie-base", "libelsie", "libelsie-render", "libelsie-workshop"},
}
PLUGINS = {"libelsie-base", "libelsie", "libelsie-inference"}
EXCEPTIONS = {}  # by plugin: the libraries of others that it may need
ENGINES = {"ode": {"libelsie-base", "libelsie", "libode"}, "planar": {"libelsie-base", "libelsie"}}
LAYOUTS = {"libelsie-base", "libelsie", "libpng16"}

# What must not come with a storey by any detour.
FORBIDDEN = {
    "libelsie": {"libode", "libcairo", "libepoxy", "libGL", "libEGL", "libsqlite3", "libcrypto", "libzstd"},
    "libelsie-workshop": {"libcairo", "libepoxy", "libGL", "libEGL", "libsqlite3", "libcrypto", "libzstd"},
    "libelsie-editing": {"libcairo", "libepoxy", "libGL", "libEGL", "libsqlite3", "libcrypto", "libzstd"},
    "libelsie-inference": {"libelsie", "libode", "libtinyxml2", "libcairo", "libepoxy", "libsqlite3", "libcrypto", "libzstd"},
}

# Modules in the order of docs/architecture.md: none includes a header of a later one.
CORE = ["base", "api", "plugin", "world", "physics", "simulation"]


def stem(name):
    """"libode" for "libode.so.8"."""
    return name.split(".so")[0].split(".")[0] if ".so" in name else name


def needed(file):
    text = subprocess.run(["readelf", "-d", str(file)], capture_output=True, text=True, check=True).stdout
    return {stem(name) for name in re.findall(r"\(NEEDED\).*\[(.+)\]", text)} - RUNTIME


def loaded_with(file):
    text = subprocess.run(["ldd", str(file)], capture_output=True, text=True, check=True).stdout
    return {stem(line.split()[0].rsplit("/", 1)[-1]) for line in text.splitlines() if line.strip()}


def problems():
    for name, allowed in STOREYS.items():
        file = LIBRARIES / f"{name}.so"
        if not file.exists():
            yield f"there is no {file}"
            continue
        for extra in sorted(needed(file) - allowed):
            yield f"{name} needs {extra}; it may need {', '.join(sorted(allowed)) or 'nothing'}"
        for unwanted in sorted(loaded_with(file) & FORBIDDEN.get(name, set())):
            yield f"{unwanted} is loaded with {name}"
    plugins = sorted((LIBRARIES / "elsie" / "plugins").glob("*.so"))
    if not plugins:
        yield "there are no plugins"
    for file in plugins:
        allowed = PLUGINS | EXCEPTIONS.get(file.stem, set())
        for extra in sorted(needed(file) - allowed):
            yield f"the plugin {file.stem} needs {extra}; plugins may need {', '.join(sorted(allowed))}"
    engines = sorted((LIBRARIES / "elsie" / "engines").glob("*.so"))
    if {file.stem for file in engines} != set(ENGINES):
        yield f"the engines are {', '.join(file.stem for file in engines) or 'none'}; expected {', '.join(ENGINES)}"
    for file in engines:
        allowed = ENGINES.get(file.stem, set())
        for extra in sorted(needed(file) - allowed):
            yield f"the engine {file.stem} needs {extra}; it may need {', '.join(sorted(allowed))}"
    for extra in sorted(needed(LIBRARIES / "elsie" / "layouts.so") - LAYOUTS):
        yield f"the library of layouts needs {extra}; it may need {', '.join(sorted(LAYOUTS))}"
    for place, module in enumerate(CORE):
        for file in sorted((SOURCES / "core" / module).rglob("*.*")):
            if file.suffix in (".h", ".cpp"):
                for used in re.findall(r'^#include [<"]elsie/(\w+)/', file.read_text(), re.M):
                    if used not in CORE[: place + 1]:
                        yield f"{file.relative_to(SOURCES)} includes a header of {used}, which is above {module}"


found = list(problems())
for problem in found:
    print(problem)
sys.exit(1 if found else 0)
