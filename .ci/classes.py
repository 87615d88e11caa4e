#!/usr/bin/env python3
"""classes.py [--all] FILE...: says which class is too large, and which one is spread over more files than one can keep in mind.

A class is what a reader has to hold in the head at once. A long one is not made smaller by more files: what it does is given
to classes with a state of their own. Counted are the lines of the functions that stand outside of it, those of templates
too, and the .cpp files they are in; a class inside another one counts as part of it. --all tells each class, the largest first.
"""
import collections
import pathlib
import re
import sys

MOST_LINES = 700
MOST_FILES = 2

# Those that are in more files, and why.
SPREAD = {
    'core/aspep Controller': 'one machine; its dialogue and what leaves out of turn have a file each',
    'core/mcb Master': 'one machine; seeking a drive and working with it have a file each',
    'core/simulation Liar': 'lies about packets, within answers, and told of its own accord: many small ones, a file each',
    'core/session WakeTimer': 'a file for each platform',
    'widgets/registers RegisterModel': 'one model for a view; its cells and its edits have a file each',
}

QUALIFIED = re.compile(r'\b([A-Z]\w*)(?:::\w+)*::(?:~?\w+|operator\W+)$')


def class_of(line):
    """The class whose function begins in this line, if one does."""
    if not line or line[0] in ' \t}#/':
        return None
    while '<' in line:
        shorter = re.sub(r'<[^<>]*>', '', line)
        if shorter == line:
            break
        line = shorter
    found = QUALIFIED.search(line.partition('(')[0].rstrip()) if '(' in line else None
    return found[1] if found else None


def functions(text):
    """Class and number of lines of each function of a class."""
    lines = text.split('\n')
    at = 0
    while at < len(lines):
        name, end = class_of(lines[at]), at
        if name:
            while end < len(lines) and not lines[end].startswith('}') and not lines[end].endswith((';', '}')):
                end += 1  # to where it opens, or is no function
            if '{' not in ''.join(lines[at:end + 1]):
                at = end + 1
                continue
            if not (lines[end].endswith('}') and not lines[end].startswith(' ')):
                while end < len(lines) and not lines[end].startswith('}'):
                    end += 1
            yield name, end - at + 1
        at = end + 1


def sources(files):
    return sorted(name for name in files if name.endswith('.cpp'))


def main():
    classes = collections.defaultdict(collections.Counter)
    for path in map(pathlib.Path, sys.argv[1:]):
        if path.suffix in ('.cpp', '.h') and path.parts[0] != 'tests' and path.is_file():
            for name, lines in functions(path.read_text(encoding='utf-8')):
                classes['/'.join(path.parts[:2]) + ' ' + name][path.name] += lines
    if '--all' in sys.argv:
        for name, files in sorted(classes.items(), key=lambda item: -sum(item[1].values())):
            print(sum(files.values()), len(sources(files)), name)
        return 0
    found = []
    for name, files in sorted(classes.items()):
        lines = sum(files.values())
        if lines > MOST_LINES:
            found.append(f'{name}: {lines} lines of functions, at most {MOST_LINES}')
        if len(sources(files)) > MOST_FILES and name not in SPREAD:
            found.append(f'{name}: in {", ".join(sources(files))}, at most {MOST_FILES} files')
    found += [f'.ci/classes.py lists {name}, which is no longer spread' for name in sorted(SPREAD)
              if len(sources(classes[name])) <= MOST_FILES]
    print('\n'.join(found), end='\n' if found else '')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
