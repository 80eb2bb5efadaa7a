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
flux crosses in the sense of the turn, and others that it crosses against it; regular are two changes. Facets that it does
not cross do not count; at an edge with such a facet it cannot circle.
*/
struct Irregular_edge {
  std::array<Vertex_index, 2> vertices; ///< its ends
  int sign_changes = 0; ///< 0: the flux circles around the edge; 4 or more: the edge is a saddle
};

namespace internal {

// The signs of the facets around an edge, in the order of a turn that leaves a first cell through its facet `exit`.
template <typename Mesh, typename Flux, typename Visitor>
void visit_signs_around(const Mesh& mesh, const Flux& flux, Half_facet exit, int entry,
                        const Visitor& visit) {
  const Cell_index first = exit.cell;
  do {
    visit(-flux.signs(exit.cell)[exit.index]);
    const Half_facet next = mesh.opposite(exit);
    // the vertex that is passed over is opposite to the next exit
    const int i = mesh.index(next.cell, mesh.vertex(exit.cell, entry));
    entry = next.index;
    exit = {next.cell, i};
  } while (exit.cell != first);
}

// The changes of sign around an interior edge; 2, that is nothing irregular, if the flux crosses not all facets and
// these in one sense only.
template <typename Mesh, typename Flux>
int sign_changes_around(const Mesh& mesh, const Flux& flux, Half_facet exit, int entry) {
  int changes = 0, first = 0, last = 0;
  bool may_circle = true;
  visit_signs_around(mesh, flux, exit, entry, [&](int sign) {
    may_circle = may_circle && sign != 0;
    if (sign == 0) return;
    if (first == 0) first = sign;
    changes += last != 0 && sign != last;
    last = sign;
  });
  changes += first != last;
  return changes == 0 && !may_circle ? 2 : changes;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

finds the irregular edges of a flux in the order of their vertices. The order of a sweep has no irregular edge with 0
changes, since nothing can circle in it.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Flux `Flux_field_3`, `Product_structure_3` or another class with their function `signs()`
\param mesh a tetrahedral mesh whose boundary is a manifold
\param flux an object whose `signs(c)[i]` is +1, -1 or 0 for a flux that enters cell `c` through facet `i`, leaves there, or
does neither

Complexity: \f$ O(n \log n) \f$.
*/
template <typename GeomTraits, typename Flux>
std::vector<Irregular_edge> irregular_edges(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                            const Flux& flux) {
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  const internal::Edge_numbering edges(mesh);
  std::vector<char> is_done(edges.number_of_edges(), 0);
  for (Facet_index f : mesh.boundary_facets())
    for (int i = 0; i < 3; ++i) is_done[edges.find(mesh.vertices(f)[i], mesh.vertices(f)[(i + 1) % 3])] = 1;
  std::vector<int> changes(edges.number_of_edges(), 2);
  for (Cell_index c : mesh.cells())
    for (int k = 0; k < 6; ++k) { // the facets at edge k are opposite to the ends of edge 5 - k
      const Edge_index e = edges.edge(c, k);
      const auto& opposite = Mesh::edge_vertices[5 - k];
      if (!is_done[e]) changes[e] = internal::sign_changes_around(mesh, flux, {c, opposite[0]}, opposite[1]);
      is_done[e] = 1;
    }
  std::vector<Irregular_edge> result;
  for (Edge_index e : edges.edges())
    if (changes[e] != 2) result.push_back({edges.ends(e), changes[e]});
  return result;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IRREGULAR_EDGES_H
