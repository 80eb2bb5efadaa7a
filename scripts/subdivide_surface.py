#!/usr/bin/python3
"""Subdivides a closed triangle surface by Loop's rule, each triangle into four, LEVELS times.

usage: subdivide_surface.py INPUT.off OUTPUT.ply LEVELS
"""

import sys

import vtk


def main(arguments):
    if "--help" in arguments or "-h" in arguments:
        print(__doc__.strip())
        return 0
    if len(arguments) != 3 or not arguments[2].isdecimal():
        print(__doc__.strip(), file=sys.stderr)
        return 2
    subdivision = vtk.vtkLoopSubdivisionFilter()
    try:
        subdivision.SetInputData(read_off(arguments[0]))
        open(arguments[1], "wb").close()  # the writer reports no error
    except OSError as error:
        return complain(f"{error.filename}: {error.strerror}")
    except (ValueError, StopIteration):
        return complain(f"{arguments[0]} is no OFF file")
    subdivision.SetNumberOfSubdivisions(int(arguments[2]))
    writer = vtk.vtkPLYWriter()
    writer.SetInputConnection(subdivision.GetOutputPort())
    writer.SetFileName(arguments[1])
    writer.Write()
    return 0


def complain(sentence):
    print(f"subdivide_surface.py: {sentence}", file=sys.stderr)
    return 1


def read_off(file):
    with open(file) as lines:
        words = iter(lines.read().split()[1:])
    number_of_points, number_of_triangles, _ = [int(next(words)) for _ in range(3)]
    points, triangles = vtk.vtkPoints(), vtk.vtkCellArray()
    for _ in range(number_of_points):
        points.InsertNextPoint([float(next(words)) for _ in range(3)])
    for _ in range(number_of_triangles):
        corners = int(next(words))
        triangles.InsertNextCell(corners, [int(next(words)) for _ in range(corners)])
    surface = vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(triangles)
    return surface


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
