#!/usr/bin/python3
"""Traces curves of a gradient with VTK's stream tracer and prints as JSON what that costs and how many curves arrive.

usage: trace_with_vtk.py FILE.vtu rk4 | rk45

FILE is one that benchmark_stages writes: tetrahedra with a function f, 0 on the floor and 1 on the ceiling, and an array
`is_seed` that marks the vertices to start from, upwards and downwards. The field is the gradient of f, averaged to the
vertices, interpolated linearly; cells are found by VTK's locator; steps and tolerances are VTK's own.
"""

import json
import sys
import time

import vtk
from vtk.util.numpy_support import vtk_to_numpy

# A curve has arrived if f at its end is that of the floor or of the ceiling up to this.
NEAR = 1e-3


def main(arguments):
    if "--help" in arguments or "-h" in arguments:
        print(__doc__.strip())
        return 0
    if len(arguments) != 2 or arguments[1] not in ("rk4", "rk45"):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    vtk.vtkSMPTools.Initialize(1)
    grid = read(arguments[0])
    if not grid.GetPointData().HasArray("is_seed"):
        print(f"trace_with_vtk.py: {arguments[0]} cannot be read, or has no seeds", file=sys.stderr)
        return 1
    grid = with_gradient(grid)
    seeds = points_of(grid, vtk_to_numpy(grid.GetPointData().GetArray("is_seed")).nonzero()[0])
    cost_of_locator = trace(grid, points_of(seeds, [0]), arguments[1])[1]
    lines, cost = trace(grid, seeds, arguments[1])
    print(json.dumps({
        "cpu_seconds": cost - cost_of_locator,
        "cpu_seconds_of_locator": cost_of_locator,
        "seeds": seeds.GetNumberOfPoints(),
        "points": lines.GetNumberOfPoints(),
        "length": length(lines),
        "share_that_arrives": share_that_arrives(lines, 2 * seeds.GetNumberOfPoints()),
        "version": vtk.vtkVersion.GetVTKVersion(),
    }, indent=2))
    return 0


def read(file):
    vtk.vtkObject.GlobalWarningDisplayOff()  # VTK's own messages name its source files
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def with_gradient(grid):
    gradient = vtk.vtkGradientFilter()
    gradient.SetInputData(grid)
    gradient.SetInputScalars(vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "f")
    gradient.SetResultArrayName("gradient")
    gradient.Update()
    return gradient.GetOutput()


def points_of(grid, numbers):
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for number in numbers:
        points.InsertNextPoint(grid.GetPoint(number))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    return data


def trace(grid, seeds, integrator):
    """returns the curves and the CPU seconds; these include those for the locator, which each call builds anew"""
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputData(grid)
    tracer.SetSourceData(seeds)
    tracer.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "gradient")
    tracer.SetInterpolatorTypeToCellLocator()
    if integrator == "rk4":
        tracer.SetIntegratorTypeToRungeKutta4()
    else:
        tracer.SetIntegratorTypeToRungeKutta45()
    tracer.SetIntegrationDirectionToBoth()
    tracer.SetComputeVorticity(False)
    tracer.SetMaximumPropagation(100 * grid.GetLength())
    tracer.SetMaximumNumberOfSteps(100000)
    start = time.process_time()
    tracer.Update()
    return tracer.GetOutput(), time.process_time() - start


def ends_of(lines):
    """returns the numbers of the points along all curves, and where in this list each curve ends"""
    return (vtk_to_numpy(lines.GetLines().GetConnectivityArray()),
            vtk_to_numpy(lines.GetLines().GetOffsetsArray())[1:] - 1)


def length(lines):
    points, ends = ends_of(lines)
    path = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)[points]
    steps = ((path[1:] - path[:-1]) ** 2).sum(1) ** 0.5
    return float(steps.sum() - steps[ends[:-1]].sum())  # without the steps from curve to curve


def share_that_arrives(lines, number_of_curves):
    points, ends = ends_of(lines)
    f = vtk_to_numpy(lines.GetPointData().GetArray("f"))[points[ends]]
    return int(((f < NEAR) | (f > 1 - NEAR)).sum()) / number_of_curves


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
