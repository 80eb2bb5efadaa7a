// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NODE_QUALITY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NODE_QUALITY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Trilinear_jacobian.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The least determinant of normalized edges over the corners and the centre of a hexahedron. Each edge is normalized once.
inline double corner_scaled_jacobian(const std::vector<Eigen::Vector3d>& nodes,
                                     const std::array<std::size_t, 8>& hexahedron) {
  // the edge at each corner in each row of Reference_hexahedron::axis_edges
  constexpr int corner_edges[8][3] = {{0, 0, 0}, {0, 1, 1}, {1, 1, 2}, {1, 0, 3},
                                      {2, 2, 0}, {2, 3, 1}, {3, 3, 2}, {3, 2, 3}};
  Eigen::Vector3d directions[3][4], centre[3];
  for (int axis = 0; axis < 3; ++axis) {
    centre[axis].setZero();
    for (int k = 0; k < 4; ++k) {
      const auto& e = Reference_hexahedron::axis_edges[axis][k];
      const Eigen::Vector3d edge = nodes[hexahedron[e[1]]] - nodes[hexahedron[e[0]]];
      centre[axis] += edge;
      directions[axis][k] = edge.normalized();
    }
  }
  double least = centre[0].normalized().cross(centre[1].normalized()).dot(centre[2].normalized());
  for (const auto& e : corner_edges)
    least = (std::min)(least, directions[0][e[0]].cross(directions[1][e[1]]).dot(directions[2][e[2]]));
  return least;
}

// Whether a hexahedron is inverted somewhere. The exact test is spared where corners tell: a determinant of normalized
// differences that is not tiny has the exact sign, and good corners hardly leave room for a bad inside.
inline bool is_inverted(const std::vector<Eigen::Vector3d>& nodes, const std::array<std::size_t, 8>& hexahedron,
                        double scaled_jacobian) {
  constexpr double rounding = 1e-12, good = 0.7;
  if (scaled_jacobian > good) return false;
  if (scaled_jacobian < -rounding) return true;
  std::array<Simple_cartesian<double>::Point_3, 8> vertices;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d& p = nodes[hexahedron[i]];
    vertices[i] = {p.x(), p.y(), p.z()};
  }
  return !(scaled_jacobian > 0) || !has_positive_jacobian(vertices);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_NODE_QUALITY_H
