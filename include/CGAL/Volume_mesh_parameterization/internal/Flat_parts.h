// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLAT_PARTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLAT_PARTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Triangle_adjacency.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Groups the triangles of a closed oriented surface that share edges, lie in one plane as well as rounded points do, and have
// the same label. Each part grows from its greatest triangle, whose plane is the least uncertain.
template <typename Point>
class Flat_parts {
public:
  // surface: one that check_surface() accepted
  explicit Flat_parts(const Triangle_soup_3<Point>& surface)
      : m_surface(surface),
        m_adjacency(surface.triangles),
        m_parts(surface.triangles.size(), none),
        m_tolerance(relative_tolerance * diagonal()) {
    const Status status = m_adjacency.assign_neighbors();
    CGAL_precondition(status.ok());
    static_cast<void>(status);
    int number = 0;
    for (std::uint32_t seed : greatest_first())
      if (m_parts[seed] == none) grow(seed, number++);
  }

  // The number of the part of each triangle.
  const std::vector<int>& parts() const { return m_parts; }

private:
  using Vector = Double_kernel::Vector_3;

  static constexpr int none = -1;
  static constexpr double relative_tolerance = 1e-7; // of single precision

  Double_kernel::Point_3 corner(std::size_t t, int i) const {
    return approximate(m_surface.points[m_surface.triangles[t][i]]);
  }

  Vector normal(std::size_t t) const {
    return CGAL::cross_product(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0));
  }

  double diagonal() const {
    Bbox_3 box;
    for (const Point& p : m_surface.points) box += approximate(p).bbox();
    return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  }

  std::vector<std::uint32_t> greatest_first() const {
    std::vector<double> squared_areas;
    for (std::size_t t = 0; t < m_parts.size(); ++t) squared_areas.push_back(normal(t).squared_length());
    std::vector<std::uint32_t> triangles(m_parts.size());
    std::iota(triangles.begin(), triangles.end(), 0);
    std::stable_sort(triangles.begin(), triangles.end(),
                     [&](auto t, auto u) { return squared_areas[t] > squared_areas[u]; });
    return triangles;
  }

  bool is_in_plane(std::size_t t, const Double_kernel::Point_3& point, const Vector& unit_normal) const {
    for (int i = 0; i < 3; ++i)
      if (std::abs((corner(t, i) - point) * unit_normal) > m_tolerance) return false;
    return normal(t) * unit_normal > 0;
  }

  void grow(std::uint32_t seed, int number) {
    const Vector n = normal(seed);
    const Vector unit_normal = n / std::sqrt(n.squared_length());
    m_parts[seed] = number;
    std::vector<std::uint32_t> part(1, seed);
    for (std::size_t k = 0; k < part.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t t = m_adjacency.neighbor(part[k], i);
        if (m_parts[t] != none || !is_in_plane(t, corner(seed, 0), unit_normal)) continue;
        if (!m_surface.labels.empty() && m_surface.labels[t] != m_surface.labels[seed]) continue;
        m_parts[t] = number;
        part.push_back(t);
      }
  }

  const Triangle_soup_3<Point>& m_surface;
  Triangle_adjacency m_adjacency;
  std::vector<int> m_parts;
  double m_tolerance; // distance from a plane
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLAT_PARTS_H
