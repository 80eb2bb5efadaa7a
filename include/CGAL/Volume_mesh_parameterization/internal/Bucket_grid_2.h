// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BUCKET_GRID_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BUCKET_GRID_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Finds the triangles near a point of the plane: a grid with about one bucket for each triangle.
class Bucket_grid_2 {
public:
  using Id = std::uint32_t;

  Bucket_grid_2() = default;

  // The box must contain all triangles.
  template <typename Point_2>
  Bucket_grid_2(double xmin, double ymin, double xmax, double ymax,
                const std::vector<std::array<Id, 3>>& triangles, const std::vector<Point_2>& points)
      : m_xmin(xmin), m_ymin(ymin) {
    m_edge = std::sqrt((xmax - xmin) * (ymax - ymin) / double(triangles.size()));
    m_columns = Id((xmax - xmin) / m_edge) + 1;
    m_rows = Id((ymax - ymin) / m_edge) + 1;
    const auto buckets_of = [&](Id t) {
      const Point_2 &a = points[triangles[t][0]], &b = points[triangles[t][1]], &c = points[triangles[t][2]];
      const Range x = hull(a.x(), b.x(), c.x()), y = hull(a.y(), b.y(), c.y());
      return buckets(x, y);
    };
    m_triangles = Incidence_lists<Id, Id>(std::size_t(m_columns) * m_rows, triangles.size(), buckets_of);
  }

  // Returns the first triangle near p for which contains(triangle), or Id(-1). A bucket is missed neither for lack of
  // digits, p being replaced by an interval around it, nor are far ones visited.
  template <typename Point_2, typename Contains>
  Id find(const Point_2& p, const Contains& contains) const {
    for (Id b : buckets(CGAL::to_interval(p.x()), CGAL::to_interval(p.y())))
      for (Id t : m_triangles[b])
        if (contains(t)) return t;
    return Id(-1);
  }

private:
  using Range = std::pair<double, double>;

  template <typename FT>
  static Range hull(const FT& a, const FT& b, const FT& c) {
    return {CGAL::to_interval((std::min)({a, b, c})).first, CGAL::to_interval((std::max)({a, b, c})).second};
  }

  std::vector<Id> buckets(const Range& x, const Range& y) const {
    std::vector<Id> result;
    for (Id j = place(y.first - m_ymin, m_rows); j <= place(y.second - m_ymin, m_rows); ++j)
      for (Id i = place(x.first - m_xmin, m_columns); i <= place(x.second - m_xmin, m_columns); ++i)
        result.push_back(j * m_columns + i);
    return result;
  }

  Id place(double offset, Id size) const {
    return Id(std::min(std::max(offset / m_edge, 0.), double(size - 1)));
  }

  double m_xmin = 0, m_ymin = 0, m_edge = 1;
  Id m_columns = 0, m_rows = 0;
  Incidence_lists<Id, Id> m_triangles; // of the buckets
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BUCKET_GRID_2_H
