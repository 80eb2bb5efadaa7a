// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CRITICAL_POINTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CRITICAL_POINTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

is a vertex at which the topology of the level sets of a function changes. A vertex may be critical with index 1 and
with index 2.
*/
struct Critical_vertex {
  Vertex_index vertex;  ///< where it is
  int index = 0;        ///< 0 minimum, 1 and 2 saddles, 3 maximum
  int multiplicity = 0; ///< how many simple critical points it stands for
  bool on_wall = false; ///< whether it lies on the boundary, where the function is taken to be even across it
};

namespace internal {

// The link of one vertex at a time: its vertices, and in which parts of it the function is lower and higher.
template <typename GeomTraits>
class Link_test {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;

  Link_test(const Mesh& mesh, const std::vector<double>& values)
      : m_mesh(mesh),
        m_values(values),
        m_stars(mesh),
        m_is_base(mesh.number_of_vertices(), 0),
        m_is_boundary(mesh.number_of_vertices(), 0),
        m_slot(mesh.number_of_vertices(), none) {
    for (Facet_index f : mesh.boundary_facets())
      for (Vertex_index v : mesh.vertices(f)) {
        m_is_boundary[v] = 1;
        if (mesh.label(f) == FLOOR || mesh.label(f) == CEILING) m_is_base[v] = 1;
      }
  }

  void append_critical(Vertex_index v, std::vector<Critical_vertex>& result) {
    if (m_is_base[v] || m_stars.cells(v).empty()) return;
    collect(v);
    const auto [lower, upper] = count_parts(v);
    for (Link_vertex u : m_link) m_slot[u.vertex] = none;
    const auto append = [&](int index, int multiplicity) {
      if (multiplicity > 0) result.push_back({v, index, multiplicity, bool(m_is_boundary[v])});
    };
    append(0, lower == 0);
    append(1, lower - 1);
    append(2, upper - 1);
    append(3, upper == 0);
  }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);
  struct Link_vertex {
    Vertex_index vertex;
    bool is_on_rim; // of the half of a sphere that is the link of a vertex on the boundary
  };

  // Simulation of simplicity: H. Edelsbrunner, E. P. Muecke, ACM Trans. Graph. 9 (1990).
  bool is_lower(Vertex_index u, Vertex_index v) const {
    return std::make_pair(m_values[u], u) < std::make_pair(m_values[v], v);
  }

  void collect(Vertex_index v) {
    m_link.clear();
    for (Cell_index c : m_stars.cells(v))
      for (Vertex_index u : m_mesh.cell(c)) {
        if (u == v || m_slot[u] != none) continue;
        m_slot[u] = std::uint32_t(m_link.size());
        m_link.push_back({u, false});
      }
    if (!m_is_boundary[v]) return;
    for (Cell_index c : m_stars.cells(v))
      for (int i = 0; i < 4; ++i) {
        if (m_mesh.vertex(c, i) == v || !m_mesh.is_boundary(m_mesh.facet(c, i))) continue;
        for (Vertex_index u : m_mesh.vertices(Half_facet{c, i}))
          if (u != v) m_link[m_slot[u]].is_on_rim = true;
      }
  }

  // returns the numbers of connected parts of the lower and of the upper link. By Alexander duality in the sphere they
  // determine the homology of both. A half link is doubled: a part off its rim counts twice.
  std::pair<int, int> count_parts(Vertex_index v) const {
    Disjoint_sets parts(m_link.size());
    for (Cell_index c : m_stars.cells(v))
      for (Vertex_index u : m_mesh.cell(c))
        for (Vertex_index w : m_mesh.cell(c))
          if (u < w && u != v && w != v && is_lower(u, v) == is_lower(w, v)) parts.join(m_slot[u], m_slot[w]);
    std::vector<char> touches_rim(m_link.size(), 0);
    for (std::uint32_t k = 0; k < m_link.size(); ++k)
      if (m_link[k].is_on_rim) touches_rim[parts.representative(k)] = 1;
    std::pair<int, int> count = {0, 0};
    for (std::uint32_t k = 0; k < m_link.size(); ++k)
      if (parts.is_representative(k))
        (is_lower(m_link[k].vertex, v) ? count.first : count.second) +=
            m_is_boundary[v] && !touches_rim[k] ? 2 : 1;
    return count;
  }

  const Mesh& m_mesh;
  const std::vector<double>& m_values;
  Vertex_stars m_stars;
  std::vector<char> m_is_base, m_is_boundary;
  std::vector<std::uint32_t> m_slot; // of a vertex in m_link
  std::vector<Link_vertex> m_link;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

finds the critical points of the piecewise linear function with the given values at the vertices, in linear time.

The part of a vertex's link where the function is lower tells: it is contractible, and so is the upper part, if and only
if the vertex is regular (T. F. Banchoff, J. Differential Geom. 1 (1967)). At a wall the mesh and the function are
reflected, as fits a function whose normal derivative vanishes there. Floor and ceiling are skipped. Of equal values that
of the vertex with the smaller number counts as lower.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a mesh that `check_tetrahedral_mesh()` accepts, with labels
\param values one for each vertex
\param result gets the critical vertices in the order of their numbers

\returns `ERROR_WRONG_PARAMETER` if there are too few or too many values or one is not finite
*/
template <typename GeomTraits>
Status find_critical_points(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                            const std::vector<double>& values, std::vector<Critical_vertex>& result) {
  result.clear();
  if (values.size() != mesh.number_of_vertices())
    return {ERROR_WRONG_PARAMETER, std::to_string(values.size()) + " values for " +
                                       std::to_string(mesh.number_of_vertices()) + " vertices"};
  for (Vertex_index v : mesh.vertices())
    if (!std::isfinite(values[v])) return {ERROR_WRONG_PARAMETER, "the value at vertex " + std::to_string(v)};
  internal::Link_test<GeomTraits> test(mesh, values);
  for (Vertex_index v : mesh.vertices()) test.append_critical(v, result);
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CRITICAL_POINTS_H
