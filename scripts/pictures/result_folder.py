"""Reads the files of a result folder."""

import functools
import json

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from .convert import arrays_of, cells_of, make_grid

FLOOR, CEILING, FIRST_WALL = 1, 2, 3


class Missing(Exception):
    """says why a picture cannot be drawn"""


class Result:
    """a result folder; each file is read when a picture first needs it"""

    def __init__(self, folder):
        self.folder = folder

    def file(self, name):
        if not (self.folder / name).is_file():
            raise Missing(f"there is no {self.folder / name}")
        return self.folder / name

    @functools.cached_property
    def mesh(self):
        return Tetrahedra(self.file("result.vtu"))

    @functools.cached_property
    def curves(self):
        return Curves(self.file("curves.vtp"))

    @functools.cached_property
    def hexahedra(self):
        """points, and corners of hexahedra"""
        sections = read_medit(self.file("hex.mesh"), ("Vertices", "Hexahedra"))
        return sections["Vertices"][:, :3], sections["Hexahedra"][:, :8].astype(int) - 1

    @functools.cached_property
    def domain_points(self):
        """the image of each vertex in P: u, v, and w times the height of P"""
        u, v, w = (self.mesh.value(name) for name in "uvw")
        return np.column_stack([u, v, w * self.domain_height])

    @functools.cached_property
    def domain_boundary(self):
        """points and triangles: exact by the piecewise linear map; where there is none, phi cuts the edges of P"""
        if not (self.folder / "parameter.mesh").is_file():
            return self.domain_points, self.mesh.boundary
        image = Labelled_mesh(self.file("parameter.mesh"))
        return image.points, image.boundary

    @functools.cached_property
    def domain_height(self):
        """what w is a share of: the height of a prism; in a given polycube w is a coordinate itself"""
        return self.report["domain"].get("height", 1)

    @functools.cached_property
    def report(self):
        return json.loads(self.file("report.json").read_text())

    @functools.cached_property
    def hexahedra_report(self):
        if "hexahedra" not in self.report:
            raise Missing(f"{self.folder / 'report.json'} tells of no hexahedra")
        return self.report["hexahedra"]


class Tetrahedra:
    """result.vtu: points, tetrahedra, labelled boundary triangles, values at points"""

    def __init__(self, path):
        grid = read_xml(vtk.vtkXMLUnstructuredGridReader(), path)
        corners, offsets = cells_of(grid.GetCells())
        types = vtk_to_numpy(grid.GetCellTypesArray()) if len(offsets) > 1 else np.zeros(0)
        rows = {kind: np.flatnonzero(types == kind) for kind in (vtk.VTK_TETRA, vtk.VTK_TRIANGLE)}
        if not len(rows[vtk.VTK_TETRA]):
            raise Missing(f"{path} has no tetrahedra")
        labels = arrays_of(grid.GetCellData()).get("label", np.zeros(len(types)))[rows[vtk.VTK_TRIANGLE]].astype(int)
        triangles = corners[offsets[rows[vtk.VTK_TRIANGLE]][:, None] + np.arange(3)]
        if not (labels >= FLOOR).any():
            raise Missing(f"{path} has no triangles with labels")
        self.path = path
        self.points = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
        self.tetrahedra = corners[offsets[rows[vtk.VTK_TETRA]][:, None] + np.arange(4)]
        self.boundary, self.labels = triangles[labels >= FLOOR], labels[labels >= FLOOR]
        self.values = arrays_of(grid.GetPointData())

    def value(self, name):
        if name not in self.values:
            raise Missing(f"{self.path} has no point data named {name}")
        return self.values[name]

    def grid(self, *names):
        """returns the tetrahedra with the named values; the first is the active one"""
        grid = make_grid(self.points, vtk.VTK_TETRA, self.tetrahedra, {name: self.value(name) for name in names})
        grid.GetPointData().SetActiveScalars(names[0])
        return grid


class Labelled_mesh:
    """a MEDIT file: points and labelled boundary triangles"""

    def __init__(self, path):
        if not path.is_file():
            raise Missing(f"there is no {path}")
        sections = read_medit(path, ("Vertices", "Triangles"))
        triangles = sections["Triangles"].astype(int)
        self.name = path.stem
        self.points = sections["Vertices"][:, :3]
        self.boundary, self.labels = triangles[:, :3] - 1, triangles[:, 3]


class Curves:
    """curves.vtp: polylines, for each the number of its curve and whether it is in M (0) or in P (1)"""

    def __init__(self, path):
        polydata = read_xml(vtk.vtkXMLPolyDataReader(), path)
        data = arrays_of(polydata.GetCellData())
        corners, offsets = cells_of(polydata.GetLines())
        if "curve" not in data or "domain" not in data or len(offsets) == 1:
            raise Missing(f"{path} lacks lines, or cell data named curve and domain")
        points = vtk_to_numpy(polydata.GetPoints().GetData())
        self.lines = [points[corners[a:b]] for a, b in zip(offsets[:-1], offsets[1:])]
        self.curve, self.domain = data["curve"].astype(int), data["domain"].astype(int)


def read_xml(reader, path):
    vtk.vtkObject.GlobalWarningDisplayOff()  # VTK's own messages name its source files
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorCode() or not reader.GetOutput().GetNumberOfPoints():
        raise Missing(f"{path} is empty or malformed")
    return reader.GetOutput()


MEDIT_COLUMNS = {"Vertices": 4, "Edges": 3, "Triangles": 4, "Quadrilaterals": 5, "Tetrahedra": 5, "Hexahedra": 9,
                 "Corners": 1, "Ridges": 1, "RequiredVertices": 1, "RequiredEdges": 1}


def read_medit(path, names):
    """returns the named sections of an ASCII MEDIT file as arrays with a row for each element"""
    words = " ".join(line.partition("#")[0] for line in path.read_text(errors="replace").splitlines()).split()
    sections, k = {}, 0
    try:
        while k < len(words) and words[k] != "End":
            if words[k] in ("MeshVersionFormatted", "Dimension"):
                k += 2
                continue
            rows, columns = int(words[k + 1]), MEDIT_COLUMNS[words[k]]
            end = k + 2 + rows * columns
            if words[k] in names:
                sections[words[k]] = np.array(words[k + 2:end], dtype=float).reshape(rows, columns)
            k = end
    except (IndexError, KeyError, ValueError):
        raise Missing(f"{path} is malformed in its section {words[k]}") from None
    for name in names:
        if not len(sections.get(name, ())):
            raise Missing(f"{path} has no {name}")
    return sections
