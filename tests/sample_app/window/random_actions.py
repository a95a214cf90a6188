#!/usr/bin/env python3
"""Does random things in a window of fbrdf-viewer, and fails where it ends by itself or its memory grows.

   tests/support/with_x.sh tests/sample_app/window/random_actions.py VIEWER DROPPER [--actions N] [--minutes M] [--seed S]

With --minutes it goes on so long and prints the memory each minute: of the second half the mean must be at most a tenth, and 50 MB, above
that of the first. Needs xdotool."""
import argparse
import pathlib
import random
import sys
import tempfile
import time

from driver import Window, resident

KEYS = ['m', 't', 'l', 'k', 'plus', 'minus', 'o', 'e', 'comma', 'period', 'space', 'f', 'r', 'c', 'h', 'Tab', 'Return', 'Left', 'Right',
        'Up', 'Down', 'ctrl+z', 'ctrl+shift+z', 'Delete', 'a', 'd', 'g', 'i', 'j', 'n', 'p', 'u', 'v', 'w', 'x', 'y', 'b', '1', '2', '3']
SIZES = [(640, 480), (200, 150), (1, 1), (900, 300), (320, 640)]
GROWTH, GROWTH_BYTES = 1.1, 50e6


def made_files(folder):
    """What is dropped: good, broken, and what nobody can read."""
    rows = ['theta_i,phi_i,theta_o,phi_o,value']
    rows += [f'{i},0,{o},{p},{0.1 + 0.002 * abs(i - o)}' for i in range(5, 80, 15) for o in range(5, 80, 15) for p in (0, 90, 180)]
    texts = {
        'samples.csv': '\n'.join(rows) + '\n',
        'triangle.obj': 'v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n',
        'lights.json': '{"lights": [{"type": "point", "position": [2, 2, 2], "intensity": [20, 20, 20]}]}',
        'broken.json': '{"lights": [{',
        'broken.csv': 'theta_i,phi_i,theta_o,phi_o,value\n1,2,three,4,5\n',
        'broken.fbrdf': 'this is no material',
        'broken.hdr': '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 7 +X',
        'notes.txt': 'nothing that a viewer knows',
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    (folder / 'sky.hdr').write_bytes(b'#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n' + bytes([90, 100, 120, 129]) * 32)
    return [folder / name for name in [*texts, 'sky.hdr', 'missing.csv']]


def act(window, files, choose):
    """One action; returns its name."""
    width, height = 640, 480
    kind = choose.choices(['key', 'drag', 'wheel', 'click', 'drop', 'resize'], [10, 3, 2, 4, 2, 1])[0]
    if kind == 'key':
        kind = choose.choice(KEYS)
        window.key(kind)
    elif kind == 'drag':
        window.drag(choose.randrange(width), choose.randrange(height), choose.randrange(width), choose.randrange(height))
    elif kind == 'wheel':
        window.move(choose.randrange(width), choose.randrange(height))
        window.wheel(choose.random() < 0.5)
    elif kind == 'click':
        x, y = choose.randrange(300), choose.randrange(height)
        window.drag(x, y, x, y)
    elif kind == 'drop':
        file = choose.choice(files)
        kind += ' ' + file.name
        window.drop(file)
    else:
        size = choose.choice(SIZES)
        kind += f' {size}'
        window.resize(*size)
    return kind


def flat(samples):
    half = len(samples) // 2
    first, second = sum(samples[:half]) / half, sum(samples[half:]) / (len(samples) - half)
    print(f'memory, MB: mean of the first half {first / 1e6:.0f}, of the second {second / 1e6:.0f}')
    return second <= GROWTH * first + GROWTH_BYTES


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('viewer')
    parser.add_argument('dropper')
    parser.add_argument('--actions', type=int, default=200)
    parser.add_argument('--minutes', type=float, default=0.0)
    parser.add_argument('--seed', type=int, default=1)
    given = parser.parse_args()
    choose = random.Random(given.seed)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = made_files(folder)
        window = Window(given.viewer, given.dropper, folder, '--light-count', '2', '--mesh', 'sphere')
        done, memory, begun = [], [], time.monotonic()
        try:
            while len(done) < given.actions or time.monotonic() < begun + 60 * given.minutes:
                done.append(act(window, files, choose))
                if window.process.poll() is not None:
                    raise AssertionError(f'the viewer ended with {window.process.returncode}')
                if given.minutes and time.monotonic() > begun + 60 * len(memory):
                    memory.append(resident(window.process.pid))
                    print(f'{len(memory) - 1:4} min {len(done):6} actions {memory[-1] / 1e6:8.1f} MB', flush=True)
            window.resize(640, 480)
            window.close()
        except AssertionError as error:
            print(f'{error}\n{window.errors()}\nafter {len(done)} actions, the last of them: {", ".join(done[-12:])}', file=sys.stderr)
            window.kill()
            return 1
    print(f'{len(done)} actions')
    return 0 if len(memory) < 4 or flat(memory[1:]) else 1


if __name__ == '__main__':
    sys.exit(main())
