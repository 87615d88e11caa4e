#!/usr/bin/env python3
"""Mutation check of the stop path: small defects are put into it one by one, and the fast tests beside it have to fail.

    tests/mutation/mutate.py --build build/dev [--only TEXT] [--sample N] [--seed S] [--jobs N]   tries mutants, prints a table
    tests/mutation/mutate.py --list [--only TEXT]                                                 only names them
    tests/mutation/mutate.py --check           every line of survivors.csv still names a mutant, and says why it survives

The source is edited in place and put back, also when this is interrupted: run it in a copy of the tree. A mutant that does
not build is none. More than 5 % of survivors, or one without its reason in survivors.csv (file;line as it was;line as it
is;reason), is a failure.
"""
import argparse
import csv
import pathlib
import random
import re
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from seeded_defects import ROOT, judged  # noqa: E402  (builds a test and runs it)

SURVIVORS = pathlib.Path(__file__).resolve().parent / "survivors.csv"
MOST_SURVIVORS = 0.05

# What is mutated, and the tests that judge it, the most telling first.
PATH = {
    "core/drive/stop_sequence.cpp": ["tst_stop_sequence", "tst_mcp_drive_stop", "tst_stop_model"],
    "core/drive/stop_sequence.h": ["tst_stop_sequence", "tst_mcp_drive_stop"],
    "core/drive/wish_drive.cpp": ["tst_late_wishes", "tst_mcp_drive_stop", "tst_motion_limits", "tst_motion_record"],
    "core/drive/wish_queue.h": ["tst_late_wishes", "tst_mcp_drive_stop", "tst_mcp_drive_writes"],
    "core/drive/task_drive.h": ["tst_late_wishes", "tst_mcp_drive_stop", "tst_mcp_drive_faults"],
    "core/drive/motion_caution.cpp": ["tst_motion_caution"],
    "core/drive/motion_limits.cpp": ["tst_motion_limits"],
    "core/drive/motion_of.cpp": ["tst_motion_record"],
    "core/drive/set_point_check.cpp": ["tst_motion_limits", "tst_what_may_be_written", "tst_mcp_drive_writes"],
    "core/drive/start_target.cpp": ["tst_start_target"],
    "core/drive/write_check.cpp": ["tst_what_may_be_written", "tst_mcp_drive_writes"],
    "core/session/link/dead_man.cpp": ["tst_dead_man"],
    "core/session/link/time_gap.h": ["tst_dead_man"],
    "core/session/link/driven_motors.cpp": ["tst_session_guardian"],
    "core/session/link/stop_page_posix.cpp": ["tst_guardian_posix", "tst_session_guardian"],
    "core/session/link/guardian_posix.cpp": ["tst_guardian_posix"],
    "widgets/window/shutdown.cpp": ["tst_leaving", "tst_stop"],
}

COMPARISONS = {"<=": ["<"], ">=": [">"], "<": ["<="], ">": [">="], "==": ["!="], "!=": ["=="]}


def spliced(line, start, end, text):
    return line[:start] + text + line[end:]


def mutants_of(line):
    """(operator, line instead) for each small defect of one line of code."""
    code = re.sub(r'"(?:\\.|[^"\\])*"', lambda text: "_" * len(text.group()), line).split("//")[0]
    for found in re.finditer(r"(?<=\s)(<=|>=|==|!=|<|>)(?=\s)", code):
        for other in COMPARISONS[found.group()]:
            yield "comparison", spliced(line, found.start(), found.end(), other)
    for found in re.finditer(r"&&|\|\|", code):
        if "operator" not in code:
            yield "and, or", spliced(line, found.start(), found.end(), "||" if found.group() == "&&" else "&&")
    for found in re.finditer(r"(?<![\w.'])\d+(?![\w.'])", code):
        for step in (1, -1):
            yield "constant", spliced(line, found.start(), found.end(), f"({found.group()} {step:+d})")
    negated = re.match(r"^(\s*(?:\} else )?(?:if|while) \()(?!const |auto |.*;)(.*)(\)(?: \{)?)$", line)
    if negated:
        yield "negation", f"{negated[1]}!({negated[2]}){negated[3]}"
    for found in re.finditer(r"(?<![\w!])!(?=[\w(])", code):
        yield "negation", spliced(line, found.start(), found.end(), "")
    if re.match(r"^\s+(?!return|break|continue|case|using|const |auto |struct|static)[\w.>*()\[\]:-]+( [-+]?= .*|\(.*\));$", code.rstrip()):
        yield "statement", re.match(r"^\s*", line).group() + "static_cast<void>(0);"
    if re.match(r"^\s+return (?!\{\};)[^;]*;$", code.rstrip()):
        yield "return", re.match(r"^\s*", line).group() + "return {};"
    found = re.search(r"\b(true|false)\b", code)
    if found:
        yield "truth", spliced(line, found.start(), found.end(), "false" if found.group() == "true" else "true")


def all_mutants(only):
    for file in PATH:
        path = ROOT / file
        if only not in file or not path.exists():
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if re.match(r"\s*(//|#|namespace|using|\*|template)", line) or not line.startswith(" "):
                continue
            for operator, other in mutants_of(line):
                if other != line:
                    yield file, number, operator, line, other


def excused():
    if not SURVIVORS.exists():
        return {}
    with SURVIVORS.open(newline="") as file:
        rows = csv.reader(file, delimiter=";")
        return {(row[0], row[1].strip(), row[2].strip()): row[3].strip() for row in rows if row}


def check():
    there = {(file, old.strip(), new.strip()) for file, _, _, old, new in all_mutants("")}
    wrong = [f"no such mutant any more: {key}" for key in excused() if key not in there]
    wrong += [f"no reason: {key}" for key, reason in excused().items() if len(reason) < 20]
    print("\n".join(wrong) or f"{len(excused())} survivors, each with its reason")
    return 1 if wrong else 0


def try_one(mutant, build, jobs):
    file, number, _, _, other = mutant
    path = ROOT / file
    kept = path.read_text()
    lines = kept.split("\n")
    lines[number - 1] = other
    try:
        path.write_text("\n".join(lines))
        for test in PATH[file]:
            if not list((ROOT / "tests").rglob(f"{test}.cpp")):
                continue
            code, _ = judged(build, jobs, test)
            if code is None:
                return "no mutant"
            if code != 0:
                return f"killed by {test}"
        return "SURVIVED"
    finally:
        path.write_text(kept)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--build", default="build/dev")
    options.add_argument("--only", default="", help="files whose names have this text")
    options.add_argument("--sample", type=int, help="so many of them, chosen by --seed")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", default="2")
    options.add_argument("--list", action="store_true")
    options.add_argument("--check", action="store_true")
    given = options.parse_args()
    if given.check:
        return check()
    mutants = list(all_mutants(given.only))
    if given.list:
        for file, number, operator, _, other in mutants:
            print(f"{file}:{number}: {operator}: {other.strip()}")
        print(len(mutants), "mutants")
        return 0
    whole = len(mutants)
    if given.sample and given.sample < whole:
        mutants = sorted(random.Random(given.seed).sample(mutants, given.sample))
    # A test that fails without any mutant would kill them all.
    for test in {test for mutant in mutants for test in PATH[mutant[0]]}:
        if list((ROOT / "tests").rglob(f"{test}.cpp")) and judged(given.build, given.jobs, test)[0] != 0:
            print(f"{test} fails, or does not build, as the source is now: nothing can be judged")
            return 1
    known, tried, survivors, unexplained = excused(), 0, 0, 0
    print("| place | operator | as it is then | result |\n|---|---|---|---|", flush=True)
    for mutant in mutants:
        file, number, operator, old, other = mutant
        begun = time.monotonic()
        result = try_one(mutant, given.build, given.jobs)
        if result == "no mutant":
            continue
        tried += 1
        if result == "SURVIVED":
            reason = known.get((file, old.strip(), other.strip()))
            survivors += 1
            unexplained += reason is None
            result += f": {reason}" if reason else ", without a reason"
        seconds = round(time.monotonic() - begun)
        print(f"| {file}:{number} | {operator} | `{other.strip()}` | {result}, {seconds} s |", flush=True)
    print(f"\n{tried} mutants of {whole}, {tried - survivors} killed, {survivors} survived, {unexplained} of them without a reason")
    return 1 if unexplained or survivors > MOST_SURVIVORS * max(tried, 1) else 0


if __name__ == "__main__":
    sys.exit(main())
