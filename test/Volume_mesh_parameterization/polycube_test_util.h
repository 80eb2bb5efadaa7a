#ifndef VOLUME_MESH_PARAMETERIZATION_POLYCUBE_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_POLYCUBE_TEST_UTIL_H

#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

using Cell = std::array<int, 3>; // the lowest corner of a unit cube

// An L-shaped floor at z = 0, with stairs on it: its three columns are 1, 2 and 3 cubes high.
inline std::vector<Cell> l_stairs() {
  return {{0, 1, 0}, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {1, 0, 2}};
}

// The letter S, seen from the side: its upper part hangs over its lower one.
inline std::vector<Cell> overhang() {
  return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}, {0, 0, 2}, {0, 0, 3}};
}

// Eight cubes around a hole along z.
inline std::vector<Cell> ring() {
  return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};
}

// Cubes without common vertices.
template <typename Point>
CGAL::Volume_mesh_parameterization::Hexahedron_soup_3<Point> cubes(const std::vector<Cell>& cells) {
  CGAL::Volume_mesh_parameterization::Hexahedron_soup_3<Point> soup;
  for (const Cell& cell : cells) {
    soup.hexahedra.emplace_back();
    for (int i = 0; i < 8; ++i) {
      soup.hexahedra.back()[i] = soup.points.size();
      const int across = (i & 3) == 1 || (i & 3) == 2; // around a square
      soup.points.emplace_back(double(cell[0] + across), double(cell[1] + (i >> 1 & 1)),
                               double(cell[2] + (i >> 2)));
    }
  }
  return soup;
}

// The squares of the cubes, with vertices of their own, with those between two cubes (twice) or without.
template <typename Point>
CGAL::Volume_mesh_parameterization::Polygon_soup_3<Point> cube_faces(const std::vector<Cell>& cells,
                                                                     bool with_inner, bool as_triangles) {
  CGAL::Volume_mesh_parameterization::Polygon_soup_3<Point> soup;
  for (const Cell& cell : cells)
    for (int axis = 0; axis < 3; ++axis)
      for (int side : {0, 1}) {
        Cell other = cell;
        other[axis] += 2 * side - 1;
        if (!with_inner && std::find(cells.begin(), cells.end(), other) != cells.end()) continue;
        const std::size_t n = soup.points.size();
        for (int i = 0; i < 4; ++i) {
          Cell corner = cell;
          corner[axis] += side;
          corner[(axis + 1) % 3] += i == 1 || i == 2;
          corner[(axis + 2) % 3] += i >> 1;
          soup.points.emplace_back(double(corner[0]), double(corner[1]), double(corner[2]));
        }
        if (as_triangles) {
          soup.polygons.push_back({n, n + 1, n + 2});
          soup.polygons.push_back({n, n + 2, n + 3});
        } else
          soup.polygons.push_back({n, n + 1, n + 2, n + 3});
      }
  return soup;
}

#endif // VOLUME_MESH_PARAMETERIZATION_POLYCUBE_TEST_UTIL_H
