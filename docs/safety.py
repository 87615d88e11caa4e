#!/usr/bin/env python3
"""Makes docs/safety.md from docs/safety.csv and checks what the table claims.

usage: safety.py            writes docs/safety.md
       safety.py --check    fails if a file, a symbol or a test slot that is named does not exist, if a rule has no row or
                            a row has an empty field, or if safety.md is not what this makes
       safety.py --run DIR  runs every test that is named, from the build folder DIR, and keeps the results
"""
import csv
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TABLE, PAGE, RESULTS = ROOT / "docs/safety.csv", ROOT / "docs/safety.md", ROOT / "docs/safety-results.csv"
FIRST_RULES = [f"MS{n}" for n in range(1, 35)]  # of the requirements; MS27 and on are those of experiments

HEAD = """# What can go wrong with a motor, and what keeps it from happening

Made by `docs/safety.py` from `docs/safety.csv`; a test checks that every file, function and test named here exists. *Verdict* says "holds",
or what does not. The tests run with every change; *last run* is the commit at which `docs/safety.py --run` saw them pass.

## What the program cannot do

- **It is not a safety function.** A PC on a serial line may not serve as an emergency stop, nor as STO or SS1. Use a switch that takes the
  power away, within reach, whenever a motor can move.
- With the cable out, the adapter dead or the computer without power no STOP reaches the board. The maker's firmware has no communication
  time-out: the motor turns on. Only firmware with a watchdog ([drive-watchdog.md](drive-watchdog.md)) stops then.
- With the wire from the board cut, a STOP reaches a board of the newer protocol only if this program has been connected to it since its
  start: other boards swallow what comes before an agreement, and of a board that was never heard one motor is known.
- STOP switches the power stage off. It does not brake: a motor may coast for a long time, and a load may drive it.
- A board's OK to STOP proves nothing, and its states are read over a line without a checksum over them. A board without a sensor cannot tell
  standstill from a speed too low for its observer.
- When the operating system hangs, nothing of this program runs.
- On Windows signals (Ctrl-C) do not stop the motor, and no STOP is sent after the program has died. Nothing was tried on macOS.
- Root, or who has the port open already, can send the board anything. The program does not refuse to run as root, because containers
  and test machines do; it needs no more rights than those of the group `dialout`.
- The command line asks nothing: the command is the confirmation. `start` leaves a motor running, as it was told.

"""


def rows():
    with TABLE.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter=";", quoting=csv.QUOTE_NONE))


def names(field):
    return [tuple(part.strip().split(":", 1)) for part in field.split(",")]


def results():
    if not RESULTS.exists():
        return {}
    with RESULTS.open(encoding="utf-8", newline="") as file:
        return {row[0]: row[1:] for row in csv.reader(file, delimiter=";") if row}


def page():
    known = results()
    lines = [HEAD, "## The table\n", "| rule | hazard | how it comes about | kept by | tests | last run | verdict |",
             "|---|---|---|---|---|---|---|"]
    for row in rows():
        kept = "<br>".join(f"`{path}`" + (f" {symbol}" if symbol else "") for path, symbol in names(row["kept by"]))
        tests = "<br>".join(f"`{Path(path).stem}` {slot}" for path, slot in names(row["tests"]))
        last = "<br>".join(known.get(f"{Path(path).stem}::{slot}", ["not on record"])[0]
                           for path, slot in names(row["tests"]))
        lines.append(f"| {row['rule']} | {row['hazard']} | {row['cause']} | {kept} | {tests} | {last} | {row['verdict']} |")
    return "\n".join(lines) + "\n"


def wrong():
    seen = []
    for row in rows():
        seen.append(row["rule"])
        for name, field in row.items():
            if not (field or "").strip():
                yield f"{row['rule']}: {name} is empty"
        for path, symbol in names(row["kept by"]) + names(row["tests"]):
            file = ROOT / path
            if not file.exists():
                yield f"{row['rule']}: there is no {path}"
            elif symbol and not re.search(rf"\b{re.escape(symbol)}\b", file.read_text(encoding="utf-8")):
                yield f"{row['rule']}: {path} has no {symbol}"
        for path, symbol in names(row["tests"]):
            file = ROOT / path
            if file.exists() and not re.search(rf"\bvoid (\w+::)?{re.escape(symbol)}\(\)", file.read_text(encoding="utf-8")):
                yield f"{row['rule']}: {path} has no slot {symbol}"
    for rule in FIRST_RULES:
        if rule not in seen:
            yield f"{rule} has no row"
    for rule in set(seen):
        if seen.count(rule) > 1:
            yield f"{rule} has two rows"
    if not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page():
        yield "docs/safety.md is not what docs/safety.py makes; run it"


def run(build):
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True,
                            check=True).stdout.strip()
    kept = results()
    for row in rows():
        for path, slot in names(row["tests"]):
            program = Path(build) / "tests" / Path(path).stem
            if not program.exists():
                continue
            ended = subprocess.run([program, slot], cwd=ROOT, capture_output=True, timeout=600,
                                   env={"QT_QPA_PLATFORM": "offscreen", **os.environ})
            kept[f"{Path(path).stem}::{slot}"] = [f"{commit} {'passed' if ended.returncode == 0 else 'FAILED'}"]
    with RESULTS.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, delimiter=";", lineterminator="\n").writerows([key] + kept[key] for key in sorted(kept))


def main():
    if "--check" in sys.argv:
        found = list(wrong())
        print("\n".join(found) or "every line of docs/safety.csv is as it says")
        return 1 if found else 0
    if "--run" in sys.argv:
        run(sys.argv[sys.argv.index("--run") + 1])
    PAGE.write_text(page(), encoding="utf-8")
    return 0


sys.exit(main())
