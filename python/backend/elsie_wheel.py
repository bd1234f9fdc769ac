"""Builds a wheel of Elsie for pip (PEP 517), by CMake and the standard library of Python alone.

The wheel has the package `elsie`, and all that Elsie installs under elsie/_root: libraries, plugins, worlds, the program. They find each other by
relative paths, as in any other place.

    pip install . --config-settings build-folder=build/release     # takes what is built there
"""
import base64
import csv
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent.parent


def _project():
    project = tomllib.loads((SOURCE / "pyproject.toml").read_text())["project"]
    project["version"] = re.search(r"^project\(elsie VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text(), re.M)[1]
    return project


def _run(*command):
    try:
        subprocess.run([str(word) for word in command], cwd=SOURCE, check=True)
    except FileNotFoundError:
        sys.exit(f"elsie: there is no {command[0]}; run scripts/install-dependencies --python, as root or with sudo")
    except subprocess.CalledProcessError as error:
        sys.exit(f"elsie: `{' '.join(map(str, command))}` failed ({error.returncode}); "
                 "if a package is missing, scripts/install-dependencies --python installs it")


def _built(settings):
    """The folder of a build for this Python."""
    given = (settings or {}).get("build-folder")
    if given:
        folder = SOURCE / given
        if not (folder / "CMakeCache.txt").exists():
            sys.exit(f"elsie: build-folder={given} is no build of Elsie; `make python` makes build/release")
        return folder
    folder = SOURCE / "build" / f"wheel-{sysconfig.get_python_version()}"
    _run("cmake", "-S", ".", "-B", folder, "-G", "Ninja", "--log-level=WARNING", "-DCMAKE_BUILD_TYPE=Release", "-DELSIE_BUILD_TESTS=OFF",
         "-DELSIE_BUILD_BENCHMARKS=OFF", f"-DPython3_EXECUTABLE={sys.executable}")
    _run("cmake", "--build", folder, "--target", "elsie_python_complete", "elsie_help")
    return folder


def _metadata(project):
    extras = project["optional-dependencies"]
    return "\n".join([
        "Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {project['version']}", f"Summary: {project['description']}",
        f"License: {project['license']['text']}", f"Requires-Python: {project['requires-python']}",
        *(f"Requires-Dist: {need}" for need in project["dependencies"]),
        *(f"Provides-Extra: {extra}\nRequires-Dist: {need}; extra == '{extra}'" for extra in extras for need in extras[extra]),
        "Description-Content-Type: text/markdown", "", (SOURCE / project["readme"]).read_text()])


def get_requires_for_build_wheel(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = _project()
    build = _built(config_settings)
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{tag}-{tag}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    name = f"{project['name']}-{project['version']}"
    with tempfile.TemporaryDirectory() as stage:
        root = Path(stage) / "elsie" / "_root"
        _run("cmake", "--install", build, "--prefix", root, "--strip")
        _run("cmake", "--install", build, "--prefix", root, "--strip", "--component", "python")
        packages = root / "lib" / "python3" / "dist-packages"
        module = f"_elsie.{sysconfig.get_config_var('SOABI')}.so"
        if not (packages / "elsie" / module).exists():
            sys.exit(f"elsie: {build} has no {module}, the module for Python {sysconfig.get_python_version()}; "
                     "`make python` builds one for Debian's Python")
        shutil.copytree(packages / "elsie", Path(stage) / "elsie", dirs_exist_ok=True)
        shutil.rmtree(root / "lib" / "python3")
        info = Path(stage) / f"{name}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(_metadata(project))
        (info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: elsie\nRoot-Is-Purelib: false\nTag: {tag}\n")
        scripts = "".join(f"{script} = {place}\n" for script, place in project["scripts"].items())
        (info / "entry_points.txt").write_text(f"[console_scripts]\n{scripts}")
        wheel = f"{name}-{tag}.whl"
        rows = []
        with zipfile.ZipFile(Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
            # Links become files: a wheel has none.
            for path in sorted(Path(folder) / file for folder, _, files in os.walk(stage, followlinks=True) for file in files):
                place, content = str(path.relative_to(stage)), path.read_bytes()
                entry = zipfile.ZipInfo(place)
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = (0o100000 | path.stat().st_mode & 0o777) << 16
                archive.writestr(entry, content)
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                rows.append((place, f"sha256={digest}", len(content)))
            rows.append((f"{info.name}/RECORD", "", ""))
            record = io.StringIO()
            csv.writer(record, lineterminator="\n").writerows(rows)
            archive.writestr(f"{info.name}/RECORD", record.getvalue())
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """What the repository has, as it is here."""
    project = _project()
    name = f"{project['name']}-{project['version']}"
    files = subprocess.run(["git", "-C", SOURCE, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout.split("\0")
    with tarfile.open(Path(sdist_directory) / f"{name}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in filter(None, files):
            archive.add(SOURCE / file, f"{name}/{file}", recursive=False)
        metadata = _metadata(project).encode()
        entry = tarfile.TarInfo(f"{name}/PKG-INFO")
        entry.size = len(metadata)
        archive.addfile(entry, io.BytesIO(metadata))
    return f"{name}.tar.gz"
