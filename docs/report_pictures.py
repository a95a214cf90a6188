#!/usr/bin/env python3
"""Cuts pictures out of a page that `fbrdf fit --report` wrote: the three standard spheres, and the maps, enlarged.

   report_pictures.py REPORT.html PREFIX     writes PREFIX-data.png, PREFIX-fit.png, PREFIX-difference.png
                                             and PREFIX-NAME.png for each map over directions or over a grid
"""
import base64
import re
import struct
import sys
import xml.etree.ElementTree as xml
import zlib

MAP_SIDE = 256  # pixels that the longer side of an enlarged map reaches at least, as many as a sphere has
WHITE = 255


def chunks(png):
    at = 8  # after the signature
    while at < len(png):
        length, kind = struct.unpack_from('>I4s', png, at)
        yield kind, png[at + 8:at + 8 + length]
        at += length + 12


def predictor(kind, left, up, corner):
    """The five filters of PNG (ISO 15948, section 9)."""
    if kind == 4:  # Paeth
        estimate = left + up - corner
        return min((left, up, corner), key=lambda value: abs(estimate - value))
    return (0, left, up, (left + up) // 2)[kind]


def decoded(png):
    """Rows of (r, g, b, a) of a PNG with 8-bit RGB or RGBA."""
    parts = list(chunks(png))
    width, height, depth, colour = struct.unpack_from('>IIBB', dict(parts)[b'IHDR'])
    if depth != 8 or colour not in (2, 6):
        sys.exit(f'{sys.argv[1]}: found a PNG of depth {depth} and colour type {colour}, expected 8-bit RGB or RGBA')
    channels = 4 if colour == 6 else 3
    data = zlib.decompress(b''.join(body for kind, body in parts if kind == b'IDAT'))
    stride = width * channels
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, line = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, corner = (line[i - channels], above[i - channels]) if i >= channels else (0, 0)
            line[i] = (line[i] + predictor(kind, left, above[i], corner)) & 255
        rows.append([tuple(line[i:i + channels]) + (255,) * (4 - channels) for i in range(0, stride, channels)])
        above = line
    return rows


def encoded(rows, scale):
    """An RGB PNG on white, each pixel `scale` pixels wide and high."""
    lines = bytearray()
    for row in rows:
        line = bytearray()
        for *colour, alpha in row:
            line += bytes((value * alpha + WHITE * (255 - alpha)) // 255 for value in colour) * scale
        lines += (b'\0' + line) * scale
    header = struct.pack('>IIBBBBB', len(rows[0]) * scale, len(rows) * scale, 8, 2, 0, 0, 0)
    png = b'\x89PNG\r\n\x1a\n'
    for kind, body in ((b'IHDR', header), (b'IDAT', zlib.compress(bytes(lines), 9)), (b'IEND', b'')):
        png += struct.pack('>I', len(body)) + kind + body + struct.pack('>I', zlib.crc32(kind + body))
    return png


def pictures(figure):
    """(alternative text, PNG) of a figure: of the picture itself, or of the map that a drawing is made of."""
    for image in figure.iter('img'):
        yield image.get('alt'), image.get('src')
    for drawing in figure.iter('svg'):
        for image in drawing.iter('image'):
            yield drawing.get('aria-label'), image.get('href')


def main():
    page, prefix = sys.argv[1:]
    names = {'Standard sphere, data': 'data', 'Standard sphere, fit': 'fit'}
    for figure in xml.parse(page).iter('figure'):
        for label, uri in pictures(figure):
            is_map = label.startswith('Map ')
            if not is_map and 'sphere' not in label and 'difference' not in label:
                continue
            name = label[len('Map '):] if is_map else names.get(label, 'difference')
            rows = decoded(base64.b64decode(re.sub('^data:image/png;base64,', '', uri)))
            scale = -(-MAP_SIDE // max(len(rows), len(rows[0]))) if is_map else 1
            with open(f'{prefix}-{name}.png', 'wb') as file:
                file.write(encoded(rows, scale))


main()
