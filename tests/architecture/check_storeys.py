"""Compares what each library, program and plugin asks the system's loader for, and which headers each module includes, with what its storey
may use. Also holds the core to its size.

  check_storeys.py BUILD_FOLDER SOURCE_FOLDER
"""
import re
import sys
from pathlib import Path

from storeys import (EXCEPTIONS, HEADERS_ALONE, MAY_NEED, MAY_NEED_BY_NAME, MODULES, OPTIONAL, PLUGINS, UNWANTED, closure, folders_of_modules, lines,
                     loaded_with, needed, sources)

BUILD = Path(sys.argv[1])
SOURCES = Path(sys.argv[2])

MOST_LINES_OF_CORE = 28_000
WATCHED = UNWANTED | set(MAY_NEED_BY_NAME) | set().union(*MAY_NEED_BY_NAME.values())


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
                yield f"{file.relative_to(BUILD)} is not in the table of tests/architecture/storeys.py (MAY_NEED): add what it may need"
    plugins = sorted((BUILD / "lib" / "elsie" / "plugins").glob("*.so"))
    if not plugins:
        yield "there are no plugins"
    for file in plugins:
        yield from problems_of_binary(file, PLUGINS | EXCEPTIONS.get(file.stem, set()))


def problems_of_includes():
    folders = folders_of_modules(SOURCES)
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
    size = lines(sources(SOURCES / "core"))
    if size > MOST_LINES_OF_CORE:
        yield f"core/ has {size} lines of C++, and may have {MOST_LINES_OF_CORE}: move what not every run needs into a library above it"


found = [*problems_of_binaries(), *problems_of_includes(), *problems_of_size()]
for problem in found:
    print(problem)
sys.exit(1 if found else 0)
