// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINED_PLACES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINED_PLACES_H

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

// Finds the places of a mesh that has been refined by splitting simplices in the mesh that it was made of.
template <typename GeomTraits>
class Refined_places {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Simplex = typename Mesh::Simplex;

  Refined_places(const Mesh& mesh, const Mesh& refined) : m_mesh(mesh), m_stars(mesh) {
    for (Vertex_index v : mesh.vertices()) m_combinations.push_back({{v, 1.}});
    const auto& splits = refined.split_simplices();
    const std::size_t added = refined.number_of_vertices() - mesh.number_of_vertices();
    std::for_each(splits.end() - added, splits.end(),
                  [&](const Simplex& s) { m_combinations.push_back(mean(s)); });
  }

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
  using Term = std::pair<Vertex_index, double>; // a vertex of the mesh and its weight
  using Combination = std::vector<Term>;

  Combination mean(const Simplex& simplex) const {
    const auto n = std::count_if(simplex.begin(), simplex.end(), [](Vertex_index v) { return v.is_valid(); });
    Combination result;
    for (std::ptrdiff_t k = 0; k < n; ++k)
      for (const auto& [v, weight] : m_combinations[simplex[k]]) add({v, weight / double(n)}, result);
    return result;
  }

  static void add(const Term& term, Combination& sum) {
    const auto same =
        std::find_if(sum.begin(), sum.end(), [&](const Term& other) { return other.first == term.first; });
    if (same == sum.end())
      sum.push_back(term);
    else
      same->second += term.second;
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

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_REFINED_PLACES_H
