"""Compares what each library, program and plugin asks the system's loader for, and which headers each module includes, with what its storey
may use. Also holds the core to its size.

  check_storeys.py BUILD_FOLDER SOURCE_FOLDER
"""
import re
import subprocess
import sys
from pathlib import Path

BUILD = Path(sys.argv[1])
SOURCES = Path(sys.argv[2])

# The C++ runtime, which everything may use; the sanitizers' libraries belong to it.
RUNTIME = {"libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64", "ld-linux-aarch64", "libasan", "libubsan", "libtsan"}

# What each library and program may name in its link line, besides the runtime: other storeys, and libraries that are not Elsie's.
MAY_NEED = {
    "lib/libelsie-base.so": set(),
    "lib/libelsie.so": {"libelsie-base", "libtinyxml2"},
    "lib/libelsie-inference.so": {"libelsie-base"},
    "lib/libelsie-workshop.so": {"libelsie-base", "libelsie", "libelsie-inference"},
    "lib/libelsie-editing.so": {"libelsie-base", "libelsie"},
    "lib/libelsie-views.so": {"libelsie-base", "libelsie", "libcairo", "libepoxy", "libzstd", "libz"},
    "lib/libelsie-testing.so": {"libelsie-base", "libelsie", "libelsie-views", "libelsie-workshop"},
    "lib/libelsie-session.so": {"libelsie-base"},
    "lib/libelsie-server.so": {"libelsie-base", "libelsie", "libelsie-editing", "libelsie-session", "libelsie-views", "libelsie-workshop"},
    "lib/libelsie-studies.so": {"libelsie-base", "libelsie", "libelsie-views", "libelsie-workshop", "libsqlite3", "libcrypto", "libmuparser"},
    "lib/libelsie-vision.so": {"libelsie-base", "libelsie", "libopencv_core", "libopencv_imgproc"},
    "lib/elsie/layouts.so": {"libelsie-base", "libelsie", "libpng16"},
    "lib/elsie/engines/ode.so": {"libelsie-base", "libelsie", "libode"},
    "lib/elsie/engines/planar.so": {"libelsie-base", "libelsie"},
    "lib/elsie/elsie-program": {"libelsie-base", "libelsie", "libelsie-workshop", "libspdlog", "libfmt"},
    "lib/elsie/elsie-commands.so": {"libelsie-base", "libelsie", "libelsie-inference", "libelsie-workshop", "libelsie-editing", "libelsie-views",
                                    "libelsie-testing", "libelsie-server", "libelsie-studies", "libspdlog", "libfmt"},
    "bin/elsie": set(),
    "bin/elsie-desktop": {"libelsie-base", "libelsie-inference", "libelsie-views", "libelsie-session", "libQt6Widgets", "libQt6Gui", "libQt6Core"},
}
OPTIONAL = {"bin/elsie-desktop"}
PLUGINS = {"libelsie-base", "libelsie", "libelsie-inference"}
EXCEPTIONS = {}  # by plugin: the libraries of others that it may need

# The libraries that must come with no storey by a detour: those above, and these; and what some of them bring themselves.
UNWANTED = {"libGL", "libEGL"}
BROUGHT = {
    "libcairo": {"libpng16"},
    "libpng16": {"libz"},
    "libopencv_core": {"libz"},
    "libQt6Gui": {"libGL", "libEGL", "libpng16"},
}

# The modules of each storey, in the order of docs/architecture.md: none includes a header of a later one.
MODULES = {
    "libelsie-base": ["base", "files"],
    "libelsie": ["api", "plugin", "world", "physics", "simulation"],
    "libelsie-inference": ["fuzzy", "neural"],
    "libelsie-workshop": ["process", "build", "reference"],
    "libelsie-editing": ["editing"],
    "libelsie-views": ["output", "render", "traces", "picture", "mcap", "recording"],
    "libelsie-testing": ["testing"],
    "libelsie-session": ["snapshots", "client"],
    "libelsie-server": ["server"],
    "libelsie-studies": ["experiment", "results", "batch", "cluster", "report"],
}
HEADERS_ALONE = {"snapshots": {"api"}}  # elsie/api/geometry.h has no code that is not inline

MOST_LINES_OF_CORE = 20_000


def stem(name):
    """"libode" for "libode.so.8"."""
    return name.split(".so")[0].split(".")[0] if ".so" in name else name


def needed(file):
    text = subprocess.run(["readelf", "-d", str(file)], capture_output=True, text=True, check=True).stdout
    return {stem(name) for name in re.findall(r"\(NEEDED\).*\[(.+)\]", text)} - RUNTIME


def loaded_with(file):
    text = subprocess.run(["ldd", str(file)], capture_output=True, text=True, check=True).stdout
    return {stem(line.split()[0].rsplit("/", 1)[-1]) for line in text.splitlines() if line.strip()}


MAY_NEED_BY_NAME = {stem(Path(path).name): allowed for path, allowed in MAY_NEED.items()}
WATCHED = UNWANTED | set(MAY_NEED_BY_NAME) | set().union(*MAY_NEED_BY_NAME.values())


def closure(allowed):
    """These libraries, those that they may need, and what they bring."""
    found = set()
    while allowed - found:
        found |= allowed
        allowed = set().union(*(MAY_NEED_BY_NAME.get(name, set()) | BROUGHT.get(name, set()) for name in found))
    return found


def problems_of_binary(file, allowed):
    name = file.relative_to(BUILD)
    may = ', '.join(sorted(allowed)) or 'nothing'
    extra = needed(file) - allowed
    if extra:
        yield f"{name} needs {', '.join(sorted(extra))}; it may need {may}"
    extra = (loaded_with(file) & WATCHED) - closure(allowed | extra)
    if extra:
        yield f"{', '.join(sorted(extra))} is loaded with {name}, which may need {may} and what comes with that"


def problems_of_binaries():
    for path, allowed in MAY_NEED.items():
        if (BUILD / path).exists():
            yield from problems_of_binary(BUILD / path, allowed)
        elif path not in OPTIONAL:
            yield f"there is no {BUILD / path}"
    for pattern in ("lib/libelsie*.so", "lib/elsie/*.so", "lib/elsie/elsie-*", "lib/elsie/engines/*.so", "bin/elsie*"):
        for file in sorted(BUILD.glob(pattern)):
            if str(file.relative_to(BUILD)) not in MAY_NEED:
                yield f"{file.relative_to(BUILD)} is not in the table of tests/architecture/check_storeys.py (MAY_NEED): add what it may need"
    plugins = sorted((BUILD / "lib" / "elsie" / "plugins").glob("*.so"))
    if not plugins:
        yield "there are no plugins"
    for file in plugins:
        yield from problems_of_binary(file, PLUGINS | EXCEPTIONS.get(file.stem, set()))


def sources(folder):
    return sorted(file for file in folder.rglob("*") if file.suffix in (".h", ".cpp"))


def problems_of_includes():
    folders = {header.name: header.parents[2] for part in ("core", "libraries") for header in (SOURCES / part).glob("**/include/elsie/*")}
    known = {module for modules in MODULES.values() for module in modules}
    for module in sorted(known ^ set(folders)):
        yield f"the module {module} is {'nowhere in core/ and libraries/' if module in known else 'not in the table of modules'}"
    for storey, modules in MODULES.items():
        below = {module for name in closure(MAY_NEED_BY_NAME[storey]) for module in MODULES.get(name, [])}
        for place, module in enumerate(modules):
            allowed = below | set(modules[: place + 1]) | HEADERS_ALONE.get(module, set())
            for file in sources(folders.get(module, SOURCES / "nowhere")):
                for used in re.findall(r'^#include [<"]elsie/(\w+)/', file.read_text(), re.M):
                    if used not in allowed:
                        yield f"{file.relative_to(SOURCES)} includes a header of {used}, which is not below {module}"


def problems_of_size():
    lines = sum(file.read_text().count("\n") for file in sources(SOURCES / "core"))
    if lines > MOST_LINES_OF_CORE:
        yield f"core/ has {lines} lines of C++, and may have {MOST_LINES_OF_CORE}: move what not every run needs into a library above it"


found = [*problems_of_binaries(), *problems_of_includes(), *problems_of_size()]
for problem in found:
    print(problem)
sys.exit(1 if found else 0)
