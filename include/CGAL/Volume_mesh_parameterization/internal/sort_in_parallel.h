// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SORT_IN_PARALLEL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SORT_IN_PARALLEL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <type_traits>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Sorts, in parallel if the tag says so. Of two different elements one has to come before the other: else the result would depend
// on the number of threads.
template <typename ConcurrencyTag, typename Iterator, typename Before>
void sort_in_parallel(Iterator first, Iterator last, const Before& before) {
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel) {
    tbb::parallel_sort(first, last, before);
    return;
  }
#else
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  std::sort(first, last, before);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SORT_IN_PARALLEL_H
