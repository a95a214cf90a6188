#!/usr/bin/env python3
"""Prints the processor time that `fbrdf info` takes for a million rows of each format of scattered rows, and how it grows.

   info.py [--rows N] [FBRDF]     FBRDF: the program; build/bin/fbrdf by default. Measure a Release build.

Rows are pairs all over the hemisphere, or within 3 degrees of the mirror direction, with the values of a rough metal. The
growth is the time of N rows over that of N / 4: 4 is linear. Exit 1 above 2 s a million rows.
"""
import argparse
import array
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOST_SECONDS = 2.0


def value(theta_i, phi_i, theta_o, phi_o):
    """A lobe about the mirror direction, radians."""
    x = math.sin(theta_i) * math.cos(phi_i) + math.sin(theta_o) * math.cos(phi_o)
    y = math.sin(theta_i) * math.sin(phi_i) + math.sin(theta_o) * math.sin(phi_o)
    z = math.cos(theta_i) + math.cos(theta_o)
    return 0.05 + 5.0 * math.exp(-20.0 * (x * x + y * y) / (z * z))


def angles(count, near_mirror):
    """theta_i, phi_i, theta_o, phi_o and f of each row, degrees."""
    rng = random.Random(1)
    for _ in range(count):
        theta_i, phi_i = math.acos(rng.uniform(0.05, 1.0)), rng.uniform(0.0, 2.0 * math.pi)
        theta_o, phi_o = math.acos(rng.uniform(0.05, 1.0)), rng.uniform(0.0, 2.0 * math.pi)
        if near_mirror:
            theta_o = abs(theta_i + math.radians(rng.uniform(-3.0, 3.0)))
            phi_o = phi_i + math.pi + math.radians(rng.uniform(-3.0, 3.0))
        f = value(theta_i, phi_i, theta_o, phi_o)
        yield tuple(math.degrees(a) for a in (theta_i, phi_i, theta_o, phi_o)) + (f,)


def direction(theta, phi):
    theta, phi = math.radians(theta), math.radians(phi)
    return math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta)


def text(head, row):
    """A writer of lines."""
    def write(path, rows):
        with open(path, 'w', encoding='ascii') as file:
            file.write(head)
            file.writelines(row(*r) for r in rows)
    return write


def columns(path, rows):
    numbers = array.array('f')
    for r in rows:
        numbers.extend(r)
    if sys.byteorder == 'big':
        numbers.byteswap()
    with open(path, 'wb') as file:
        file.write(b'fbrdf-columns 1\ntheta_i,phi_i,theta_o,phi_o,value\n%d\n' % (len(numbers) // 5))
        numbers.tofile(file)


def pab(path, rows):
    with open(path, 'w', encoding='ascii') as file:
        for i, (ti, pi, to, po, f) in enumerate(rows):
            if i % 10000 == 0:
                light = ti, pi
                file.write('#incident_angle %.4f %.4f\n#format: theta phi BRDF\n' % light)
            file.write('%.4f %.4f %.6g\n' % (to, po, f))


def vectors(separator, numbers):
    template = separator.join(['%.6f'] * 6 + ['%.6g'] * numbers) + '\n'
    return lambda ti, pi, to, po, f: template % (direction(to, po) + direction(ti, pi) + (f,) * numbers)


def four(template):
    return lambda ti, pi, to, po, f: template % (ti, pi, to, po, f)


FORMATS = (
    ('csv', 'a.csv', text('wo_x,wo_y,wo_z,wi_x,wi_y,wi_z,r,g,b\n', vectors(',', 3))),
    ('csv of angles', 'a.csv', text('theta_i,phi_i,theta_o,phi_o,value\n', four('%.4f,%.4f,%.4f,%.4f,%.6g\n'))),
    ('csv, quoted', 'a.csv', text('theta_i,phi_i,theta_o,phi_o,value\n', four('"%.4f","%.4f","%.4f","%.4f","%.6g"\n'))),
    ('columns', 'a.f32c', columns),
    ('scattered', 'a.txt', text('', vectors(' ', 3))),
    ('alta', 'a.alta', text('#DIM 4 1\n#PARAM_IN SPHERICAL_TL_PL_TV_PV\n#PARAM_OUT INV_STERADIAN\n',
                            lambda *r: '%.6f %.6f %.6f %.6f %.6g\n' % (*(math.radians(a) for a in r[:4]), r[4]))),
    ('astm', 'a.astm', text('VARS theta_i,phi_i,theta_s,phi_s,v\n', four('%.4f %.4f %.4f %.4f %.6g\n'))),
    ('lumos', 'a.txt', text('# phi_i theta_i phi_o theta_o brdf\n', four('%.4f %.4f %.4f %.4f %.6g\n'))),
    ('pab', 'a.bme', pab),
    ('rt300s', 'a.csv', text('stage_deg,theta_i_deg,A_deg,R_deg,brdf\n',
                             lambda ti, pi, to, po, f: '%.4f,%.4f,%.4f,%.4f,%.6g\n' % (pi, ti, po, to, f))),
    ('nist', 'a.csv', text('lambda,thetai,phi,thetar,phir,f_r\n', lambda *r: '0.532,%.4f,%.4f,%.4f,%.4f,%.6g\n' % r)),
)


def seconds(fbrdf, path):
    process = subprocess.Popen([fbrdf, 'info', path], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f'{path}: found an error of info, expected none')
    return usage.ru_utime + usage.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('fbrdf', nargs='?', default=ROOT / 'build/bin/fbrdf')
    parser.add_argument('--rows', default=1_000_000, type=int)
    options = parser.parse_args()
    slow = False
    print(f'{"format":<16} {"directions":<12} {"MB":>6} {"s a million":>12} {"growth":>7}')
    with tempfile.TemporaryDirectory() as folder:
        for near_mirror in (False, True):
            for name, file, write in FORMATS:
                path, times = pathlib.Path(folder) / file, []
                for rows in (options.rows // 4, options.rows):
                    write(path, angles(rows, near_mirror))
                    times.append(min(seconds(options.fbrdf, path) for _ in range(3)))
                rate = times[1] * 1e6 / options.rows
                print(f'{name:<16} {"near mirror" if near_mirror else "everywhere":<12} {path.stat().st_size / 1e6:6.1f} '
                      f'{rate:12.2f} {times[1] / times[0]:7.1f}', flush=True)
                slow |= rate > MOST_SECONDS
                path.unlink()
    return 1 if slow else 0


if __name__ == '__main__':
    sys.exit(main())
