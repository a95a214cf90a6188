"""Drives a window of fbrdf-viewer by xdotool, as a person would, and reads its stats in the end. Needs a display
(tests/support/with_x.sh), xdotool, and the program xdnd_drop beside the tests."""
import json
import os
import pathlib
import subprocess
import time

PATIENCE = 240.0  # seconds for what takes a moment: a busy machine, a sanitizer
PAUSE = 0.02


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=PATIENCE)


def resident(pid):
    """Bytes of memory that a process has of its own."""
    for line in pathlib.Path(f'/proc/{pid}/status').read_text().splitlines():
        if line.startswith('RssAnon:'):
            return 1024 * int(line.split()[1])
    return 0


class Window:
    """A running viewer. folder: where it runs, and leaves stats and screenshots."""

    def __init__(self, viewer, dropper, folder, *arguments, size=(640, 480)):
        self.dropper = pathlib.Path(dropper).absolute()
        self.folder = pathlib.Path(folder)
        self.stats_file = self.folder / f'stats-{time.monotonic_ns()}.json'
        environment = {key: value for key, value in os.environ.items() if key != 'WAYLAND_DISPLAY'}
        with open(self.folder / 'stderr.txt', 'w') as log:
            self.process = subprocess.Popen(
                [pathlib.Path(viewer).absolute(), '--size', f'{size[0]}x{size[1]}', '--stats', self.stats_file, *map(str, arguments)],
                cwd=self.folder, stdout=subprocess.DEVNULL, stderr=log, env=environment)
        self.number = self.wait('a window', self.find)

    def find(self):
        found = run('xdotool', 'search', '--onlyvisible', '--pid', self.process.pid).stdout.split()
        return found[-1] if found else None

    def wait(self, what, ready):
        """What ready() gives, as soon as it is something."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if self.process.poll() is not None:
                raise AssertionError(f'the viewer ended with {self.process.returncode}: {self.errors()}')
            if found := ready():
                return found
            time.sleep(PAUSE)
        raise AssertionError(f'found no {what} in {PATIENCE} s: {self.errors()}')

    def errors(self):
        return (self.folder / 'stderr.txt').read_text()

    def title(self):
        return run('xdotool', 'getwindowname', self.number).stdout.strip()

    def shows(self, name):
        """Waits until the window's title says that a material is shown."""
        self.wait(f'title with {name}, but {self.title()}', lambda: name in self.title())

    def key(self, *keys):
        run('xdotool', 'key', '--window', self.number, *keys)

    def move(self, x, y):
        run('xdotool', 'mousemove', '--window', self.number, x, y)

    def drag(self, x, y, to_x, to_y):
        run('xdotool', 'mousemove', '--window', self.number, x, y, 'mousedown', 1)
        run('xdotool', 'mousemove', '--window', self.number, to_x, to_y, 'mouseup', 1)

    def wheel(self, up):
        run('xdotool', 'click', '4' if up else '5')

    def resize(self, width, height):
        run('xdotool', 'windowsize', self.number, width, height)

    def drop(self, *files):
        done = run(self.dropper, self.number, *files)
        assert done.returncode == 0, f'the window did not take {files}: {done.stderr}'

    def picture(self, path):
        """What is on the screen of the window."""
        run('import', '-window', self.number, path)

    def still(self):
        """The picture as it is when it becomes no better: the title does not end with dots any more. Needs a turntable that stands."""
        self.wait('picture that stands', lambda: not self.title().endswith('...'))
        self.picture(self.folder / 'window.ppm')
        return (self.folder / 'window.ppm').read_bytes()

    def hold(self, x, y, places):
        """A drag with the left button through places [(x, y)]; returns after the last, with the button still down."""
        run('xdotool', 'mousemove', '--window', self.number, x, y, 'mousedown', 1)
        for x, y in places:
            run('xdotool', 'mousemove', '--window', self.number, x, y)

    def close(self):
        """Its stats, after the key that ends it."""
        end = time.monotonic() + PATIENCE
        while self.process.poll() is None and time.monotonic() < end:
            self.key('Escape')
            time.sleep(0.2)
        run('xdotool', 'keyup', 'Escape')  # else the server repeats it: xdotool ends where its window does
        assert self.process.poll() is not None, 'the viewer did not end'
        assert self.process.returncode == 0, f'exit code {self.process.returncode}: {self.errors()}'
        return json.loads(self.stats_file.read_text())

    def kill(self):
        self.process.kill()
        self.process.wait()
