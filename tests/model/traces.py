#!/usr/bin/env python3
"""Random runs of the models of the stop, one a line, for tst_stop_model.

usage: traces.py MODEL FIRST COUNT [PHASES]     the runs with the seeds FIRST, FIRST + 1, ... of MODEL.pml

A line holds phases; a phase is  act,motor,line,obeys,reset,start,fates|link,armed,starts,stops,told1,told2,drives1,drives2
with what the model printed, each choice by its first letters.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PHASE = re.compile(r"phase act=(\w+) motor=(\d) line=(\w+) obeys=(\d) reset=(\d) start=(\w+)")
END = re.compile(r"end link=(\w+) armed=(\d) starts=(\d) stops=(\d) told=(\d+),(\d+) run=(\d),(\d)")
ACTS = {"NOTHING": "N", "ARM": "A", "DOSTART": "S", "DOSTOP": "X", "DOBOTH": "B"}
FATES = {"DELIVERED": "d", "ASKLOST": "q", "ANSWERLOST": "a", "TWICE": "t", "LATE": "l"}


def run(folder, model, seed, phases):
    printed = subprocess.run(["spin", "-T", f"-n{seed}", f"-u{phases * 260}", f"{model}.pml"], cwd=folder,
                             capture_output=True, text=True, check=True).stdout
    done, chosen, fates = [], None, ""
    for line in printed.splitlines():
        if found := PHASE.match(line):
            act, motor, wire, obeys, reset, start = found.groups()
            chosen, fates = [ACTS[act], motor, wire[0], obeys, reset, FATES[start]], ""
        elif line.startswith("fate "):
            fates += FATES[line[5:].strip()]
        elif (found := END.match(line)) and chosen:
            done.append(",".join(chosen + [fates]) + "|" + ",".join((found[1][0],) + found.groups()[1:]))
            chosen = None
    return ";".join(done[:phases])


def main():
    model, first, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    phases = int(sys.argv[4]) if len(sys.argv) > 4 else 12
    with tempfile.TemporaryDirectory() as folder:  # where spin leaves a file of its own
        for file in Path(__file__).resolve().parent.glob("*.pml"):
            shutil.copy(file, folder)
        for seed in range(first, first + count):
            print(run(folder, model, seed, phases))


main()
