#!/usr/bin/env python3
"""Looks for classes of one qualified name in two files: one program would mix their functions.

   check_names.py ROOT          prints them; exit 1 where there are any
   check_names.py --self-test   checks that a made clash is seen

Members of anonymous namespaces do not count. Reads C++ as clang-format writes it here: a namespace is opened in a line
of its own, and closed by a line with a comment.
"""
import pathlib
import re
import sys
import tempfile

FOLDERS = ('runtime', 'fitter', 'plugin', 'sample_app')
OPENS = re.compile(r'^(?:inline )?namespace ?([\w:]*) ?\{$')
CLOSES = re.compile(r'^\}  // namespace')
CLASS = re.compile(r'^(?:struct|class|union|enum class) (\w+)(?: final)?(?: : [^;]*)?(?: ?\{.*)?$')


def classes(path):
    """Qualified names of the classes that a file defines."""
    namespaces = []
    for line in path.read_text().splitlines():
        if opened := OPENS.match(line):
            namespaces.append(opened.group(1))
        elif CLOSES.match(line):
            namespaces.pop()
        elif (found := CLASS.match(line)) and namespaces and '' not in namespaces:
            yield '::'.join(namespaces + [found.group(1)])


def clashes(root):
    owners = {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob('*')):
            if path.suffix in ('.h', '.hpp', '.cpp', '.inl'):
                for name in set(classes(path)):
                    owners.setdefault(name, []).append(str(path.relative_to(root)))
    return [f'{name}: found in {", ".join(paths)}, expected one class of this name'
            for name, paths in sorted(owners.items()) if len(paths) > 1]


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / 'runtime').mkdir()
        text = 'namespace fbrdf {{\n{0}\nstruct Image {{\n}};\n{1}\n}}  // namespace fbrdf\n'
        (root / 'runtime/a.h').write_text(text.format('', ''))
        (root / 'runtime/b.h').write_text(text.format('namespace {', '}  // namespace'))
        assert clashes(root) == [], clashes(root)
        (root / 'runtime/c.cpp').write_text(text.format('', ''))
        assert clashes(root) == ['fbrdf::Image: found in runtime/a.h, runtime/c.cpp, expected one class of this name']


if sys.argv[1:] == ['--self-test']:
    self_test()
else:
    found = clashes(pathlib.Path(sys.argv[1]))
    print('\n'.join(found))
    sys.exit(1 if found else 0)
