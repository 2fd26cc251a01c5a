#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""comparison_seeds.py FOLDER FILE..: inputs of the target `comparison` from CSV files: of each two neighbouring columns a curve,
whose points are the result's and the reference's by turns."""
import csv
import math
import pathlib
import struct
import sys

MOST_POINTS = 120  # of both curves
LARGEST = 300.0  # numbers are hundredths in two bytes
MOST_CURVES = 4  # of a file


def columns(path):
    """Returns the columns of the rows that are numbers throughout, thinned."""
    rows = []
    with open(path, encoding='utf-8', errors='replace', newline='') as lines:
        for row in csv.reader(line for line in lines if not line.startswith('#')):
            try:
                rows.append([float(field) for field in row])
            except ValueError:
                continue
    rows = [row for row in rows if len(row) == len(rows[-1]) and all(map(math.isfinite, row))]
    return list(zip(*rows[::len(rows) // MOST_POINTS + 1]))


def hundredths(column):
    """Returns a column as numbers of the target, of its own scale."""
    size = max(abs(number) for number in column) or 1.0
    return [round(100.0 * LARGEST * number / size) for number in column]


def seed(kind, abscissa, value):
    """Returns an input: tolerances by the kind, number of points of the result, points of both."""
    points = [struct.pack('<hh', *point) for point in zip(hundredths(abscissa), hundredths(value))]
    result, reference = points[::2], points[1::2]
    return bytes([kind % 16, 0x8a, len(result)]) + b''.join(result + reference)


def main():
    folder = pathlib.Path(sys.argv[1])
    kind = 0
    for name in sys.argv[2:]:
        found = columns(name)
        for i in range(min(len(found) - 1, MOST_CURVES)):
            kind += 1
            (folder / f'{pathlib.Path(name).stem}_{i + 1}').write_bytes(seed(kind, found[i], found[i + 1]))


main()
