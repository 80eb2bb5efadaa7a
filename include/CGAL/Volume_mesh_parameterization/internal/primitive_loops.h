// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRIMITIVE_LOOPS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRIMITIVE_LOOPS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/shortest_path.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A class in the first homology group of a handlebody, by generators.
using Homology_class = std::vector<int>;

// The quotient of Z^n by some of its elements, as a basis of the homomorphisms to Z that vanish on them. Each element
// must be primitive in the quotient by those before: then the quotient is free.
class Free_quotient {
public:
  explicit Free_quotient(int n) : m_homomorphisms(n, Row(n, 0)) {
    for (int k = 0; k < n; ++k) m_homomorphisms[k][k] = 1;
  }

  bool is_primitive(const Homology_class& c) const {
    Number divisor = 0;
    for (const Row& row : m_homomorphisms) divisor = std::gcd(divisor, value(row, c));
    return divisor == 1;
  }

  // Euclid's algorithm: one homomorphism is left that does not vanish, and is given up.
  void divide_by(const Homology_class& c) {
    for (;;) {
      const auto least =
          std::min_element(m_homomorphisms.begin(), m_homomorphisms.end(), [&](const Row& a, const Row& b) {
            const Number x = std::abs(value(a, c)), y = std::abs(value(b, c));
            return x != 0 && (y == 0 || x < y);
          });
      bool is_last = true;
      for (auto row = m_homomorphisms.begin(); row != m_homomorphisms.end(); ++row) {
        if (row == least || value(*row, c) == 0) continue;
        subtract(value(*row, c) / value(*least, c), *least, *row);
        is_last = false;
      }
      if (!is_last) continue;
      m_homomorphisms.erase(least);
      return;
    }
  }

private:
  using Number = std::int64_t;
  using Row = std::vector<Number>;

  static Number value(const Row& row, const Homology_class& c) {
    return std::inner_product(row.begin(), row.end(), c.begin(), Number(0));
  }
  static void subtract(Number factor, const Row& from, Row& row) {
    for (std::size_t i = 0; i < row.size(); ++i) row[i] -= factor * from[i];
  }

  std::vector<Row> m_homomorphisms;
};

// The classes of edges of a mesh that gets refined by midpoints. To move each of them to an end of its edge is homotopic
// to the identity and maps simplices to simplices.
class Edge_classes {
public:
  Edge_classes(const Handlebody_certificate& certificate, std::size_t number_of_vertices)
      : m_certificate(certificate), m_original(number_of_vertices) {
    std::iota(m_original.begin(), m_original.end(), 0);
  }

  int rank() const { return m_certificate.genus(); }
  void add_midpoint(std::uint32_t v) { m_original.push_back(m_original[v]); }

  // Adds the class of the edge from v to w, `sign` times.
  void add(std::uint32_t v, std::uint32_t w, int sign, int* sum) const {
    const Vertex_index from(m_original[v]), to(m_original[w]);
    if (from == to) return;
    if (to < from) sign = -sign;
    for (int letter : m_certificate.word(m_certificate.edges().find(from, to)))
      sum[std::abs(letter) - 1] += letter > 0 ? sign : -sign;
  }

private:
  const Handlebody_certificate& m_certificate;
  std::vector<std::uint32_t> m_original; // the vertex of the mesh that a vertex is moved to
};

/*
Searches a short simple loop off the cuts of a surface whose class is primitive in a quotient of the homology of the
solid. From each of some roots a tree of shortest paths is grown; an edge off the tree closes a loop.
*/
template <typename Length>
class Primitive_loop_search {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;

  Primitive_loop_search(const Refined_surface& surface, const Edge_classes& classes,
                        const Free_quotient& quotient, const Length& length)
      : m_surface(surface),
        m_classes(classes),
        m_quotient(quotient),
        m_length(length),
        m_distance(surface.number_of_vertices(), unreached),
        m_before(surface.number_of_vertices(), Refined_surface::none),
        m_is_settled(surface.number_of_vertices(), 0),
        m_class(surface.number_of_vertices() * classes.rank(), 0) {}

  // The loop, its first vertex being its last one, too; empty if there is none.
  Path run() {
    for (Id root : spread(free_vertices(), number_of_roots)) search_from(root);
    for (Id root : spread(m_loop, number_of_improvements)) search_from(root);
    return m_loop;
  }

  Homology_class loop_class() const {
    Homology_class sum(m_classes.rank(), 0);
    for (std::size_t i = 1; i < m_loop.size(); ++i) m_classes.add(m_loop[i - 1], m_loop[i], 1, sum.data());
    return sum;
  }

private:
  static constexpr std::size_t number_of_roots = 30, number_of_improvements = 12;
  static constexpr double unreached = std::numeric_limits<double>::infinity();
  using Entry = std::pair<double, Id>;

  Path free_vertices() const {
    Path result;
    for (Id v = 0; v < m_surface.number_of_vertices(); ++v)
      if (m_surface.outgoing(v) != Refined_surface::none && !m_surface.is_on_cut(v)) result.push_back(v);
    std::sort(result.begin(), result.end(),
              [&](Id v, Id w) { return comes_before(v, w, [&](Id u) { return m_surface.points()[u]; }); });
    return result;
  }

  static Path spread(const Path& vertices, std::size_t n) {
    Path result;
    for (std::size_t k = 0; k < n && k < vertices.size(); ++k)
      result.push_back(vertices[k * vertices.size() / std::min(n, vertices.size())]);
    return result;
  }

  void search_from(Id root) {
    grow_tree(root);
    double shortest = unreached;
    std::array<Id, 2> ends = {root, root};
    for (Id v : m_settled)
      m_surface.for_each_neighbor(v, [&](Id w) {
        if (w < v || !m_is_settled[w] || m_before[v] == w || m_before[w] == v) return;
        const double l = m_distance[v] + m_length(v, w) + m_distance[w];
        if (l >= shortest || !m_quotient.is_primitive(class_closed_by(v, w))) return;
        shortest = l;
        ends = {v, w};
      });
    if (shortest < unreached) take_shorter(close_loop(ends[0], ends[1]));
    clear_tree();
  }

  // The shortest paths from the root, as far as a loop through the root that is shorter than the best one can reach.
  void grow_tree(Id root) {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    reach(root, 0, Refined_surface::none);
    queue.push({0, root});
    while (!queue.empty() && 2 * queue.top().first < m_loop_length) {
      const Id v = queue.top().second;
      queue.pop();
      if (m_is_settled[v]) continue;
      settle(v);
      m_surface.for_each_neighbor(v, [&](Id w) {
        const double d = m_distance[v] + m_length(v, w);
        if (m_surface.is_on_cut(w) || m_is_settled[w] || !(d < m_distance[w])) return;
        reach(w, d, v);
        queue.push({d, w});
      });
    }
  }

  void reach(Id v, double distance, Id before) {
    if (m_distance[v] == unreached) m_reached.push_back(v);
    m_distance[v] = distance;
    m_before[v] = before;
  }

  void settle(Id v) {
    m_is_settled[v] = 1;
    m_settled.push_back(v);
    int* const sum = class_of(v);
    const Id u = m_before[v];
    std::fill(sum, sum + m_classes.rank(), 0);
    if (u == Refined_surface::none) return;
    std::copy(class_of(u), class_of(u) + m_classes.rank(), sum);
    m_classes.add(u, v, 1, sum);
  }

  void clear_tree() {
    for (Id v : m_reached) {
      m_distance[v] = unreached;
      m_is_settled[v] = 0;
    }
    m_reached.clear();
    m_settled.clear();
  }

  int* class_of(Id v) { return m_class.data() + std::size_t(v) * m_classes.rank(); }

  const Homology_class& class_closed_by(Id v, Id w) {
    m_closed.assign(class_of(v), class_of(v) + m_classes.rank());
    m_classes.add(v, w, 1, m_closed.data());
    for (int k = 0; k < m_classes.rank(); ++k) m_closed[k] -= class_of(w)[k];
    return m_closed;
  }

  // The paths to both ends and the edge between them, without the part that the paths share.
  Path close_loop(Id v, Id w) const {
    Path loop = path_to(v, m_before);
    const Path back = path_to(w, m_before);
    std::size_t shared = 0;
    for (std::size_t k = 0; k < std::min(loop.size(), back.size()) && loop[k] == back[k]; ++k) shared = k;
    loop.erase(loop.begin(), loop.begin() + shared);
    loop.insert(loop.end(), back.rbegin(), back.rend() - shared);
    return loop;
  }

  void take_shorter(const Path& loop) {
    double l = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) l += m_length(loop[i - 1], loop[i]);
    if (!(l < m_loop_length)) return;
    m_loop_length = l;
    m_loop = loop;
  }

  const Refined_surface& m_surface;
  const Edge_classes& m_classes;
  const Free_quotient& m_quotient;
  const Length& m_length;
  Path m_loop;
  double m_loop_length = unreached;
  std::vector<double> m_distance;
  Path m_before, m_reached, m_settled;
  std::vector<char> m_is_settled;
  std::vector<int> m_class; // of the paths to the vertices
  Homology_class m_closed;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRIMITIVE_LOOPS_H
