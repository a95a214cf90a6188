#!/usr/bin/env python3
"""Checks that pages point to what exists: relative links, and paths of the repository in backticks.

   check_links.py ROOT         every Markdown page below ROOT; exit 1 and a line for each fault
   check_links.py --self-test  the checker itself, on a page that must fail
"""
import pathlib
import re
import sys
import tempfile

LINK = re.compile(r'\]\(([^)#\s]+)[^)]*\)')
PATH = re.compile(r'`((?:runtime|fitter|plugin|sample_app|tests|docs|cmake|\.ci)/[^`\s]+)`')
PLACEHOLDER = re.compile(r'[A-Z]{3,}|New[A-Z]|[*{<]')  # `plugin/ENGINE` and patterns name no file; README.md does
BUILT = {'.git', 'shared'}


def pages(root):
    for page in sorted(root.rglob('*.md')):
        parts = page.relative_to(root).parts
        if not any(part in BUILT or part.startswith('build') for part in parts[:-1]):
            yield page


def is_placeholder(path):
    return PLACEHOLDER.search(path.replace('README', '').replace('CMakeLists', '').replace('CHANGELOG', ''))


def text_lines(page):
    """(number, line) outside blocks of code, where [](...) begins a function."""
    is_code = False
    for number, line in enumerate(page.read_text().splitlines(), 1):
        if line.lstrip().startswith('```'):
            is_code = not is_code
        elif not is_code:
            yield number, line


def faults_of(page, root):
    for number, line in text_lines(page):
        where = f'{page.relative_to(root)}:{number}'
        for link in LINK.findall(line):
            if not re.match(r'[a-z]+:', link) and not (page.parent / link).exists():
                yield f'{where}: found a link to {link}, expected a file'
        for path in PATH.findall(line):
            if not is_placeholder(path) and not (root / path.rstrip('.,')).exists():
                yield f'{where}: found `{path}`, expected a path of the repository'


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / 'docs').mkdir()
        (root / 'docs' / 'there.md').write_text('[up](../page.md) [web](https://example.org) `docs/NAME.md`\n')
        (root / 'page.md').write_text('[gone](docs/gone.md) [there](docs/there.md) `runtime/gone.cpp` `docs/there.md`\n'
                                      '```cpp\n[](void*, const char*) {}\n```\n')
        found = [fault for page in pages(root) for fault in faults_of(page, root)]
    expected = ['page.md:1: found a link to docs/gone.md, expected a file',
                'page.md:1: found `runtime/gone.cpp`, expected a path of the repository']
    return [] if found == expected else [f'self-test: found {found}, expected {expected}']


def main():
    if sys.argv[1] == '--self-test':
        faults = self_test()
    else:
        root = pathlib.Path(sys.argv[1]).resolve()
        faults = [fault for page in pages(root) for fault in faults_of(page, root)]
    print('\n'.join(faults))
    sys.exit(1 if faults else 0)


main()
