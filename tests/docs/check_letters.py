#!/usr/bin/env python3
"""Checks that pages spell the letters in the names of forms out as `fbrdf forms` does.

   check_letters.py FBRDF PAGE...      exit 1 and a line for each letter that a page lacks or explains in other words
"""
import json
import pathlib
import subprocess
import sys


def main():
    fbrdf, *pages = sys.argv[1:]
    forms = json.loads(subprocess.run([fbrdf, 'forms', '--json'], check=True, capture_output=True, text=True).stdout)
    rows = [f'| `{entry["letters"]}` | {entry["meaning"]} |' for entry in forms['letters']]
    faults = [f'{page}: found no line "{row}"' for page in pages for row in rows
              if row not in pathlib.Path(page).read_text().splitlines()]
    print('\n'.join(faults))
    sys.exit(1 if faults or not rows else 0)


main()
