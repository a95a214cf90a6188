#!/usr/bin/env python3
"""How soon and how smoothly a window of fbrdf-viewer shows things, beside the figures that it should reach.

   tests/support/with_x.sh tests/sample_app/window/reach.py VIEWER TOOL DROPPER

VIEWER, TOOL: fbrdf-viewer and fbrdf of a Release build; DROPPER: xdnd_drop, which the tests build. Needs xdotool. Seconds depend on what
else the machine does: each figure is that of the fastest of five runs. Exit code 1 where one is not reached."""
import itertools
import pathlib
import sys
import tempfile
import time

from driver import Window, run

RUNS = 5
SLIDER = 40, 160  # pixels: near the left end of the slider of alpha, the third row below the name of the material
DRAG_SECONDS, DRAG_STEP, DRAG_WIDTH = 4.0, 3, 120
LIGHTS = ['--light-count', '4']


def first_picture(viewer, dropper, folder, material):
    window = Window(viewer, dropper, folder, '--material', material, *LIGHTS)
    window.shows(pathlib.Path(material).name)
    return window.close()['window']['first_picture_seconds']


def dropped(viewer, dropper, folder, material, merl):
    """Seconds to the first picture of a dropped file, and the longest frame while it was fitted."""
    window = Window(viewer, dropper, folder, '--material', material, *LIGHTS)
    window.shows(pathlib.Path(material).name)
    settle(window)
    window.drop(merl)
    window.shows(pathlib.Path(merl).name)
    stats = window.close()['window']
    return stats['opened'][0]['seconds'], stats['longest_while_fitting']


def settle(window):
    """Waits until the environment has come, and lets the turntable turn again."""
    window.key('space')
    window.still()
    window.key('space')


def fits_a_second(viewer, dropper, folder):
    """That the window makes while GGX's alpha is dragged to and fro, and shows."""
    window = Window(viewer, dropper, folder, '--material', 'ggx:alpha=0.3,f0=0.9/0.6/0.3,kd=0.1', '--form', 'hdio', *LIGHTS)
    window.shows('ggx')
    settle(window)
    end = time.monotonic() + DRAG_SECONDS
    window.hold(*SLIDER, to_and_fro(end))
    run('xdotool', 'mouseup', 1)
    stats = window.close()['window']
    return stats['made_while_held'] / max(stats['seconds_while_held'], DRAG_SECONDS)


def to_and_fro(end):
    """Places along the slider, until the clock says so."""
    x, y = SLIDER
    for step in itertools.count():
        if time.monotonic() > end:
            return
        yield x + abs(step * DRAG_STEP % (2 * DRAG_WIDTH) - DRAG_WIDTH), y


def main(viewer, tool, dropper):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        material, merl = folder / 'ready.fbrdf', folder / 'measured.binary'
        run(tool, 'fit', 'ggx:alpha_x=0.12,alpha_y=0.4,f0=1.0/0.77/0.34', '-o', material, '--form', 'pqpr')
        run(tool, 'convert', 'ggx:alpha=0.15,f0=0.9/0.6/0.3,kd=0.1', merl)
        first = min(first_picture(viewer, dropper, folder, material) for _ in range(RUNS))
        drops = [dropped(viewer, dropper, folder, material, merl) for _ in range(RUNS)]
        fits = max(fits_a_second(viewer, dropper, folder) for _ in range(RUNS))
    rows = [('first picture of a ready material, s', first, 1.0),
            ('a dropped MERL file is seen, s', min(drop[0] for drop in drops), 1.5),
            ('longest frame while it is fitted, 640 x 480, 4 lights, ms', min(drop[1] for drop in drops), 100.0)]
    for name, found, asked in rows:
        print(f'{name:60} {found:8.2f}   asked {asked:g}')
    asked = 10.0
    print(f'{"fits a second while alpha of GGX is dragged, hdio":60} {fits:8.2f}   asked {asked:g}')
    return 0 if all(found <= asked for _, found, asked in rows) and fits >= asked else 1


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
