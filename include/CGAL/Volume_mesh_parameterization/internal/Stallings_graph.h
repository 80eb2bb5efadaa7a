// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STALLINGS_GRAPH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STALLINGS_GRAPH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A connected graph whose edges carry letters of a free group: k for generator k = 1..rank, -k for its inverse. Edges
// with the same letter at the same node are folded at once, so that the loops at a node spell a subgroup without
// redundancy: J. R. Stallings, Topology of finite graphs, Invent. Math. 71 (1983).
class Stallings_graph {
public:
  using Node = std::size_t;
  static constexpr Node none = Node(-1);

  explicit Stallings_graph(int rank) : m_rank(rank) {}

  Node add_node() {
    m_parent.push_back(m_parent.size());
    m_targets.resize(m_targets.size() + 2 * m_rank, none);
    return m_parent.back();
  }

  // Adds a path from a to b that spells the word.
  template <typename Word>
  void add_path(Node a, const Word& word, Node b) {
    if (word.empty()) merge(a, b);
    std::size_t left = word.size();
    for (int letter : word) {
      const Node next = --left == 0 ? b : add_node();
      m_pending.push_back({a, letter, next});
      a = next;
    }
    fold();
  }

  // Whether the loops spell all of the group. As the graph is connected, any node will do.
  bool is_whole_group() const {
    if (m_rank == 0) return true;
    if (m_parent.empty()) return false;
    const Node base = find(0);
    for (int letter = 1; letter <= m_rank; ++letter) {
      const Node target = m_targets[slot(base, letter)];
      if (target == none || find(target) != base) return false;
    }
    return true;
  }

private:
  struct Edge {
    Node source;
    int letter;
    Node target;
  };

  std::size_t slot(Node a, int letter) const {
    return 2 * m_rank * a + 2 * (std::abs(letter) - 1) + (letter < 0 ? 1 : 0);
  }

  Node find(Node a) const {
    while (m_parent[a] != a) a = m_parent[a] = m_parent[m_parent[a]];
    return a;
  }

  void fold() {
    while (!m_pending.empty()) {
      const Edge e = m_pending.back();
      m_pending.pop_back();
      direct(e.source, e.letter, e.target);
      direct(e.target, -e.letter, e.source);
    }
  }

  void direct(Node a, int letter, Node b) {
    Node& target = m_targets[slot(find(a), letter)];
    if (target == none)
      target = find(b);
    else
      merge(target, b);
  }

  void merge(Node a, Node b) {
    a = find(a), b = find(b);
    if (a == b) return;
    m_parent[b] = a;
    for (int k = 1; k <= m_rank; ++k)
      for (int letter : {k, -k}) {
        Node& target = m_targets[slot(b, letter)];
        if (target != none) m_pending.push_back({a, letter, target});
        target = none;
      }
  }

  int m_rank;
  mutable std::vector<Node> m_parent; // of a disjoint-set forest
  std::vector<Node> m_targets;        // 2 * rank for each node
  std::vector<Edge> m_pending;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STALLINGS_GRAPH_H
