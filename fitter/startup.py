#!/usr/bin/env python3
"""Prints processor time and peak memory of commands that have to be quick: --version, info and eval of a material.

   startup.py [FBRDF]     FBRDF: the program; build/bin/fbrdf by default. Measure a Release build.

Exit 1 where a command takes more than 0.05 s of processor time or 30 MB. Neighbours only ever add time, so each command
runs many times and the least time counts. Of memory the most counts; the kernel never reports less than what this script takes.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

RUNS = 25
MOST_SECONDS, MOST_MEGABYTES = 0.05, 30.0
ROOT = pathlib.Path(__file__).resolve().parent.parent
# A material of a usual size and one of two terms.
MATERIALS = (('ward-rolled-brass', 'hdio'), ('ggx:alpha=0.2', 'io+hdpio'))
PAIR = 'wo_x,wo_y,wo_z,wi_x,wi_y,wi_z\n0,0,1,0.6,0,0.8\n'


def run(command):
    """Seconds of processor time and megabytes of one run."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f'{" ".join(map(str, command))}: ended with {process.returncode}')
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0


def report(command, name):
    """Prints a line of the table; true within the limits."""
    runs = [run(command) for _ in range(RUNS)]
    seconds, megabytes = min(s for s, _ in runs), max(m for _, m in runs)
    print(f'{name:<32} {seconds:8.3f} s {megabytes:8.1f} MB')
    return seconds <= MOST_SECONDS and megabytes <= MOST_MEGABYTES


def main():
    fbrdf = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / 'build/bin/fbrdf').resolve()
    with tempfile.TemporaryDirectory() as folder:
        pairs = pathlib.Path(folder) / 'pairs.csv'
        pairs.write_text(PAIR)
        good = report([fbrdf, '--version'], '--version')
        for source, form in MATERIALS:
            material = pathlib.Path(folder) / 'material.fbrdf'
            subprocess.run([fbrdf, 'fit', source, '--form', form, '-o', material], check=True,
                           stdout=subprocess.DEVNULL)
            good &= report([fbrdf, 'eval', material, '--pairs', pairs], f'eval, {form}')
            good &= report([fbrdf, 'info', material], f'info, {form}')
    sys.exit(0 if good else f'expected at most {MOST_SECONDS} s and {MOST_MEGABYTES} MB each')


main()
