#!/usr/bin/env python3
"""Draws what a frame costs by the lights that reach a pixel, from `fbrdf-bench --reach --json` on stdin, as SVG on stdout."""
import json
import math
import sys

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 400, 70, 150, 30, 50


def scale(values, low, high):
    first, last = math.log2(min(values)), math.log2(max(values))
    return lambda x: low + (math.log2(x) - first) / (last - first) * (high - low)


def line(rows, key, across, up, colour, name):
    places = [(across(row["reaching"] if key != "one_list" else row["wanted"]), up(row[key])) for row in rows]
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    dots = "".join(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in places)
    x, y = places[-1]
    return (f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>{dots}'
            f'<text x="{x + 8:.1f}" y="{y + 4:.1f}" fill="{colour}">{name}</text>\n')


def main():
    measured = json.load(sys.stdin)
    rows = measured["rows"]
    times = [row[key] for row in rows for key in ("clustered", "one_list", "building")]
    counts = [row["wanted"] for row in rows]
    across = scale(counts, LEFT, WIDTH - RIGHT)
    up = scale(times, HEIGHT - BOTTOM, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
           f'font-size="12"><rect width="100%" height="100%" fill="white"/>\n']
    for count in counts:
        x = across(count)
        out.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}" stroke="#ddd"/>'
                   f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 18}" text-anchor="middle">{count}</text>\n')
    tick = 2.0 ** math.ceil(math.log2(min(times)))
    while tick <= max(times):
        y = up(tick)
        out.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#ddd"/>'
                   f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{tick:g}</text>\n')
        tick *= 4.0
    out.append(line(rows, "clustered", across, up, "#c33", f'{measured["lights"]} lights in lists'))
    out.append(line(rows, "building", across, up, "#888", "of it to build them"))
    out.append(line(rows, "one_list", across, up, "#36c", "one list of as many"))
    size = "x".join(str(side) for side in measured["size"])
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 10}" text-anchor="middle">lights that reach a pixel</text>'
               f'<text x="{LEFT}" y="18">ms a frame ({measured["clock"]} time, {size} pixels, '
               f'{measured["renderer"].split(" (")[0]})</text>\n</svg>\n')
    sys.stdout.write("".join(out))


main()
