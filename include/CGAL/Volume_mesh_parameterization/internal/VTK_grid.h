// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_GRID_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_GRID_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

enum VTK_cell_type {
  VTK_VERTEX = 1,
  VTK_LINE = 3,
  VTK_POLYLINE = 4,
  VTK_TRIANGLE = 5,
  VTK_TETRAHEDRON = 10,
  VTK_HEXAHEDRON = 12
};

// An unstructured grid as the files of VTK hold it, not yet checked.
class VTK_grid {
public:
  std::vector<double> coordinates;
  std::vector<std::int64_t> offsets; // starts with 0
  std::vector<std::int64_t> connectivity;
  std::vector<int> types;

  std::size_t number_of_points() const { return coordinates.size() / 3; }

  // The array named "label" is the one, else the first of integers.
  void offer_labels(const std::string& name, std::vector<std::int64_t> values) {
    if (m_labels.empty() || name == "label") m_labels = std::move(values);
  }

  // Triangles are taken as labelled facets if there are labels; vertices and lines are left out.
  template <typename Point>
  Status make_soup(Tetrahedron_soup_3<Point>& soup) const {
    Tetrahedron_soup_3<Point> result;
    Status status = check_arrays();
    if (status.ok()) status = copy_points(result.points);
    for (std::size_t c = 0; c < types.size() && status.ok(); ++c) status = copy_cell(c, result);
    if (status.ok()) soup = std::move(result);
    return status;
  }

private:
  Status check_arrays() const {
    if (coordinates.size() % 3 != 0) return {ERROR_WRONG_FORMAT, "a point has not three coordinates"};
    if (offsets.size() != types.size() + 1)
      return {ERROR_WRONG_FORMAT, "there are not as many cells as cell types"};
    if (!m_labels.empty() && m_labels.size() != types.size())
      return {ERROR_WRONG_FORMAT, "there are not as many labels as cells"};
    return {};
  }

  template <typename Point>
  Status copy_points(std::vector<Point>& points) const {
    points.reserve(number_of_points());
    for (std::size_t i = 0; i < coordinates.size(); i += 3) {
      const double x = coordinates[i], y = coordinates[i + 1], z = coordinates[i + 2];
      if (!are_finite(x, y, z)) return {ERROR_COORDINATE_NOT_FINITE, "point " + std::to_string(i / 3)};
      points.emplace_back(x, y, z);
    }
    return {};
  }

  template <typename Point>
  Status copy_cell(std::size_t c, Tetrahedron_soup_3<Point>& soup) const {
    if (types[c] >= VTK_VERTEX && types[c] <= VTK_POLYLINE) return {};
    if (types[c] == VTK_TETRAHEDRON) return copy_vertices(c, soup.cells.emplace_back());
    if (types[c] != VTK_TRIANGLE)
      return {ERROR_WRONG_FORMAT, "cell " + std::to_string(c) + " has the VTK type " +
                                      std::to_string(types[c]) +
                                      ": all cells must be tetrahedra (10) or triangles (5)"};
    if (m_labels.empty()) return {};
    Labelled_facet& facet = soup.facets.emplace_back();
    facet.label = int(m_labels[c]);
    if (facet.label != m_labels[c])
      return {ERROR_WRONG_FORMAT, "cell " + std::to_string(c) + ": the label is too large"};
    return copy_vertices(c, facet.vertices);
  }

  template <typename Vertices>
  Status copy_vertices(std::size_t c, Vertices& vertices) const {
    const std::int64_t begin = offsets[c], end = offsets[c + 1];
    if (begin < 0 || end < begin || std::size_t(end) > connectivity.size() ||
        std::size_t(end - begin) != vertices.size())
      return {ERROR_WRONG_FORMAT,
              "cell " + std::to_string(c) + " has not " + std::to_string(vertices.size()) + " vertices"};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      vertices[i] = std::size_t(connectivity[std::size_t(begin) + i]);
      if (vertices[i] >= number_of_points())
        return {ERROR_INDEX_OUT_OF_RANGE, "cell " + std::to_string(c) + ": vertex " +
                                              std::to_string(connectivity[std::size_t(begin) + i]) + " of " +
                                              std::to_string(number_of_points())};
    }
    return {};
  }

  std::vector<std::int64_t> m_labels;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_GRID_H
