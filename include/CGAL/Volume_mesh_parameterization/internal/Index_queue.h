// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INDEX_QUEUE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INDEX_QUEUE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A priority queue of the numbers less than n, each of which it holds at most once: one bit for each, and one for each
// word of the level below that is not zero. All operations take time O(log n) to the base 64.
class Index_queue {
public:
  explicit Index_queue(std::size_t n) {
    do {
      n = (n + 63) / 64;
      m_levels.emplace_back(n, 0);
    } while (n > 1);
  }

  bool empty() const { return m_levels.back().empty() || m_levels.back().front() == 0; }

  void push(std::uint32_t i) {
    for (std::vector<Word>& level : m_levels) {
      level[i / 64] |= Word(1) << i % 64;
      i /= 64;
    }
  }

  // removes the least number and returns it. requires !empty()
  std::uint32_t pop() {
    std::uint32_t least = 0;
    for (std::size_t k = m_levels.size(); k-- > 0;) least = 64 * least + lowest_bit(m_levels[k][least]);
    std::uint32_t i = least;
    for (std::vector<Word>& level : m_levels) {
      level[i / 64] &= level[i / 64] - 1;
      if (level[i / 64] != 0) break;
      i /= 64;
    }
    return least;
  }

private:
  using Word = std::uint64_t;

  static std::uint32_t lowest_bit(Word w) { return std::uint32_t(std::bitset<64>((w & -w) - 1).count()); }

  std::vector<std::vector<Word>> m_levels; // the finest first
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INDEX_QUEUE_H
