#!/usr/bin/python3
"""Subdivides a closed triangle surface by Loop's rule, each triangle into four, LEVELS times.

usage: subdivide_surface.py INPUT.off OUTPUT.ply LEVELS
"""

import sys

import vtk


def main(arguments):
    if len(arguments) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    subdivision = vtk.vtkLoopSubdivisionFilter()
    subdivision.SetInputData(read_off(arguments[0]))
    subdivision.SetNumberOfSubdivisions(int(arguments[2]))
    writer = vtk.vtkPLYWriter()
    writer.SetInputConnection(subdivision.GetOutputPort())
    writer.SetFileName(arguments[1])
    return 0 if writer.Write() else 1


def read_off(file):
    with open(file) as lines:
        words = iter(lines.read().split()[1:])
    number_of_points, number_of_triangles, _ = (int(next(words)) for _ in range(3))
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
