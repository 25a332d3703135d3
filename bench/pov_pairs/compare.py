#!/usr/bin/env python3
"""Renders pairs of scenes with lray and POV-Ray and tells how much the pictures differ.

compare.py --lray build/release/lray [--keep DIRECTORY] [NAME...]
compare.py A B          two pictures that are there: PFM, or linear PPM or PNG of 8 or 16 bits

Differences are of linear values, over all pixels and channels; what POV-Ray writes is rounded to
1/65535. Pixels that differ by more than a thousandth are counted: along edges a ray may hit on one
side only. Exit code 1 when a pair differs more than that explains.
"""

import argparse
import array
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).resolve().parent
NAMES = ["sphere", "plane", "triangle", "cylinder", "shadow", "mirror", "glass", "texture"]
EDGE = 1e-3  # more is another surface, not rounding
LARGEST_EDGE_SHARE = 2e-3
# lray averages a texture over the pixel, POV-Ray looks it up at one point: cells have such edges.
LARGEST_TEXTURED_EDGE_SHARE = 8e-2
LARGEST_RMS_BESIDE_EDGES = 5e-5


class Picture:
    """Linear values, row by row from the top left, three for each pixel."""

    def __init__(self, width, height, values):
        self.width, self.height, self.values = width, height, values


def header_words(data, count):
    """Returns words of a PPM or PFM header and where the pixels begin."""
    words, at = [], 0
    while len(words) < count:
        while data[at : at + 1].isspace() or data[at : at + 1] == b"#":
            at = data.index(b"\n", at) if data[at : at + 1] == b"#" else at + 1
        end = at
        while not data[end : end + 1].isspace():
            end += 1
        words.append(data[at:end])
        at = end
    return words, at + 1


def read_ppm(data):
    (_, width, height, maximum), at = header_words(data, 4)
    width, height, maximum = int(width), int(height), int(maximum)
    count = 3 * width * height
    kind = "B" if maximum < 256 else "H"
    values = struct.unpack_from(f">{count}{kind}", data, at)
    return Picture(width, height, [value / maximum for value in values])


def read_pfm(data):
    (_, width, height, scale), at = header_words(data, 4)
    width, height = int(width), int(height)
    floats = array.array("f", data[at : at + 12 * width * height])
    if (float(scale) < 0) != (sys.byteorder == "little"):
        floats.byteswap()
    rows = [floats[3 * width * y : 3 * width * (y + 1)] for y in range(height)]
    return Picture(width, height, [value for row in reversed(rows) for value in row])


def unfilter(raw, row_size, step, height):
    """Undoes the filters of PNG (PNG 1.2, 6) and returns the bytes of all rows."""
    before, rows = bytearray(row_size), bytearray()
    for y in range(height):
        first = y * (row_size + 1)
        kind, row = raw[first], bytearray(raw[first + 1 : first + 1 + row_size])
        for i in range(row_size):
            left = row[i - step] if i >= step else 0
            up, corner = before[i], before[i - step] if i >= step else 0
            if kind == 1:
                guess = left
            elif kind == 2:
                guess = up
            elif kind == 3:
                guess = (left + up) // 2
            elif kind == 4:
                at = left + up - corner
                guess = min((left, up, corner), key=lambda value: abs(at - value))
            else:
                guess = 0
            row[i] = (row[i] + guess) & 255
        rows += row
        before = row
    return bytes(rows)


def read_png(data):
    at, packed, header = 8, b"", None
    while at < len(data):
        size, name = struct.unpack_from(">I4s", data, at)
        body = data[at + 8 : at + 8 + size]
        if name == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif name == b"IDAT":
            packed += body
        at += size + 12
    width, height, bits, color, _, _, interlaced = header
    channels = {0: 1, 2: 3, 4: 2, 6: 4}.get(color)
    if channels is None or bits not in (8, 16) or interlaced:
        raise ValueError("a PNG without palette and interlacing, of 8 or 16 bits, is read")
    step = channels * bits // 8
    plain = unfilter(zlib.decompress(packed), width * step, step, height)
    kind = "B" if bits == 8 else "H"
    values = struct.unpack(f">{width * height * channels}{kind}", plain)
    used = (0, 0, 0) if channels < 3 else (0, 1, 2)
    maximum = 2**bits - 1
    pixels = range(0, len(values), channels)
    return Picture(width, height, [values[p + c] / maximum for p in pixels for c in used])


def read_picture(path):
    data = pathlib.Path(path).read_bytes()
    readers = {b"P6": read_ppm, b"PF": read_pfm, b"\x89P": read_png}
    if data[:2] not in readers:
        raise ValueError(f"{path}: neither PPM (P6), PFM nor PNG")
    return readers[data[:2]](data)


def compare(a, b):
    """Returns the largest difference, the root of the mean square, the same of all pixels that are
    no edges, and the share of those that are."""
    if (a.width, a.height) != (b.width, b.height):
        raise ValueError("the pictures differ in size")
    # `max` would pass a NaN over.
    gaps = [abs(x - y) if x == x and y == y else math.inf for x, y in zip(a.values, b.values)]
    pixels = [gaps[i : i + 3] for i in range(0, len(gaps), 3)]
    beside = [gap for pixel in pixels if max(pixel) <= EDGE for gap in pixel]

    def rms(values):
        return math.sqrt(sum(value * value for value in values) / max(1, len(values)))

    edges = sum(max(pixel) > EDGE for pixel in pixels)
    return max(gaps), rms(gaps), rms(beside), max(beside, default=0.0), edges / len(pixels)


def run(command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")


def render(lray, name, directory):
    scene = HERE / name
    ours, theirs = directory / f"{name}.pfm", directory / f"{name}.ppm"
    run([lray, "-n", "1", "--shading", "full", "-i", f"{scene}.lrs", "-o", ours, "--quiet"])
    # No antialiasing: one ray through the middle of each pixel, like level 1 of lray.
    run(["povray", f"+I{scene}.pov", f"+O{theirs}", f"+L{HERE}", "+FP16", "File_Gamma=1",
         "+W320", "+H240", "-A", "-D", "-V", "-P"])
    return read_picture(ours), read_picture(theirs)


def show(name, a, b):
    largest, all_rms, rms, beside, edges = compare(a, b)
    numbers = f"{largest:11.6f} {all_rms:11.8f} {100 * edges:8.3f} % {beside:12.6f} {rms:12.8f}"
    print(f"{name:10} {numbers}")
    share = LARGEST_TEXTURED_EDGE_SHARE if name == "texture" else LARGEST_EDGE_SHARE
    return rms <= LARGEST_RMS_BESIDE_EDGES and edges <= share


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lray", default="build/release/lray")
    parser.add_argument("--keep", type=pathlib.Path, help="where the pictures stay")
    parser.add_argument("names", nargs="*", metavar="NAME")
    arguments = parser.parse_args()
    print(f"{'':10} {'max':>11} {'rms':>11} {'edges':>10} {'max beside':>12} {'rms beside':>12}")
    names = arguments.names or NAMES
    if len(names) == 2 and all(pathlib.Path(name).is_file() for name in names):
        return 0 if show("", *map(read_picture, names)) else 1
    for program in ("povray", arguments.lray):
        if shutil.which(program) is None:
            sys.exit(f"{program} is missing")
    with tempfile.TemporaryDirectory() as temporary:
        directory = arguments.keep or pathlib.Path(temporary)
        directory.mkdir(parents=True, exist_ok=True)
        agree = [show(name, *render(arguments.lray, name, directory)) for name in names]
    return 0 if all(agree) else 1


if __name__ == "__main__":
    sys.exit(main())
