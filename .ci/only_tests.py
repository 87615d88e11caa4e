#!/usr/bin/env python3
"""only_tests.py FILE...: names the functions of the program that only tests call, or nothing at all.

A function is called where its name stands and does not declare or define one. Namesakes vouch for each other, so this
finds less than there is and never too much. What overrides a virtual function is called from elsewhere.
"""
import collections
import os
import re
import sys

# Ways for a test to look into the program, and nothing else. At most twelve.
PROBES = {
    'drawnMeasured', 'energies', 'observerWords', 'phases_a', 'redraws', 'setSessionClock', 'slave',
    'takesWord', 'trueBus_v', 'valueRangeOf', 'waiting',
}
MOST_PROBES = 12

NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\''
                   r'|^[ \t]*#[^\n]*', re.S | re.M)
TOKEN = re.compile(r"[A-Za-z_]\w*|::|->|&&|\|\||\d[\w.']*|[^\s\w]")
NAME = re.compile(r'[A-Za-z_]\w*$')
NOT_TYPES = {'return', 'co_return', 'else', 'case', 'new', 'delete', 'throw', 'using', 'emit', 'Q_EMIT'}
NOT_FUNCTIONS = NOT_TYPES | {'if', 'for', 'while', 'switch', 'catch', 'sizeof', 'decltype', 'static_assert', 'noexcept',
                             'operator', 'assert', 'main'}
TYPE_PARTS = {'::', '<', '>', '*', '&', '&&', '[', ']', '~'}


def tokens_of(path):
    with open(path, encoding='utf-8') as file:
        return TOKEN.findall(NOISE.sub(' ', file.read()))


def declares(tokens, at):
    """Whether a type stands between the start of the statement and the name, with its qualifiers, at `at`."""
    at -= 1
    while tokens[at] == '::':
        at -= 2
        if not NAME.match(tokens[at + 1]):
            return False
    types = depth = 0
    while at >= 0 and (depth or tokens[at] not in ';{}:)'):
        token = tokens[at]
        if token in NOT_TYPES or not (depth or token in TYPE_PARTS or NAME.match(token)):
            return False
        depth += {'>': 1, '<': -1}.get(token, 0)
        types += bool(NAME.match(token))
        at -= 1
    return types > 0


def behind_parameters(tokens, at):
    """The tokens behind the parameters that open at `at`, up to the body or the end of the declaration, with that."""
    depth = 0
    for at in range(at, len(tokens)):
        depth += {'(': 1, ')': -1}.get(tokens[at], 0)
        if not depth:
            break
    end = at
    while end < len(tokens) and tokens[end] not in ';{':
        end += 1
    return tokens[at + 1:end + 1]


def read(paths):
    declared, overridden, used = {}, set(), collections.Counter()
    for path in paths:
        tokens = tokens_of(path)
        for at, token in enumerate(tokens[:-1]):
            if tokens[at + 1] == '(' and NAME.match(token) and token not in NOT_FUNCTIONS and declares(tokens, at):
                behind = behind_parameters(tokens, at + 1)
                if path.endswith('.h') or behind[-1:] == ['{']:  # else it may be a variable
                    declared.setdefault(token, path)
                if 'override' in behind:
                    overridden.add(token)
            else:
                used[token] += 1
    return declared, overridden, used


def main():
    files = [f for f in sys.argv[1:] if f.endswith(('.h', '.cpp')) and os.path.exists(f)]
    declared, overridden, used = read([f for f in files if not f.startswith('tests/')])
    in_tests = read([f for f in files if f.startswith('tests/')])[2]
    lonely = {name for name in declared if not used[name]} - overridden
    for name in sorted(lonely - PROBES):
        print(f'{declared[name]}: {"only tests call" if in_tests[name] else "nothing calls"} {name}')
    for name in sorted(PROBES - lonely):
        print(f'{name} is called by the program: no probe')
    if len(PROBES) > MOST_PROBES:
        print(f'{len(PROBES)} probes, {MOST_PROBES} at most')
    return bool(lonely ^ PROBES) or len(PROBES) > MOST_PROBES


if __name__ == '__main__':
    sys.exit(main())
