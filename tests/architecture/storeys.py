"""What each library, program, plugin and module may use, and how a file says what it uses: for check_storeys.py and scripts/library-table."""
import re
import subprocess
from pathlib import Path

# The C++ runtime, which everything may use; the sanitizers' libraries belong to it.
RUNTIME = {"libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64", "ld-linux-aarch64", "libasan", "libubsan", "libtsan"}

# What each library and program may name in its link line, besides the runtime: other storeys, and libraries that are not Elsie's.
MAY_NEED = {
    "lib/libelsie-base.so": set(),
    "lib/libelsie.so": {"libelsie-base", "libexpat"},
    "lib/libelsie-files.so": {"libelsie-base"},
    "lib/libelsie-formula.so": {"libelsie-base", "libmuparser"},
    "lib/libelsie-inference.so": {"libelsie-base", "libelsie-files"},
    "lib/libelsie-workshop.so": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-formula", "libelsie-inference"},
    "lib/libelsie-editing.so": {"libelsie-base", "libelsie"},
    "lib/libelsie-render.so": {"libelsie-base", "libelsie", "libepoxy"},
    "lib/libelsie-views.so": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-render", "libcairo", "libcgraph", "libgvc", "libzstd", "libz"},
    "lib/libelsie-testing.so": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-render", "libelsie-workshop"},
    "lib/libelsie-session.so": {"libelsie-base"},
    "lib/libelsie-server.so": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-editing", "libelsie-session", "libelsie-render", "libelsie-views",
                                "libelsie-workshop"},
    "lib/libelsie-experiments.so": {"libelsie-base", "libelsie", "libelsie-formula", "libelsie-render", "libelsie-workshop"},
    "lib/libelsie-studies.so": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-render", "libelsie-views", "libelsie-workshop", "libelsie-experiments", "libelsie-formula", "libsqlite3",
                                 "libcrypto"},
    "lib/libelsie-vision.so": {"libelsie-base", "libelsie", "libopencv_core", "libopencv_imgproc"},
    "lib/elsie/images.so": {"libelsie-base", "libelsie", "libpng16"},
    "lib/elsie/layouts.so": {"libelsie-base", "libelsie"},
    "lib/elsie/python.so": {"libelsie-base", "libelsie"},
    "lib/elsie/engines/ode.so": {"libelsie-base", "libelsie", "libode"},
    "lib/elsie/engines/planar.so": {"libelsie-base", "libelsie"},
    "lib/elsie/elsie-commands.so": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-inference", "libelsie-workshop", "libelsie-editing", "libelsie-render",
                                    "libelsie-views", "libelsie-testing", "libelsie-server", "libelsie-experiments", "libelsie-studies", "libspdlog",
                                    "libfmt"},
    "bin/elsie": {"libelsie-base", "libelsie-files", "libelsie", "libelsie-workshop", "libspdlog", "libfmt"},
    "bin/elsie-desktop": {"libelsie-base", "libelsie-files", "libelsie-inference", "libelsie-render", "libelsie-views", "libelsie-session", "libQt6Svg", "libQt6Widgets", "libQt6Gui", "libQt6Core"},
}
OPTIONAL = {"bin/elsie-desktop", "lib/elsie/python.so"}
PLUGINS = {"libelsie-base", "libelsie", "libelsie-inference"}
# By plugin: the libraries of others that it may need.
EXCEPTIONS = {name: {"libelsie-formula"} for name in ("arbiter_learning", "arbiter_spreading_activation", "arbiter_states", "arbiter_tree", "reward")}

# The libraries that must come with no storey by a detour: those above, and these; and what some of them bring themselves.
UNWANTED = {"libGL", "libEGL"}
BROUGHT = {
    "libcairo": {"libpng16"},
    "libgvc": {"libexpat", "libz"},
    "libpng16": {"libz"},
    "libopencv_core": {"libz"},
    "libQt6Gui": {"libGL", "libEGL", "libpng16"},
}

# The modules of each storey, in the order of docs/internals/architecture.md: none includes a header of a later one.
MODULES = {
    "libelsie-base": ["base", "shapes"],
    "libelsie": ["api", "plugin", "world", "physics", "simulation"],
    "libelsie-files": ["files"],
    "libelsie-formula": ["formula"],
    "libelsie-inference": ["fuzzy", "neural", "learning"],
    "libelsie-workshop": ["process", "build", "reference", "check"],
    "libelsie-editing": ["editing"],
    "libelsie-render": ["render"],
    "libelsie-views": ["traces", "picture", "mcap", "recording", "page", "live"],
    "libelsie-testing": ["testing"],
    "libelsie-session": ["snapshots", "client"],
    "libelsie-server": ["server"],
    "libelsie-experiments": ["experiment"],
    "libelsie-studies": ["results", "batch", "cluster", "report"],
}
HEADERS_ALONE = {"shapes": {"api"}, "snapshots": {"api"}}  # what they use of its headers is inline


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


def closure(allowed):
    """These libraries, those that they may need, and what they bring."""
    found = set()
    while allowed - found:
        found |= allowed
        allowed = set().union(*(MAY_NEED_BY_NAME.get(name, set()) | BROUGHT.get(name, set()) for name in found))
    return found


def sources(folder):
    return sorted(file for file in folder.rglob("*") if file.suffix in (".h", ".cpp"))


def folders_of_modules(root):
    """The folder of each module, by its name."""
    return {header.name: header.parents[2] for part in ("core", "libraries") for header in (root / part).glob("**/include/elsie/*")}


def lines(files):
    return sum(file.read_text().count("\n") for file in files)
