# SPDX-License-Identifier: Apache-2.0
"""Sketches of the connection types as SVG.

Directions are (x, y, z): to the right, up, to the front. What belongs to node a is grey, what belongs to node b is blue; what the type frees is
a green mark, what it holds an orange one: a straight arrow for a displacement or force, a turned one for a rotation or moment.
"""
import math
import re

RIGHT, UP, FRONT = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def add(p, d, t=1.0):
    return tuple(a + t * b for a, b in zip(p, d))


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def unit(d):
    return tuple(a / math.hypot(*d) for a in d)


def flat(p):
    """A point on the paper; y is down there."""
    return 0.94 * p[0] - 0.46 * p[2], 0.20 * p[0] - p[1] + 0.40 * p[2]


def path(points, look, close=True):
    return f'<path class="{look}" d="M' + "L".join(f"{x:.1f} {y:.1f}" for x, y in points) + ("Z" if close else "") + '"/>'


def text(at, words, look=""):
    """Words at a point on the paper; what stands behind _ is an index."""
    head, _, index = words.partition("_")
    index = f'<tspan class="index" dy="4">{index}</tspan>' if index else ""
    return f'<text class="{look}" x="{at[0]:.1f}" y="{at[1] + 4:.1f}">{head}{index}</text>'


def circle(c, d, r, begin=0.0, end=360.0, steps=36):
    """Points on the paper of a circle, or an arc, about direction d."""
    u = unit(cross(d, UP if abs(d[1]) < 0.9 * math.hypot(*d) else FRONT))
    v = cross(unit(d), u)
    return [flat(add(add(c, u, r * math.cos(t)), v, r * math.sin(t)))
            for t in (math.radians(begin + (end - begin) * n / steps) for n in range(steps + 1))]


def hull(points):
    chain = []
    for ordered in (sorted(points), sorted(points, reverse=True)):
        side = []
        for p in ordered:
            while len(side) > 1 and ((side[-1][0] - side[-2][0]) * (p[1] - side[-2][1]) - (side[-1][1] - side[-2][1]) * (p[0] - side[-2][0])) <= 0:
                side.pop()
            side.append(p)
        chain += side[:-1]
    return chain


def rod(p, q, r, look, end=None):
    """A cylinder from p to q, of radius end at q if that is another; the end at q is the one that is seen."""
    d = add(q, p, -1)
    far = circle(q, d, r if end is None else end)
    return path(hull(circle(p, d, r) + far), f"{look} side") + path(far, f"{look} face")


def box(low, high, look):
    (a, b, c), (x, y, z) = low, high
    return (path([flat(p) for p in ((a, b, z), (x, b, z), (x, y, z), (a, y, z))], f"{look} side")
            + path([flat(p) for p in ((a, y, c), (x, y, c), (x, y, z), (a, y, z))], f"{look} face")
            + path([flat(p) for p in ((x, b, c), (x, y, c), (x, y, z), (x, b, z))], f"{look} shade"))


def ball(c, r, look):
    x, y = flat(c)
    return f'<circle class="{look} side" cx="{x:.1f}" cy="{y:.1f}" r="{r}"/>'


def ring(c, d, r, look):
    return path(circle(c, d, r), look)


def line(p, q, look="axis"):
    return path([flat(p), flat(q)], look, close=False)


def head(at, back, look, size=9.0):
    """The head of an arrow whose shaft comes from `back`, both on the paper."""
    x, y = at[0] - back[0], at[1] - back[1]
    n = math.hypot(x, y)
    x, y = size * x / n, size * y / n
    return path([at, (at[0] - x - 0.42 * y, at[1] - y + 0.42 * x), (at[0] - x + 0.42 * y, at[1] - y - 0.42 * x)], f"{look} head")


def straight(c, d, at, look, words, both):
    """An arrow along d at a distance from c: to and fro, or towards c."""
    near, far = flat(add(c, d, at)), flat(add(c, d, at + 36))
    out = math.hypot(far[0] - near[0], far[1] - near[1]) / 12
    label = (far[0] + (far[0] - near[0]) / out + (4 if d[0] else 0), far[1] + (far[1] - near[1]) / out)
    return path([near, far], look, close=False) + head(near, far, look) + (head(far, near, look) if both else "") + text(label, words, look)


def turned(c, d, at, look, words, both, r=17, begin=-60, end=210):
    arc = circle(add(c, d, at), d, r, begin, end)
    away = flat(add((0, 0, 0), d))
    if abs(away[0]) > 0.8:  # below one about the direction to the right, beside one about that up, outside of others
        label = add(max(arc, key=lambda p: p[1]), (0, 13))
    elif abs(d[1]) > 0.8 or end - begin < 90:
        label = add(max(arc), (25, 0))
    else:
        label = add(min(arc), (-20, 6))
    return path(arc, look, close=False) + head(arc[-1], arc[-3], look) + (head(arc[0], arc[2], look) if both else "") + text(label, words, look)


def size(p, q, words, off=(0, 12)):
    """A length of the formula."""
    p, q = flat(p), flat(q)
    middle = ((p[0] + q[0]) / 2 + off[0], (p[1] + q[1]) / 2 + off[1])
    return path([p, q], "size", close=False) + head(p, q, "size", 6) + head(q, p, "size", 6) + text(middle, words, "size")


def plate(*more):
    """A plane under what slides on it."""
    return box((-110, -12, -80), (110, 0, 80), "a") + "".join(more)


def shafts(*more):
    """Two shafts along 3 that meet at an angle."""
    return (rod((-130, 0, 0), (-14, 0, 0), 14, "a") + rod((6, 4, 0), (105, 58, 0), 14, "b") + ball((0, 0, 0), 17, "a")
            + line((0, 0, 0), (150, 0, 0)) + "".join(more))


def cardan_cross(*more):
    """A cross between two forks: pins along 1 turn in that of a, pins along 3 in that of b."""
    def pin(d, near, far, r=8):
        return rod(add((0, 0, 0), d, near), add((0, 0, 0), d, far), r, "pin")
    return (rod((0, -92, 0), (0, -70, 0), 13, "a") + box((-71, -70, -10), (71, -58, 10), "a") + box((-71, -58, -10), (-53, 16, 10), "a")
            + box((-9, -16, -71), (9, 58, -53), "b") + pin(FRONT, -62, 47) + pin(RIGHT, -53, -46, 15) + pin(RIGHT, -46, 46) + ball((0, 0, 0), 13, "pin")
            + pin(RIGHT, 46, 53, 15) + box((53, -58, -10), (71, 16, 10), "a") + pin(RIGHT, 71, 84) + pin(FRONT, 13, 53)
            + box((-9, -16, 53), (9, 58, 71), "b") + pin(FRONT, 71, 84) + box((-9, 58, -71), (9, 70, 71), "b") + rod((0, 70, 0), (0, 92, 0), 13, "b") + "".join(more))


def gimbal(outer, middle, inner):
    """Three rings, one in the other, the last around a ball; each turns about a direction of the one before."""
    return (ring((0, 0, 0), outer, 78, "ring a") + ring((0, 0, 0), middle, 62, "ring pin") + ring((0, 0, 0), inner, 46, "ring b") + ball((0, 0, 0), 24, "b"))


BELT = [(-100, -60), *((42 * math.cos(math.radians(t)), 42 * math.sin(math.radians(t))) for t in range(142, 36, -3)), (125, -95)]
# Of each type: the components to the right, up and to the front; the body; of each component where its mark stands: origin, direction, distance,
# and of a turned one its radius.
SKETCHES = {
    "SLOT": ((1, 2, 3), box((-120, -26, -34), (120, 0, 34), "a") + path([flat(p) for p in ((-104, 0, -9), (104, 0, -9), (104, 0, 9), (-104, 0, 9))], "hole")
             + rod((0, -4, 0), (0, 40, 0), 9, "b"), {1: ((0, 18, 0), RIGHT, 22), 2: ((0, 0, 0), UP, 48), 3: ((0, 12, 0), FRONT, 44)}),
    "SLIDE-PLANE": ((3, 1, 2), plate(box((-32, 0, -30), (32, 30, 30), "b")), {3: ((0, 8, 0), RIGHT, 44), 1: ((0, 0, 0), UP, 44), 2: ((0, 8, 0), FRONT, 50)}),
    "CYLINDRICAL": ((1, 2, 3), rod((-125, 0, 0), (120, 0, 0), 20, "b") + rod((-55, 0, 0), (45, 0, 0), 36, "a ghost") + line((-150, 0, 0), (160, 0, 0))
                    + size((120, 0, 0), (120, 20, 0), "R", (11, 2)) + size((-55, -50, 0), (45, -50, 0), "L"),
                    {1: ((0, 0, 0), RIGHT, 146), 4: ((0, 0, 0), RIGHT, 86, 32), 2: ((0, 0, 0), UP, 42), 5: ((0, 0, 0), UP, 116), 3: ((0, 0, 0), FRONT, 42),
                     6: ((0, 0, 0), FRONT, 124)}),
    "TRANSLATOR": ((1, 2, 3), box((-125, -16, -16), (120, 16, 16), "b") + box((-55, -32, -32), (45, 32, 32), "a ghost")
                   + size((120, 0, 0), (120, 16, 16), "R_r", (14, 6)) + size((-55, -44, 32), (45, -44, 32), "L"),
                   {1: ((0, 0, 0), RIGHT, 146), 4: ((0, 0, 0), RIGHT, 84, 30), 2: ((0, 0, 0), UP, 40), 5: ((0, 0, 0), UP, 116), 3: ((0, 0, 0), FRONT, 42),
                    6: ((0, 0, 0), FRONT, 124)}),
    "HINGE": ((1, 2, 3), box((-45, -78, -30), (45, -66, 30), "a") + box((-45, -68, -12), (45, 0, 12), "a") + rod((-86, 0, 0), (46, 0, 0), 17, "b")
              + rod((-45, 0, 0), (45, 0, 0), 34, "a ghost") + rod((46, 0, 0), (56, 0, 0), 30, "b") + box((56, -12, -9), (66, 80, 9), "b")
              + rod((66, 0, 0), (88, 0, 0), 17, "b") + line((-110, 0, 0), (150, 0, 0)) + size((-45, -98, 0), (45, -98, 0), "L_s")
              + size((88, 0, 0), (88, 17, 0), "R_p", (15, -4)) + size((56, 0, 0), (56, -30, 0), "R_a", (14, 12)),
              {1: ((0, 0, 0), RIGHT, 156), 4: ((0, 0, 0), RIGHT, 124), 2: ((0, 0, 0), UP, 42), 5: ((0, 0, 0), UP, 116), 3: ((0, 0, 0), FRONT, 42),
               6: ((0, 0, 0), FRONT, 124)}),
    "PLANAR": ((3, 1, 2), plate(rod((0, 0, 0), (0, 22, 0), 48, "b"), path(circle((0, 22, 0), UP, 17), "hole"), size((0, 22, 0), (0, 22, -48), "R", (14, -2)),
                                size((0, 22, 0), (-17, 22, 0), "R_i", (-17, 4))),
               {3: ((0, 8, 0), RIGHT, 56), 6: ((0, 8, 0), RIGHT, 140), 1: ((0, 0, 0), UP, 58), 4: ((0, 0, 0), UP, 30, 60), 2: ((0, 8, 0), FRONT, 56),
                5: ((0, 8, 0), FRONT, 140)}),
    "UJOINT": ((1, 2, 3), cardan_cross(size((0, -26, 0), (62, -26, 0), "L_a"), size((71, 28, -10), (53, 28, -10), "L_s", (12, -12)),
                                       size((84, 0, 0), (84, 8, 0), "R_p", (15, -7)), size((-46, 0, 0), (-46, 15, 0), "R_a", (14, -10))),
               {1: ((0, 0, 0), RIGHT, 152), 4: ((0, 0, 0), RIGHT, 124), 2: ((0, 0, 0), UP, 96), 5: ((0, 0, 0), (0, -1, 0), 82, 26), 3: ((0, 0, 0), FRONT, 150),
                6: ((0, 0, 0), FRONT, 112)}),
    "JOIN": ((1, 2, 3), rod((0, -90, 0), (0, -30, 0), 12, "a") + ball((0, 0, 0), 40, "a") + ball((0, 0, 0), 29, "b") + rod((0, 26, 0), (0, 60, 0), 9, "b"),
             {1: ((0, 0, 0), RIGHT, 48), 2: ((0, 0, 0), UP, 66), 3: ((0, 0, 0), FRONT, 60)}),
    "LINK": ((1, 2, 3), ball((-90, 0, 0), 15, "a") + rod((-78, 0, 0), (76, 0, 0), 7, "pin") + ball((90, 0, 0), 15, "b") + line((-130, 0, 0), (-106, 0, 0)),
             {1: ((0, 0, 0), RIGHT, 112)}),
    "AXIAL": ((1, 2, 3), ball((-105, 0, 0), 13, "a") + rod((-10, 0, 0), (92, 0, 0), 8, "b") + rod((-94, 0, 0), (18, 0, 0), 18, "a ghost") + ball((105, 0, 0), 13, "b"),
              {1: ((0, 0, 0), RIGHT, 124)}),
    "RADIAL-THRUST": ((3, 1, 2), rod((-120, -40, 0), (120, -40, 0), 11, "a") + line((30, -40, 0), (30, 40, 0)) + ball((30, 46, 0), 14, "b"),
                      {1: ((30, -40, 0), UP, 10), 3: ((30, 46, 0), RIGHT, 24)}),
    "CARTESIAN": ((1, 2, 3), line((-80, -40, 0), (60, -40, 0)) + line((60, -40, 0), (60, -40, 70)) + line((60, -40, 70), (60, 40, 70)) + line((-80, -40, 0), (60, 40, 70))
                  + ball((-80, -40, 0), 13, "a") + ball((60, 40, 70), 13, "b"),
                  {1: ((60, 40, 70), RIGHT, 22), 2: ((60, 40, 70), UP, 22), 3: ((60, 40, 70), FRONT, 24)}),
    "PROJECTION CARTESIAN": ((1, 2, 3), line((-85, -45, 0), (50, 30, 0)) + box((-99, -59, -14), (-71, -31, 14), "a")
                             + path(hull([flat(p) for p in ((30, 24, 0), (62, 10, 0), (76, 42, 0), (44, 56, 0))]), "b face"),
                             {1: ((53, 33, 0), (0.97, 0.22, 0), 28), 2: ((53, 33, 0), (-0.22, 0.97, 0), 28), 3: ((53, 33, 0), FRONT, 34)}),
    "ALIGN": ((1, 2, 3), box((-110, -34, -26), (-58, 18, 26), "a") + box((10, -14, -26), (62, 38, 26), "b") + line((-84, -8, 0), (36, 12, 0)),
              {4: ((36, 12, 0), RIGHT, 58), 5: ((36, 12, 0), UP, 56), 6: ((36, 12, 0), FRONT, 66)}),
    "REVOLUTE": ((1, 2, 3), line((-140, 0, 0), (150, 0, 0)) + rod((-70, 0, 0), (-30, 0, 0), 40, "a") + rod((10, 0, 0), (50, 0, 0), 40, "b"),
                 {4: ((0, 0, 0), RIGHT, 100), 5: ((30, 0, 0), UP, 64), 6: ((30, 0, 0), FRONT, 76)}),
    "UNIVERSAL": ((1, 2, 3), cardan_cross(), {4: ((0, 0, 0), RIGHT, 112), 5: ((0, 0, 0), UP, 84, 26), 6: ((0, 0, 0), FRONT, 112)}),
    "CONSTANT VELOCITY": ((3, 1, 2), shafts(*(ball((4 * math.cos(t), 26 * math.sin(t), 26 * math.cos(t)), 6, "pin") for t in (0.3, 1.5, 2.6, 4.0, 5.2)),
                                              ball((0, 0, 0), 37, "a ghost")), {5: ((0, 0, 0), RIGHT, -90, 26)}),
    "CARDAN": ((1, 2, 3), gimbal(RIGHT, UP, FRONT), {4: ((0, 0, 0), RIGHT, 112), 5: ((0, 0, 0), UP, 104), 6: ((0, 0, 0), FRONT, 124)}),
    "EULER": ((1, 2, 3), gimbal(FRONT, RIGHT, (0, 0.6, 0.8)), {4: ((0, 0, 0), FRONT, 124), 5: ((0, 0, 0), RIGHT, 112), 6: ((0, 0, 0), (0, 0.9, 0.44), 112)}),
    "ROTATION": ((1, 2, 3), line((-60, -50, 0), (80, 66, 0)) + ball((0, 0, 0), 38, "b") + line((34, 28, 0), (80, 66, 0)),
                 {4: ((0, 0, 0), RIGHT, 76), 5: ((0, 0, 0), UP, 72), 6: ((0, 0, 0), FRONT, 88)}),
    "FLEXION-TORSION": ((3, 1, 2), shafts(), {4: ((0, 0, 0), FRONT, 0, 138, 180, 208), 5: ((6, 4, 0), (0.88, 0.48, 0), 76, 24), 6: ((0, 0, 0), RIGHT, -90, 26)}),
    "PROJECTION FLEXION-TORSION": ((3, 1, 2), shafts(), {4: ((0, 0, 0), UP, 56), 5: ((0, 0, 0), FRONT, 60), 6: ((6, 4, 0), (0.88, 0.48, 0), 76, 24)}),
    "BUSHING": ((1, 2, 3), rod((-42, 0, 0), (42, 0, 0), 46, "a") + path(circle((42, 0, 0), RIGHT, 37), "rubber") + rod((42, 0, 0), (58, 0, 0), 16, "b")
                + path(circle((58, 0, 0), RIGHT, 8), "hole"),
                {1: ((0, 0, 0), RIGHT, 72), 4: ((0, 0, 0), RIGHT, 156), 2: ((0, 0, 0), UP, 50), 5: ((0, 0, 0), UP, 120), 3: ((0, 0, 0), FRONT, 56),
                 6: ((0, 0, 0), FRONT, 140)}),
    "SLIPRING": ((1, 2, 3), rod((0, 0, -14), (0, 0, 14), 38, "b") + line((0, 0, 14), (-30, 23, 14)) + line((0, 0, 14), (30, 23, 14)) + text((-5, -14), "α", "size")
                 + path([flat((x, y, 14)) for x, y in BELT], "belt", close=False) + ball((-104, -64, 14), 10, "a") + ball((129, -101, 14), 10, "pin")
                 + text((-92, 16), "f1") + text((66, 98), "f_bc") + text((-122, 44), "a") + text((-10, 32), "b") + text((136, 132), "c"),
                 {1: ((-113, -50, 14), (0.61, 0.79, 0), 40), 2: ((46, 35, 14), (0.61, -0.79, 0), 20), 3: ((-104, -64, 14), (-0.61, -0.79, 0), 14)}),
    "CONTACT": ((3, 1, 2), plate(ball((0, 26, 0), 26, "b"), rod((0, 27, 0), (0, 66, 0), 26, "b")),
                {3: ((0, 10, 0), RIGHT, 40), 1: ((0, 0, 0), UP, 76), 2: ((0, 10, 0), FRONT, 46)}),
}


def identity(name):
    return f"sketch-{name.lower().replace(' ', '-')}"


def labels(name):
    """The lengths that a sketch shows."""
    shown = re.findall(r'<text class="size"[^>]*>(.*?)</text>', SKETCHES[name][1])
    return {re.sub("<[^>]*>", "", words.replace("<tspan", "_<tspan")) for words in shown}


def sketch(name, held, free):
    """The SVG of a type; `held` and `free` are what the program says: f1, m2, .., CP1, CPR3, .."""
    axes, body, marks = SKETCHES[name]
    drawn = ""
    for words in (*held, *free):
        component = int(words[-1]) + (3 if words.startswith(("m", "CPR")) else 0)
        c, d, at, *more = marks[component]
        draw = turned if component > 3 else straight
        drawn += draw(c, d, at, "free" if words in free else "held", words, words in free, *more)
    triad = "".join(path([(-176, 118), (-176 + 0.75 * x, 118 + 0.75 * y)], "triad", close=False) + text((-176 + x, 118 + y), str(component))
                    for component, (x, y) in zip(axes, (flat(add((0, 0, 0), d, 32)) for d in (RIGHT, UP, FRONT))))
    words = f"Sketch of {name}: free {', '.join(free) or 'nothing'}; held {', '.join(held) or 'nothing'}"
    return f'<svg class="sketch" viewBox="-210 -160 420 310" role="img" aria-label="{words}"><g id="{identity(name)}" class="joint">{body}{drawn}</g><g class="joint">{triad}</g></svg>'
