#!/usr/bin/env python3
"""Tests of the window of fbrdf-viewer that need a mouse, a keyboard and files to drop.

   tests/support/with_x.sh window_test.py VIEWER TOOL DROPPER [TEST...]
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from driver import Window, run

VIEWER = TOOL = DROPPER = ''


class WindowTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.gold = self.fitted('gold.fbrdf', 'ggx:alpha=0.3,f0=1.0/0.77/0.34,kd=0')
        self.paint = self.fitted('paint.fbrdf', 'ggx:alpha=0.2,f0=0.04,kd=0.3')
        self.windows = []

    def tearDown(self):
        for window in self.windows:
            if window.process.poll() is None:
                window.kill()
        self.temporary.cleanup()

    def fitted(self, name, source):
        path = self.folder / name
        done = run(TOOL, 'fit', source, '-o', path, '--form', 'hdio', '--smoothness', '0.001', '--environment-lobes', '1', '--quiet')
        self.assertEqual(done.returncode, 0, done.stderr)
        return path

    def window(self, *arguments, scene='--plain', size=(320, 240)):
        folder = self.folder / f'window{len(self.windows)}'
        folder.mkdir()
        self.windows.append(Window(VIEWER, DROPPER, folder, '--light-count', '2', scene, *arguments, size=size))
        return self.windows[-1]

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def test_a_dropped_material_is_shown(self):
        window = self.window('--material', self.gold)
        window.shows('gold.fbrdf')
        window.drop(self.paint)
        window.shows('paint.fbrdf')
        opened = window.close()['window']['opened']
        self.assertEqual([pathlib.Path(o['file']).name for o in opened], ['paint.fbrdf'])
        self.assertGreater(opened[0]['seconds'], 0.0)
        self.assertIsNone(opened[0]['why'])

    def test_a_dropped_measurement_is_fitted(self):
        rows = ['theta_i,phi_i,theta_o,phi_o,value']
        rows += [f'{i},0,{o},{p},0.2' for i in range(5, 80, 15) for o in range(5, 80, 15) for p in (0, 90, 180)]
        window = self.window('--material', self.gold)
        window.shows('gold.fbrdf')
        window.drop(self.file('grey paper.csv', '\n'.join(rows) + '\n'))
        window.shows('grey paper.csv')
        stats = window.close()['window']
        self.assertGreater(stats['opened'][0]['seconds'], 0.0)
        self.assertGreaterEqual(stats['materials_made'], 1)

    def test_a_broken_file_is_refused_in_the_words_of_the_tool_and_the_rest_goes_on(self):
        broken = self.file('broken.csv', 'theta_i,phi_i,theta_o,phi_o,value\n1,2,three,4,5\n')
        none = self.file('broken.fbrdf', 'this is no material')
        window = self.window('--material', self.gold)
        window.shows('gold.fbrdf')
        window.drop(broken)
        window.drop(none)
        window.drop(self.paint)
        window.shows('paint.fbrdf')
        opened = window.close()['window']['opened']
        for path, found in zip((broken, none), opened):
            told = run(TOOL, 'info', path).stderr.strip().removeprefix('fbrdf: ')
            self.assertEqual(found['why'], told)
            self.assertIsNone(found['seconds'])
        self.assertIsNone(opened[2]['why'])

    def test_a_fit_is_cancelled(self):
        merl = self.folder / 'measured.binary'
        run(TOOL, 'convert', 'ggx:alpha=0.3,f0=0.5,kd=0.2', merl)
        window = self.window('--material', self.gold)
        window.shows('gold.fbrdf')
        window.drop(merl)
        window.key('c')
        window.drop(self.paint)
        window.shows('paint.fbrdf')
        opened = window.close()['window']['opened']
        self.assertTrue(opened[0]['why'] or opened[0]['seconds'] is None, opened)
        self.assertGreater(opened[1]['seconds'], 0.0)

    def test_keys_drags_and_the_wheel_change_the_picture(self):
        window = self.window('--material', self.gold, '--mesh', 'knot', scene='--full', size=(480, 360))  # wider than its panel
        window.shows('gold.fbrdf')
        window.key('space')  # the turntable stands
        pictures = []

        def another_that_stands():
            picture = window.still()
            return picture if len(set(picture)) > 50 and picture not in pictures else None

        def take():
            pictures.append(window.wait('another picture that stands', another_that_stands))

        take()
        window.drag(380, 100, 420, 40)
        take()
        window.move(420, 40)
        window.wheel(True)
        take()
        window.key('plus')
        take()
        window.close()

    def test_it_may_be_one_pixel_and_back(self):
        window = self.window('--material', self.gold, '--material', self.paint)
        window.shows('gold.fbrdf')
        for size, name in (((1, 1), 'paint'), ((320, 240), 'gold'), ((1, 200), 'paint'), ((400, 1), 'gold'), ((320, 240), 'paint')):
            window.resize(*size)
            window.key('m')  # the next material: the window is alive
            window.shows(f'{name}.fbrdf')
        window.close()
        self.assertEqual(window.errors(), '')

    def test_two_at_once_do_not_disturb_each_other(self):
        first, second = self.window('--material', self.gold), self.window('--material', self.paint)
        first.shows('gold.fbrdf')
        second.shows('paint.fbrdf')
        second.drop(self.gold)
        second.shows('gold.fbrdf')
        second.close()
        first.shows('gold.fbrdf')
        self.assertEqual(len(first.close()['materials']), 1)


if __name__ == '__main__':
    VIEWER, TOOL, DROPPER = sys.argv[1:4]
    unittest.main(argv=[sys.argv[0], *(f'WindowTest.{name}' for name in sys.argv[4:])])
