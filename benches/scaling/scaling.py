"""Measures the rows of work.py; see `run`."""

import math
import os
import pathlib
import subprocess
import sys
import tempfile

from work import ROWS

VIROTE = os.environ["VIROTE"]
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "performance.md"
# What is repeated until it takes so long, in seconds of the processor.
ENOUGH = 0.1
# Where the answer to one size takes so long, larger ones are left out.
LONGEST = 8.0
HEAD = "geo 1\n"


def cost(folder, script):
    """Seconds of the processor that the command takes for a script on one thread, and its peak in bytes."""
    path = folder / "work.geo"
    path.write_text(script)
    command = [VIROTE, "run", str(path), "--quiet", "--threads", "1", "--out", str(folder / "out"), "--limit", "memory=8000000000"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    message = process.stderr.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise RuntimeError(message)
    return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024


def asked(given, question, times):
    """The script that asks so many times; none asks nothing."""
    if question == "DEFINITIONS":
        return HEAD + given
    if question.startswith("EXPORT"):
        ending = question.split()[1]
        lines = "".join(f'export m to "m{k}.{ending}"\n' for k in range(times))
        return HEAD + given + "\n" + lines
    line = f"let answers = [for asked in 1..{times}: {question}]\n" if times else ""
    return HEAD + given + "\n" + line


def measure(folder, given, question, size):
    """Seconds of the processor for one answer."""
    if question == "DEFINITIONS":
        chain = "let d0 = 1\n" + "".join(f"let d{k} = d{k - 1} + {k}\n" for k in range(1, size))
        return cost(folder, HEAD + chain)[0] - min(cost(folder, HEAD)[0] for _ in range(3))
    text = {"n": repr(size) if isinstance(size, float) else size}
    given, question = given.format(**text), question.format(**text)
    without = min(cost(folder, asked(given, question, 0))[0] for _ in range(3))
    times = 1
    while True:
        spent = cost(folder, asked(given, question, times))[0] - without
        if ENOUGH < spent or 1 << 17 < times:
            break
        times *= 16 if spent < ENOUGH / 16 else 4 if spent < ENOUGH / 4 else 2
    if spent < 10 * ENOUGH:
        spent = min(spent, cost(folder, asked(given, question, times))[0] - without)
    return spent / times


def exponent(sizes, costs):
    """The power of the size that fits the costs, by least squares of logarithms."""
    x, y = [math.log(s) for s in sizes], [math.log(c) for c in costs]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def spelled(seconds):
    for unit, factor in [("s", 1.0), ("ms", 1e3), ("µs", 1e6)]:
        if 1.0 <= seconds * factor or unit == "µs":
            return f"{seconds * factor:.3g} {unit}"


def counted(size):
    return f"{size:.0e}".replace("e-0", "e-") if isinstance(size, float) else f"{size:,}"


def row(folder, name, counts, sizes, given, question):
    done, costs = [], []
    for size in sizes:
        costs.append(max(measure(folder, given, question, size), 1e-9))
        done.append(size)
        if LONGEST < costs[-1]:
            break
    powers = [1.0 / s if isinstance(s, float) else s for s in done]
    fitted = exponent(powers, costs)
    ends = [f"{counted(s)}: {spelled(c)}" for s, c in ((done[0], costs[0]), (done[-1], costs[-1]))]
    return f"| {name} | {counts} | {ends[0]} | {ends[1]} | {fitted:.1f} |"


def main(words):
    write = "--write" in words
    words = [word for word in words if not word.startswith("--")]
    text = []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for chapter, rows in ROWS.items():
            head = [f"### {chapter}", "", "| work | its size | smallest | largest | exponent |", "| --- | --- | --- | --- | --- |"]
            lines = []
            for name, counts, sizes, given, question in rows:
                if words and not any(word in f"{chapter} {name}" for word in words):
                    continue
                try:
                    lines.append(row(folder, name, counts, sizes, given, question))
                except RuntimeError as wrong:
                    print(f"{name}: {str(wrong)[:600]}", file=sys.stderr)
                    continue
                print(lines[-1], flush=True)
            if lines:
                text += head + lines + [""]
    if write:
        begin, end = "<!-- scaling -->\n", "<!-- /scaling -->"
        page = PAGE.read_text()
        before, after = page.split(begin)[0], page.split(end)[1]
        PAGE.write_text(before + begin + "\n" + "\n".join(text) + "\n" + end + after)


if __name__ == "__main__":
    main(sys.argv[1:])
