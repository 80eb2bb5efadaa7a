// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_CUTTER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_CUTTER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/shortest_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Cuts the floor into four trapezoids for each hole, chooses the rectangles, and fixes the images of the cuts.

A chain of paths from the left end of the outer rim through all holes to its right end, the spine, halves the floor
into two disks: in these, every further path has only one way to go, whatever the shape of the floor. It is given up in
the end. Between two holes a separator runs from the bottom through a vertex of the spine to the top; around each hole
four paths join its corners to those of its cell.
*/
class Floor_cutter {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;
  using Point_2 = Double_kernel::Point_2;

  // rims[0] is the outer one, then the holes from left to right, all with corners
  Floor_cutter(const std::vector<Floor_rim>& rims, Refined_surface& surface)
      : m_rims(rims), m_number_of_holes(rims.size() - 1), m_surface(surface) {}

  Status cut() {
    Status status = cut_spine();
    if (status.ok()) status = choose_rectangles();
    if (status.ok()) status = cut_separators();
    if (status.ok()) status = cut_corners();
    for (const Path& path : m_spine) m_surface.uncut(path);
    return status;
  }

  const std::vector<Rectangle_2>& rectangles() const { return m_rectangles; }

  // Replaces the rectangles of the rims; the holes remain in a row.
  void set_rectangles(const std::vector<Rectangle_2>& rectangles) { m_rectangles = rectangles; }

  // Places the vertices on the cuts: uniformly by length on each straight segment.
  void place(std::vector<Point_2>& positions, std::vector<char>& is_fixed) const {
    positions.assign(m_surface.number_of_vertices(), Point_2(0, 0));
    is_fixed.assign(m_surface.number_of_vertices(), 0);
    const auto place_path = [&](const Path& path, const Point_2& from, const Point_2& to) {
      const double total = m_surface.length(path);
      double arc = 0;
      for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) arc += m_surface.length(path[i - 1], path[i]);
        positions[path[i]] = i + 1 == path.size() ? to : from + (arc / total) * (to - from);
        is_fixed[path[i]] = 1;
      }
    };
    for (std::size_t r = 0; r < m_rims.size(); ++r)
      for (int k = 0; k < 4; ++k) place_side(r, k, place_path);
    for (const Path& path : m_separators) place_path(path, positions[path.front()], positions[path.back()]);
    for (const Path& path : m_corner_paths) place_path(path, positions[path.front()], positions[path.back()]);
  }

private:
  const Floor_rim& outer() const { return m_rims[0]; }
  const Floor_rim& hole(std::size_t k) const { return m_rims[k + 1]; }

  Status add_path(const Path& sources, const Path& targets, std::vector<Path>& paths) {
    paths.push_back(shortest_path(m_surface, sources, targets));
    if (paths.back().empty()) return {ERROR_FLOOR_MAP, "no path joins two of its rims"};
    m_surface.cut(paths.back());
    m_surface.split_chords();
    return {};
  }

  Status cut_spine() {
    Status status;
    for (std::size_t k = 0; m_number_of_holes > 0 && k <= m_number_of_holes && status.ok(); ++k) {
      const Id from = k == 0 ? outer().left() : hole(k - 1).right();
      status = add_path({from}, {k == m_number_of_holes ? outer().right() : hole(k).left()}, m_spine);
    }
    return status;
  }

  // The mean length of two opposite sides.
  double mean_side(const Floor_rim& rim, int k) const {
    return (m_surface.length(rim.side(k)) + m_surface.length(rim.side(k + 2))) / 2;
  }

  // Widths and heights of the rectangles are the lengths of the sides, distances between them those measured on the
  // floor, all scaled so that they add up and that the area is that of the floor.
  Status choose_rectangles() {
    double row = 0, column_sum = 0;
    std::vector<Rectangle_2> holes;
    for (std::size_t k = 0; k < m_number_of_holes; ++k) {
      const Path below = shortest_path(m_surface, hole(k).side(0), outer().side(0));
      const Path above = shortest_path(m_surface, hole(k).side(2), outer().side(2));
      if (below.empty() || above.empty())
        return {ERROR_FLOOR_MAP, "hole " + std::to_string(k) + " is walled in"};
      const double left = row + m_surface.length(m_spine[k]), bottom = m_surface.length(below);
      const double top = bottom + mean_side(hole(k), 1), column = top + m_surface.length(above);
      row = left + mean_side(hole(k), 0);
      column_sum += column;
      holes.push_back({left, bottom / column, row, top / column});
    }
    double width = mean_side(outer(), 0), height = mean_side(outer(), 1);
    if (m_number_of_holes > 0) {
      row += m_surface.length(m_spine.back());
      width = (width + row) / 2;
      height = (height + column_sum / double(m_number_of_holes)) / 2;
    }
    scale_rectangles(holes, row, width, height);
    return {};
  }

  // Holes come with x relative to the length of the row, y relative to 1.
  void scale_rectangles(const std::vector<Rectangle_2>& holes, double row, double width, double height) {
    double share = 1;
    for (const Rectangle_2& r : holes) share -= r.area() / row;
    const double scale = std::sqrt(floor_area() / (share * width * height));
    const double sx = scale * width, sy = scale * height;
    m_rectangles.assign(1, {0, 0, sx, sy});
    for (const Rectangle_2& r : holes)
      m_rectangles.push_back({r.xmin / row * sx, r.ymin * sy, r.xmax / row * sx, r.ymax * sy});
  }

  double floor_area() const {
    const auto& p = m_surface.points();
    double area = 0;
    for (const auto& t : m_surface.triangles())
      area += std::sqrt(CGAL::squared_area(p[t[0]], p[t[1]], p[t[2]]));
    return area;
  }

  double separator_x(std::size_t k) const {
    return (m_rectangles[k + 1].xmax + m_rectangles[k + 2].xmin) / 2;
  }

  // Inner vertices of a side at about the given shares of its length, in strictly increasing order.
  Path pick(const Path& side, const std::vector<double>& shares) const {
    const double total = m_surface.length(side);
    Path picked;
    std::size_t i = 1;
    double arc = m_surface.length(side[0], side[1]);
    for (std::size_t k = 0; k < shares.size(); ++k, arc += m_surface.length(side[i], side[i + 1]), ++i) {
      const std::size_t last = side.size() - 1 - (shares.size() - k);
      for (; i < last && arc + m_surface.length(side[i], side[i + 1]) / 2 < shares[k] * total; ++i)
        arc += m_surface.length(side[i], side[i + 1]);
      picked.push_back(side[i]);
    }
    return picked;
  }

  Status cut_separators() {
    std::vector<double> shares;
    for (std::size_t k = 0; k + 1 < m_number_of_holes; ++k)
      shares.push_back(separator_x(k) / m_rectangles[0].xmax);
    Path top = outer().side(2);
    std::reverse(top.begin(), top.end());
    m_bottom_stops = pick(outer().side(0), shares);
    m_top_stops = pick(top, shares);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const std::vector<Path> halves = split_spine(k + 1);
      std::vector<Path> parts;
      Status status = add_path({m_bottom_stops[k]}, {halves[0].back()}, parts);
      if (status.ok()) status = add_path({halves[0].back()}, {m_top_stops[k]}, parts);
      if (!status.ok()) return status;
      parts[0].insert(parts[0].end(), parts[1].begin() + 1, parts[1].end());
      m_separators.push_back(parts[0]);
    }
    return {};
  }

  // Splits path k of the spine at its middle; the second half goes to the end of the list.
  std::vector<Path> split_spine(std::size_t k) {
    const Path path = m_spine[k];
    const std::size_t middle = path.size() / 2;
    m_spine[k].assign(path.begin(), path.begin() + middle + 1);
    m_spine.emplace_back(path.begin() + middle, path.end());
    return {m_spine[k], m_spine.back()};
  }

  // The corners of the cell of hole k, counterclockwise from the lower left.
  std::array<Id, 4> cell_corners(std::size_t k) const {
    const bool is_first = k == 0, is_last = k + 1 == m_number_of_holes;
    return {is_first ? outer().corner(0) : m_bottom_stops[k - 1],
            is_last ? outer().corner(1) : m_bottom_stops[k], is_last ? outer().corner(2) : m_top_stops[k],
            is_first ? outer().corner(3) : m_top_stops[k - 1]};
  }

  Status cut_corners() {
    for (std::size_t k = 0; k < m_number_of_holes; ++k)
      for (int i = 0; i < 4; ++i) {
        const Status status = add_path({hole(k).corner(i)}, {cell_corners(k)[i]}, m_corner_paths);
        if (!status.ok()) return status;
      }
    return {};
  }

  // Places side k of rim r piece by piece between its corners and the ends of separators.
  template <typename PlacePath>
  void place_side(std::size_t r, int k, const PlacePath& place_path) const {
    const auto corners = m_rectangles[r].corners();
    const auto &c = corners[k], &d = corners[(k + 1) % 4];
    Point_2 from(c[0], c[1]);
    Path piece;
    for (Id v : m_rims[r].side(k)) {
      piece.push_back(v);
      const Path& stops = k == 0 ? m_bottom_stops : m_top_stops;
      const auto stop = std::find(stops.begin(), stops.end(), v);
      if (r > 0 || k % 2 == 1 || stop == stops.end()) continue;
      const Point_2 to(separator_x(stop - stops.begin()), c[1]);
      place_path(piece, from, to);
      piece.assign(1, v);
      from = to;
    }
    place_path(piece, from, Point_2(d[0], d[1]));
  }

  const std::vector<Floor_rim>& m_rims;
  std::size_t m_number_of_holes;
  Refined_surface& m_surface;
  std::vector<Rectangle_2> m_rectangles; // of the rims
  std::vector<Path> m_spine, m_separators, m_corner_paths;
  Path m_bottom_stops, m_top_stops; // ends of the separators
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_CUTTER_H
