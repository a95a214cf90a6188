#!/usr/bin/env python3
"""Writes the manual pages of a program and of its subcommands from what they print for --help.

   make_man.py PROGRAM VERSION FOLDER           FOLDER/PROGRAM.1, FOLDER/PROGRAM-SUBCOMMAND.1, ...; needs help2man
   make_man.py PROGRAM VERSION FOLDER --check   whether those pages name every option; exit code 1 where one does not
   make_man.py --self-test                      the check itself, on a page that must fail
"""
import pathlib
import re
import subprocess
import sys


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def summary(text):
    """The first sentence, as it goes on after a dash."""
    first = text.strip().splitlines()[0].split(': ')[0].rstrip('.')
    return first[0].lower() + first[1:]


def subcommands(text):
    _, _, listed = text.partition('\nSubcommands:\n')
    return re.findall(r'^  (\S+)', listed.split('\n\n')[0], re.MULTILINE)


def options(text):
    return re.findall(r'^  (?:-\w,)?(--[\w-]+)', text, re.MULTILINE)


def page(program, arguments, version, helped, see):
    """help2man's page with its own name, both spellings of an option in bold, and sections for what follows the options."""
    written = output('help2man', '--no-info', f'--version-string={version}', f'--name={summary(helped)}',
                     f'--help-option={" ".join([*arguments, "--help"])}', program)
    name = '-'.join([pathlib.Path(program).name, *arguments])
    for pattern, text in (
            (r'^\.TH \S+', f'.TH {name.upper()}'),
            (r'(?<=^\.SH NAME\n)\S+', name),
            (r'(?<=\\fR,)(\\-\\-[\w\\-]+)', r' \\fB\1\\fR'),
            (r'^\.SS "(\w+):"', r'.SH \1'),
            (r'^\.PP\nSOURCE is', '.SH SOURCES\nSOURCE is'),
            (r'^(?:\.PP\n)?Exit codes: ', '.SH "EXIT STATUS"\n')):
        written = re.sub(pattern, text, written, flags=re.MULTILINE)
    return written + '.SH "SEE ALSO"\n' + ',\n'.join(f'.BR {other} (1)' for other in see if other != name) + '\n'


def pages(program):
    """{file: (arguments, help)}"""
    name = pathlib.Path(program).name
    helped = output(program, '--help')
    found = {f'{name}.1': ([], helped)}
    for command in subcommands(helped):
        found[f'{name}-{command}.1'] = ([command], output(program, command, '--help'))
    return found


def missing(written, helped):
    plain = written.replace('\\-', '-')
    return [option for option in options(helped) if option not in plain]


def self_test():
    helped = 'Usage: x\n\nOptions:\n  -h,--help   this\n  --max-size N   bytes\n'
    return 0 if missing('\\fB\\-\\-help\\fR', helped) == ['--max-size'] else 1


def check(program, folder):
    faults = 0
    for file, (_, helped) in pages(program).items():
        for option in missing((folder / file).read_text(), helped):
            print(f'{file}: found no {option}, which --help has', file=sys.stderr)
            faults += 1
    return 1 if faults else 0


def main(program, version, folder, *rest):
    folder = pathlib.Path(folder)
    if rest == ('--check',):
        return check(program, folder)
    folder.mkdir(parents=True, exist_ok=True)
    found = pages(program)
    for file, (arguments, helped) in found.items():
        see = [pathlib.Path(other).stem for other in found]
        (folder / file).write_text(page(program, arguments, version, helped, see))
    return 0


if __name__ == '__main__':
    sys.exit(self_test() if sys.argv[1:] == ['--self-test'] else main(*sys.argv[1:]))
