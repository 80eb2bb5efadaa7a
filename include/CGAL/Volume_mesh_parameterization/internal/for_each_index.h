// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FOR_EACH_INDEX_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FOR_EACH_INDEX_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#endif

#include <boost/range/irange.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The tag to use for numbers of type FT: others than plain ones evaluate lazily, with shared memory behind them, which is
// not safe for threads in all versions of CGAL.
template <typename ConcurrencyTag, typename FT>
using Concurrency_for = std::conditional_t<std::is_floating_point<FT>::value, ConcurrencyTag, Sequential_tag>;

// The indices less than n in blocks of the same size, but for the last: what is done for each block does not depend on the
// number of threads.
class Index_blocks {
public:
  Index_blocks(std::size_t n, std::size_t size_of_block) : m_n(n), m_size_of_block(size_of_block) {}

  std::size_t size() const { return (m_n + m_size_of_block - 1) / m_size_of_block; }

  // returns the indices of block b, as a range.
  auto operator[](std::size_t b) const {
    const std::size_t first = b * m_size_of_block;
    return boost::irange(first, (std::min)(first + m_size_of_block, m_n));
  }

  std::size_t block_of(std::size_t i) const { return i / m_size_of_block; }

private:
  std::size_t m_n, m_size_of_block;
};

// Calls f(i) for all i less than n, in parallel in blocks of fixed size if the tag says so: the order of the calls may
// vary, nothing else.
template <typename ConcurrencyTag, typename Function>
void for_each_index(std::size_t n, const Function& f, std::size_t block = 64) {
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel) {
    const auto run = [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) f(i);
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, block), run, tbb::simple_partitioner());
    return;
  }
#else
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
  static_cast<void>(block);
#endif
  for (std::size_t i = 0; i < n; ++i) f(i);
}

// Calls f(i), which returns a Status, for all i of a permutation of the first numbers; returns the failure of the least i,
// whatever the number of threads. Once one has failed, greater ones may be left out.
template <typename ConcurrencyTag, typename Order, typename Function>
Status try_each_in_order(const Order& order, const Function& f, std::size_t block = 64) {
  const std::size_t n = order.size();
  std::atomic<std::size_t> failed(n);
  Status failure;
  std::mutex mutex;
  const auto attempt = [&](std::size_t k) {
    const std::size_t i = order[k];
    if (i > failed) return;
    Status status = f(i);
    if (status.ok()) return;
    const std::lock_guard<std::mutex> lock(mutex);
    if (i > failed) return;
    failed = i;
    failure = std::move(status);
  };
  for_each_index<ConcurrencyTag>(n, attempt, block);
  return failure;
}

// The same for all i less than n.
template <typename ConcurrencyTag, typename Function>
Status try_each_index(std::size_t n, const Function& f, std::size_t block = 64) {
  return try_each_in_order<ConcurrencyTag>(boost::irange(std::size_t(0), n), f, block);
}

// Calls functions without arguments, at the same time if the tag says so; returns the failure of the first in the list that
// fails. Those after it may have been called or not.
template <typename ConcurrencyTag, typename... Functions>
Status try_all(const Functions&... functions) {
  const auto call = [&](std::size_t i) {
    Status status;
    std::size_t k = 0;
    ((k++ == i ? void(status = functions()) : void()), ...);
    return status;
  };
  return try_each_index<ConcurrencyTag>(sizeof...(functions), call, 1);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FOR_EACH_INDEX_H
