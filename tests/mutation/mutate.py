#!/usr/bin/env python3
"""Mutation check of the stop path: small defects are put into it one by one, and the fast tests beside it have to fail.

    tests/mutation/mutate.py --build build/dev [--only TEXT] [--jobs N] [--part N] [--table]   tries mutants, prints what survives
    tests/mutation/mutate.py --list [--only TEXT]                             only names them
    tests/mutation/mutate.py --check           every line of survivors.csv still names a mutant, and says why it survives

The sources are not touched: a mutant is a file of its own under BUILD/mutation; the units that read it are compiled anew with
the flags of the build and linked before its libraries. What was found is kept there, too: a run that was interrupted goes on
from it. What was killed is tried again when its file changes, what survived each time. More than 5 % of survivors, or one
without its reason in survivors.csv (file;line as it was;line as it is;reason), is a failure.

Operators, one line at a time: comparisons lose or gain the border, or turn round; && and || change places; a constant becomes
0 (0 becomes 1) or twice as much; a condition, or a part behind "!", turns round; a statement is left out; a function returns
nothing, zero or false; true and false change places; + and - change places. No mutants are made of assertions, of lines that
only word a text or a log, and of declarations. One that does not build, or from which the compiler makes the same code, is none.
"""
import argparse
import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SURVIVORS = pathlib.Path(__file__).resolve().parent / "survivors.csv"
MOST_SURVIVORS = 0.05

# What is mutated, and the tests that judge it, the fastest first. The second group is not of the path, but close to it.
PATH = {
    "core/drive/stop_sequence.cpp": ["tst_stop_sequence"],
    "core/drive/stop_sequence.h": ["tst_stop_sequence"],
    "core/drive/motion_caution.cpp": ["tst_motion_caution"],
    "core/drive/motion_limits.cpp": ["tst_set_points"],
    "core/drive/motion_entry.cpp": ["tst_motion_texts"],
    "core/drive/set_point_check.cpp": ["tst_set_points"],
    "core/drive/wish_queue.h": ["tst_wish_queue"],
    "core/session/link/dead_man.cpp": ["tst_dead_man_rules"],
    "core/session/link/time_gap.h": ["tst_dead_man_rules"],
    "core/session/link/driven_motors.cpp": ["tst_driven_motors"],
    "core/session/link/stop_page_posix.cpp": ["tst_guardian_rules_posix"],
    "core/session/link/guardian_posix.cpp": ["tst_guardian_rules_posix"],
    "widgets/window/shutdown.cpp": ["tst_shutdown"],
}
NEIGHBOURS = {
    "core/drive/wish_drive.cpp": ["tst_late_wishes", "tst_mcp_drive_stop", "tst_motion_limits", "tst_motion_entry"],
    "core/drive/task_drive.h": ["tst_late_wishes", "tst_mcp_drive_stop"],
    "core/drive/start_target.cpp": ["tst_start_target"],
    "core/drive/write_check.cpp": ["tst_what_may_be_written", "tst_mcp_drive_writes"],
}

COMPARISONS = {"<=": ["<", ">"], ">=": [">", "<"], "<": ["<=", ">="], ">": [">=", "<="], "==": ["!="], "!=": ["=="]}
LEFT_OUT = r"\s*(//|#|namespace|using|\*|template|case\b|(const )?char )|.*\b(assert|Q_ASSERT\w*|static_assert|syslog|say)\("


def mutants_of(line):
    """(operator, line instead) for each small defect of one line of code."""
    code = re.sub(r'"(?:\\.|[^"\\])*"', lambda text: "_" * len(text.group()), line).split("//")[0]
    indent = re.match(r"\s*", line).group()

    def instead(found, text):
        return line[:found.start()] + text + line[found.end():]

    for found in re.finditer(r"(?<=\s)(<=|>=|==|!=|<|>)(?=\s)", code):
        for other in COMPARISONS[found.group()]:
            yield "comparison", instead(found, other)
    for found in re.finditer(r"&&|\|\|", code):
        yield "and, or", instead(found, "||" if found.group() == "&&" else "&&")
    for found in re.finditer(r"(?<=\s)[+-](?=\s)", code):
        yield "plus, minus", instead(found, "-" if found.group() == "+" else "+")
    for found in re.finditer(r"(?<![\w.'])\d[\d.']*(?![\w.'])", code):
        zero = float(found.group().replace("'", "")) == 0
        for other in ["1"] if zero else ["0", f"({found.group()} * 2)"]:
            yield "constant", instead(found, other)
    condition = re.match(r"^(\s*(?:\} else )?(?:if|while) \()(?!const |auto |![^ ]*\)|.*;)(.*)(\)(?: \{)?)$", line)
    if condition:
        yield "negation", f"{condition[1]}!({condition[2]}){condition[3]}"
    for found in re.finditer(r"(?<![\w!])!(?=[\w(])", code):
        yield "negation", instead(found, "")
    if re.match(r"^\s+(?!return|break|continue|using|const |auto |struct|static|bool |int )[\w.>*()\[\]:-]+( [-+]?= .*|\(.*\));$", code.rstrip()):
        yield "statement", indent + "static_cast<void>(0);"
    if re.match(r"^\s+return (?!\{\};)[^;]*;$", code.rstrip()):
        yield "return", indent + "return {};"
    for found in re.finditer(r"\b(true|false)\b", code):
        yield "truth", instead(found, "false" if found.group() == "true" else "true")


def all_mutants(only, files=PATH):
    for file in files:
        if only in file:
            for number, line in enumerate((ROOT / file).read_text().splitlines(), 1):
                if line.startswith(" ") and not re.match(LEFT_OUT, line):
                    for operator, other in mutants_of(line):
                        yield file, number, operator, line, other


def excused():
    with SURVIVORS.open(newline="") as file:
        rows = csv.reader(file, delimiter=";")
        return {(row[0], row[1].strip(), row[2].strip()): row[3].strip() for row in rows if row}


def check():
    there = {(file, old.strip(), new.strip()) for file, _, _, old, new in all_mutants("", PATH | NEIGHBOURS)}
    wrong = [f"no such mutant any more: {key}" for key in excused() if key not in there]
    wrong += [f"no reason: {key}" for key, reason in excused().items() if len(reason) < 20]
    print("\n".join(wrong) or f"{len(excused())} survivors, each with its reason")
    return 1 if wrong else 0


class Bench:
    """A finished build, and mutants of it."""

    def __init__(self, build):
        self.build = pathlib.Path(build).resolve()
        self.units = {}
        for unit in json.loads((self.build / "compile_commands.json").read_text()):
            self.units[re.search(r" -o (\S+)", unit["command"])[1]] = unit
        self.readers, reader = {}, ""
        for line in self.ninja("-t", "deps").splitlines():
            if line.startswith(" "):
                self.readers.setdefault(os.path.normpath(self.build / line.strip()), []).append(reader)
            else:
                reader = line.split(":")[0]
        self.links, self.same, self.limits, self.headers = {}, {}, {}, set()
        self.local, self.lock = threading.local(), threading.Lock()
        self.lanes = iter(range(99))

    def ninja(self, *words):
        return subprocess.run(["ninja", "-C", self.build, *words], check=True, capture_output=True, text=True).stdout

    def lane(self):
        """A folder for each thread."""
        if not hasattr(self.local, "lane"):
            self.local.lane = self.build / "mutation" / f"{os.getpid()}-{next(self.lanes)}"
            shutil.rmtree(self.local.lane, ignore_errors=True)
            self.local.lane.mkdir(parents=True)
        return self.local.lane

    def link(self, test):
        """How its program is linked, and what of the libraries gets into it."""
        if test not in self.links:
            program = next(found[1] for unit in self.units if (found := re.match(rf"tests/CMakeFiles/([^/]*)\.dir/.*/{test}\.cpp\.o", unit)))
            words = shlex.split(self.ninja("-t", "commands", f"tests/{program}").splitlines()[-1])[2:]
            words = words[:words.index("&&")] + ["-fuse-ld=lld", "-Wl,-S"] # behind it are the links with the tests' names
            words[words.index("-o") + 1] = str(self.lane() / test)
            members = subprocess.run([*words, "-Wl,-t"], cwd=self.build, check=True, capture_output=True, text=True).stdout
            archives = {"librotorscope_core.a": "core/CMakeFiles/rotorscope_core.dir/", "librotorscope_session.a":
                        "core/CMakeFiles/rotorscope_session.dir/", "librotorscope_widgets.a": "widgets/CMakeFiles/rotorscope_widgets.dir/"}
            used = {word for word in words if word.endswith(".o")}
            for library, folder in archives.items():
                names = set(re.findall(rf"{library}\(([^)]*)\)", members))
                used |= {unit for unit in self.units if unit.startswith(folder) and pathlib.Path(unit).name in names}
            self.links[test] = words, used
        return self.links[test]

    def precompiled(self, words, source):
        """What that file includes, which is most of the work."""
        with self.lock:
            header = self.build / "mutation" / (pathlib.Path(source).name + ".includes.h")
            if header not in self.headers:
                self.headers.add(header)
                header.write_text("".join(re.findall(r"^#include.*\n", pathlib.Path(source).read_text(), re.M)))
                options = [word for word in words[:words.index("-o")]]
                subprocess.run([*options, "-w", "-x", "c++-header", header, "-o", f"{header}.gch"], cwd=self.build, check=True)
        return header

    def compile(self, unit, file, text, to):
        """The unit as it is with `text` instead of that file; None: it does not build."""
        overlay = to.parent / "overlay"
        shutil.rmtree(overlay, ignore_errors=True)
        (overlay / file).parent.mkdir(parents=True)
        (overlay / file).write_text(text)
        words = shlex.split(self.units[unit]["command"])
        source = self.units[unit]["file"]
        words[words.index("-c") + 1] = str(overlay / file) if source == str(ROOT / file) else source
        words[words.index("-o") + 1] = str(to)
        words[1:1] = [f"-I{overlay}", f"-I{overlay}/core"]
        words = [word for word in words if word != "-Werror"] + ["-w"]
        if source == str(ROOT / file) and "-include" not in words:
            words[1:1] = ["-include", str(self.precompiled(words, source))]
        if subprocess.run(words, cwd=self.build, capture_output=True, check=False).returncode != 0:
            return None
        subprocess.run(["objcopy", "-g", to], check=True)
        return hashlib.sha1(to.read_bytes()).hexdigest()

    def run(self, program, limit):
        home = self.lane() / "home"
        home.mkdir(exist_ok=True)
        home.chmod(0o700)
        places = {f"XDG_{name}": str(home) for name in ("RUNTIME_DIR", "CONFIG_HOME", "DATA_HOME", "CACHE_HOME")}
        environment = os.environ | places | {"QT_QPA_PLATFORM": "offscreen", "LC_ALL": "C.UTF-8"}
        with subprocess.Popen([program], env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, start_new_session=True) as process:
            try:
                return process.wait(limit)
            except subprocess.TimeoutExpired:
                return "too long"
            finally:
                self.end(program)

    @staticmethod
    def end(program):
        """Whatever runs that program: a mutant's children may have left it, and run for ever."""
        for place in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if os.readlink(place / "exe") == str(program):
                    os.kill(int(place.name), signal.SIGKILL)
            except OSError:
                continue

    def judge(self, file, text, test):
        """False: the test fails. None: no mutant."""
        words, used = self.link(test)
        readers = self.readers[str(ROOT / file)] if file.endswith(".h") else [
            unit for unit, how in self.units.items() if how["file"] == str(ROOT / file)]
        objects, changed, instead = [], False, []
        for number, unit in enumerate(sorted(used.intersection(readers))):
            to = self.lane() / f"{number}.o"
            code = self.compile(unit, file, text, to)
            if code is None:
                return None
            changed |= code != self.same.get((unit, file))
            self.same.setdefault((unit, file), code)
            objects.append(str(to))
            instead.append(unit)
        if not changed:
            return None
        program = self.lane() / test
        words = [word for word in words if word not in instead]
        at = words.index("-o")
        words[at + 1] = str(program)
        words[at:at] = objects
        subprocess.run(words, cwd=self.build, capture_output=True, check=True)
        begun = time.monotonic()
        good = self.run(program, self.limits.get(test, 300)) == 0
        self.limits.setdefault(test, 5 + 4 * (time.monotonic() - begun))
        return good

    def prepare(self, files):
        """As the sources are now the tests pass: they would kill every mutant otherwise."""
        for file, tests in files.items():
            for test in tests:
                if self.judge(file, (ROOT / file).read_text(), test) is False:
                    raise SystemExit(f"{test} fails as {file} is now: nothing can be judged")

    def try_one(self, mutant):
        file, number, _, _, other = mutant
        lines = (ROOT / file).read_text().split("\n")
        lines[number - 1] = other
        results = []
        for test in (PATH | NEIGHBOURS)[file]:
            results.append(self.judge(file, "\n".join(lines), test))
            if results[-1] is False:
                return f"killed by {test}"
        return "SURVIVED" if True in results else "no mutant"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--build", default="build/dev")
    options.add_argument("--only", default="", help="files whose names have this text")
    options.add_argument("--part", type=int, default=1, help="each so-manieth mutant")
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--neighbours", action="store_true", help="the second group")
    options.add_argument("--list", action="store_true")
    options.add_argument("--check", action="store_true")
    given = options.parse_args()
    if given.check:
        return check()
    files = {file: tests for file, tests in (NEIGHBOURS if given.neighbours else PATH).items() if given.only in file}
    mutants = list(all_mutants("", files))[::given.part]
    if given.list:
        for file, number, operator, _, other in mutants:
            print(f"{file}:{number}: {operator}: {other.strip()}")
        print(len(mutants), "mutants")
        return 0
    bench, known = Bench(given.build), excused()
    bench.prepare(files)
    kept = bench.build / "mutation" / "results"
    before = dict(line.rsplit("\t", 1) for line in kept.read_text().splitlines()) if kept.exists() else {}
    results, lock = {}, threading.Lock()

    def judged(mutant):
        source = hashlib.sha1((ROOT / mutant[0]).read_bytes()).hexdigest()
        key = f"{mutant[0]}:{mutant[1]}:{source}:{mutant[4]}"
        result = before.get(key, "SURVIVED")
        if result == "SURVIVED":
            result = bench.try_one(mutant)
        with lock:
            results[mutant] = result
            with kept.open("a") as file:
                file.write(f"{key}\t{result}\n")
            if result == "SURVIVED" and (mutant[0], mutant[3].strip(), mutant[4].strip()) not in known:
                print(f"{mutant[0]}:{mutant[1]}: {mutant[2]}\n  - {mutant[3].strip()}\n  + {mutant[4].strip()}", flush=True)

    with concurrent.futures.ThreadPoolExecutor(given.jobs) as lanes:
        list(lanes.map(judged, mutants))
    print("\n| File | Mutants | Killed | Survived with a reason | without |\n|---|---|---|---|---|")
    sums = [0, 0, 0, 0]
    for file in [*files, None]:
        those = {mutant: result for mutant, result in results.items() if mutant[0] == file and result != "no mutant"}
        alive = [mutant for mutant, result in those.items() if result == "SURVIVED"]
        excuse = sum((mutant[0], mutant[3].strip(), mutant[4].strip()) in known for mutant in alive)
        row = [len(those), len(those) - len(alive), excuse, len(alive) - excuse] if file else sums
        sums = [a + b for a, b in zip(sums, row)] if file else sums
        print(f"| `{file}` |" if file else "| **all** |", " | ".join(str(number) for number in row), "|")
    return 1 if sums[3] or sums[2] > MOST_SURVIVORS * max(sums[0], 1) else 0


if __name__ == "__main__":
    sys.exit(main())
