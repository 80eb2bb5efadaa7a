"""Carries arrays between numpy and VTK."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy


def arrays_of(data):
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {array.GetName(): vtk_to_numpy(array) for array in arrays if array is not None}


def add_array(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)


def add_cell_colors(polydata, colors):
    """`colors` has a row of red, green, blue in [0, 1] for each cell"""
    add_array(polydata.GetCellData(), "color", np.round(255 * np.clip(colors, 0, 1)).astype(np.uint8))
    polydata.GetPointData().SetActiveScalars(None)
    polydata.GetCellData().SetActiveScalars("color")


def set_points(target, points):
    vtk_points = vtk.vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    target.SetPoints(vtk_points)


def cell_array(corners, offsets):
    """cell i has the corners offsets[i], ..., offsets[i + 1] - 1"""
    array = vtk.vtkCellArray()
    ids = [numpy_to_vtkIdTypeArray(np.ascontiguousarray(a, dtype=np.int64), deep=True) for a in (offsets, corners)]
    array.SetData(*ids)
    return array


def uniform_cells(cells):
    """`cells` has a row of corners for each cell"""
    return cell_array(cells.ravel(), np.arange(0, cells.size + 1, cells.shape[1]))


def cells_of(array):
    """returns the corners and offsets of a vtkCellArray"""
    if not array.GetNumberOfCells():
        return np.zeros(0, np.int64), np.zeros(1, np.int64)
    return vtk_to_numpy(array.GetConnectivityArray()), vtk_to_numpy(array.GetOffsetsArray())


def make_surface(points, polygons):
    polydata = vtk.vtkPolyData()
    set_points(polydata, points)
    polydata.SetPolys(uniform_cells(polygons))
    return polydata


def make_polylines(lines):
    polydata = vtk.vtkPolyData()
    set_points(polydata, np.concatenate(lines))
    offsets = np.cumsum([0] + [len(line) for line in lines])
    polydata.SetLines(cell_array(np.arange(offsets[-1]), offsets))
    return polydata


def make_grid(points, cell_type, cells, point_data):
    grid = vtk.vtkUnstructuredGrid()
    set_points(grid, points)
    grid.SetCells(cell_type, uniform_cells(cells))
    for name, values in point_data.items():
        add_array(grid.GetPointData(), name, values)
    return grid


def run(vtk_filter, data):
    vtk_filter.SetInputData(data)
    vtk_filter.Update()
    return vtk_filter.GetOutput()
