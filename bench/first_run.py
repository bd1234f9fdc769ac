"""Measures how long a newcomer waits for `make demo` on a bare Debian 12.

  first_run.py     as root, with debootstrap; makes a small Debian system in a temporary folder, and removes it
"""
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
STEPS = {
    "`make demo`: packages": "scripts/install-dependencies --program",
    "`make demo`: builds the program, and runs a world": "make demo",
}


def inside(system, command):
    """Runs a command in the clone of the small system, with mounts that end with it."""
    script = f"""
        mount -t proc proc '{system}/proc' && mount --bind /dev '{system}/dev' && mount -t tmpfs tmpfs '{system}/tmp' &&
        exec chroot '{system}' env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root sh -c 'cd /root/elsie && {command}'"""
    done = subprocess.run(["unshare", "--mount", "sh", "-c", script], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"first_run: `{command}` ended with {done.returncode}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")


if os.geteuid() != 0 or not shutil.which("debootstrap"):
    sys.exit("first_run: this needs root and debootstrap")
with tempfile.TemporaryDirectory(prefix="first_run-", dir="/var/tmp") as folder:
    made = subprocess.run(["debootstrap", "--variant=minbase", "--include=git,make,ca-certificates", "bookworm", folder], capture_output=True, text=True)
    if made.returncode != 0:
        sys.exit(f"first_run: debootstrap failed:\n{made.stdout[-2000:]}{made.stderr[-2000:]}")
    subprocess.run(["git", "clone", "--quiet", str(ROOT), f"{folder}/root/elsie"], check=True)
    print("| step | time, s |\n|---|---|")
    for step, command in STEPS.items():
        began = time.monotonic()
        inside(folder, command)
        print(f"| {step} | {time.monotonic() - began:.0f} |")
