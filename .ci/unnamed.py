#!/usr/bin/env python3
"""unnamed.py FILE...: says what two files of a folder call by the same name in their unnamed namespaces.

The files of a folder are compiled in batches (cmake/precompiled.cmake), where both would be one. Constants, types and functions
count, functions with what they take: others of that name may stand beside them. In tests functions count by their names alone:
a test must not call another's helper because that fits better; and with the folder of a program of tests go those inside it.
Files that are compiled alone are left out.
"""
import collections
import pathlib
import re
import sys

ALONE = {'registers_hso.cpp', 'registers_standard.cpp', 'tst_out_of_memory.cpp'}
CONSTANT = re.compile(r'(?:constexpr|const|inline|static)\b.*?\b(k[A-Z]\w*)\s*(?:=|\{|\[|;)')
FURTHER = re.compile(r',\s*\*?(k[A-Z]\w*)\s*=')
TYPE = re.compile(r'(?:class|struct|enum class|enum) (\w+)')
FUNCTION = re.compile(r'[\w:<>*&, ]+?[ *&](\w+)\((.*)\)(?: const)?$')


def room(path):
    """The folder whose files are compiled together: of tests that of their program, see tests/CMakeLists.txt."""
    parts = path.parent.parts
    if parts[0] != 'tests':
        return path.parent
    inside = {('app',): 2, ('core', 'session'): 4, ('core', 'simulation'): 4}
    return pathlib.Path(*parts[:inside.get(parts[1:2], inside.get(parts[1:3], 3))])


def parameters(text):
    """What a function takes: types without the names."""
    return ','.join(re.sub(r'\s*\b\w+$', '', part.strip()) for part in text.split(','))


def names(path):
    inside = False
    lines = path.read_text(encoding='utf-8').split('\n')
    for number, line in enumerate(lines, 1):
        if line == 'namespace {':
            inside = True
        elif re.match(r'\} // namespace$', line):
            inside = False
        elif inside and line and line[0] not in ' \t}#/{':
            statement = line
            while not re.search(r'[;{})]$', statement) and number + statement.count('\n') < len(lines):
                statement += '\n' + lines[number + statement.count('\n')]
            statement = re.sub(r'\s+', ' ', re.sub(r'//.*', '', statement))
            if match := CONSTANT.match(statement):
                yield match.group(1), number
                for other in FURTHER.findall(statement):
                    yield other, number
            elif match := TYPE.match(statement):
                yield match.group(1), number
            elif match := FUNCTION.match(statement.split(' {')[0]):
                yield f'{match.group(1)}({parameters(match.group(2))})', number


def main():
    found = collections.defaultdict(dict)
    for name in sys.argv[1:]:
        path = pathlib.Path(name)
        if path.parts[0] == 'tests' and not path.name.startswith('tst_'):
            continue
        if path.suffix != '.cpp' or path.name in ALONE or path.name.endswith(('_windows.cpp', '_other.cpp')):
            continue
        for what, number in names(path):
            if path.name.startswith('tst_'):
                what = what.split('(')[0]
            found[room(path), what].setdefault(name, number)
    for (folder, what), places in sorted(found.items(), key=str):
        if len(places) > 1:
            print(f'{folder}: {what} is in ' + ', '.join(f'{pathlib.Path(p).name}:{n}' for p, n in sorted(places.items())))


main()
