// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

is a grid of a prism: lines at all its sides and between them, in equal steps, and levels. Sides of holes may be a little beside
their line: it bends there, so that it is at the side of each hole that it is nearest to.
*/
struct Prism_grid {
  std::vector<double> x; ///< the lines x = constant, in increasing order
  std::vector<double> y; ///< the lines y = constant, in increasing order
  std::vector<double> levels = {
      0., 1.}; ///< shares of the way up where layers begin and end, increasing from 0 to 1

  /// returns the number of hexahedra between floor and ceiling.
  std::size_t layers() const { return levels.size() - 1; }
};

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns the levels of so many layers, each of which is `ratio` times as high as the one below it.

\pre `layers` > 0, `ratio` > 0
*/
inline std::vector<double> graded_levels(std::size_t layers, double ratio = 1) {
  std::vector<double> levels(1, 0.);
  for (std::size_t k = 0; k < layers; ++k) levels.push_back(levels.back() + std::pow(ratio, double(k)));
  for (double& level : levels) level /= levels.back();
  return levels;
}

namespace internal {

// The sides of all rims, and equidistant lines between them at a distance of about `edge`. Sides that follow each other
// within half of that, and all have their holes on the right or all on the left, share a line in their middle.
class Grid_lines {
public:
  template <typename GeomTraits>
  Grid_lines(const Prism_3<GeomTraits>& prism, int axis, double edge) : m_edge(edge) {
    for (std::size_t r = 0; r < prism.number_of_rims(); ++r) {
      m_sides[prism.rim(r).low(axis)] |= r == 0 ? OUTER : LOW;
      m_sides[prism.rim(r).high(axis)] |= r == 0 ? OUTER : HIGH;
    }
  }

  std::vector<double> lines() const {
    std::vector<double> result(1, m_sides.begin()->first);
    for (auto first = std::next(m_sides.begin()), end = first; first != m_sides.end(); first = end) {
      while (end != m_sides.end() && (end == first || may_share(*first, *end))) ++end;
      add_lines((first->first + std::prev(end)->first) / 2, result);
    }
    return result;
  }

private:
  enum Kind { LOW = 1, HIGH = 2, OUTER = 4 }; // a hole begins, ends; the base does
  using Side = std::pair<const double, int>;

  bool may_share(const Side& a, const Side& b) const {
    constexpr double share = 0.5;
    return a.second == b.second && (a.second == LOW || a.second == HIGH) && b.first - a.first < share * m_edge;
  }

  void add_lines(double to, std::vector<double>& lines) const {
    const double from = lines.back();
    const int steps = (std::max)(1, int(std::lround((to - from) / m_edge)));
    for (int k = 1; k < steps; ++k) lines.push_back(from + (to - from) * k / steps);
    lines.push_back(to);
  }

  std::map<double, int> m_sides; // with their kinds
  double m_edge;
};

// Which column of the grid belongs to which hole, and where lines cross.
template <typename GeomTraits>
class Prism_columns {
public:
  Prism_columns(const Prism_3<GeomTraits>& prism, const Prism_grid& grid) : m_prism(prism), m_grid(grid) {
    for (std::size_t k = 0; k < prism.number_of_holes(); ++k) m_holes.push_back(lines_of(prism.hole(k)));
  }

  // Whether there are columns in all holes and all around them.
  bool is_valid() const {
    for (auto h = m_holes.begin(); h != m_holes.end(); ++h)
      if (!(h->xmin < h->xmax && h->ymin < h->ymax && 0 < h->xmin && 0 < h->ymin && h->xmax < width() &&
            h->ymax < depth()) ||
          std::any_of(std::next(h), m_holes.end(), [&](const Lines& other) { return h->meets(other); }))
        return false;
    return true;
  }

  int width() const { return int(m_grid.x.size()) - 1; }
  int depth() const { return int(m_grid.y.size()) - 1; }

  // The rim whose wall one meets when entering column (i, j): 0 outside, 1 + k in hole k, -1 in the solid.
  int rim(int i, int j) const {
    if (i < 0 || j < 0 || i >= width() || j >= depth()) return 0;
    for (std::size_t k = 0; k < m_holes.size(); ++k) {
      const Lines& h = m_holes[k];
      if (h.xmin <= i && i < h.xmax && h.ymin <= j && j < h.ymax) return int(k) + 1;
    }
    return -1;
  }
  bool is_solid(int i, int j) const { return rim(i, j) < 0; }

  // The crossing of lines i and j, on the sides of the hole that it belongs to.
  typename GeomTraits::Point_2 crossing(int i, int j) const {
    double x = m_grid.x[i], y = m_grid.y[j];
    for (std::size_t k = 0; k < m_holes.size(); ++k) {
      const Lines& h = m_holes[k];
      if (i < h.xmin || i > h.xmax || j < h.ymin || j > h.ymax) continue;
      const Rectangle_2& r = m_prism.hole(k);
      x = i == h.xmin ? r.xmin : i == h.xmax ? r.xmax : x;
      y = j == h.ymin ? r.ymin : j == h.ymax ? r.ymax : y;
    }
    return {x, y};
  }

  std::size_t count() const {
    std::size_t n = 0;
    for (int j = 0; j < depth(); ++j)
      for (int i = 0; i < width(); ++i) n += is_solid(i, j);
    return n;
  }

  // The number of sides of columns that are on walls.
  std::size_t count_sides() const {
    std::size_t n = 0;
    for (int j = 0; j <= depth(); ++j)
      for (int i = 0; i <= width(); ++i)
        n += (is_solid(i, j) != is_solid(i - 1, j)) + (is_solid(i, j) != is_solid(i, j - 1));
    return n;
  }

private:
  // Numbers of the lines at the sides of a hole.
  struct Lines {
    int xmin, ymin, xmax, ymax;
    bool meets(const Lines& l) const {
      return xmin <= l.xmax && l.xmin <= xmax && ymin <= l.ymax && l.ymin <= ymax;
    }
  };

  Lines lines_of(const Rectangle_2& r) const {
    return {nearest(m_grid.x, r.xmin), nearest(m_grid.y, r.ymin), nearest(m_grid.x, r.xmax), nearest(m_grid.y, r.ymax)};
  }
  static int nearest(const std::vector<double>& lines, double c) {
    const auto next = std::lower_bound(lines.begin(), lines.end(), c);
    const bool is_previous = next == lines.end() || (next != lines.begin() && c - *std::prev(next) < *next - c);
    return int(next - lines.begin()) - int(is_previous);
  }

  const Prism_3<GeomTraits>& m_prism;
  const Prism_grid& m_grid;
  std::vector<Lines> m_holes;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns the grid of cells whose edges along the three axes have about these lengths. Sides of holes that nearly have a line in
common, as far as half an edge, share one if no other kind of side is between them.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre `prism.is_valid()`; the lengths are positive
*/
template <typename GeomTraits>
Prism_grid prism_grid(const Prism_3<GeomTraits>& prism, const std::array<double, 3>& edges) {
  const std::size_t layers = (std::max)(1l, std::lround(prism.height() / edges[2]));
  return {internal::Grid_lines(prism, 0, edges[0]).lines(), internal::Grid_lines(prism, 1, edges[1]).lines(),
          graded_levels(layers)};
}

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns the grid of about cubic cells of edge `edge`.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre `prism.is_valid()`; `edge` is positive
*/
template <typename GeomTraits>
Prism_grid prism_grid(const Prism_3<GeomTraits>& prism, double edge) {
  return prism_grid(prism, std::array<double, 3>{edge, edge, edge});
}

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns how many hexahedra the grid has.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
std::size_t number_of_hexahedra(const Prism_3<GeomTraits>& prism, const Prism_grid& grid) {
  return internal::Prism_columns<GeomTraits>(prism, grid).count() * grid.layers();
}

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns how many quadrilaterals the boundary of the grid has: how many hexahedra `pillow_hexahedra()` adds.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
std::size_t number_of_boundary_quadrilaterals(const Prism_3<GeomTraits>& prism, const Prism_grid& grid) {
  const internal::Prism_columns<GeomTraits> columns(prism, grid);
  return 2 * columns.count() + columns.count_sides() * grid.layers();
}

namespace internal {

// The edge of about `target` cubes that fill the prism and, for a pillow, cover its boundary once more.
template <typename GeomTraits>
double edge_of_size(const Prism_3<GeomTraits>& prism, double target, bool has_pillow) {
  constexpr int rounds = 20; // each divides the error by at least 3
  double rim_length = 0;
  for (std::size_t r = 0; r < prism.number_of_rims(); ++r)
    rim_length += 2 * (prism.rim(r).width() + prism.rim(r).height());
  const double volume = prism.base_area() * prism.height();
  const double area = has_pillow ? 2 * prism.base_area() + rim_length * prism.height() : 0;
  double edge = std::cbrt(volume / target);
  for (int k = 0; k < rounds && has_pillow; ++k) edge = std::cbrt((volume + area * edge) / target);
  return edge;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns the grid of about cubic cells whose number of hexahedra, with those of a pillow if `has_pillow`, is nearest to
`target` among edges around the one that the volume suggests.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\pre `prism.is_valid()`
*/
template <typename GeomTraits>
Prism_grid prism_grid_of_size(const Prism_3<GeomTraits>& prism, std::size_t target, bool has_pillow = false) {
  const double edge = internal::edge_of_size(prism, double((std::max)(target, std::size_t(1))), has_pillow);
  constexpr int trials = 40;
  constexpr double least = 0.5, greatest = 2; // shares of that edge
  Prism_grid best = prism_grid(prism, edge);
  const auto miss = [&](const Prism_grid& g) {
    const std::size_t in_pillow = has_pillow ? number_of_boundary_quadrilaterals(prism, g) : 0;
    return CGAL::abs(double(number_of_hexahedra(prism, g) + in_pillow) - double(target));
  };
  for (int k = 0; k <= trials; ++k) {
    const Prism_grid grid = prism_grid(prism, edge * least * std::pow(greatest / least, double(k) / trials));
    if (miss(grid) < miss(best)) best = grid;
  }
  return best;
}

namespace internal {

// Builds the hexahedra over a grid of columns of points.
template <typename GeomTraits, typename Point>
class Hexahedra_builder {
public:
  Hexahedra_builder(const Prism_3<GeomTraits>& prism, const Prism_grid& grid, Hexahedron_soup_3<Point>& mesh)
      : m_prism(prism), m_grid(grid), m_columns(prism, grid), m_mesh(mesh) {}

  template <typename ConcurrencyTag, typename Column>
  Status build(const Column& column) {
    const Status status = add_points<ConcurrencyTag>(column);
    if (!status.ok()) return status;
    for (int j = 0; j < m_columns.depth(); ++j)
      for (int i = 0; i < m_columns.width(); ++i)
        if (m_columns.is_solid(i, j)) add_column(i, j);
    return {};
  }

private:
  static constexpr std::size_t none = std::size_t(-1);
  using Point_2 = typename GeomTraits::Point_2;

  // Numbers the nodes over the crossings of lines that are used, and returns these crossings.
  std::vector<Point_2> number_nodes() {
    std::vector<Point_2> crossings;
    const int lines = m_columns.width() + 1;
    for (int j = 0; j <= m_columns.depth(); ++j)
      for (int i = 0; i < lines; ++i) {
        const bool is_used = m_columns.is_solid(i - 1, j - 1) || m_columns.is_solid(i, j - 1) ||
                             m_columns.is_solid(i - 1, j) || m_columns.is_solid(i, j);
        m_first.push_back(is_used ? crossings.size() * (m_grid.layers() + 1) : none);
        if (is_used) crossings.push_back(m_columns.crossing(i, j));
      }
    return crossings;
  }

  template <typename ConcurrencyTag, typename Column>
  Status add_points(const Column& column) {
    const std::vector<Point_2> crossings = number_nodes();
    const std::size_t size = m_grid.layers() + 1;
    m_mesh.points.resize(crossings.size() * size);
    using Tag = Concurrency_for<ConcurrencyTag, typename GeomTraits::FT>;
    const auto add_column = [&](std::size_t k) -> Status {
      std::vector<Point> points;
      const Status status = column(crossings[k], m_grid.levels, points);
      if (!status.ok()) return status;
      if (points.size() != size) return {ERROR_WRONG_PARAMETER, "a column has not one point for each level"};
      std::move(points.begin(), points.end(), m_mesh.points.begin() + k * size);
      return {};
    };
    return try_each_index<Tag>(crossings.size(), add_column, 4);
  }

  std::size_t node(int i, int j, std::size_t layer) const {
    return m_first[j * (m_columns.width() + 1) + i] + layer;
  }

  void add_column(int i, int j) {
    const std::array<int, 4> rims = {m_columns.rim(i, j - 1), m_columns.rim(i + 1, j), m_columns.rim(i, j + 1),
                                     m_columns.rim(i - 1, j)};
    for (std::size_t k = 0; k < m_grid.layers(); ++k) {
      std::array<std::size_t, 8> h;
      for (int top = 0; top < 2; ++top) {
        h[4 * top] = node(i, j, k + top);
        h[4 * top + 1] = node(i + 1, j, k + top);
        h[4 * top + 2] = node(i + 1, j + 1, k + top);
        h[4 * top + 3] = node(i, j + 1, k + top);
      }
      m_mesh.hexahedra.push_back(h);
      if (k == 0) m_mesh.facets.push_back({{h[0], h[3], h[2], h[1]}, FLOOR});
      if (k + 1 == m_grid.layers()) m_mesh.facets.push_back({{h[4], h[5], h[6], h[7]}, CEILING});
      add_wall(rims[0], {h[0], h[1], h[5], h[4]});
      add_wall(rims[1], {h[1], h[2], h[6], h[5]});
      add_wall(rims[2], {h[2], h[3], h[7], h[6]});
      add_wall(rims[3], {h[3], h[0], h[4], h[7]});
    }
  }

  void add_wall(int rim, const std::array<std::size_t, 4>& vertices) {
    if (rim >= 0) m_mesh.facets.push_back({vertices, m_prism.wall_label(std::size_t(rim))});
  }

  const Prism_3<GeomTraits>& m_prism;
  const Prism_grid& m_grid;
  Prism_columns<GeomTraits> m_columns;
  Hexahedron_soup_3<Point>& m_mesh;
  std::vector<std::size_t> m_first; // lowest node over each crossing of lines
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

extracts the hexahedra of `grid`: those of a prism, seen through the map that `column` evaluates. Facets are labelled
like the sides of the prism. Linear in the number of hexahedra, of evaluations, and of columns times holes.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: then `column` is called by several
  threads at a time. The result does not depend on it. If `FT` is no floating point type, one thread does all.
\tparam Column a function object `Status column(const Point_2& p, const std::vector<double>& levels, std::vector<Point>& points)`
  that appends the points over `p` at these levels, the first of which is on the floor and the last on the ceiling
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Point a point type of a \cgal kernel

\returns `ERROR_WRONG_PARAMETER` if `prism` is not valid, `grid` is empty or has no columns in a hole or between two, or a column
  has a wrong length, or the status of the first column that fails; then the mesh is left empty
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename Column, typename Point>
Status hexahedral_mesh(const Prism_3<GeomTraits>& prism, const Prism_grid& grid, const Column& column,
                       Hexahedron_soup_3<Point>& mesh) {
  mesh = Hexahedron_soup_3<Point>();
  if (!prism.is_valid()) return {ERROR_WRONG_PARAMETER, "the prism"};
  for (const std::vector<double>* places : {&grid.x, &grid.y, &grid.levels})
    if (places->size() < 2 || !std::is_sorted(places->begin(), places->end(), std::less_equal<double>()))
      return {ERROR_WRONG_PARAMETER, "the lines or levels of the grid do not increase"};
  if (!internal::Prism_columns<GeomTraits>(prism, grid).is_valid())
    return {ERROR_WRONG_PARAMETER, "the grid has too few lines for the holes"};
  const Status status = internal::Hexahedra_builder<GeomTraits, Point>(prism, grid, mesh)
                            .template build<ConcurrencyTag>(column);
  if (!status.ok()) mesh = Hexahedron_soup_3<Point>();
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H
