// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BISECTED_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BISECTED_MESH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Finds the places of a mesh that has been refined by bisecting edges in the mesh that it was made of.
template <typename GeomTraits>
class Bisected_mesh {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Edge = std::array<Vertex_index, 2>;

  // edges: those that were bisected, in their order; their midpoints are the vertices after those of the mesh
  Bisected_mesh(const Mesh& mesh, const std::vector<Edge>& edges) : m_mesh(mesh), m_stars(mesh) {
    for (Vertex_index v : mesh.vertices()) m_combinations.push_back({{v, 1.}});
    for (const Edge& e : edges) m_combinations.push_back(mean(m_combinations[e[0]], m_combinations[e[1]]));
  }

  std::size_t number_of_vertices() const { return m_combinations.size(); }

  Location_3<GeomTraits> location(Vertex_index v) const {
    std::vector<Vertex_index> corners;
    for (const Term& t : m_combinations[v]) corners.push_back(t.first);
    Location_3<GeomTraits> result{cell_with(corners), {}};
    result.barycentric.fill(typename GeomTraits::FT(0));
    for (const Term& t : m_combinations[v])
      result.barycentric[m_mesh.index(result.cell, t.first)] = typename GeomTraits::FT(t.second);
    return result;
  }

  // The cell that the refined cell with these vertices is a part of: all of its corners occur there.
  Cell_index origin(const std::array<Vertex_index, 4>& refined_cell) const {
    std::vector<Vertex_index> corners;
    for (Vertex_index v : refined_cell)
      for (const Term& t : m_combinations[v]) corners.push_back(t.first);
    return cell_with(corners);
  }

private:
  using Term = std::pair<Vertex_index, double>; // weights are dyadic, so exact
  using Combination = std::vector<Term>;

  static Combination mean(const Combination& a, const Combination& b) {
    Combination result = a;
    for (const Term& t : b) {
      const auto same =
          std::find_if(result.begin(), result.end(), [&](const Term& u) { return u.first == t.first; });
      if (same == result.end())
        result.push_back(t);
      else
        same->second += t.second;
    }
    for (Term& t : result) t.second /= 2;
    return result;
  }

  Cell_index cell_with(const std::vector<Vertex_index>& corners) const {
    const auto& star = m_stars.cells(corners[0]);
    return *std::find_if(star.begin(), star.end(), [&](Cell_index c) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](Vertex_index v) { return m_mesh.index(c, v) >= 0; });
    });
  }

  const Mesh& m_mesh;
  Vertex_stars m_stars;
  std::vector<Combination> m_combinations; // of the vertices of the mesh, for each vertex of the refined one
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BISECTED_MESH_H
