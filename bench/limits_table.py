#!/usr/bin/env python3
"""How well the program keeps --time-limit and --max-memory, on inputs of a million nodes.

    limits_table.py PROGRAM [WORD...]

Runs each command that has all WORDs in its name without a limit, then with several, and prints the
seconds and megabytes that it took beside those it was given. What is more than a tenth over, stops
with a tenth to spare, or ends otherwise than with exit code 5 and one line, is marked. The inputs
are kept in $TMPDIR/wellspaced_limits and made where they are missing.
"""
import os
import shutil
import subprocess
import sys
import tempfile
import time

SECONDS = (1, 2, 5)
PARTS_OF_PEAK = (0.25, 0.5, 0.75, 1.1)
SLACK = 1.1
LONGEST = 120  # seconds without a limit

INPUTS = {
    "grid": "generate grid --nx 1000 --ny 1000 --diagonals mixed:0.13 -o grid",
    "random.node": "generate random --nodes 1000000 -o random.node",
    "mesh": "triangulate random.node -o mesh",
    "lattice.node": "generate lattice3 -o lattice.node",
    "solid": "triangulate lattice.node -o solid",
    "levels": "coarsen grid -o levels",
    "square.poly": None,
}
SQUARE = "4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n"

# {out} is a new directory.
COMMANDS = {
    "generate random": "generate random --nodes 20000000 -o {out}/x.node",
    "generate grid": "generate grid --nx 3000 --ny 3000 -o {out}/x",
    "generate airfoil": "generate airfoil --nodes 1000000 -o {out}/x",
    "triangulate": "triangulate random.node -o {out}/x",
    "triangulate space": "triangulate lattice.node -o {out}/x",
    "mesh": "mesh square.poly --size 0.001 -o {out}/x",
    "convert": "convert mesh {out}/x.vtu",
    "coarsen": "coarsen grid -o {out}/levels",
    "coarsen thesis": "coarsen grid --profile thesis -o {out}/levels",
    "coarsen mis": "coarsen grid --method mis -o {out}/levels",
    "coarsen quality": "coarsen grid --profile quality -o {out}/levels",
    "coarsen threshold": "coarsen grid --method threshold -o {out}/levels",
    "coarsen quasi-uniform": "coarsen grid --method quasi-uniform -o {out}/levels",
    "coarsen quadtree": "coarsen grid --method quadtree -o {out}/levels",
    "coarsen from-finest": "coarsen grid --scheme from-finest -o {out}/levels",
    "coarsen coarse-to-fine": "coarsen grid --scheme coarse-to-fine -o {out}/levels",
    "coarsen euclidean": "coarsen grid --metric euclidean -o {out}/levels",
    "coarsen geodesic": "coarsen grid --metric geodesic -o {out}/levels",
    "coarsen special-lfs": "coarsen grid --special-lfs -o {out}/levels",
    "coarsen full": "coarsen grid --stats full --report {out}/x.html -o {out}/levels",
    "coarsen matrices": "coarsen grid --transfers mtx,petsc,npz -o {out}/levels",
    "audit": "audit mesh",
    "audit spacing": "audit mesh --spacing nn",
    "audit space": "audit solid --spacing nn",
    "audit levels": "audit levels",
    "audit picture": "audit mesh --vtu {out}/x.vtu",
}


def run(words, **options):
    """Seconds, peak megabytes, exit code and the last line of what it said."""
    with tempfile.TemporaryFile() as said:
        start = time.monotonic()
        child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=said, **options)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.monotonic() - start
        said.seek(0)
        lines = said.read().decode(errors="replace").strip().splitlines()
    return seconds, usage.ru_maxrss * 1024 / 1e6, child.returncode, lines[-1] if lines else ""


def run_command(program, command, *limit):
    """The same in a new directory, and whether a half-written file stayed there."""
    out = tempfile.mkdtemp()
    try:
        result = run([program, *command.format(out=out).split(), *limit])
        parts = [f for _, _, files in os.walk(out) for f in files if ".part" in f]
        return *result, bool(parts)
    finally:
        shutil.rmtree(out)


def make_inputs(program):
    for name, command in INPUTS.items():
        if os.path.exists(name) or os.path.exists(name + ".node"):
            continue
        if command is None:
            with open(name, "w") as file:
                file.write(SQUARE)
        else:
            subprocess.run([program, *command.split(), "--quiet"], check=True)


def verdict(used, given, needed, code, line, half_written):
    faults = []
    if code == 5 and SLACK * needed <= given:
        faults.append("STOPPED")
    if used > SLACK * given:
        faults.append("OVER")
    if code not in (0, 1, 5) or (code == 5 and not line):
        faults.append(f"exit code {code}")
    if half_written:
        faults.append("HALF WRITTEN")
    return " ".join(faults)


def print_row(name, limit, unit, used, needed, rest):
    code, line, half_written = rest
    print(f"{name:24} {limit:8.4g} {unit:2} {used:9.3f} {used / limit:6.2f}  {code}  "
          f"{verdict(used, limit, needed, code, line, half_written)}  {line[:90]}", flush=True)


def table(program, name, command):
    seconds, megabytes, code, line, _ = run_command(program, command, "--time-limit", str(LONGEST))
    print(f"{name:24}     none    {seconds:8.2f} s {megabytes:.0f} MB  {code}  {line[:90]}", flush=True)
    for limit in SECONDS:
        used, _, *rest = run_command(program, command, "--time-limit", str(limit))
        print_row(name, limit, "s", used, seconds, rest)
    for part in PARTS_OF_PEAK:
        limit = part * megabytes
        _, used, *rest = run_command(program, command, "--max-memory", f"{limit:.1f}")
        print_row(name, limit, "MB", used, megabytes, rest)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, words = os.path.abspath(sys.argv[1]), sys.argv[2:]
    folder = os.path.join(tempfile.gettempdir(), "wellspaced_limits")
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    make_inputs(program)
    for name, command in COMMANDS.items():
        if all(word in name.split() for word in words):
            table(program, name, command)


main()
