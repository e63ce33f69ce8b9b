"""Whole processes that evaluate 10 MB of definitions of lists, here and in Gmsh, in turn; the least of three."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

SIZE = 10_000_000
N_ROUNDS = 3

# Gmsh from its library, without a window.
GMSH = "import gmsh, sys; gmsh.initialize(); gmsh.option.setNumber('General.Terminal', 0); gmsh.merge(sys.argv[1]); gmsh.finalize()"


def text(definition):
    """Definitions, by their number, up to the size."""
    lines, size, i = [], 0, 0
    while size < SIZE:
        lines.append(definition(i))
        size += len(lines[-1])
        i += 1
    return "".join(lines)


def taken(command):
    """How long a process takes, in seconds; None if it fails."""
    start = time.perf_counter()
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    if done.returncode:
        print(done.stderr.decode()[-300:])
        return None
    return time.perf_counter() - start


def main():
    folder = Path(tempfile.mkdtemp())
    items = lambda i: f"{i}, {i} + 0.5, 2.25, -{i}, 1e-3, {i} * 2"
    ours, theirs = folder / "lists.geo", folder / "lists-of-gmsh.geo"
    ours.write_text("geo 1\n" + text(lambda i: f"let list_{i} = [{items(i)}]\n"))
    theirs.write_text(text(lambda i: f"list_{i}() = {{{items(i)}}};\n"))
    commands = {
        "virote": [os.environ["VIROTE"], "run", str(ours)],
        "Gmsh": [sys.executable, "-c", GMSH, str(theirs)],
    }
    times = {name: [] for name in commands}
    for _ in range(N_ROUNDS):
        for name, command in commands.items():
            times[name].append(taken(command))
    least = {name: min(t for t in all_times if t is not None) for name, all_times in times.items() if any(all_times)}
    for name, seconds in least.items():
        print(f"{name:8} {seconds * 1e3:8.0f} ms   {seconds / least.get('virote', seconds):6.1f} times virote")
    for name in commands.keys() - least.keys():
        print(f"{name} failed")


if __name__ == "__main__":
    main()
