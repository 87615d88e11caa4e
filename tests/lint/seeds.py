#!/usr/bin/env python3
"""seeds.py: breaks each house rule of .ci/lint in a copy of the project, and fails if lint does not say so.

All the seeds are in it at once, and each of them has to be named; that the project itself is clean is for lint to say.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
COPIED = ['.ci', 'app', 'cmake', 'core', 'docs', 'packaging', 'resources', 'tests', 'widgets', 'ARCHITECTURE.md', 'CHANGELOG.md',
          'CMakeLists.txt', 'CMakePresets.json', 'CONTRIBUTING.md', 'LICENSE', 'README.md', 'dev']

LINES = '    work();\n'


def function(name, lines):
    """So many lines, from the first one to its closing brace."""
    return f'void {name}()\n{{\n' + LINES * (lines - 3) + '}\n'


# Where, what is put at the end of it, and what lint has to say about it.
SEEDS = [
    # Layers.
    ('core/base/seed_up.h', '#include "drive/drive.h"\n', 'core/base/seed_up.h: goes up, or aside, to core/drive'),
    ('core/scope/seed_aside.h', '#include "recorded/entry.h"\n', 'core/scope/seed_aside.h: goes up, or aside, to core/recorded'),
    ('core/lab/seed_truth.h', '#include "simulation/device.h"\n', 'core/lab/seed_truth.h: must not use core/simulation'),
    ('core/drive/seed_widgets.h', '#include "widgets/base/look/theme.h"\n', 'core/drive/seed_widgets.h: goes up to widgets'),
    ('widgets/base/seed_up.h', '#include "widgets/window/settings.h"\n',
     'widgets/base/seed_up.h: goes up, or aside, to widgets/window'),
    ('widgets/control/seed_aside.h', '#include "widgets/files/recording_control.h"\n',
     'widgets/control/seed_aside.h: goes up, or aside, to widgets/files'),
    ('core/drive/seed_qt.h', '#include <QString>\n', 'core/drive/seed_qt.h: Qt is for core/session alone: QString'),
    ('core/attic/seed.h', '#include "base/result.h"\n', '.ci/layers.py has no row for core/attic'),
    ('core/drive/seed_space.h', 'namespace capture {\nint seeds();\n}\n',
     'core/drive/seed_space.h: in namespace capture, not drive'),
    ('widgets/files/file_seed.h', '#pragma once\n', 'widgets/files/file_seed.h: its name repeats the folder'),
    ('core/drive/mcp/response.h', '#pragma once\n', 'core/drive/mcp/response.h: hides core/mcp/response.h'),
    *[(f'widgets/registers/seed_{number}.h', '#pragma once\n', 'widgets/registers: ') for number in range(51)],
    # ARCHITECTURE.md and the folders.
    ('core/cellar/seed.h', '#pragma once\n', 'ARCHITECTURE.md has no row for core/cellar'),
    ('widgets/cellar/seed.h', '#pragma once\n', 'ARCHITECTURE.md does not name widgets/cellar'),
    ('ARCHITECTURE.md', '\n| `core/loft` | | | |\n', 'ARCHITECTURE.md has a row for core/loft, which is not there'),
    ('ARCHITECTURE.md', '\n`SeededClass`, `core/drive/seeded.h`\n', 'ARCHITECTURE.md names SeededClass, which is not there'),
    ('ARCHITECTURE.md', '', 'ARCHITECTURE.md names core/drive/seeded.h, which is not there'),
    ('docs/seed.md', '[Seed](seeded.md)\n', 'docs/seed.md opens seeded.md, which is not there'),
    ('docs/seed.md', '', 'docs/README.md does not open seed.md'),
    # Classes.
    ('widgets/window/seed_long.cpp', function('Long::run', 360), 'widgets/window Long: 710 lines of functions'),
    ('widgets/window/seed_long_too.cpp', function('Long::runToo', 350), None),
    *[(f'core/recorded/seed_sliced_{number}.cpp', function(f'Sliced::run{number}', 5),
       'core/recorded Sliced: in seed_sliced_0.cpp, seed_sliced_1.cpp, seed_sliced_2.cpp') for number in range(3)],
    # Names in unnamed namespaces.
    ('core/recorded/seed_one.cpp', 'namespace {\nconstexpr int kSeeded = 1;\nint seededSum(int a) { return a; }\n} // namespace\n',
     'core/recorded: kSeeded is in seed_one.cpp:2, seed_two.cpp:2'),
    ('core/recorded/seed_two.cpp', 'namespace {\nconstexpr int kOther = 1, kSeeded = 2;\nint seededSum(\n    int b)\n{\n    return b;\n}\n'
     '} // namespace\n', 'core/recorded: seededSum(int) is in seed_one.cpp:3, seed_two.cpp:3'),
    ('tests/core/recorded/tst_seed_one.cpp', 'namespace {\nint seededHelp(int a) { return a; }\n} // namespace\n',
     'tests/core/recorded: seededHelp is in tst_seed_two.cpp:2, tst_seed_one.cpp:2'),
    ('tests/core/recorded/attic/tst_seed_two.cpp', 'namespace {\nint seededHelp(double a) { return int(a); }\n} // namespace\n',
     'tests/core/recorded/attic/tst_seed_two.cpp: there is no folder core/recorded/attic that it could test'),
    # Functions that only tests call.
    ('core/recorded/seed_lonely.h', 'int seededProbe();\n', 'core/recorded/seed_lonely.h: only tests call seededProbe'),
    ('tests/core/recorded/tst_seed_lonely.cpp', 'int main() { return seededProbe(); }\n', None),
    ('core/recorded/seed_dead.h', 'int seededDead();\n', 'core/recorded/seed_dead.h: nothing calls seededDead'),
    # Lines.
    ('core/base/seed_wide.h', '// ' + 'so wide ' * 15 + '\n', 'core/base/seed_wide.h:1: wider than 120 columns'),
    ('core/base/seed_broken.h', 'int seededFacts(\n    int a); ///< whatever it is, and some more\n',
     'core/base/seed_broken.h:2: the comment breaks'),
    ('core/base/seed_names.h', 'int seededOne = 1,\n    seededTwo = 2; ///< both of them\n',
     'core/base/seed_names.h:2: the comment breaks'),
    ('core/base/seed_brace.h', 'struct SeededBrace {\n    int one()\n    {\n        return 1;\n    } ///< no more\n};\n',
     'core/base/seed_brace.h:5: the comment breaks'),
    ('core/base/seed_condition.h', 'if (seeded\n    > 0.0) { // more\n', 'core/base/seed_condition.h:2: the comment breaks'),
    ('core/drive/protocol_table.cpp', '// ProtocolRow{{Seed, "seeded", "", "", true}},\n', None),
    ('widgets/base/seed_of_table.h', '// as seeded has it\n', 'widgets/base/seed_of_table.h'),
    ('widgets/base/seed_word.h', '// as MCB has it\n', 'widgets/base/seed_word.h'),
    ('tests/core/base/tst_seed_sleep.cpp', 'QTest::qW' 'ait(5);\n', 'tests/core/base/tst_seed_sleep.cpp:1:'),
    ('tests/core/base/tst_seed_skip.cpp', 'QSK' 'IP("later");\n', 'tests/core/base/tst_seed_skip.cpp:1:'),
    ('core/base/seed_later.h', '// TO' 'DO\n', 'core/base/seed_later.h:1:'),
    ('core/base/seed_locale.h', 'inline double read(const char *text) { return strtod(text, nullptr); }\n',
     'core/base/seed_locale.h:1:'),
    ('docs/seed.md', 'See /' 'home/me/notes.\n', 'docs/seed.md:2:'),
    ('widgets/window/seed_arg.cpp', 'text\n    .arg(name(first, 2))\n    .arg(second);\n', 'widgets/window/seed_arg.cpp:2'),
]


def lint(folder):
    return subprocess.run(['bash', '.ci/lint', '--rules'], cwd=folder, capture_output=True, text=True, check=False)


def main():
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for name in COPIED:
            copy = shutil.copytree if (SOURCE / name).is_dir() else shutil.copy
            copy(SOURCE / name, folder / name)
        for name, text, _ in SEEDS:
            file = folder / name
            file.parent.mkdir(exist_ok=True)
            with file.open('a', encoding='utf-8') as grown:
                grown.write(text)
        seeded = lint(folder)
        missed = [said for _, _, said in SEEDS if said and said not in seeded.stdout]
        if missed or not seeded.returncode:
            print('Lint did not say:', *missed, 'It said:', seeded.stdout, seeded.stderr, sep='\n')
            return 1
        print(f'lint found {len({said for _, _, said in SEEDS if said})} seeds of {len(SEEDS)} files')
    return 0


if __name__ == '__main__':
    sys.exit(main())
