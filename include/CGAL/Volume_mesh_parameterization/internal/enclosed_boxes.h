// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENCLOSED_BOXES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENCLOSED_BOXES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Box_grid_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Finds the boxes, between the planes of polygons orthogonal to the axes, that the polygons separate from infinity. So it does
not matter how the surface is cut into polygons, and whether there are others inside, as between unit cubes.

The polygons of a plane end at other planes: a square of the grid is covered as a whole if its centre is.
*/
template <typename Point>
class Enclosed_boxes {
public:
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using FT = typename Kernel::FT;
  using Grid = Box_grid_3<FT>;

  Enclosed_boxes(const Polygon_soup_3<Point>& soup, Grid& grid) : m_soup(soup), m_grid(grid) {}

  Status run() {
    Status status = check_coordinates(m_soup.points.size(),
                                      [&](std::size_t v) -> const Point& { return m_soup.points[v]; });
    if (status.ok()) status = find_planes();
    if (!status.ok()) return status;
    find_squares();
    fill();
    return label_squares();
  }

private:
  using Polygon_2 = std::vector<typename Kernel::Point_2>;

  std::string name(std::size_t polygon) const { return "facet " + std::to_string(polygon); }

  Polygon_2 projected(std::size_t polygon, int axis) const {
    Polygon_2 result;
    for (std::size_t v : m_soup.polygons[polygon])
      result.emplace_back(m_soup.points[v][(axis + 1) % 3], m_soup.points[v][(axis + 2) % 3]);
    return result;
  }

  bool is_orthogonal(std::size_t polygon, int axis) const {
    const auto& vertices = m_soup.polygons[polygon];
    for (std::size_t v : vertices)
      if (m_soup.points[v][axis] != m_soup.points[vertices[0]][axis]) return false;
    const Polygon_2 p = projected(polygon, axis);
    for (std::size_t i = 2; i < p.size(); ++i)
      if (typename Kernel::Orientation_2()(p[i - 2], p[i - 1], p[i]) != COLLINEAR) return true;
    return false;
  }

  Status find_planes() {
    if (m_soup.polygons.empty()) return {ERROR_EMPTY_MESH, "there are no facets"};
    for (std::size_t f = 0; f < m_soup.polygons.size(); ++f) {
      for (std::size_t v : m_soup.polygons[f])
        if (v >= m_soup.points.size()) return {ERROR_INDEX_OUT_OF_RANGE, name(f)};
      int axis = 0;
      while (axis < 3 && !is_orthogonal(f, axis)) ++axis;
      if (axis == 3) return {ERROR_NOT_A_POLYCUBE, name(f) + " is flat, or orthogonal to no axis"};
      m_axes.push_back(axis);
      m_grid.planes[axis].push_back(m_soup.points[m_soup.polygons[f][0]][axis]);
    }
    m_grid.sort_planes();
    double number = 1;
    for (int axis = 0; axis < 3; ++axis) number *= double(m_grid.planes[axis].size() + 1);
    return number <= double(Grid::most_boxes)
               ? Status()
               : Status(ERROR_WRONG_PARAMETER, "the planes of the polycube cut space into more than " +
                                                   std::to_string(Grid::most_boxes) + " boxes");
  }

  FT center(int axis, std::int32_t interval) const {
    return (m_grid.planes[axis][interval] + m_grid.planes[axis][interval + 1]) / FT(2);
  }

  // The intervals whose centres are in the range of the polygon.
  std::array<std::int32_t, 2> intervals(const Polygon_2& polygon, int coordinate, int axis) const {
    const auto less = [&](const auto& p, const auto& q) { return p[coordinate] < q[coordinate]; };
    const auto ends = std::minmax_element(polygon.begin(), polygon.end(), less);
    const FT low = (*ends.first)[coordinate], high = (*ends.second)[coordinate];
    const std::int32_t last = std::int32_t(m_grid.planes[axis].size()) - 1;
    std::int32_t begin = (std::max)(m_grid.plane_from(axis, low) - 1, 0);
    std::int32_t end = (std::min)(m_grid.plane_from(axis, high), last);
    while (begin < end && center(axis, begin) < low) ++begin;
    while (begin < end && center(axis, end - 1) > high) --end;
    return {begin, end};
  }

  static bool contains(const Polygon_2& polygon, const typename Kernel::Point_2& p) {
    return CGAL::bounded_side_2(polygon.begin(), polygon.end(), p, Kernel()) != ON_UNBOUNDED_SIDE;
  }

  static typename Kernel::Point_2 mean(const Polygon_2& polygon) {
    FT x(0), y(0);
    for (const auto& p : polygon) x += p.x(), y += p.y();
    return {x / FT(double(polygon.size())), y / FT(double(polygon.size()))};
  }

  // The squares that a polygon covers; the one that it lies in, if it is small and convex.
  void find_squares() {
    for (std::size_t f = 0; f < m_soup.polygons.size(); ++f) {
      const int axis = m_axes[f], a = (axis + 1) % 3, b = (axis + 2) % 3;
      const Polygon_2 polygon = projected(f, axis);
      Grid_site s;
      s[axis] = m_grid.plane_from(axis, m_soup.points[m_soup.polygons[f][0]][axis]);
      const auto as = intervals(polygon, 0, a), bs = intervals(polygon, 1, b);
      for (s[a] = as[0]; s[a] < as[1]; ++s[a])
        for (s[b] = bs[0]; s[b] < bs[1]; ++s[b])
          if (contains(polygon, {center(a, s[a]), center(b, s[b])}))
            m_squares.push_back({{axis, s, INTERIOR}, f});
      if (!m_squares.empty() && m_squares.back().polygon == f) continue;
      const typename Kernel::Point_2 inside = mean(polygon);
      s[a] = m_grid.plane_from(a, inside.x()) - 1, s[b] = m_grid.plane_from(b, inside.y()) - 1;
      if (contains(polygon, inside)) m_squares.push_back({{axis, s, INTERIOR}, f});
    }
  }

  // With a layer of boxes around all, which are outside.
  std::size_t dense(const Grid_site& s) const {
    const auto& p = m_grid.planes;
    return (std::size_t(s[0] + 1) * (p[1].size() + 1) + std::size_t(s[1] + 1)) * (p[2].size() + 1) +
           std::size_t(s[2] + 1);
  }

  void fill() {
    const auto& p = m_grid.planes;
    const Grid_site last = {std::int32_t(p[0].size()) - 1, std::int32_t(p[1].size()) - 1,
                            std::int32_t(p[2].size()) - 1};
    std::vector<std::array<char, 3>> is_covered(dense(last) + 1, {0, 0, 0}); // the squares below a box
    for (const Covered_square& q : m_squares) is_covered[dense(q.square.site)][q.square.axis] = 1;
    std::vector<char> is_outside(is_covered.size(), 0);
    std::vector<Grid_site> stack(1, Grid_site{-1, -1, -1});
    is_outside[0] = 1;
    const auto visit = [&](const Grid_site& s, bool is_separated) {
      if (is_separated || is_outside[dense(s)]) return;
      is_outside[dense(s)] = 1;
      stack.push_back(s);
    };
    while (!stack.empty()) {
      const Grid_site s = stack.back();
      stack.pop_back();
      for (int axis = 0; axis < 3; ++axis) {
        const Grid_site above = stepped(s, axis), below = stepped(s, axis, -1);
        if (s[axis] < last[axis]) visit(above, is_covered[dense(above)][axis] != 0);
        if (s[axis] >= 0) visit(below, is_covered[dense(s)][axis] != 0);
      }
    }
    for_each_site({0, 0, 0}, last, [&](const Grid_site& s) {
      if (!is_outside[dense(s)]) m_grid.boxes.push_back(s);
    });
  }

  // A facet with the outside on both sides belongs to a surface with a gap.
  Status label_squares() {
    for (Covered_square& q : m_squares) {
      const bool is_inside = m_grid.has(q.square.site),
                 is_on_boundary = m_grid.is_on_boundary(q.square.axis, q.square.site);
      if (!is_inside && !is_on_boundary) return {ERROR_OPEN_SURFACE, name(q.polygon) + " encloses nothing"};
      const int label = m_soup.labels.empty() ? int(INTERIOR) : m_soup.labels[q.polygon];
      if (label == INTERIOR) continue;
      if (!is_on_boundary) return {ERROR_LABEL_NOT_ON_BOUNDARY, name(q.polygon)};
      m_grid.squares.push_back({q.square.axis, q.square.site, label});
    }
    return {};
  }

  struct Covered_square {
    typename Grid::Square square;
    std::size_t polygon;
  };

  const Polygon_soup_3<Point>& m_soup;
  Grid& m_grid;
  std::vector<int> m_axes; // of the polygons
  std::vector<Covered_square> m_squares;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_ENCLOSED_BOXES_H
