#!/usr/bin/python3
"""Solves Laplace's equation on hexahedra with CalculiX, and compares with the solution on the tetrahedra.

usage: solve_with_calculix.py RESULT_FOLDER...

Each folder is one that `handlebody parameterize INPUT -o RESULT_FOLDER --hexes N --hex-format abaqus` made. Heat is
conducted through its hexahedra (hex.inp), with temperature 0 on the floor, 1 on the ceiling and insulated walls; the
program ccx solves that, in the Debian package calculix-ccx. The same on its tetrahedra is the field f of result.vtu, linear
on each tetrahedron. The table has the largest and the mean difference of both at the nodes of the hexahedra that are not on
floor or ceiling, where the temperature is given.

The differences have the errors of both solutions in them, and that the boundary of the hexahedra is not quite that of the
tetrahedra. Where floor or ceiling meet a wall smoothly, the exact solution grows like the square root of the distance from
there, with an infinite gradient: the largest difference falls slowly, or not at all as more nodes come near. A node that
rounding put outside takes its value from the tetrahedron in which its least barycentric coordinate is greatest.

Exit: 0 the table is printed, 1 a file cannot be read or ccx fails, 2 wrong usage.
"""

import itertools
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

STEP = """*INCLUDE, INPUT=hex.inp
*MATERIAL, NAME=UNIT
*CONDUCTIVITY
1
*SOLID SECTION, ELSET=SOLID, MATERIAL=UNIT
*INITIAL CONDITIONS, TYPE=TEMPERATURE
SOLID, 0.5
*STEP
*HEAT TRANSFER, STEADY STATE
*BOUNDARY
FLOOR, 11, 11, 0
CEILING, 11, 11, 1
*NODE PRINT, NSET=SOLID
NT
*END STEP
"""
VTK_TETRAHEDRON = 10


class Failure(Exception):
    """What cannot be read, or why ccx did not solve."""


def main(arguments):
    if "--help" in arguments or "-h" in arguments:
        print(__doc__.strip())
        return 0
    if not arguments or any(a.startswith("-") for a in arguments):
        return complain("usage: solve_with_calculix.py RESULT_FOLDER...", 2)
    if shutil.which("ccx") is None:
        return complain("the program ccx is missing (Debian package calculix-ccx)", 1)
    print("| folder | hexahedra | nodes | largest difference | mean |")
    print("| --- | ---: | ---: | ---: | ---: |")
    for folder in map(pathlib.Path, arguments):
        try:
            print(row(folder), flush=True)
        except (OSError, ValueError, KeyError, Failure, xml.etree.ElementTree.ParseError) as error:
            return complain(f"{folder}: {error}", 1)
    return 0


def complain(sentence, code):
    print(f"solve_with_calculix.py: {sentence}", file=sys.stderr)
    return code


def row(folder):
    blocks = read_deck(folder / "hex.inp")
    nodes = {int(n): tuple(map(float, x)) for n, *x in blocks["*NODE"]}
    given = {int(n) for name in ("FLOOR", "CEILING") for n, in blocks[f"*NSET {name}"]}
    temperatures = solve(folder / "hex.inp")
    tetrahedra = Tetrahedra(folder / "result.vtu")
    differences = [abs(temperatures[n] - tetrahedra.value(p)) for n, p in nodes.items() if n not in given]
    if not differences:
        raise Failure("all nodes are on floor and ceiling")
    return (f"| {folder} | {len(blocks['*ELEMENT'])} | {len(nodes)} | {max(differences):.2g} | "
            f"{sum(differences) / len(differences):.2g} |")


def read_deck(file):
    """The lines of hex.inp, split at commas, by their keyword; by keyword and name for sets and surfaces."""
    blocks = {}
    for line in file.read_text().splitlines():
        items = [item.strip() for item in line.split(",")]
        if line.startswith("*"):
            named = items[0] in ("*NSET", "*SURFACE")
            block = blocks.setdefault(items[0] + " " + items[-1].split("=")[1] if named else items[0], [])
        else:
            block.append(items)
    return blocks


def solve(deck):
    """The temperatures of the nodes, from a run of ccx in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copy(deck, pathlib.Path(folder) / "hex.inp")
        pathlib.Path(folder, "heat.inp").write_text(STEP)
        run = subprocess.run(["ccx", "heat"], cwd=folder, capture_output=True, text=True, check=False)
        result = pathlib.Path(folder, "heat.dat")
        lines = [line.split() for line in result.read_text().splitlines()] if result.exists() else []
    if run.returncode != 0 or "*ERROR" in run.stdout or not lines:
        raise Failure("ccx failed: " + " ".join(run.stdout.split()[-40:]))
    return {int(line[0]): float(line[1]) for line in lines if len(line) == 2}


class Tetrahedra:
    """Finds tetrahedra of result.vtu in a grid of boxes, and values of f in them."""

    def __init__(self, file):
        piece = xml.etree.ElementTree.parse(file).find("UnstructuredGrid/Piece")
        arrays = {array.get("Name"): array.text.split() for array in piece.iter("DataArray")}
        coordinates = list(map(float, arrays["Points"]))
        self.points = list(zip(coordinates[0::3], coordinates[1::3], coordinates[2::3]))
        self.f = list(map(float, arrays["f"]))
        connectivity, offsets = list(map(int, arrays["connectivity"])), list(map(int, arrays["offsets"]))
        self.cells = [connectivity[end - 4:end] for end, kind in zip(offsets, arrays["types"])
                      if int(kind) == VTK_TETRAHEDRON]
        self.low = [min(x) for x in zip(*self.points)]
        extents = [max(x) - low for x, low in zip(zip(*self.points), self.low)]
        self.edge = max(extents) / max(1, round(len(self.cells) ** (1 / 3)))
        slack = self.edge * 1e-6  # for nodes that rounding put outside
        self.boxes = {}
        for cell in self.cells:
            extents = list(zip(*(self.points[v] for v in cell)))
            low, high = self.box([min(x) - slack for x in extents]), self.box([max(x) + slack for x in extents])
            for box in itertools.product(*(range(a, b + 1) for a, b in zip(low, high))):
                self.boxes.setdefault(box, []).append(cell)

    def box(self, point):
        return tuple(math.floor((x - low) / self.edge) for x, low in zip(point, self.low))

    def value(self, point):
        """f at a point, by the tetrahedron where its least barycentric coordinate is greatest."""
        cells, reach = [], 0
        while not cells and reach < 10:
            around = (range(x - reach, x + reach + 1) for x in self.box(point))
            cells = [cell for box in itertools.product(*around) for cell in self.boxes.get(box, ())]
            reach += 1
        if not cells:
            raise Failure(f"the node at {point} is far from all tetrahedra")
        weights, cell = max(((self.barycentric(point, cell), cell) for cell in cells), key=lambda w: min(w[0]))
        return sum(w * self.f[v] for w, v in zip(weights, cell))

    def barycentric(self, point, cell):
        corners = [self.points[v] for v in cell]
        volume = determinant(*corners)
        return [determinant(*corners[:i], point, *corners[i + 1:]) / volume for i in range(4)]


def determinant(a, b, c, d):
    """Six times the volume of the tetrahedron a b c d."""
    u, v, w = ([x - y for x, y in zip(p, a)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
