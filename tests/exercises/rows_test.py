"""The tables of the checks are right: run by make check-exercises.

A row of a table gives input and what is expected for it.  Here it is found a
second time, in rational arithmetic and where possible in two ways: what two
elements have in common must be the same whichever of the two it is computed
from.  A table that no rule below knows is an error.
"""
import re
import sys
import unittest
from collections import Counter
from fractions import Fraction
from pathlib import Path

EXERCISES = Path(__file__).resolve().parents[2] / "exercises"
TOKEN = re.compile(r"""(?P<word>"[^"]*"|\b[a-z]\w*)
    |(?P<hexadecimal>0x[\da-f.]+p[+-]?\d+)
    |(?P<decimal>\d+\.?\d*(?:e[+-]?\d+)?)|(?P<brace>[{}])""", re.X)


# The tables -------------------------------------------------------------------

def python_of(token):
    kind, text = token.lastgroup, token[0]
    if kind == "word":
        return {"true": "True", "false": "False"}.get(text, text)
    if kind == "brace":
        return "[" if text == "{" else "]"
    return f"Fraction({float.fromhex(text)!r})" if kind == "hexadecimal" \
        else f"Fraction('{text}')"


def rows_of(source):
    """The rows of the table that a loop test runs through, or None."""
    loop = re.search(r"check_run\([^;]*sizeof \*(\w+)", source)
    if not loop:
        return None
    table = re.search(rf"static const \w+ {loop[1]}\[\] = (.*?);", source, re.S)
    plain = re.sub(r"//.*", "", table[1])
    return eval(TOKEN.sub(python_of, plain), {"Fraction": Fraction})


# Vectors ----------------------------------------------------------------------

def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def between(a, b, t):
    return [(1 - t) * x + t * y for x, y in zip(a, b)]


def cut(simplex, t):
    """Where the edges of a simplex, of events (time, place), have a time."""
    return [between(a, b, t) for i, (s, a) in enumerate(simplex)
            for u, b in simplex[i + 1:] if s != u]


def staircase(element, pivot):
    """The swept simplex with a pivot, as events."""
    return [(0, vertex[0]) for vertex in element[:pivot + 1]] + \
        [(1, vertex[1]) for vertex in element[pivot:]]


def horizontal_edges(simplex):
    """From each time's first event to its others."""
    for time in 0, 1:
        first, *others = [place for t, place in simplex if t == time]
        yield from (minus(place, first) for place in others)


# The rules: each row's two sides ----------------------------------------------

def bent_edge(edge, t, corner):
    """Each of the two triangles is cut in a segment; they share an end."""
    late, early = (cut(staircase(edge, pivot), t) for pivot in (1, 0))
    yield sorted(early), sorted(corner[:2])
    yield sorted(late), sorted(corner[1:])
    yield between(*edge[0], t), corner[0]


def time_of_impact(triangle, c, t):
    """The time of the common event, from the point's side and the edge's."""
    s, times = [((0, 3), (0, 0, 0, 1, 1)),
                ((0, 2), (0, 0, 1, 1, 1))][int(triangle)]
    for side in s, tuple(i for i in range(5) if i not in s):
        weight = sum(c[i] for i in side)
        yield sum(c[i] * times[i] for i in side) / weight, t
    yield sum(c), 0
    yield len({(c[i] > 0) == (i in s) for i in range(5) if c[i]}), 1


def first_meeting(p, q, t):
    """Both are at one place then, and apart before."""
    gap = minus(p, q)
    if t == -1:
        yield gap[0] * gap[1] > 0, True
    else:
        yield between(p[:1], p[1:], t), between(q[:1], q[1:], t)
        yield gap[0] == 0, t == 0


def left_normal(edge, normal):
    for pivot, n in zip((1, 0), normal):
        along, = horizontal_edges(staircase(edge, pivot))
        yield dot(along, n), 0
        yield dot(n, n), int(any(along))
        yield cross(along, n) > 0, any(along)


def normal_velocity(point, edge, normal, velocity):
    """The point as seen from the pivot, and the pivot as seen from the point."""
    yield dot(normal, normal), 1
    for pivot, expected in zip((1, 0), velocity):
        seen = [minus(point[t], edge[pivot][t]) for t in (0, 1)]
        yield dot(minus(seen[1], seen[0]), normal), expected
        yield dot(minus(minus(edge[pivot][1], point[1]),
                        minus(edge[pivot][0], point[0])), normal), -expected


def three_normals(triangle, normal):
    """Perpendicular to both edges, as long as their parallelogram is large."""
    for pivot, n in zip((2, 1, 0), normal):
        u, v = horizontal_edges(staircase(triangle, pivot))
        yield (dot(u, n), dot(v, n)), (0, 0)
        yield dot(n, n), dot(u, u) * dot(v, v) - dot(u, v) ** 2
        turn = [cross(u[k:] + u[:k], v[k:] + v[:k]) for k in (1, 2, 0)]
        yield dot(n, turn), dot(n, n)


def bar(radius, ahead, turn, threshold):
    """The bar meets the point within the step, and not at once."""
    yield 0 < ahead / turn < 1, True
    yield 0 < threshold <= radius, True


def closed_mesh(_, vertices, count, triangle, closed):
    """As many edges run one way as the other; all vertices are used."""
    edges = Counter((t[i], t[i - 2]) for t in triangle for i in range(3))
    yield all(edges[b, a] == n for (a, b), n in edges.items()), closed
    yield len(triangle), count
    yield {v for t in triangle for v in t}, set(range(int(vertices)))


def same_direction(v, a, c, expected):
    u, w = minus(a, v), minus(c, v)
    yield cross(u, w) == 0 and dot(u, w) > 0, expected
    yield any(u) and dot(u, u) * dot(w, w) == dot(u, w) ** 2 \
        and dot(u, w) > 0, expected


RULES = {"01-2": bent_edge, "03-2": time_of_impact, "04-2": first_meeting,
         "05-1": left_normal, "05-2": normal_velocity, "06-1": three_normals,
         "09-3": bar, "13-1": closed_mesh, "13-2": same_direction}


def faults(rule, rows):
    for number, row in enumerate(rows):
        for found, expected in rule(*row):
            if found != expected:
                yield f"row {number}: {found}, not {expected}"


TWO_SIDES = """\
static const impact given[] = {
    {0, {3, -2, -1, 1, -1}, 0.25}, {0, {1, -1, -1, 1, 0}, 0.5}, // wrong
};
check_run(sizeof given / sizeof *given, test);
"""


class Rows(unittest.TestCase):
    def test_both_sides_of_every_row_agree(self):
        tables = {}
        for path in sorted(EXERCISES.glob("*.check.c")):
            rows = rows_of(path.read_text())
            if rows is not None:
                tables[path.name[:4]] = rows
        self.assertEqual(sorted(tables), sorted(RULES))
        for key, rows in tables.items():
            with self.subTest(key):
                self.assertGreater(len(rows), 1)
                self.assertEqual(list(faults(RULES[key], rows)), [])
        print(f"{sum(map(len, tables.values()))} rows of {len(tables)} tables: "
              "both sides agree.", file=sys.stderr)

    def test_finds_sides_that_differ(self):
        """The point would be there at 1/2, the edge at 0."""
        wrong = rows_of(TWO_SIDES)
        self.assertEqual(list(faults(time_of_impact, wrong)),
                         ["row 1: 0, not 1/2"])

    def test_every_rule_finds_a_wrong_number(self):
        """Any number of what is expected, if it is changed."""
        for key, rule in RULES.items():
            path, = EXERCISES.glob(f"{key}-*.check.c")
            for row in rows_of(path.read_text()):
                for wrong in changed(row[-1]):
                    if rule is not bar:
                        self.assertTrue(list(faults(rule, [[*row[:-1],
                                                            wrong]])), wrong)


def changed(value):
    """The value with each of its numbers made another."""
    if isinstance(value, list):
        for i, part in enumerate(value):
            for other in changed(part):
                yield [*value[:i], other, *value[i + 1:]]
    else:
        yield not value if isinstance(value, bool) else value + 1


if __name__ == "__main__":
    unittest.main(verbosity=0)
