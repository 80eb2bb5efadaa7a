// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOXES_OF_HEXAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOXES_OF_HEXAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Box_grid_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Takes hexahedra that are boxes apart where planes of others cut them.
template <typename Point>
class Boxes_of_hexahedra {
public:
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  using Grid = Box_grid_3<FT>;

  Boxes_of_hexahedra(const Hexahedron_soup_3<Point>& soup, Grid& grid) : m_soup(soup), m_grid(grid) {}

  Status run() {
    Status status = check_coordinates(m_soup.points.size(),
                                      [&](std::size_t v) -> const Point& { return m_soup.points[v]; });
    if (status.ok()) status = find_corners();
    if (status.ok()) status = fill();
    return status.ok() ? label_squares() : status;
  }

private:
  using Extent = std::array<Point, 2>; // lowest and highest corner

  template <std::size_t N>
  bool find_extent(const std::array<std::size_t, N>& vertices, Extent& extent) const {
    for (std::size_t v : vertices)
      if (v >= m_soup.points.size()) return false;
    std::array<FT, 3> low, high;
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = high[axis] = m_soup.points[vertices[0]][axis];
      for (std::size_t v : vertices) {
        low[axis] = (std::min)(low[axis], FT(m_soup.points[v][axis]));
        high[axis] = (std::max)(high[axis], FT(m_soup.points[v][axis]));
      }
    }
    extent = {Point(low[0], low[1], low[2]), Point(high[0], high[1], high[2])};
    return true;
  }

  // Whether each vertex is another one of the eight corners.
  bool is_box(const std::array<std::size_t, 8>& vertices, const Extent& extent) const {
    unsigned corners = 0;
    for (std::size_t v : vertices) {
      unsigned corner = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const FT x = m_soup.points[v][axis];
        if (x == extent[1][axis]) corner |= 1u << axis;
        if (x != extent[0][axis] && x != extent[1][axis]) return false;
      }
      corners |= 1u << corner;
    }
    return corners == 0xff;
  }

  Status find_corners() {
    if (m_soup.hexahedra.empty()) return {ERROR_EMPTY_MESH, "there are no boxes"};
    for (std::size_t h = 0; h < m_soup.hexahedra.size(); ++h) {
      Extent extent;
      if (!find_extent(m_soup.hexahedra[h], extent))
        return {ERROR_INDEX_OUT_OF_RANGE, "hexahedron " + std::to_string(h)};
      if (!is_box(m_soup.hexahedra[h], extent))
        return {ERROR_NOT_A_POLYCUBE, "hexahedron " + std::to_string(h) + " is no box along the axes"};
      m_extents.push_back(extent);
      for (int axis = 0; axis < 3; ++axis)
        for (const Point& p : extent) m_grid.planes[axis].push_back(p[axis]);
    }
    m_grid.sort_planes();
    return {};
  }

  Grid_site site(const Point& corner) const {
    return {m_grid.plane_from(0, corner.x()), m_grid.plane_from(1, corner.y()),
            m_grid.plane_from(2, corner.z())};
  }

  Status fill() {
    std::vector<std::pair<Grid_site, std::size_t>> parts; // with their hexahedra
    double number = 0;
    for (const Extent& e : m_extents) {
      const Grid_site begin = site(e[0]), end = site(e[1]);
      number += double(end[0] - begin[0]) * (end[1] - begin[1]) * (end[2] - begin[2]);
    }
    if (number > double(Grid::most_boxes))
      return {ERROR_WRONG_PARAMETER, "the planes of the polycube cut it into more than " +
                                         std::to_string(Grid::most_boxes) + " boxes"};
    for (std::size_t h = 0; h < m_extents.size(); ++h)
      for_each_site(site(m_extents[h][0]), site(m_extents[h][1]),
                    [&](const Grid_site& s) { parts.emplace_back(s, h); });
    std::sort(parts.begin(), parts.end());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (k > 0 && parts[k].first == parts[k - 1].first)
        return {ERROR_NOT_A_POLYCUBE, "hexahedra " + std::to_string(parts[k - 1].second) + " and " +
                                          std::to_string(parts[k].second) + " overlap"};
      m_grid.boxes.push_back(parts[k].first);
    }
    return {};
  }

  Status label_squares() {
    for (std::size_t q = 0; q < m_soup.facets.size(); ++q)
      if (m_soup.facets[q].label != INTERIOR && !label_squares_of(m_soup.facets[q]))
        return {ERROR_LABEL_NOT_ON_BOUNDARY, "quadrilateral " + std::to_string(q)};
    return {};
  }

  bool label_squares_of(const Labelled_quadrilateral& quadrilateral) {
    Extent extent;
    if (!find_extent(quadrilateral.vertices, extent)) return false;
    const Grid_site begin = site(extent[0]);
    Grid_site end = site(extent[1]);
    const auto flat = std::mismatch(begin.begin(), begin.end(), end.begin(), std::not_equal_to<>());
    if (flat.first == begin.end()) return false;
    const int axis = int(flat.first - begin.begin());
    ++end[axis];
    bool is_on_boundary = true;
    for_each_site(begin, end, [&](const Grid_site& s) {
      is_on_boundary &= m_grid.is_on_boundary(axis, s);
      m_grid.squares.push_back({axis, s, quadrilateral.label});
    });
    return is_on_boundary;
  }

  const Hexahedron_soup_3<Point>& m_soup;
  Grid& m_grid;
  std::vector<Extent> m_extents;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOXES_OF_HEXAHEDRA_H
