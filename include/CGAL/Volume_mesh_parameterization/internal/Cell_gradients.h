// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELL_GRADIENTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELL_GRADIENTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The volume of a cell and the gradients of its four barycentric coordinates, in double.
struct Cell_gradients {
  using Vector_3 = Double_kernel::Vector_3;
  using Point_3 = Double_kernel::Point_3;

  double volume;
  std::array<Vector_3, 4> gradients;

  // Gradient i is the area vector of facet i, pointing towards vertex i, divided by three times the volume.
  explicit Cell_gradients(const std::array<Point_3, 4>& p)
      : volume(CGAL::determinant(p[1] - p[0], p[2] - p[0], p[3] - p[0]) / 6) {
    for (int i = 0; i < 4; ++i) {
      const int* v = Compact_tetrahedral_mesh_3<Double_kernel>::facet_vertices[i];
      gradients[i] = CGAL::cross_product(p[v[2]] - p[v[0]], p[v[1]] - p[v[0]]) / (6 * volume);
    }
  }

  template <typename Mesh>
  Cell_gradients(const Mesh& mesh, Cell_index c)
      : Cell_gradients(
            {approximate(mesh.point(mesh.vertex(c, 0))), approximate(mesh.point(mesh.vertex(c, 1))),
             approximate(mesh.point(mesh.vertex(c, 2))), approximate(mesh.point(mesh.vertex(c, 3)))}) {}

  // returns the gradient of the linear function with `values` at the vertices; constants give exactly 0.
  Vector_3 interpolate(const std::array<double, 4>& values) const {
    return (values[1] - values[0]) * gradients[1] + (values[2] - values[0]) * gradients[2] +
           (values[3] - values[0]) * gradients[3];
  }
};

template <typename Mesh>
double squared_area(const Mesh& mesh, Facet_index f) {
  const auto v = mesh.vertices(f);
  const auto p = approximate(mesh.point(v[0]));
  return CGAL::cross_product(approximate(mesh.point(v[1])) - p, approximate(mesh.point(v[2])) - p)
             .squared_length() /
         4;
}

// The weight of a facet in the dual graph: its area, divided by the sum of the distances of the centroids of its cells. That
// of a cell of volume V lies 3V / 4A away from a facet of area A.
template <typename Mesh>
double dual_conductance(const Mesh& mesh, Facet_index f, const std::vector<double>& volumes) {
  double volume = volumes[mesh.half_facet(f).cell];
  if (!mesh.is_boundary(f)) volume += volumes[mesh.half_facet(f, 1).cell];
  return squared_area(mesh, f) / (0.75 * volume);
}

// The volumes of all cells.
template <typename Mesh>
std::vector<double> volumes(const Mesh& mesh) {
  std::vector<double> result(mesh.number_of_cells());
  for (Cell_index c : mesh.cells()) result[c] = Cell_gradients(mesh, c).volume;
  return result;
}

// computes the volumes of all cells; returns ERROR_FLAT_TETRAHEDRON if one is not positive in double.
template <typename Mesh>
Status compute_volumes(const Mesh& mesh, std::vector<double>& result) {
  result = volumes(mesh);
  const auto flat = std::find_if(result.begin(), result.end(), [](double volume) { return !(volume > 0); });
  if (flat == result.end()) return {};
  return {ERROR_FLAT_TETRAHEDRON,
          "the volume of tetrahedron " + std::to_string(flat - result.begin()) + " is not positive in double"};
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CELL_GRADIENTS_H
