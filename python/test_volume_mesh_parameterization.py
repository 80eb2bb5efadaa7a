"""Tests of the Python module: arrays in, arrays out, and failures as exceptions."""

import itertools
import unittest

import numpy as np
import volume_mesh_parameterization as vmp

FLOOR, CEILING, WALL = 1, 2, 3
ERROR_OPEN_SURFACE, ERROR_UNLABELLED_FACET = 10, 19  # of Error_code.h


def block(size=3):
    """Cubes around a hole along z, each cut into six tetrahedra around a diagonal."""
    points = np.array(list(itertools.product(range(size + 1), repeat=3)), dtype=float)
    number = {tuple(p): i for i, p in enumerate(points.astype(int))}
    cells = []
    for cube in itertools.product(range(size), repeat=3):
        if all(0 < k < size - 1 for k in cube[:2]):
            continue
        for order in itertools.permutations(range(3)):
            path = [np.array(cube)]
            for axis in order:
                path.append(path[-1] + np.eye(3, dtype=int)[axis])
            cells.append([number[tuple(p)] for p in path])
    cells = np.array(cells)
    inverted = volumes(points, cells) < 0
    cells[inverted] = cells[inverted][:, [1, 0, 2, 3]]
    return points, cells


def volumes(points, cells):
    """Six times the volumes of tetrahedra."""
    p = points[cells]
    return np.linalg.det(p[:, 1:] - p[:, :1])


def boundary(points, cells, size=3):
    """The triangles of one tetrahedron only, seen from outside, and their labels."""
    faces = cells[:, [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]]].reshape(-1, 3)
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    triangles = faces[first[count == 1]]
    corners = points[triangles]
    labels = np.full(len(triangles), WALL + 1)
    labels[np.any([np.all(corners[:, :, k] == end, axis=1) for k in (0, 1) for end in (0, size)], axis=0)] = WALL
    labels[np.all(corners[:, :, 2] == 0, axis=1)] = FLOOR
    labels[np.all(corners[:, :, 2] == size, axis=1)] = CEILING
    return triangles, labels


class TestParameterization(unittest.TestCase):
    def check_mesh(self, mesh):
        self.assertEqual(mesh["points"].shape, mesh["uvw"].shape)
        self.assertEqual(mesh["triangles"].shape, (len(mesh["labels"]), 3))
        self.assertTrue(np.array_equal(np.sort(mesh["order"]), np.arange(len(mesh["cells"]))))
        self.assertTrue(np.all(volumes(mesh["points"], mesh["cells"]) > 0))
        for label, end in ((FLOOR, min), (CEILING, max)):
            w = mesh["uvw"][mesh["triangles"][mesh["labels"] == label], 2]
            self.assertTrue(np.all(w == end(mesh["uvw"][:, 2])))

    def test_labelled_tetrahedra(self):
        points, cells = block()
        solid = vmp.parameterize(points, cells, *boundary(points, cells))
        self.assertEqual(solid.genus, 1)
        mesh = solid.mesh()
        self.check_mesh(mesh)
        self.assertTrue(np.array_equal(mesh["points"][: len(points)], points))
        self.assertAlmostEqual(volumes(mesh["points"], mesh["cells"]).sum(), 6 * 24)

    def test_piecewise_linear_map(self):
        points, cells = block()
        solid = vmp.parameterize(points, cells, *boundary(points, cells))
        mesh = solid.piecewise_linear()
        self.assertEqual(solid.why_not_piecewise_linear(), "")
        self.check_mesh(mesh)
        self.assertTrue(np.all(volumes(mesh["uvw"], mesh["cells"]) > 0))

    def test_hexahedra(self):
        points, cells = block()
        hexahedra = vmp.parameterize(points, cells, *boundary(points, cells)).hexahedra(200)
        self.assertEqual(hexahedra["cells"].shape[1], 8)
        self.assertEqual(set(hexahedra["labels"]), {FLOOR, CEILING, WALL, WALL + 1})
        # a box of these nodes is cut like the blocks are: the sum of six tetrahedra around each diagonal
        tetrahedra = hexahedra["cells"][:, [[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]]]
        self.assertAlmostEqual(volumes(hexahedra["points"], tetrahedra.reshape(-1, 4)).sum(), 6 * 24, delta=1)

    def test_partition_is_found(self):
        points, cells = block()
        solid = vmp.parameterize(points, cells.astype(np.int32))
        self.assertEqual(set(solid.mesh()["labels"]), {FLOOR, CEILING, WALL, WALL + 1})

    def test_failures_have_codes(self):
        points, cells = block()
        triangles, labels = boundary(points, cells)
        with self.assertRaises(vmp.Error) as caught:
            vmp.parameterize(points, cells, triangles[1:], labels[1:])
        self.assertEqual(caught.exception.code, ERROR_UNLABELLED_FACET)
        self.assertIn("label", str(caught.exception))
        with self.assertRaises(vmp.Error) as caught:
            vmp.parameterize_surface(points, triangles[1:])
        self.assertEqual(caught.exception.code, ERROR_OPEN_SURFACE)
        with self.assertRaises(vmp.Error):
            vmp.parameterize(points, cells - 1)

    def test_arguments_of_wrong_shape_or_type(self):
        points, cells = block()
        with self.assertRaises(ValueError):
            vmp.parameterize(points[:, :2], cells)
        with self.assertRaises(ValueError):
            vmp.parameterize(points, cells, cells[:, :3], [FLOOR])
        triangles, labels = boundary(points, cells)
        with self.assertRaises(ValueError):
            vmp.parameterize(points, cells, triangles, labels + 2**32)
        with self.assertRaises(TypeError):
            vmp.parameterize(points, cells + 0.5)

    def test_surface(self):
        points, cells = block()
        triangles, _ = boundary(points, cells)
        try:
            solid = vmp.parameterize_surface(points, triangles, number_of_cells=1000, direction=(0, 0, 1))
        except vmp.Error as error:
            self.assertIn("TetGen", str(error))  # built without it
            return
        self.assertEqual(solid.genus, 1)
        self.check_mesh(solid.mesh())


if __name__ == "__main__":
    unittest.main()
