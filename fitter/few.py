#!/usr/bin/env python3
"""Prints how near fits to few samples come to the whole material, with a prior and without, on materials that the prior
   has not seen.

   few.py [options] [FBRDF]     FBRDF: the program; build/bin/fbrdf by default

The networks of MERL's materials are parted into groups. For each group a prior is learned from all other groups, and the
materials of the group are fitted from samples: at random on the axes of MERL's grid, or at the directions of the plan
that was learned with that prior. Errors are PSNR in dB of the standard sphere (fbrdf compare), mean and least over
materials, the standard deviation of the mean over draws, and the most that a fit without the prior is better ("loses";
its mean over draws for one material comes second). No fit ends for want of time, so the figures are the same on
every machine.
"""
import argparse
import json
import math
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = 'wo_x,wo_y,wo_z,wi_x,wi_y,wi_z'
LEAST = math.sin(math.radians(2.0))  # elevation


def pair(theta_h, theta_d, phi_d):
    """wo and wi with phi_h = 0."""
    x, y, z = math.sin(theta_d) * math.cos(phi_d), math.sin(theta_d) * math.sin(phi_d), math.cos(theta_d)
    c, s = math.cos(theta_h), math.sin(theta_h)
    return (-x * c + z * s, -y, x * s + z * c, x * c + z * s, y, -x * s + z * c)


def random_pairs(count, rng):
    pairs = []
    while len(pairs) < count:
        p = pair(rng.random() ** 2 * math.pi / 2, rng.random() * math.pi / 2, rng.random() * math.pi)
        if p[2] > LEAST and p[5] > LEAST:
            pairs.append(p)
    return pairs


def planned_pairs(count, path):
    lines = path.read_text().splitlines()[1:count + 1]
    return [pair(*(math.radians(float(a)) for a in line.split(','))) for line in lines]


def run(*command, text=None):
    done = subprocess.run([str(c) for c in command], input=text, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f'{" ".join(map(str, command))}: {done.stderr.strip()}')
    return done.stdout


def samples_csv(fbrdf, source, pairs, noise, rng):
    rows = [','.join(f'{v:.9g}' for v in p) for p in pairs]
    values = run(fbrdf, 'eval', source, '--pairs', '-', text='\n'.join([COLUMNS] + rows) + '\n').splitlines()[1:]
    lines = [COLUMNS + ',r,g,b']
    for row, value in zip(rows, values):
        noisy = [max(0.0, float(v)) * math.exp(rng.gauss(0.0, noise)) for v in value.split(',')[-3:]]
        lines.append(row + ',' + ','.join(f'{v:.9g}' for v in noisy))
    return '\n'.join(lines) + '\n'


def fitted(fbrdf, source, prior, csv, folder):
    """PSNR, and whether the fit called the material unlike all that the prior knows."""
    fit = json.loads(run(fbrdf, 'fit', csv, '-o', folder / 'm.fbrdf', '--prior', prior, '--seconds', 0, '--environment-lobes', 0, '--json'))
    errors = json.loads(run(fbrdf, 'compare', folder / 'm.fbrdf', source, '--json'))['errors']
    return errors['psnr_linear'], bool(fit['prior'] and fit['prior']['unlike'])


def judged(task):
    options, source, prior, plan, kind, count, draw = task
    rng = random.Random(f'{source} {kind} {count} {draw}')
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        pairs = planned_pairs(count, plan) if kind == 'planned' else random_pairs(count, rng)
        csv = folder / 'samples.csv'
        csv.write_text(samples_csv(options.fbrdf, source, pairs, options.noise, rng))
        with_prior, unlike = fitted(options.fbrdf, source, prior, csv, folder)
        return [with_prior, fitted(options.fbrdf, source, 'none', csv, folder)[0], unlike]


def learned(options, sources, planned, folder, pool):
    """(source, prior, plan) of each material that is judged."""
    def learn(group):
        prior, plan = folder / f'{group}.prior', folder / f'{group}.csv'
        known = [s for i, s in enumerate(sources) if i % options.groups != group]
        run(options.fbrdf, 'learn-prior', *known, '-o', prior, '--plan', plan, '--planned', planned, '--quiet')
        return [(source, prior, plan) for source in sources[group::options.groups][::options.every]]
    return [judge for judges in pool.map(learn, range(options.groups)) for judge in judges]


def print_row(count, kind, tasks, results):
    by_draw, lost = {}, {}
    for task, (prior, none, _) in zip(tasks, results):
        by_draw.setdefault(task[6], []).append(prior)
        lost.setdefault(task[1], []).append(none - prior)
    means = [statistics.mean(psnrs) for psnrs in by_draw.values()]
    spread = statistics.stdev(means) if len(means) > 1 else 0.0
    loses = f'{max(map(max, lost.values())):.1f} / {max(map(statistics.mean, lost.values())):.1f}'
    print(f'{count:7} {kind:10} {statistics.mean(means):11.1f} {min(r[0] for r in results):6.1f} {spread:6.2f}   '
          f'{statistics.mean(r[1] for r in results):10.1f} {min(r[1] for r in results):6.1f}   {loses:>11}   '
          f'{sum(r[2] for r in results)} of {len(results)}', flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('fbrdf', nargs='?', default=ROOT / 'build/bin/fbrdf')
    parser.add_argument('--data', default=ROOT.parent / 'shared/data', type=pathlib.Path)
    parser.add_argument('--groups', default=4, type=int)
    parser.add_argument('--samples', default='16,64,1458')
    parser.add_argument('--draws', default=5, type=int)
    parser.add_argument('--noise', default=0.0, type=float, help='standard deviation, relative')
    parser.add_argument('--every', default=1, type=int, help='judge one material of so many')
    parser.add_argument('--jobs', default=2, type=int)
    options = parser.parse_args()
    weights = options.data / 'nbrdf/nbrdf_weights.f32'
    lines = (options.data / 'nbrdf/materials.txt').read_text().split('\n')
    sources = [f'{weights}#{line.split()[1]}' for line in lines if line.startswith('merl ')]
    counts = [int(n) for n in options.samples.split(',')]
    print(f'{"samples":>7} {"directions":10} {"prior: mean":>11} {"least":>6} {"spread":>6}   {"none: mean":>10} {"least":>6}   {"loses":>11}   unlike',
          flush=True)
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(options.jobs) as pool:
        judges = learned(options, sources, max(counts), pathlib.Path(name), pool)
        for count in counts:
            for kind in ('random', 'planned'):
                draws = range(options.draws if kind == 'random' or options.noise > 0 else 1)
                tasks = [(options, *judge, kind, count, draw) for judge in judges for draw in draws]
                print_row(count, kind, tasks, list(pool.map(judged, tasks)))


if __name__ == '__main__':
    main()
