#!/usr/bin/python3
"""Compares boxes that a foreign program read with those of the .csv file.

Usage: compare_boxes.py FILE.csv TIMES [--y-up] [--tolerance METRES] < what a reader printed
       compare_boxes.py FILE.csv --json FILE.json
TIMES: how often the list of boxes is there. Exit code: 0 when they are the same.
"""

import argparse
import json
import math
import sys


def turned(q, v):
    """The vector v turned by the quaternion q = (x, y, z, w)."""
    x, y, z, w = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1],
            v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


def corners_between(low, high):
    return [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]


class Table:
    """The boxes of a .csv file in the input's frame."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as lines:
            words = next(lines).split(": ")[1].split()
            self.frame = [[float(word) for word in words[4 * row:4 * row + 4]] for row in range(3)]
            next(lines)
            self.rows = [[float(word) for word in line.split(",")] for line in lines]
        self.corners = [[self.in_input(corner) for corner in corners_between(row[:3], row[3:6])]
                        for row in self.rows]

    def in_input(self, point):
        moved = [point[row] - self.frame[row][3] for row in range(3)]
        return [sum(self.frame[row][axis] * moved[row] for row in range(3)) for axis in range(3)]


def box_corners(numbers):
    center, turn, size = numbers[:3], numbers[3:7], numbers[7:]
    half = [edge / 2 for edge in size]
    return [[c + d for c, d in zip(center, turned(turn, corner))]
            for corner in corners_between([-h for h in half], half)]


def boxes_printed(lines, y_up):
    """For each box its corners: eight in order, or those of twelve triangles in any order."""
    boxes, triangles = [], []
    for line in lines:
        kind, *words = line.split()
        numbers = [float(word) for word in words]
        if kind == "box":
            boxes.append(box_corners(numbers))
        elif kind == "triangle":
            triangles.append([numbers[i:i + 3] for i in (0, 3, 6)])
    for i in range(0, len(triangles), 12):
        boxes.append([[p[0], -p[2], p[1]] if y_up else p
                      for triangle in triangles[i:i + 12] for p in triangle])
    return boxes


def deviation(read, expected):
    """How far a corner of one box is from the nearest of the other, at most."""
    if len(read) == 8:
        return max(math.dist(a, b) for a, b in zip(read, expected))
    return max(max(min(math.dist(a, b) for b in other) for a in one)
               for one, other in ((read, expected), (expected, read)))


def compare_json(path, table):
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    for row in range(3):
        for axis in range(3):
            unit = [float(axis == i) for i in range(3)]
            if abs(turned(data["frame"]["quaternion"], unit)[row] - table.frame[row][axis]) > 1e-12:
                sys.exit("the rotation is another one")
        if data["frame"]["translation"][row] != table.frame[row][3]:
            sys.exit("the translation is another one")
    rows = [[*box["min"], *box["max"], box["points"], box["density"]] for box in data["cuboids"]]
    if rows != table.rows:
        sys.exit("the boxes are others")
    print(f"{len(rows)} boxes, the same")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("csv")
    parser.add_argument("times", type=int, nargs="?", default=1)
    parser.add_argument("--y-up", action="store_true")
    parser.add_argument("--tolerance", type=float, default=1e-6)
    parser.add_argument("--json")
    arguments = parser.parse_args()
    table = Table(arguments.csv)
    if arguments.json:
        compare_json(arguments.json, table)
        return
    expected = table.corners * arguments.times
    boxes = boxes_printed(sys.stdin, arguments.y_up)
    if len(boxes) != len(expected):
        sys.exit(f"{len(boxes)} boxes, where {len(expected)} are expected")
    farthest = max(map(deviation, boxes, expected), default=0)
    if not farthest <= arguments.tolerance:
        sys.exit(f"a corner is {farthest:.3g} m off")
    print(f"{len(boxes)} boxes, corners within {farthest:.2g} m")


if __name__ == "__main__":
    main()
