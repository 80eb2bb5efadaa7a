// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_PRODUCT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_PRODUCT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

// The 14 faces of a tetrahedron as bits: 0-3 its vertices, 4-9 its edges, 10-13 its facets, facet i opposite to
// vertex i. Sets of faces are integers, so that the rules of the sweep are formulas on sets.
struct Tetrahedron_faces {
  using Set = std::uint32_t;

  static constexpr int number = 14, first_edge = 4, first_facet = 10;
  static constexpr Set all_facets = Set(15) << first_facet;
  /// The vertices of each face, again as bits.
  static constexpr Set vertices[number] = {1, 2, 4, 8, 3, 5, 9, 6, 10, 12, 14, 13, 11, 7};

  /// returns the face `i` with all its faces.
  static constexpr Set closed_face(int i) {
    Set closure = 0;
    for (int j = 0; j < number; ++j)
      if (!(vertices[j] & ~vertices[i])) closure |= Set(1) << j;
    return closure;
  }

  /// returns the facets among `faces` with all their faces.
  static constexpr Set closed_facets(Set faces) {
    Set closure = 0;
    for (int i = first_facet; i < number; ++i)
      if (faces >> i & 1) closure |= closed_face(i);
    return closure;
  }
};

// Replays a sweep and checks each step against what is swept already. It even numbers the edges by itself: code
// shared with the sweep would hide their common defects.
template <typename GeomTraits>
class Sweep_verifier {
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Faces = Tetrahedron_faces;
  using Set = Faces::Set;
  using Face_ids = std::array<std::size_t, Faces::number>;
  using Marks = std::vector<char>;

public:
  template <typename ConcurrencyTag>
  Sweep_verifier(const Mesh& mesh, ConcurrencyTag) : m_mesh(mesh) {
    number_edges<ConcurrencyTag>();
    m_on_wall.assign(number_of_faces(), 0);
    for (Facet_index f : mesh.boundary_facets())
      if (mesh.label(f) >= FIRST_WALL) mark_facet(f, m_on_wall);
  }

  /// replays the sweep `first`, ..., `last` from the facets with the label `base`.
  template <typename CellIterator>
  Status verify(CellIterator first, CellIterator last, Boundary_label base) const {
    Marks swept(number_of_faces(), 0);
    for (Facet_index f : m_mesh.boundary_facets())
      if (m_mesh.label(f) == base) mark_facet(f, swept);
    for (CellIterator c = first; c != last; ++c) {
      const Breach breach = find_breach(*c, swept);
      if (breach.rule)
        return {ERROR_SWEEP_RULE, std::string("from the ") + (base == FLOOR ? "floor" : "ceiling") +
                                      ", position " + std::to_string(c - first) + ", tetrahedron " +
                                      std::to_string(*c) + " " + breach.rule + name_least(*c, breach.faces)};
      for (std::size_t id : face_ids(*c)) swept[id] = 1;
    }
    return {};
  }

private:
  struct Breach {
    const char* rule = nullptr;
    Set faces = 0; // where the rule is broken
  };
  struct Occurrence {
    std::uint32_t upper_end, cell, edge;
  };

  // The rules of the theorem, for the next tetrahedron of the sweep.
  Breach find_breach(Cell_index c, const Marks& swept_faces) const {
    const Face_ids ids = face_ids(c);
    const Set swept = select(ids, swept_faces), on_wall = select(ids, m_on_wall);
    const Set entry = Faces::closed_facets(swept), wall = Faces::closed_facets(on_wall);
    if (!entry) return {"has no facet to enter by"};
    if (swept != entry) return {"meets what is swept outside of its entry facets, in", swept & ~entry};
    if (!(Faces::all_facets & ~entry & ~wall)) return {"has no facet to leave by"};
    return {on_wall & ~swept & ~wall ? "reaches the wall from inside, in" : nullptr,
            on_wall & ~swept & ~wall};
  }

  static Set select(const Face_ids& ids, const Marks& marks) {
    Set set = 0;
    for (int i = 0; i < Faces::number; ++i) set |= Set(marks[ids[i]]) << i;
    return set;
  }

  void mark_facet(Facet_index f, Marks& marks) const {
    const Half_facet h = m_mesh.half_facet(f);
    const Face_ids ids = face_ids(h.cell);
    const Set closed_facet = Faces::closed_face(Faces::first_facet + h.index);
    for (int i = 0; i < Faces::number; ++i)
      if (closed_facet >> i & 1) marks[ids[i]] = 1;
  }

  // The faces of the mesh have one numbering: first the vertices, then the edges, then the facets.
  std::size_t first_facet() const { return m_mesh.number_of_vertices() + m_number_of_edges; }
  std::size_t number_of_faces() const { return first_facet() + m_mesh.number_of_facets(); }

  Face_ids face_ids(Cell_index c) const {
    Face_ids ids;
    for (int i = 0; i < 4; ++i) ids[i] = m_mesh.vertex(c, i);
    for (int e = 0; e < 6; ++e) ids[Faces::first_edge + e] = m_mesh.number_of_vertices() + m_cell_edges[c][e];
    for (int i = 0; i < 4; ++i) ids[Faces::first_facet + i] = first_facet() + m_mesh.facet(c, i);
    return ids;
  }

  std::pair<std::uint32_t, std::uint32_t> edge(Cell_index c, int e) const {
    const int* ends = Mesh::edge_vertices[e];
    return std::minmax({std::uint32_t(m_mesh.vertex(c, ends[0])), std::uint32_t(m_mesh.vertex(c, ends[1]))});
  }

  // Linear for vertices of bounded degree: a counting sort by the lower end, then each small bucket by the upper one.
  template <typename ConcurrencyTag>
  void number_edges() {
    std::vector<std::size_t> bucket(m_mesh.number_of_vertices() + 1, 0);
    const std::vector<Occurrence> occurrences = sort_into_buckets<ConcurrencyTag>(bucket);
    m_cell_edges.resize(m_mesh.number_of_cells());
    for (Vertex_index v : m_mesh.vertices())
      for (std::size_t k = bucket[v]; k < bucket[v + 1]; ++k) {
        const Occurrence& o = occurrences[k];
        m_number_of_edges += k == bucket[v] || occurrences[k - 1].upper_end != o.upper_end;
        m_cell_edges[o.cell][o.edge] = m_number_of_edges - 1;
      }
  }

  template <typename ConcurrencyTag>
  std::vector<Occurrence> sort_into_buckets(std::vector<std::size_t>& bucket) const {
    for (Cell_index c : m_mesh.cells())
      for (int e = 0; e < 6; ++e) ++bucket[edge(c, e).first + 1];
    std::partial_sum(bucket.begin(), bucket.end(), bucket.begin());
    std::vector<std::size_t> next = bucket;
    std::vector<Occurrence> occurrences(bucket.back());
    for (Cell_index c : m_mesh.cells())
      for (int e = 0; e < 6; ++e) {
        const auto ends = edge(c, e);
        occurrences[next[ends.first]++] = {ends.second, c, std::uint32_t(e)};
      }
    const auto sort_bucket = [&](std::size_t v) {
      std::sort(occurrences.begin() + bucket[v], occurrences.begin() + bucket[v + 1],
                [](const Occurrence& a, const Occurrence& b) { return a.upper_end < b.upper_end; });
    };
    for_each_index<ConcurrencyTag>(m_mesh.number_of_vertices(), sort_bucket, 4096);
    return occurrences;
  }

  // Names the first of `faces` by its vertices.
  std::string name_least(Cell_index c, Set faces) const {
    if (!faces) return {};
    int face = 0;
    while (!(faces >> face & 1)) ++face;
    std::string name = face < Faces::first_edge ? " vertex" : face < Faces::first_facet ? " edge" : " facet";
    for (int i = 0; i < 4; ++i)
      if (Faces::vertices[face] >> i & 1) name += " " + std::to_string(m_mesh.vertex(c, i));
    return name;
  }

  const Mesh& m_mesh;
  std::vector<std::array<std::uint32_t, 6>> m_cell_edges;
  std::uint32_t m_number_of_edges = 0;
  Marks m_on_wall; // for each face of the mesh
};

inline Status verify_permutation(const std::vector<Cell_index>& order, std::size_t n) {
  if (order.size() != n)
    return {ERROR_SWEEP_RULE,
            "the order names " + std::to_string(order.size()) + " tetrahedra of " + std::to_string(n)};
  std::vector<char> seen(n, 0);
  for (std::size_t k = 0; k < n; ++k)
    if (order[k] >= n || seen[order[k]]++)
      return {ERROR_SWEEP_RULE, "position " + std::to_string(k) + ", tetrahedron " +
                                    std::to_string(order[k]) +
                                    (order[k] >= n ? " does not exist" : " comes a second time")};
  return {};
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

verifies that `order` sweeps `mesh` from the floor to the ceiling, and backwards from the ceiling to the floor.

Let \f$ X \f$ be the floor and all tetrahedra swept so far. The next tetrahedron \f$ t \f$ must obey three rules:
1. \f$ t \cap X \f$ is exactly one, two or three facets of \f$ t \f$, by which the sweep enters it;
2. a facet of \f$ t \f$ is left that is neither an entry nor on a wall;
3. each edge or vertex of \f$ t \f$ on the closed walls is in \f$ X \f$ or in a facet of \f$ t \f$ on a wall.

If the labels are a legal partition, see `validate_partition()`, such an order proves that the mesh is the product of
its floor and an interval, by combinatorics alone.

The function shares no code with the sweep but parallel loops. It takes \f$ O(n) \f$ time for vertices of bounded degree.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: both directions may be replayed at
the same time
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\param mesh a tetrahedral mesh with labels
\param order all tetrahedra, in the order in which the front sweeps them

\returns `ERROR_SWEEP_RULE` when `order` is not a permutation of the tetrahedra or breaks a rule; the detail names the
first position, tetrahedron and rule
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits>
Status verify_product(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                      const std::vector<Cell_index>& order) {
  Status status = internal::verify_permutation(order, mesh.number_of_cells());
  if (!status.ok()) return status;
  const internal::Sweep_verifier<GeomTraits> verifier(mesh, ConcurrencyTag());
  const auto verify = [&](std::size_t i) {
    return i == 0 ? verifier.verify(order.begin(), order.end(), FLOOR)
                  : verifier.verify(order.rbegin(), order.rend(), CEILING);
  };
  return internal::try_each_index<ConcurrencyTag>(2, verify, 1);
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_PRODUCT_H
