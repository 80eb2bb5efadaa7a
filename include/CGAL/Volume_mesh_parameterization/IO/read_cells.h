// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_CELLS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_CELLS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

// The unit cube [i, i + 1] x [j, j + 1] x [k, k + 1], with vertices of its own.
template <typename Point>
void add_unit_cube(const std::array<int, 3>& cell, Hexahedron_soup_3<Point>& soup) {
  constexpr int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  soup.hexahedra.emplace_back();
  for (int i = 0; i < 8; ++i) {
    soup.hexahedra.back()[i] = soup.points.size();
    const int* c = corners[i];
    soup.points.emplace_back(double(cell[0]) + c[0], double(cell[1]) + c[1], double(cell[2]) + c[2]);
  }
}

inline Status read_cell_list(std::istream& is, std::vector<std::array<int, 3>>& cells) {
  std::string text;
  const Status status = read_all(is, text);
  if (!status.ok()) return status;
  Text_scanner lines(text);
  while (!lines.at_end()) {
    const Text_scanner here = lines;
    Text_scanner line(lines.rest_of_line());
    auto& [i, j, k] = cells.emplace_back();
    if (!line.read(i) || !line.read(j) || !line.read(k) || !line.at_end())
      return {ERROR_WRONG_FORMAT, "line " + std::to_string(here.line()) + ": a cell is three integers"};
  }
  return {};
}

template <typename Cells>
Status check_no_repetition(const Cells& cells) {
  Cells sorted = cells;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice == sorted.end()) return {};
  return {ERROR_WRONG_FORMAT, "the cell " + std::to_string((*twice)[0]) + " " + std::to_string((*twice)[1]) +
                                  " " + std::to_string((*twice)[2]) + " comes twice"};
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads a list of unit cubes, each given by the three integers of its lowest corner; `#` starts a comment. The cubes have no
common vertices: see `tetrahedralize_polycube()`.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_CANNOT_READ_FILE`, `ERROR_WRONG_FORMAT`, also for a cube that comes twice, or `ERROR_EMPTY_MESH`; then
`soup` is left as it was
*/
template <typename Point>
Status read_cells(std::istream& is, Hexahedron_soup_3<Point>& soup) {
  std::vector<std::array<int, 3>> cells;
  Status status = internal::read_cell_list(is, cells);
  if (status.ok()) status = internal::check_no_repetition(cells);
  if (status.ok() && cells.empty()) status = {ERROR_EMPTY_MESH, "there are no cells"};
  if (!status.ok()) return status;
  soup = {};
  for (const auto& cell : cells) internal::add_unit_cube(cell, soup);
  return {};
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads the file `filename`, as the function above.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status read_cells(const std::string& filename, Hexahedron_soup_3<Point>& soup) {
  return internal::read_file(filename, [&](std::istream& is) { return read_cells(is, soup); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_CELLS_H
