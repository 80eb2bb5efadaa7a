// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_ALONG_LEVEL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_ALONG_LEVEL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Splits every edge at whose ends `values` lie on different sides of `level`, and triangles accordingly; the new
// vertices get this level as their value. Afterwards no triangle has values on both sides. A vertex at the level counts
// as above.
template <typename Point>
class Level_cutter {
public:
  Level_cutter(Triangle_soup_3<Point>& soup, Vertex_field& values, double level)
      : m_soup(soup), m_values(values), m_level(level) {}

  void cut() {
    const Facet_adjacency adjacency = approximate_surface(m_soup).adjacency;
    std::vector<std::array<std::size_t, 3>> inserted(m_soup.triangles.size(), {none, none, none});
    for (Facet_index f : adjacency.facets())
      for (int i = 0; i < 3; ++i)
        if (f < adjacency.neighbor(f, i) && crosses(adjacency.source({f, i}), adjacency.target({f, i}))) {
          const auto o = adjacency.opposite({f, i});
          inserted[f][i] = inserted[o.facet][o.index] =
              insert(adjacency.source({f, i}), adjacency.target({f, i}));
        }
    const Eigen::Index n = m_values.size();
    m_values.conservativeResize(Eigen::Index(m_soup.points.size()));
    m_values.tail(m_values.size() - n).setConstant(m_level);
    for (std::size_t t = 0, end = inserted.size(); t < end; ++t) split(t, inserted[t]);
  }

private:
  static constexpr std::size_t none = std::size_t(-1);
  // Splits closer to an end would make needles.
  static constexpr double least_part = .2;

  bool is_below(std::size_t v) const { return m_values[Eigen::Index(v)] < m_level; }
  bool crosses(std::size_t v, std::size_t w) const { return is_below(v) != is_below(w); }

  std::size_t insert(std::size_t v, std::size_t w) {
    if (w < v) std::swap(v, w);
    const double at_v = m_values[Eigen::Index(v)], at_w = m_values[Eigen::Index(w)];
    const double part = std::max(least_part, std::min(1 - least_part, (m_level - at_v) / (at_w - at_v)));
    const Point p = m_soup.points[v];
    m_soup.points.push_back(p + typename Kernel_traits<Point>::Kernel::FT(part) * (m_soup.points[w] - p));
    return m_soup.points.size() - 1;
  }

  // A crossed triangle has one vertex alone on its side; the quadrilateral on the other side gets its shorter diagonal.
  void split(std::size_t t, const std::array<std::size_t, 3>& inserted) {
    const int whole = int(std::find(inserted.begin(), inserted.end(), none) - inserted.begin());
    if (inserted[(whole + 1) % 3] == none) return;
    const auto& corners = m_soup.triangles[t];
    const std::size_t a = corners[whole], b = corners[(whole + 1) % 3], c = corners[(whole + 2) % 3];
    const std::size_t on_ab = inserted[(whole + 2) % 3], on_ac = inserted[(whole + 1) % 3];
    m_soup.triangles[t] = {a, on_ab, on_ac};
    if (squared_length(b, on_ac) < squared_length(c, on_ab)) {
      add({on_ab, b, on_ac}, t);
      add({b, c, on_ac}, t);
    } else {
      add({on_ab, b, c}, t);
      add({on_ab, c, on_ac}, t);
    }
  }

  double squared_length(std::size_t v, std::size_t w) const {
    return (approximate(m_soup.points[v]) - approximate(m_soup.points[w])).squared_length();
  }

  void add(const std::array<std::size_t, 3>& triangle, std::size_t parent) {
    m_soup.triangles.push_back(triangle);
    if (!m_soup.labels.empty()) m_soup.labels.push_back(m_soup.labels[parent]);
  }

  Triangle_soup_3<Point>& m_soup;
  Vertex_field& m_values;
  double m_level;
};

template <typename Point>
Status cut_along_level(Triangle_soup_3<Point>& soup, Vertex_field& values, double level) {
  Level_cutter<Point>(soup, values, level).cut();
  return {};
}

// In a tetrahedral mesh the crossed edges of the boundary are split at their midpoints.
template <typename GeomTraits>
Status cut_along_level(Compact_tetrahedral_mesh_3<GeomTraits>& mesh, Vertex_field& values, double level) {
  Splittable_mesh<GeomTraits> splittable(mesh);
  Status status;
  for (Facet_index f : mesh.boundary_facets()) {
    const auto v = mesh.vertices(f);
    for (int i = 0; i < 3 && status.ok(); ++i) {
      const Vertex_index below = v[i], above = v[(i + 1) % 3]; // the neighbor sees it the other way round
      if (values[below] < level && values[above] >= level)
        status = splittable.insert_barycentre({below, above});
    }
  }
  if (status.ok()) status = std::move(splittable).write_to(mesh);
  const Eigen::Index n = values.size();
  values.conservativeResize(Eigen::Index(mesh.number_of_vertices()));
  values.tail(values.size() - n).setConstant(level);
  return status;
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_ALONG_LEVEL_H
