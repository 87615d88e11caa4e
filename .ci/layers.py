#!/usr/bin/env python3
"""layers.py FILE...: says where an include goes up, where Qt is where it must not be, where tests are beside no source,
where ARCHITECTURE.md is not true, and which page of the documents is lost.

Folders are layers: each may include those of lower rows, and its own. A folder that the list does not name is a finding.
"""
import pathlib
import re
import sys

ROWS = {
    'core': ['base',
             'aspep catalog',
             'capture fcp mcb motor',
             'mcp',
             'drive',
             'recorded scope simulation snapshots',
             'lab',
             'session'],
    'widgets': ['base',
                'registers scope',
                'control files measuring snapshots',
                'forms',
                'lab',
                'runs',
                'window'],
}
NEVER = {('core/lab', 'core/simulation')}  # what measures a motor must not know the one that is simulated
QT = {'core/session'}  # of core
NO_NAMESPACE = {'base'}  # of core: its names are for all
MOST_FILES = 50  # in one folder, its own folders not counted

INCLUDE = re.compile(r'^\s*#\s*include\s+(["<])([^">]+)[">]', re.M)


def row_of(path):
    """Row and room of a file: ('core', 2, 'drive'); no row if the list has none for it."""
    top, room = path.parts[0], path.parts[1]
    for number, row in enumerate(ROWS.get(top, [])):
        if room in row.split():
            return top, number, room
    return top, None, room


def target_of(name):
    """The file in the project that an include names; core's are named without `core`."""
    for candidate in (pathlib.Path(name), pathlib.Path('core') / name):
        if candidate.is_file():
            return candidate
    return None


def includes(path):
    for quote, name in INCLUDE.findall(path.read_text(encoding='utf-8')):
        top, row, room = row_of(path)
        if row is None:
            yield f'{path}: .ci/layers.py has no row for {top}/{room}'
        if top == 'core' and f'{top}/{room}' not in QT and re.match(r'Q[A-Z]|Qt', name):
            yield f'{path}: Qt is for {", ".join(sorted(QT))} alone: {name}'
        target = target_of(name) if quote == '"' else None
        if target is None or len(target.parts) < 3:
            continue
        to_top, to_row, to_room = row_of(target)
        if (f'{top}/{room}', f'{to_top}/{to_room}') in NEVER:
            yield f'{path}: must not use {to_top}/{to_room}: {name}'
        order = ['core', 'widgets', 'app']
        if order.index(to_top) > order.index(top):
            yield f'{path}: goes up to {to_top}: {name}'
        elif to_top == top and to_room != room and to_row is not None and row is not None and to_row >= row:
            yield f'{path}: goes up, or aside, to {to_top}/{to_room}: {name}'


def rooms(files):
    """Folders of the source as the table has them: those of core and their own, of the rest the first."""
    found = set()
    for path in files:
        depth = len(path.parts) - 1
        found.add('/'.join(path.parts[:min(depth, 3)]) if path.parts[0] == 'core' else path.parts[0])
    return {room for room in found if room != 'core'}


def table():
    text = pathlib.Path('ARCHITECTURE.md').read_text(encoding='utf-8')
    return set(re.findall(r'^\| `((?:core|widgets|app)[\w/]*)`', text, re.M)), text


def namespaces(path):
    """A file of core opens the namespace of its folder, one of widgets that of all widgets."""
    wanted = {'core': path.parts[1], 'widgets': 'widgets'}.get(path.parts[0])
    opened = re.findall(r'^namespace (\w+)', path.read_text(encoding='utf-8'), re.M)
    if wanted and wanted not in NO_NAMESPACE and opened and wanted not in opened:
        yield f'{path}: in namespace {opened[0]}, not {wanted}'


def untrue_names(text, source):
    """What ARCHITECTURE.md names and the project has not: classes and functions, and paths."""
    code = '\n'.join(path.read_text(encoding='utf-8') for path in source)
    words = set(re.findall(r'\w+', code))
    said = re.findall(r'^    .*$', text, re.M) + re.findall(r'`([^`\n]+)`', text)
    for name in sorted({name for line in said for name in re.findall(r'[\w./*:-]+', line)}):
        path = re.match(r'(core|widgets|app|tests|docs|resources)/', name)
        if any(pathlib.Path().glob(name)) if path else all(part in words for part in name.split('::')
                                                           if re.search(r'[a-z][A-Z]', part)):
            continue
        yield f'ARCHITECTURE.md names {name}, which is not there'


def lost_pages():
    """Links of the documents to what is not there, and pages that the index does not open."""
    pages = sorted(pathlib.Path('docs').glob('*.md'))
    index = pathlib.Path('docs/README.md').read_text(encoding='utf-8')
    yield from (f'docs/README.md does not open {page.name}' for page in pages
                if page.name != 'README.md' and f']({page.name})' not in index)
    for page in [*sorted(pathlib.Path().glob('*.md')), *pages]:
        for link in re.findall(r'\]\((?!https?:)([^)#\s]+)', page.read_text(encoding='utf-8')):
            if not (page.parent / link).exists():
                yield f'{page} opens {link}, which is not there'


def main():
    files = [path for path in map(pathlib.Path, sys.argv[1:]) if path.suffix in ('.cpp', '.h') and path.is_file()]
    source = [path for path in files if path.parts[0] != 'tests']
    found = [line for path in source if path.parts[0] != 'app' for line in includes(path)]
    found += [line for path in source for line in namespaces(path)]

    # One of `files` repeats it as much as the folder's own word.
    found += [f'{path}: its name repeats the folder' for path in source
              if path.name.startswith(f'{path.parent.name.removesuffix("s")}_')]

    # What lies in core/drive and asks for "mcp/request.h" would get core/drive/mcp/request.h.
    found += [f'{path}: hides core/{path.parent.name}/{path.name} from what lies beside its folder' for path in source
              if path.parts[0] == 'core' and len(path.parts) > 3
              and pathlib.Path('core', path.parent.name, path.name).is_file()]

    # tests/core/drive/mcp/tst_x.cpp tests something of core/drive/mcp; whose folder moves, moves its tests.
    found += [f'{path}: there is no folder {path.parent.relative_to("tests")} that it could test' for path in files
              if path.parts[0] == 'tests' and path.parts[1] in ('core', 'widgets', 'app')
              and not path.parent.relative_to('tests').is_dir()]

    counts = {}
    for path in files:
        counts[path.parent] = counts.get(path.parent, 0) + 1
    found += [f'{folder}: {count} files, at most {MOST_FILES}' for folder, count in sorted(counts.items())
              if count > MOST_FILES]

    told, text = table()
    have = rooms(source)
    found += [f'ARCHITECTURE.md has no row for {room}' for room in sorted(have - told)]
    found += [f'ARCHITECTURE.md has a row for {room}, which is not there' for room in sorted(told - have)]
    widgets = {path.parts[1] for path in source if path.parts[0] == 'widgets' and len(path.parts) > 2}
    row = next((line for line in text.splitlines() if line.startswith('| `widgets`')), '')
    found += [f'ARCHITECTURE.md does not name widgets/{room}' for room in sorted(widgets) if f'`{room}`' not in row]
    found += untrue_names(text, source)
    found += lost_pages()
    print('\n'.join(found), end='\n' if found else '')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
