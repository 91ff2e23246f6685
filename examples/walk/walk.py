#!/usr/bin/env python3
"""Write a walking body and a skirt, for walk.yaml: OBJ, in meters, the z axis is up.

    python3 walk.py FOLDER [FRAMES]

writes hips-000.obj, left-000.obj, right-000.obj, ... and skirt-000.obj, ...: of
the skirt only the first frame counts, and in the others its waist.
"""
import math
import sys
from pathlib import Path

RATE = 30               # frames a second
HIPS, LEGS, SKIRT = (24, 12), (16, 20), (96, 24)    # around, along


def lathe(around, rows, closed=True):
    """The points of circles, (radius, height) each, and their faces."""
    points = [(r * math.cos(2 * math.pi * i / around), h,
               r * math.sin(2 * math.pi * i / around))
              for r, h in rows for i in range(around)]
    faces = [(j * around + i, (j + 1) * around + i,
              (j + 1) * around + (i + 1) % around, j * around + (i + 1) % around)
             for j in range(len(rows) - 1) for i in range(around)]
    if closed:
        last = (len(rows) - 1) * around
        faces.append(tuple(range(around)))
        faces.append(tuple(last + i for i in reversed(range(around))))
    return points, faces


def egg(around, along, radius, top, bottom):
    """A closed surface of revolution, like an egg."""
    rows = []
    for j in range(along):
        a = math.pi * (j + 0.5) / along
        rows.append((radius * math.sin(a) ** 0.6,
                     (top + bottom) / 2 + (top - bottom) / 2 * math.cos(a)))
    return lathe(around, rows)


def turned(point, angle, pitch, hip):
    """A point of a limb that swings about its hip, of a body that turns."""
    x, y, z = point
    c, s = math.cos(pitch), math.sin(pitch)
    x, y, z = x + hip, c * y - s * z, s * y + c * z
    c, s = math.cos(angle), math.sin(angle)
    return c * x + s * z, s * x - c * z, y + 1


def write(path, points, faces):
    path.write_text("".join("v %.17g %.17g %.17g\n" % p for p in points) +
                    "".join("f " + " ".join(str(i + 1) for i in f) + "\n"
                            for f in faces))


def main(folder, frames):
    hips = egg(*HIPS, 0.16, 0.3, -0.12)
    leg = egg(*LEGS, 0.075, 0.06, -0.85)
    skirt = lathe(SKIRT[0], [(0.185 + 0.5 * j / SKIRT[1],
                              0.16 - 0.12 * j / SKIRT[1])
                             for j in range(SKIRT[1] + 1)], closed=False)
    for i in range(frames):
        time = i / RATE
        angle = 0.5 * math.pi * time * time / (1 + time)
        swing = 0.55 * math.sin(2 * math.pi * time) * min(1, time * 2)
        sway = 0.06 * math.sin(2 * math.pi * time) * min(1, time * 2)
        for name, (points, faces), pitch, hip in (
                ("hips", hips, sway, 0), ("left", leg, swing, -0.085),
                ("right", leg, -swing, 0.085), ("skirt", skirt, sway, 0)):
            write(folder / f"{name}-{i:03}.obj",
                  [turned(p, angle, pitch, hip) for p in points], faces)


folder = Path(sys.argv[1])
folder.mkdir(exist_ok=True)
main(folder, int(sys.argv[2]) if len(sys.argv) > 2 else 121)
