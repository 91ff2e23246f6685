"""Show determinants whose errors come near to the bounds that are proved.

Every entry, every product and every sum but the last is rounded by almost u,
all in the worst direction: entries are 1 + x, less or more than the true ones
by the double below u, and the x are chosen such that products fall just short
of the middle between two doubles.  The errors are exact fractions.
"""

import sys
from fractions import Fraction

U = Fraction(1, 2**53)
BELOW_U = 2.0**-53 * (1 - 2.0**-53)

PLANE = [["0x1.0000002000000p+0", "0x1.0000002d023ffp+0"],
         ["0x1.0000002d8091dp+0", "0x1.0000004000000p+0"]]
PLANE_REST = [[1, -1], [-1, 1]]
SPACE = [["0x1.00000016a0155p+0", "0x1.00000016a0154p+0", "0x0p+0"],
         ["-0x1.0000002cc803cp+0", "0x1.0000002cc803cp+0",
          "-0x1.0000002dfd42ap+0"],
         ["-0x1.0000002c8837bp+0", "0x1.0000002c8837bp+0",
          "0x1.0000002dbbbe0p+0"]]
SPACE_REST = [[1, 1, 0], [-1, 1, -1], [-1, 1, 1]]


def entries(rounded, rest):
    """The rounded entries, and the true ones, differences of two doubles."""
    e = [[float.fromhex(text) for text in row] for row in rounded]
    subtrahend = [[-sign * BELOW_U for sign in row] for row in rest]
    for to, one in zip(e, subtrahend):
        assert [a - b for a, b in zip(to, one)] == to
    return e, [[Fraction(a) - Fraction(b) for a, b in zip(to, one)]
               for to, one in zip(e, subtrahend)]


def plane():
    e, d = entries(PLANE, PLANE_REST)
    down, up = e[0][0] * e[1][1], e[0][1] * e[1][0]
    determinant = d[0][0] * d[1][1] - d[0][1] * d[1][0]
    return Fraction(down) - Fraction(up) - determinant, abs(down) + abs(up)


def space():
    # The third part is zero, so that the last addition rounds nothing.
    e, d = entries(SPACE, SPACE_REST)
    yz, zy = e[1][1] * e[2][2], e[1][2] * e[2][1]
    zx, xz = e[1][2] * e[2][0], e[1][0] * e[2][2]
    number = e[0][0] * (yz - zy) + e[0][1] * (zx - xz)
    permanent = (abs(e[0][0]) * (abs(yz) + abs(zy)) +
                 abs(e[0][1]) * (abs(zx) + abs(xz)))
    determinant = (
        d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
        d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]))
    return Fraction(number) - determinant, permanent


def main():
    for name, (error, permanent), share, digit in (
            ("2x2", plane(), 3, 24), ("3x3", space(), 7, 22)):
        reached = abs(error) / Fraction(permanent) / U
        if reached < share - Fraction(1, 2**digit):
            sys.exit(f"{name}: an error of only {float(reached)} u")
        print(f"reached: the error of a {name} determinant is more than "
              f"({share} - 2^-{digit}) u of its permanent")


if __name__ == "__main__":
    main()
