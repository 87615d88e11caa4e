#!/usr/bin/env python3
"""Runs what takes hours, and writes down what ran: `./dev campaign [HOURS] [--only PART...]` starts it.

Parts, in this order; what there is no time left for is named and left out:
  fuzz      every fuzz target for its share of half the time, with ASan and UBSan
  sessions  the seeded campaigns of sessions with faults, from the first seed that no row of theirs has
  long      soaks, kills and the monkey, each test program with ROTORSCOPE_LONG=1
  asan      every test with ASan and UBSan
  tsan      every test with TSan
  locales   every test without a window, in German, Turkish and Arabic
Each run of a target is a row of the table in docs/reliability.md, appended between two marks there; sums are made of the
rows. A row says what ran and at which commit; it is written when the run has ended, also with findings. The script never
takes a row away. Exit status 1 if anything was found.
"""

import argparse
import datetime
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "docs" / "reliability.md"
ROWS = ("<!-- campaign rows -->", "<!-- end of campaign rows -->")
SUMS = ("<!-- campaign sums -->", "<!-- end of campaign sums -->")
PARTS = ("fuzz", "sessions", "long", "asan", "tsan", "locales")
LOCALES = ("de_DE.UTF-8", "tr_TR.UTF-8", "ar_EG.UTF-8")
# The campaigns of sessions, and the function that plays them. Which seeds: tests/support/seeds.h. A program that has
# played n sessions by its rows has had no seed above n, so the next run begins at n + 1 and repeats nothing.
SESSIONS = {"tst_mcb_sessions": "everythingEndsOnceWhateverHappens",
            "tst_controller_faults": "everyRequestEndsOnceAndTheLinkComesBack",
            "tst_mcp_drive_faults": "underRandomFaultsEachWishEndsOnceAndTheLinkComesBack",
            "tst_legacy_drive_faults": "everyWishEndsOnceAndNoValueGoesAstray",
            "tst_liars": "noLieMisleadsTheDrive",
            "tst_experiment_faults": "whateverHappensNothingIsLeftWithoutASentence",
            "tst_session_experiment_faults": "whateverIsPulledItEndsOnceAndNothingIsLeftUnsaid"}
PLAYED = "sessions with faults"
# The tests that have another long form, and its functions where not all of them; each is a row.
LONG = {"tst_mcp_drive_faults": ["oneFaultAtAnyByteIsOvercome", "aStopGetsThroughABadLine"],
        "tst_fault_classes": [], "tst_unplug_anywhere": [], "tst_recording_kill": [], "tst_kept_files_posix": [],
        "tst_setpoints": [], "tst_cli_readme_posix": [], "tst_soak": [], "tst_monkey": [], "tst_guardian_posix": []}


def commit():
    """The short name of the commit, with a + if files differ from it."""
    def git(*args):
        return subprocess.run(["git", "-c", "safe.directory=*", *args], cwd=ROOT, capture_output=True, text=True).stdout
    changed = [line for line in git("status", "--porcelain", "-uno").splitlines() if "docs/reliability.md" not in line]
    return git("rev-parse", "--short=7", "HEAD").strip() + ("+" if changed else "")


def between(text, marks):
    begin = text.index(marks[0]) + len(marks[0])
    return begin, text.index(marks[1], begin)


def rows_of(text):
    """The rows as lists of cells, oldest first."""
    begin, end = between(text, ROWS)
    return [[cell.strip() for cell in line.strip("|").split("|")]
            for line in text[begin:end].strip().splitlines() if line.startswith("| 2")]


def sums_of(rows):
    """Executions and findings of each target over all rows, as lines of a table."""
    sums = {}
    for row in rows:
        entry = sums.setdefault((row[2], row[3]), [0, 0])
        entry[0] += int(row[4].replace(",", ""))
        entry[1] += int(row[7])
    lines = ["| Target | What is counted | In all | Findings |", "|---|---|---|---|"]
    for (target, what), (count, found) in sorted(sums.items()):
        lines.append(f"| `{target}` | {what} | {count:,} | {found} |")
    fuzzed = sum(count for (_, what), (count, _) in sums.items() if what == "executions")
    lines.append(f"| **all fuzz targets** | executions | **{fuzzed:,}** | |")
    return lines


def add_row(target, what, count, seconds, how, findings, at=None):
    """Appends a row and makes the sums anew; the file is replaced whole."""
    today = datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d")
    text = TABLE.read_text(encoding="utf-8")
    row = f"| {today} | {at or commit()} | {target} | {what} | {count:,} | {round(seconds)} | {how} | {findings} |"
    _, end = between(text, ROWS)
    text = text[:end] + row + "\n" + text[end:]
    begin, end = between(text, SUMS)
    text = text[:begin] + "\n" + "\n".join(sums_of(rows_of(text))) + "\n" + text[end:]
    new = TABLE.with_suffix(".new")
    new.write_text(text, encoding="utf-8")
    os.replace(new, TABLE)
    print(f"campaign: {row}", flush=True)


class Budget:
    """How much time there is, and what had none."""

    def __init__(self, hours):
        self.begin = time.monotonic()
        self.end = self.begin + 3600 * hours
        self.left_out = []

    def left(self):
        return self.end - time.monotonic()

    def allows(self, what):
        if self.left() > 0:
            return True
        self.left_out.append(what)
        return False


def build(preset, *targets):
    """Configures and builds; ends the campaign if that fails."""
    jobs = str(os.cpu_count() or 2)
    subprocess.run(["cmake", "--preset", preset, "-Wno-dev", "--log-level=WARNING"], cwd=ROOT, check=True)
    command = ["cmake", "--build", f"build/{preset}", "--parallel", jobs]
    subprocess.run(command + (["--target", *targets] if targets else []), cwd=ROOT, check=True)


def stands(target, artifact):
    """Whether a script is slow or endless by itself, and not because the machine stood still meanwhile."""
    begin = time.monotonic()
    try:
        alone = subprocess.run([str(target), str(artifact)], capture_output=True, timeout=60)
    except subprocess.TimeoutExpired:
        return True
    return alone.returncode != 0 or time.monotonic() - begin > 10


def run_fuzzer(target, seconds, folder, how="ASan, UBSan", nice=0, runs=None):
    """One target for so long or so often, going on over what it found before. @return whether it found something"""
    name = target.name
    corpus = folder / "corpus" / name
    corpus.mkdir(parents=True, exist_ok=True)
    found = folder / "found" / name
    found.mkdir(parents=True, exist_ok=True)
    before = set(found.iterdir())
    seeds = ROOT / "tests" / "data" / "corpus" / name
    late = 1200 if nice else 30  # in seconds; where others go first the machine may stand still for long
    # Weighing the inputs by what is rare in them takes longer than running them; only this one adds any: none are read again.
    command = ["nice", "-n", str(nice), str(target), f"-max_total_time={max(1, round(seconds))}",
               "-entropic=0", "-reload=0", "-print_final_stats=1", f"-timeout={late}", f"-report_slow_units={late}", "-rss_limit_mb=3000", f"-artifact_prefix={found}/", str(corpus)]
    # Scripts of a drive: longer ones hit the bound of acts and take long. Files and streams: as the fuzzer likes.
    if name.startswith("fuzz_drive_"):
        command.insert(4, "-max_len=160")
    if runs:
        command.insert(4, f"-runs={runs}")
    dictionary = ROOT / "tests" / "fuzz" / f"{name}.dict"
    if dictionary.exists():
        command.insert(4, f"-dict={dictionary}")
    begin, at = time.monotonic(), commit()
    result = subprocess.run(command + ([str(seeds)] if seeds.is_dir() else []), cwd=ROOT, stderr=subprocess.PIPE,
                            stdout=subprocess.DEVNULL, text=True, errors="replace")
    count = re.findall(r"stat::number_of_executed_units:\s*(\d+)", result.stderr)
    new = set(found.iterdir()) - before
    if not count:  # a crash prints no sum: the last line that counts tells
        count = re.findall(r"^#(\d+)", result.stderr, re.MULTILINE)
    held = {one for one in new if one.name.startswith(("slow-unit-", "timeout-")) and not stands(target, one)}
    for one in held:
        one.unlink()
    new -= held
    if new or (result.returncode != 0 and not held):
        print(result.stderr[-4000:], file=sys.stderr)
    findings = max(len(new), 1 if result.returncode != 0 and not held else 0)
    add_row(name, "executions", int(count[-1]) if count else 0, time.monotonic() - begin, how, findings, at)
    return findings > 0


def fuzz(budget):
    if not budget.allows("fuzz"):
        return False
    build("fuzz", "fuzz_targets")
    targets = sorted((ROOT / "build" / "fuzz" / "bin").glob("fuzz_*"))
    share = budget.left() / 2 / max(1, len(targets))
    return any([run_fuzzer(target, share, ROOT / "build" / "fuzz") for target in targets])


def environment(preset, **more):
    # Settings of the user who runs it must not decide.
    home = ROOT / "build" / preset / "campaign"
    home.mkdir(parents=True, exist_ok=True)
    home.chmod(0o700)
    folders = {name: str(home) for name in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME")}
    # A long form takes longer than the minutes that Qt gives a function.
    return {**os.environ, "QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8", "QTEST_FUNCTION_TIMEOUT": "36000000",
            **folders, **more}


def run_sessions(program, seeds=None):
    """A campaign of sessions, with seeds that are not on record. @return whether something failed"""
    name = program.name
    first = 1 + sum(int(row[4].replace(",", "")) for row in rows_of(TABLE.read_text(encoding="utf-8"))
                    if row[2:4] == [name, PLAYED])
    more = {"ROTORSCOPE_LONG": "1", "ROTORSCOPE_FIRST_SEED": str(first)}
    if seeds:
        more["ROTORSCOPE_SEEDS"] = str(seeds)
    begin, at = time.monotonic(), commit()
    result = subprocess.run(["nice", "-n", "19", str(program), SESSIONS[name]], cwd=ROOT,
                            env=environment(program.parts[-3], **more), capture_output=True, text=True, errors="replace")
    sums = [(int(played), int(failed))
            for played, failed in re.findall(PLAYED + r": (\d+), failed: (\d+)", result.stdout + result.stderr)]
    played, failed = sum(one for one, _ in sums), sum(one for _, one in sums)
    if failed or result.returncode != 0:
        print(result.stdout[-8000:], result.stderr[-2000:], file=sys.stderr)
    add_row(name, PLAYED, played, time.monotonic() - begin, "-", max(failed, 1 if result.returncode else 0), at)
    return failed > 0 or result.returncode != 0


def sessions(budget):
    if not budget.allows("sessions"):
        return False
    build("dev", *SESSIONS)
    return any([run_sessions(ROOT / "build" / "dev" / "tests" / name) for name in SESSIONS if budget.allows(name)])


def run_program(program, functions, preset, what, how, **more):
    """One test program, its own sums counted. @return whether something failed"""
    begin, at = time.monotonic(), commit()
    result = subprocess.run([str(program), *functions], cwd=ROOT, env=environment(preset, **more), capture_output=True,
                            text=True, errors="replace")
    totals = re.findall(r"Totals: (\d+) passed, (\d+) failed", result.stdout)
    passed, failed = (int(number) for number in totals[-1]) if totals else (0, 1)
    if failed or result.returncode != 0:
        print(result.stdout[-4000:], result.stderr[-2000:], file=sys.stderr)
    add_row(program.name, what, passed, time.monotonic() - begin, how, max(failed, 1 if result.returncode else 0), at)
    return failed > 0 or result.returncode != 0


def long(budget):
    if not budget.allows("long"):
        return False
    build("dev")
    found = False
    for name, functions in LONG.items():
        program = ROOT / "build" / "dev" / "tests" / name
        if program.exists() and budget.allows(name):
            found |= run_program(program, functions, "dev", "cases, long form", "-", ROTORSCOPE_LONG="1")
    return found


def whole_tree(budget, preset, how):
    if not budget.allows(preset):
        return False
    build(preset)
    begin, at = time.monotonic(), commit()
    result = subprocess.run(["ctest", "--preset", preset, "--no-label-summary", "--label-exclude", "^long$"], cwd=ROOT,
                            capture_output=True, text=True, errors="replace")
    print(result.stdout[-3000:])
    totals = re.findall(r"(\d+) tests failed out of (\d+)", result.stdout)
    failed, count = (int(number) for number in totals[-1]) if totals else (1, 0)
    add_row("whole tree", "test programs", count, time.monotonic() - begin, how, failed, at)
    return failed > 0


def locales(budget):
    if not budget.allows("locales"):
        return False
    build("dev")
    begin, at, count, failed = time.monotonic(), commit(), 0, 0
    names = [source.stem for source in sorted((ROOT / "tests" / "core").rglob("tst_*.cpp"))]
    for name in names + ["tst_setpoints", "tst_settings"]:
        program = ROOT / "build" / "dev" / "tests" / name
        for locale in LOCALES:
            if not program.exists() or not budget.allows(f"{name} in {locale}"):
                continue
            result = subprocess.run([str(program)], cwd=ROOT, env=environment("dev", LC_ALL=locale, LANG=locale),
                                    capture_output=True, text=True, errors="replace")
            count += 1
            if result.returncode != 0:
                failed += 1
                print(locale, name, result.stdout[-2000:], file=sys.stderr)
    add_row("other locales", "test programs", count, time.monotonic() - begin, "-", failed, at)
    return failed > 0


def main():
    arguments = argparse.ArgumentParser(prog="./dev campaign", description="Runs what takes hours.")
    arguments.add_argument("hours", nargs="?", type=float, default=4.0, help="how long, about (4)")
    arguments.add_argument("--only", nargs="+", choices=PARTS, help="these parts alone")
    arguments.add_argument("--target", metavar="PROGRAM", type=pathlib.Path,
                           help="this fuzz program alone, for all the time, or this campaign of sessions")
    arguments.add_argument("--how", default="ASan, UBSan", help="what the program of --target was built with")
    arguments.add_argument("--runs", type=int, help="how often the fuzz program of --target runs, if its time lasts so long")
    arguments.add_argument("--seeds", type=int, help="how many for each function and row of a campaign of sessions")
    chosen = arguments.parse_args()
    budget = Budget(chosen.hours)
    if chosen.target and chosen.target.name in SESSIONS:
        return run_sessions(chosen.target.absolute(), chosen.seeds)  # its name says which of the tests in it
    if chosen.target:
        return run_fuzzer(chosen.target.resolve(), budget.left(), ROOT / "build" / "fuzz", chosen.how, nice=19, runs=chosen.runs)
    run = {"fuzz": fuzz, "sessions": sessions, "long": long, "asan": lambda b: whole_tree(b, "asan", "ASan, UBSan"),
           "tsan": lambda b: whole_tree(b, "tsan", "TSan"), "locales": locales}
    found = [run[part](budget) for part in chosen.only or PARTS]
    if budget.left_out:
        print("campaign: no time was left for", ", ".join(budget.left_out))
    return any(found)


if __name__ == "__main__":
    sys.exit(1 if main() else 0)
