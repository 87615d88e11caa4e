#!/usr/bin/env python3
"""Searches the whole state space of the models of the stop and prints its size; fails on any error or line too many.

usage: verify.py [MODEL...]      of mcp, legacy, mcb; all of them if none is named
Needs spin and a C compiler.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
MOST_LINES = 310  # of a model with what it includes; larger ones are not read any more
SEARCHES = [("assertions and dead ends", ["-DSAFETY"], []), ("phases without an end", ["-DNP"], ["-l"])]


def search(model, what, defines, options, folder):
    subprocess.run(["cc", "-O2", "-DCOLLAPSE", *defines, "-o", "pan", "pan.c"], cwd=folder, check=True)
    printed = subprocess.run(["./pan", *options, "-m1000000", "-w24"], cwd=folder, capture_output=True, text=True).stdout
    states = re.search(r"(\d+) states, stored", printed)
    depth = re.search(r"depth reached (\d+), errors: (\d+)", printed)
    complete = "Search not completed" not in printed and "max search depth" not in printed
    good = states and depth and depth[2] == "0" and complete
    print(f"{model}: {what}: {states and states[1]} states, depth {depth and depth[1]}: {'none wrong' if good else 'WRONG'}")
    return good


def main():
    missing = [tool for tool in ("spin", "cc") if shutil.which(tool) is None]
    if missing:
        print("needs", " and ".join(missing))
        return 1
    good = True
    for model in sys.argv[1:] or ["mcp", "legacy", "mcb"]:
        lines = sum(len((HERE / name).read_text().splitlines()) for name in (f"{model}.pml", "stop.pml"))
        if lines > MOST_LINES:
            print(f"{model}: {lines} lines are too many")
            good = False
        with tempfile.TemporaryDirectory() as folder:
            for file in HERE.glob("*.pml"):
                shutil.copy(file, folder)
            subprocess.run(["spin", "-a", f"{model}.pml"], cwd=folder, check=True, capture_output=True)
            for what, defines, options in SEARCHES:
                good = search(model, what, defines, options, folder) and good
    return 0 if good else 1


sys.exit(main())
