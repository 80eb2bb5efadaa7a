// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_HANDLEBODY_CERTIFICATE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HANDLEBODY_CERTIFICATE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Edge_numbering.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/tags.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {
template <typename ConcurrencyTag, typename GeomTraits>
class Handlebody_collapse;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

proves that a mesh is a handlebody: a word in the free group of `genus()` generators for each edge, such that the
words around each facet cancel. `certify_handlebody()` fills it.
*/
class Handlebody_certificate {
public:
  /// returns the number of generators of the fundamental group.
  int genus() const { return m_genus; }

  /// returns the reduced word of `e`, from its smaller to its larger end: a range of `int`, `k` for generator
  /// `k = 1, ..., genus()` and `-k` for its inverse.
  auto word(Edge_index e) const {
    return boost::make_iterator_range(m_letters.begin() + m_spans[e][0], m_letters.begin() + m_spans[e][1]);
  }

  /// returns the length of the longest word.
  std::size_t longest_word() const {
    std::size_t longest = 0;
    for (const Span& span : m_spans) longest = std::max<std::size_t>(longest, span[1] - span[0]);
    return longest;
  }

#ifndef DOXYGEN_RUNNING
  const internal::Edge_numbering& edges() const { return m_edges; }
#endif

private:
  template <typename ConcurrencyTag, typename GeomTraits>
  friend class internal::Handlebody_collapse;
  using Span = std::array<std::uint32_t, 2>;

  int m_genus = 0;
  internal::Edge_numbering m_edges;
  std::vector<Span> m_spans;
  std::vector<int> m_letters;
};

namespace internal {

using Word = std::vector<int>;

inline void append_letter(Word& word, int letter) {
  if (!word.empty() && word.back() == -letter)
    word.pop_back();
  else
    word.push_back(letter);
}

// One attempt to collapse a tetrahedral mesh to a graph, and the words of its edges.
template <typename ConcurrencyTag, typename GeomTraits>
class Handlebody_collapse {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;

  Handlebody_collapse(const Mesh& mesh, Handlebody_certificate& certificate)
      : m_mesh(mesh),
        m_certificate(certificate),
        m_edges(certificate.m_edges),
        m_is_removed(mesh.number_of_facets(), 0),
        m_is_collapsed(m_edges.number_of_edges(), 0),
        m_uses(m_edges.number_of_edges()) {}

  // The edges of cells are needed as long as there are attempts.
  static void number_edges(const Mesh& mesh, Handlebody_certificate& certificate) {
    certificate.m_edges = Edge_numbering(mesh, ConcurrencyTag());
  }

  static void forget_cells(Handlebody_certificate& certificate) { certificate.m_edges.forget_cells(); }

  // Digs through the mesh from the boundary facets `first`, `first + step`, ...
  Status run(std::size_t first, std::size_t step) {
    remove_cells(first, step);
    collapse_edges();
    if (m_number_of_triangles > 0)
      return {ERROR_NOT_A_HANDLEBODY,
              std::to_string(m_number_of_triangles) + " triangles cannot be collapsed"};
    Status status = name_generators();
    if (status.ok()) status = replay();
    if (status.ok()) status = check_facets();
    return status;
  }

private:
  // the edges around the facet opposite to each vertex, in the order of Mesh::edge_vertices
  static constexpr int facet_edges[4][3] = {{3, 4, 5}, {1, 2, 5}, {0, 2, 4}, {0, 1, 3}};

  // Words grow at each step of a replay: an order in which they explode is given up.
  static constexpr std::size_t letters_per_edge = 16;

  std::size_t most_letters() const { // 32 bits number them
    const std::size_t numbers = std::numeric_limits<std::uint32_t>::max();
    return (std::min)(letters_per_edge * m_edges.number_of_edges(), numbers);
  }

  std::array<Edge_index, 3> edges_of(Facet_index f) const {
    const Half_facet h = m_mesh.half_facet(f);
    const int* k = facet_edges[h.index];
    return {m_edges.edge(h.cell, k[0]), m_edges.edge(h.cell, k[1]), m_edges.edge(h.cell, k[2])};
  }

  // Each cell is removed together with the facet through which the search reaches it.
  void remove_cells(std::size_t first, std::size_t step) {
    std::vector<char> reached(m_mesh.number_of_cells(), 0);
    std::vector<Cell_index> queue;
    const auto reach = [&](Facet_index f, Cell_index c) {
      if (!c.is_valid() || reached[c]) return;
      reached[c] = 1;
      m_is_removed[f] = 1;
      queue.push_back(c);
    };
    for (std::size_t f = first; f < m_mesh.number_of_boundary_facets(); f += step)
      reach(Facet_index(f), m_mesh.half_facet(Facet_index(f)).cell);
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (int i = 0; i < 4; ++i) reach(m_mesh.facet(queue[k], i), m_mesh.neighbor(queue[k], i));
  }

  // The numbers of the triangles left at an edge, added bit by bit, name the last one.
  struct Uses {
    std::uint32_t number = 0, triangles = 0;
  };

  void collapse_edges() {
    for (Facet_index f : m_mesh.facets())
      if (!m_is_removed[f]) count(f, +1);
    std::vector<Edge_index> queue;
    for (Edge_index e : m_edges.edges())
      if (m_uses[e].number == 1) queue.push_back(e);
    for (std::size_t k = 0; k < queue.size(); ++k) {
      if (m_uses[queue[k]].number != 1) continue;
      const Facet_index f(m_uses[queue[k]].triangles);
      m_is_collapsed[queue[k]] = 1;
      m_collapses.push_back({queue[k], f});
      count(f, -1);
      for (Edge_index e : edges_of(f))
        if (m_uses[e].number == 1) queue.push_back(e);
    }
  }

  void count(Facet_index f, int sign) {
    m_number_of_triangles += sign;
    for (Edge_index e : edges_of(f)) {
      m_uses[e].number += sign;
      m_uses[e].triangles ^= f;
    }
  }

  // The edges outside of a spanning tree of the graph are the generators.
  Status name_generators() {
    m_certificate.m_genus = 0;
    m_certificate.m_letters.clear();
    m_certificate.m_spans.assign(m_edges.number_of_edges(), {0, 0});
    Disjoint_sets sets(m_mesh.number_of_vertices());
    std::size_t number_of_parts = count_vertices_of_cells();
    for (Edge_index e : m_edges.edges()) {
      if (m_is_collapsed[e]) continue;
      const std::uint32_t v = m_edges.ends(e)[0], w = m_edges.ends(e)[1];
      if (sets.representative(v) == sets.representative(w)) {
        store(e, {++m_certificate.m_genus});
      } else {
        sets.join(v, w);
        --number_of_parts;
      }
    }
    if (number_of_parts == 1) return {};
    return {ERROR_NOT_A_HANDLEBODY, "it has " + std::to_string(number_of_parts) + " components"};
  }

  std::size_t count_vertices_of_cells() const {
    std::vector<char> used(m_mesh.number_of_vertices(), 0);
    for (Cell_index c : m_mesh.cells())
      for (Vertex_index v : m_mesh.cell(c)) used[v] = 1;
    return std::count(used.begin(), used.end(), 1);
  }

  void store(Edge_index e, const Word& word) {
    const std::size_t begin = m_certificate.m_letters.size();
    m_certificate.m_letters.insert(m_certificate.m_letters.end(), word.begin(), word.end());
    m_certificate.m_spans[e] = {std::uint32_t(begin), std::uint32_t(m_certificate.m_letters.size())};
  }

  // Goes along an edge from the vertex v and returns the other one.
  Vertex_index append(Word& word, Edge_index e, Vertex_index v) const {
    const auto letters = m_certificate.word(e);
    const bool is_forward = v == m_edges.ends(e)[0];
    if (is_forward)
      for (int letter : letters) append_letter(word, letter);
    else
      for (std::size_t k = letters.size(); k-- > 0;) append_letter(word, -letters[k]);
    return m_edges.ends(e)[is_forward ? 1 : 0];
  }

  // The edges of a facet in the order in which one passes them who starts with `first`, from its smaller end.
  std::array<Edge_index, 3> loop_from(Edge_index first, Facet_index f) const {
    std::array<Edge_index, 3> e = edges_of(f);
    std::swap(e[0], *std::find(e.begin(), e.end(), first));
    const Vertex_index v = m_edges.ends(first)[1];
    if (m_edges.ends(e[1])[0] != v && m_edges.ends(e[1])[1] != v) std::swap(e[1], e[2]);
    return e;
  }

  // Undoing the collapses, the last first: a collapsed edge is homotopic to the other two edges of its triangle.
  Status replay() {
    Word word;
    for (std::size_t k = m_collapses.size(); k-- > 0;) {
      const auto [e, f] = m_collapses[k];
      const std::array<Edge_index, 3> loop = loop_from(e, f);
      word.clear();
      append(word, loop[1], append(word, loop[2], m_edges.ends(e)[0]));
      store(e, word);
      if (m_certificate.m_letters.size() > most_letters())
        return {ERROR_NOT_A_HANDLEBODY, "the words of the edges grow too long"};
    }
    return {};
  }

  Status check_facets() const {
    const auto check = [this](std::size_t f) -> Status {
      Word word;
      const std::array<Edge_index, 3> loop = loop_from(edges_of(Facet_index(f))[0], Facet_index(f));
      Vertex_index v = m_edges.ends(loop[0])[0];
      for (Edge_index e : loop) v = append(word, e, v);
      if (word.empty()) return {};
      return {ERROR_NOT_A_HANDLEBODY, "the loop around facet " + std::to_string(f)};
    };
    return try_each_index<ConcurrencyTag>(m_mesh.number_of_facets(), check, 4096);
  }

  const Mesh& m_mesh;
  Handlebody_certificate& m_certificate;
  const Edge_numbering& m_edges;
  std::vector<char> m_is_removed, m_is_collapsed;
  std::vector<Uses> m_uses; // of each edge, by triangles that are left
  std::size_t m_number_of_triangles = 0;
  std::vector<std::pair<Edge_index, Facet_index>> m_collapses;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

proves that `mesh` is a handlebody by collapsing it to a graph, in a few orders.

All cells are removed by a breadth-first search from the boundary, then triangles with a free edge as long as there is
one. If a graph remains, the solid is a handlebody, and the steps in reverse give a word for each edge. Each order
takes linear time.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns `ERROR_NOT_A_HANDLEBODY` if every order fails; the detail says how many triangles remained. The solid may be
a handlebody nevertheless.
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits>
Status certify_handlebody(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                          Handlebody_certificate& certificate) {
  using Collapse = internal::Handlebody_collapse<ConcurrencyTag, GeomTraits>;
  Collapse::number_edges(mesh, certificate);
  const std::size_t n = mesh.number_of_boundary_facets();
  Status status = Collapse(mesh, certificate).run(0, 1);
  for (std::size_t k = 0; k < 7 && !status.ok(); ++k) status = Collapse(mesh, certificate).run(k * n / 7, n);
  Collapse::forget_cells(certificate);
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HANDLEBODY_CERTIFICATE_H
