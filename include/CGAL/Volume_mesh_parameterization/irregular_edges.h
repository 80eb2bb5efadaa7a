// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IRREGULAR_EDGES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IRREGULAR_EDGES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Edge_numbering.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

is an interior edge around which a flux does not simply pass by. Going once around the edge one meets facets that the
flux crosses in the sense of the turn, and others that it crosses against it; regular are two changes.
*/
struct Irregular_edge {
  std::array<Vertex_index, 2> vertices;
  int sign_changes; ///< 0: the flux circles around the edge; 4 or more: the edge is a saddle
};

/*!
\ingroup PkgVolumeMeshParameterizationVerification

finds the irregular edges of a flux in the order of their vertices.

A change happens in a cell whose two facets at the edge are both crossed inwards or both outwards. The order of a sweep
has no irregular edge with 0 changes, since nothing can circle in it.

\param mesh a tetrahedral mesh
\param flux an object whose `signs(c)[i]` is +1, -1 or 0 for a flux that enters cell `c` through facet `i`, leaves there, or
does neither: a `Flux_field_3` or a `Product_structure_3`

Complexity: \f$ O(n) \f$.
*/
template <typename GeomTraits, typename Flux>
std::vector<Irregular_edge> irregular_edges(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh, const Flux& flux) {
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  const internal::Edge_numbering edges(mesh);
  std::vector<int> changes(edges.number_of_edges(), 0);
  for (Cell_index c : mesh.cells())
    for (int k = 0; k < 6; ++k) { // the facets at edge k are opposite to the ends of edge 5 - k
      const auto& opposite = Mesh::edge_vertices[5 - k];
      changes[edges.edge(c, k)] += flux.signs(c)[opposite[0]] == flux.signs(c)[opposite[1]];
    }
  std::vector<char> is_interior(edges.number_of_edges(), 1);
  for (Facet_index f : mesh.boundary_facets())
    for (int i = 0; i < 3; ++i) is_interior[edges.find(mesh.vertices(f)[i], mesh.vertices(f)[(i + 1) % 3])] = 0;
  std::vector<Irregular_edge> result;
  for (Edge_index e : edges.edges())
    if (is_interior[e] && changes[e] != 2) result.push_back({edges.ends(e), changes[e]});
  return result;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IRREGULAR_EDGES_H
