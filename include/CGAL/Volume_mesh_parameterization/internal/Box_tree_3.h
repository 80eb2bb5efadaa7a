// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOX_TREE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOX_TREE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Bbox_3.h>

// Boost.Geometry 1.74 includes a deprecated header of Boost itself, and would be told so aloud.
#ifndef BOOST_ALLOW_DEPRECATED_HEADERS
#define BOOST_ALLOW_DEPRECATED_HEADERS
#define CGAL_VOLUME_MESH_PARAMETERIZATION_RESTORE_DEPRECATED_HEADERS
#endif
#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_RESTORE_DEPRECATED_HEADERS
#undef BOOST_ALLOW_DEPRECATED_HEADERS
#undef CGAL_VOLUME_MESH_PARAMETERIZATION_RESTORE_DEPRECATED_HEADERS
#endif

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Finds the elements whose boxes meet a box, by an R-tree of Boost.
class Box_tree_3 {
public:
  explicit Box_tree_3(const std::vector<Bbox_3>& boxes) : m_size(boxes.size()), m_tree(entries(boxes)) {}

  // The least element with is_wanted(element) among those whose boxes meet the query; the number of elements if there
  // is none.
  template <typename Predicate>
  std::size_t find(const Bbox_3& query, const Predicate& is_wanted) const {
    std::size_t least = m_size;
    const auto overlap = boost::geometry::index::intersects(box(query));
    for (auto e = m_tree.qbegin(overlap); e != m_tree.qend(); ++e)
      if (e->second < least && is_wanted(e->second)) least = e->second;
    return least;
  }

private:
  using Point = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Box = boost::geometry::model::box<Point>;
  using Entry = std::pair<Box, std::size_t>;

  static Box box(const Bbox_3& b) { return {Point(b.xmin(), b.ymin(), b.zmin()), Point(b.xmax(), b.ymax(), b.zmax())}; }

  // Packed at once: better and faster than by insertion.
  static std::vector<Entry> entries(const std::vector<Bbox_3>& boxes) {
    std::vector<Entry> result;
    result.reserve(boxes.size());
    for (const Bbox_3& b : boxes) result.emplace_back(box(b), result.size());
    return result;
  }

  std::size_t m_size;
  boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>> m_tree;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOX_TREE_3_H
