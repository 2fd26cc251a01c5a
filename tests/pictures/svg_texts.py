# SPDX-License-Identifier: Apache-2.0
"""Where the texts of an SVG picture stand, and what is wrong with their places.

Widths are those of a wide sans serif (DejaVu Sans): viewers that have no Helvetica take such a one.
"""

import math
import re
import xml.etree.ElementTree

# A part of the font's size for each letter, by classes of letters.
WIDTHS = {"ijlI.,:;'|! ": 0.32, "frt()[]/-\"": 0.40, "mwMW%@+=<>~": 0.86, "ABDGHNOQU": 0.75}
NARROWEST = 0.32
USUAL = 0.62
# The height above the line that letters stand on, and below it: of the letters that most texts have.
ABOVE = 0.72
BELOW = 0.20


def width_of(text):
    return sum(next((width for letters, width in WIDTHS.items() if c in letters), USUAL) for c in text)


def numbers(text):
    return [float(number) for number in re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text or "")]


def transform_of(text):
    """The matrix (a b c d e f) of a transform: translate, rotate, scale and matrix, in their order."""
    a, b, c, d, e, f = 1.0, 0.0, 0.0, 1.0, 0.0, 0.0
    for name, arguments in re.findall(r"(\w+)\(([^)]*)\)", text or ""):
        n = numbers(arguments)
        if name == "translate":
            m = (1, 0, 0, 1, n[0], n[1] if len(n) > 1 else 0)
        elif name == "rotate":
            angle = math.radians(n[0])
            m = (math.cos(angle), math.sin(angle), -math.sin(angle), math.cos(angle), 0, 0)
        elif name == "scale":
            m = (n[0], 0, 0, n[-1], 0, 0)
        elif name == "matrix":
            m = tuple(n)
        else:
            raise ValueError(f"transform {name} is not known here")
        a, b, c, d, e, f = (a * m[0] + c * m[1], b * m[0] + d * m[1], a * m[2] + c * m[3], b * m[2] + d * m[3],
                            a * m[4] + c * m[5] + e, b * m[4] + d * m[5] + f)
    return a, b, c, d, e, f


def times(outer, inner):
    a, b, c, d, e, f = outer
    g, h, i, j, k, m = inner
    return (a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * m + e, b * k + d * m + f)


def texts(svg):
    """Every text of a picture with its box: (text, left, top, right, bottom), and the picture's own box."""
    root = xml.etree.ElementTree.fromstring(svg)
    view = numbers(root.get("viewBox")) or [0.0, 0.0, *numbers(root.get("width")), *numbers(root.get("height"))]
    found = []

    def walk(node, matrix, size, anchor):
        matrix = times(matrix, transform_of(node.get("transform")))
        size = (numbers(node.get("font-size")) or [size])[0]
        anchor = node.get("text-anchor", anchor)
        if node.tag.endswith("}text"):
            text = "".join(node.itertext()).strip()
            inner = next((one for one in node.iter() if one.get("font-size")), node)
            size = (numbers(inner.get("font-size")) or [size])[0]
            if text:
                place(text, matrix, size, anchor, numbers(node.get("x") or "0")[0], numbers(node.get("y") or "0")[0])
            return
        for child in node:
            walk(child, matrix, size, anchor)

    def place(text, matrix, size, anchor, x, y):
        width = size * width_of(text)
        x -= {"start": 0.0, "middle": 0.5, "end": 1.0}[anchor] * width
        corners = [(matrix[0] * u + matrix[2] * v + matrix[4], matrix[1] * u + matrix[3] * v + matrix[5])
                   for u in (x, x + width) for v in (y - ABOVE * size, y + BELOW * size)]
        found.append((text, min(u for u, _ in corners), min(v for _, v in corners), max(u for u, _ in corners),
                      max(v for _, v in corners)))

    walk(root, (1.0, 0.0, 0.0, 1.0, 0.0, 0.0), 12.0, "start")
    return found, (view[0], view[1], view[0] + view[2], view[1] + view[3])


def misplaced(svg):
    """What is wrong with the places of a picture's texts, in sentences: out of the picture, or one over another."""
    found, (left, top, right, bottom) = texts(svg)
    faults = []
    for text, x0, y0, x1, y1 in found:
        if x0 < left or y0 < top or x1 > right or y1 > bottom:
            faults.append(f"'{text}' leaves the picture: {x0:.0f}..{x1:.0f} of {left:.0f}..{right:.0f}, "
                          f"{y0:.0f}..{y1:.0f} of {top:.0f}..{bottom:.0f}")
    for i, (text, x0, y0, x1, y1) in enumerate(found):
        for other, u0, v0, u1, v1 in found[:i]:
            over = min(x1, u1) - max(x0, u0), min(y1, v1) - max(y0, v0)
            # Boxes that touch are not yet over one another.
            if over[0] > 1.0 and over[1] > 1.0:
                faults.append(f"'{text}' stands over '{other}' at {max(x0, u0):.0f}, {max(y0, v0):.0f}")
    return faults
