// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SMOOTH_EDGE_LENGTHS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SMOOTH_EDGE_LENGTHS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// For each hexahedron the mean length of its edges along each axis, averaged with hexahedra that share such an edge.
inline std::vector<Eigen::Vector3d> smooth_edge_lengths(const std::vector<Eigen::Vector3d>& nodes,
                                                        const std::vector<std::array<std::size_t, 8>>& hexahedra) {
  constexpr int rounds = 20;
  struct Edge {
    std::array<std::size_t, 2> nodes;
    std::size_t hexahedron;
    int axis;
    bool operator<(const Edge& e) const { return nodes < e.nodes; }
  };
  std::vector<Eigen::Vector3d> lengths(hexahedra.size(), Eigen::Vector3d::Zero());
  std::vector<Edge> edges;
  for (std::size_t h = 0; h < hexahedra.size(); ++h)
    for (int axis = 0; axis < 3; ++axis)
      for (const auto& e : Reference_hexahedron::axis_edges[axis]) {
        const std::size_t v = hexahedra[h][e[0]], w = hexahedra[h][e[1]];
        lengths[h][axis] += (nodes[v] - nodes[w]).norm() / 4;
        edges.push_back({{(std::min)(v, w), (std::max)(v, w)}, h, axis});
      }
  std::stable_sort(edges.begin(), edges.end());
  for (int round = 0; round < rounds; ++round) {
    std::vector<Eigen::Vector3d> means(lengths.size(), Eigen::Vector3d::Zero());
    for (auto e = edges.begin(), end = e; e != edges.end(); e = end) {
      double sum = 0;
      for (; end != edges.end() && end->nodes == e->nodes; ++end) sum += lengths[end->hexahedron][end->axis];
      for (auto i = e; i != end; ++i) means[i->hexahedron][i->axis] += sum / double(end - e) / 4;
    }
    lengths = std::move(means);
  }
  return lengths;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SMOOTH_EDGE_LENGTHS_H
