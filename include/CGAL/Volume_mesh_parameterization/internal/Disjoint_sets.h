// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISJOINT_SETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISJOINT_SETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A partition of 0, ..., n - 1, at first into singletons. The smallest member of a set represents it.
class Disjoint_sets {
public:
  explicit Disjoint_sets(std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), 0); }

  std::uint32_t representative(std::uint32_t i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  bool is_representative(std::uint32_t i) const { return m_parent[i] == i; }

  void join(std::uint32_t i, std::uint32_t j) {
    i = representative(i), j = representative(j);
    if (j < i) std::swap(i, j);
    m_parent[j] = i;
  }

  std::size_t number_of_sets() const {
    std::size_t n = 0;
    for (std::uint32_t i = 0; i < m_parent.size(); ++i) n += is_representative(i);
    return n;
  }

private:
  std::vector<std::uint32_t> m_parent;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_DISJOINT_SETS_H
