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
#include <CGAL/Volume_mesh_parameterization/internal/Rectangle_slicing.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/shortest_path.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Cuts the floor into pieces, one without holes or four trapezoids for each hole, and fixes the images of the cuts.

The rectangles of the rims are sliced until each hole is alone in its cell, and the floor is cut accordingly. To part two
groups of holes, all of one group are joined to their side of the cell by a tree of paths, all others to the opposite
side. Between the trees the separator has only one way to go, whatever the shape of the floor; then the trees are given
up. Nor has a path from the corner of a hole to that of its cell a choice, while the hole is joined to two sides.
*/
class Floor_cutter {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;
  using Point_2 = Double_kernel::Point_2;

  // rims[0] is the outer one; all have corners; the rectangles are separable
  Floor_cutter(const std::vector<Rectangle_2>& rectangles, std::vector<Floor_rim>& rims,
               Refined_surface& surface)
      : m_rectangles(rectangles), m_rims(rims), m_surface(surface) {}

  Status cut() {
    Cell cell{m_rectangles[0], {0, 1, 2, 3}, {}, std::vector<std::size_t>(m_rims.size() - 1)};
    std::iota(cell.holes.begin(), cell.holes.end(), 1);
    const auto corners = m_rectangles[0].corners();
    for (int k = 0; k < 4; ++k) {
      cell.corners[k] = m_rims[0].corner(k);
      Path path = m_rims[0].side(k);
      if (!runs_upwards(k)) std::reverse(path.begin(), path.end());
      add_line(k % 2, corners[k][1 - k % 2], path, m_rectangles[0]);
    }
    return cut_cell(cell);
  }

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
    for (const Line& line : m_lines)
      for (std::size_t i = 1; i < line.stops.size(); ++i)
        place_path(line.between(line.stops[i - 1].vertex, line.stops[i].vertex),
                   line.point(line.stops[i - 1].coordinate), line.point(line.stops[i].coordinate));
    for (std::size_t r = 1; r < m_rims.size(); ++r) {
      const auto c = m_rectangles[r].corners();
      for (int k = 0; k < 4; ++k)
        place_path(m_rims[r].side(k), Point_2(c[k][0], c[k][1]),
                   Point_2(c[(k + 1) % 4][0], c[(k + 1) % 4][1]));
    }
    for (const Path& path : m_corner_paths) place_path(path, positions[path.front()], positions[path.back()]);
  }

private:
  // A vertex of a line where it ends or others end on it. The images of two stops fix those of the vertices between them.
  struct Stop {
    double coordinate;
    Id vertex;
  };

  // A side of the outer rim or a separator: an axis-parallel segment of the plane.
  struct Line {
    int axis;                // along which it runs
    double position;         // the other coordinate
    Path path;               // in increasing direction
    std::vector<Stop> stops; // likewise

    Point_2 point(double coordinate) const {
      return axis == 0 ? Point_2(coordinate, position) : Point_2(position, coordinate);
    }
    std::size_t place(Id v) const { return std::find(path.begin(), path.end(), v) - path.begin(); }
    Path between(Id v, Id w) const {
      const auto ends = std::minmax({place(v), place(w)});
      return {path.begin() + ends.first, path.begin() + ends.second + 1};
    }
  };

  // A rectangle of the plane. Side k, from corner k to corner k + 1, is a part of a line: bottom, right, top, left.
  struct Cell {
    Rectangle_2 box;
    std::array<std::size_t, 4> lines;
    std::array<Id, 4> corners;
    std::vector<std::size_t> holes; // their rims

    void replace_side(int k, std::size_t line, const std::array<Id, 2>& ends) {
      lines[k] = line;
      corners[k] = ends[runs_upwards(k) ? 0 : 1];
      corners[(k + 1) % 4] = ends[runs_upwards(k) ? 1 : 0];
    }
  };

  static bool runs_upwards(int side) { return side < 2; }
  static int low_side(int axis) { return axis == 0 ? 3 : 0; }
  static int high_side(int axis) { return axis == 0 ? 1 : 2; }

  void add_line(int axis, double position, const Path& path, const Rectangle_2& box) {
    m_lines.push_back({axis, position, path, {{box.low(axis), path.front()}, {box.high(axis), path.back()}}});
  }

  Status cut_cell(const Cell& cell) {
    if (cell.holes.empty()) return {};
    if (cell.holes.size() == 1) return cut_corners(cell);
    const Slice slice = widest_slice(m_rectangles, cell.holes);
    const int axis = slice.axis;
    const double position = slice.position();
    std::array<Id, 2> ends{};
    Status status = cut_separator(cell, slice, position, ends);
    if (!status.ok()) return status;
    Cell low = cell, high = cell;
    low.box.high(axis) = high.box.low(axis) = position;
    low.holes = slice.low;
    high.holes = slice.high;
    low.replace_side(high_side(axis), m_lines.size() - 1, ends);
    high.replace_side(low_side(axis), m_lines.size() - 1, ends);
    status = cut_cell(low);
    return status.ok() ? cut_cell(high) : status;
  }

  Status cut_separator(const Cell& cell, const Slice& slice, double position, std::array<Id, 2>& ends) {
    const int along = 1 - slice.axis;
    ends[0] = stop(m_lines[cell.lines[low_side(along)]], position);
    ends[1] = stop(m_lines[cell.lines[high_side(along)]], position);
    std::vector<Path> trees, separator;
    Status status = join(inner_side(cell, low_side(slice.axis)), slice.low, trees);
    if (status.ok()) status = join(inner_side(cell, high_side(slice.axis)), slice.high, trees);
    if (status.ok()) status = add_path({ends[0]}, {ends[1]}, separator);
    for (const Path& path : trees) m_surface.uncut(path);
    if (status.ok()) add_line(along, position, separator[0], cell.box);
    return status;
  }

  // Joins the holes to a side, the nearest to what is joined first.
  Status join(Path joined, std::vector<std::size_t> holes, std::vector<Path>& trees) {
    while (!holes.empty()) {
      Path targets;
      for (std::size_t hole : holes)
        targets.insert(targets.end(), m_rims[hole].loop.begin(), m_rims[hole].loop.end());
      const Status status = add_path(joined, targets, trees);
      if (!status.ok()) return status;
      const auto nearest = std::find_if(holes.begin(), holes.end(), [&](std::size_t hole) {
        const Path& loop = m_rims[hole].loop;
        return std::find(loop.begin(), loop.end(), trees.back().back()) != loop.end();
      });
      joined.insert(joined.end(), m_rims[*nearest].loop.begin(), m_rims[*nearest].loop.end());
      holes.erase(nearest);
    }
    return {};
  }

  Status cut_corners(const Cell& cell) {
    const Floor_rim& hole = m_rims[cell.holes[0]];
    std::vector<Path> belt;
    Status status = add_path(inner_side(cell, low_side(0)), {hole.left()}, belt);
    if (status.ok()) status = add_path({hole.right()}, inner_side(cell, high_side(0)), belt);
    for (int k = 0; k < 4 && status.ok(); ++k)
      status = add_path({hole.corner(k)}, {cell.corners[k]}, m_corner_paths);
    for (const Path& path : belt) m_surface.uncut(path);
    return status;
  }

  Status add_path(const Path& sources, const Path& targets, std::vector<Path>& paths) {
    const Path path = shortest_path(m_surface, sources, targets);
    if (path.empty()) return {ERROR_FLOOR_MAP, "no path joins two of its rims"};
    paths.push_back(path);
    m_surface.cut(path);
    m_surface.split_chords();
    return {};
  }

  // The vertices of a side without its ends, at least one.
  Path inner_side(const Cell& cell, int k) {
    Line& line = m_lines[cell.lines[k]];
    Path side = line.between(cell.corners[k], cell.corners[(k + 1) % 4]);
    if (side.size() == 2) {
      bisect(line, line.place(side[0]));
      side = line.between(side[0], side[1]);
    }
    return {side.begin() + 1, side.end() - 1};
  }

  // The vertex of the line that comes to lie at the coordinate: a stop that is there, or one between its neighbors, at
  // about that share of the way.
  Id stop(Line& line, double coordinate) {
    const auto next = std::lower_bound(line.stops.begin(), line.stops.end(), coordinate,
                                       [](const Stop& s, double c) { return s.coordinate < c; });
    if (next->coordinate == coordinate) return next->vertex;
    const Stop before = *(next - 1);
    if (line.between(before.vertex, next->vertex).size() == 2) bisect(line, line.place(before.vertex));
    const double share = (coordinate - before.coordinate) / (next->coordinate - before.coordinate);
    const Id v = inner_vertex(line.between(before.vertex, next->vertex), share);
    line.stops.insert(next, {coordinate, v});
    return v;
  }

  // The inner vertex that is nearest to a share of the way.
  Id inner_vertex(const Path& path, double share) const {
    const double wanted = share * m_surface.length(path);
    double arc = m_surface.length(path[0], path[1]);
    std::size_t i = 1;
    for (; i + 2 < path.size(); ++i) {
      const double edge = m_surface.length(path[i], path[i + 1]);
      if (wanted <= arc + edge / 2) break;
      arc += edge;
    }
    return path[i];
  }

  // Bisects the edge of the line after place i.
  void bisect(Line& line, std::size_t i) {
    const Id v = line.path[i], w = line.path[i + 1], middle = m_surface.bisect(m_surface.half_edge(v, w));
    line.path.insert(line.path.begin() + i + 1, middle);
    if (m_surface.is_border(m_surface.outgoing(middle))) m_rims[0].insert(v, w, middle);
    m_surface.split_chords();
  }

  const std::vector<Rectangle_2>& m_rectangles; // of the rims
  std::vector<Floor_rim>& m_rims;
  Refined_surface& m_surface;
  std::vector<Line> m_lines; // the sides of the outer rim, then the separators
  std::vector<Path> m_corner_paths;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_FLOOR_CUTTER_H
