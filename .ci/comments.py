#!/usr/bin/env python3
"""comments.py FILE...: says which line is too wide, and which comment breaks a declaration, a condition or a function that
one line has room for.

Code has 100 columns, which clang-format sees to; with a comment it may have 120. A comment that does not fit behind what
it explains stands above it: clang-format would break the declaration instead.
"""
import pathlib
import re
import sys

WIDEST = 120
CODE = 100

COMMENTED = re.compile(r'^(\s*\S.*?)\s+//')
WHOLE = (';', '{', '}', ':', '\\')  # ends of a line that the next one does not go on with
STATEMENT = re.compile(r'\s*(} )?(if|for|while|else|case|template)\b')


def indent(line):
    return len(line) - len(line.lstrip())


def breaks(before, line):
    """Whether the comment of this line is all that keeps it apart from the one before."""
    if re.match(r'\s*} ///<', line):
        return True
    commented = COMMENTED.match(line)
    if not commented or 'NOLINT' in line or line.strip().startswith(('//', '.')):
        return False
    if not commented[1].endswith((';', ',', '{', ')')) or indent(line) <= indent(before):
        return False
    if not before.strip() or '//' in before or before.startswith('#') or before.endswith(WHOLE):
        return False
    if STATEMENT.match(before) and before.count('(') == before.count(')'):
        return False
    return len(before) + len(commented[1].strip()) + (not before.endswith('(')) <= CODE


def main():
    for name in sys.argv[1:]:
        path = pathlib.Path(name)
        if path.suffix not in ('.h', '.cpp'):
            continue
        before = ''
        for number, line in enumerate(path.read_text(encoding='utf-8').split('\n'), 1):
            if len(line) > WIDEST:
                print(f'{path}:{number}: wider than {WIDEST} columns')
            if breaks(before, line):
                print(f'{path}:{number}: the comment breaks what one line has room for')
            before = line.rstrip()


if __name__ == '__main__':
    main()
