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

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

is a grid of a prism: lines at all its sides and between them, in equal steps, and layers of equal height.
*/
struct Prism_grid {
  std::vector<double> x, y; ///< the lines, in increasing order
  std::size_t layers = 1;   ///< number of hexahedra between floor and ceiling
};

namespace internal {

// The sides of all rims, and equidistant lines between them at a distance of about `edge`.
inline std::vector<double> grid_lines(std::vector<double> sides, double edge) {
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::vector<double> lines(1, sides[0]);
  for (std::size_t i = 1; i < sides.size(); ++i) {
    const double from = sides[i - 1], to = sides[i];
    const int steps = (std::max)(1, int(std::lround((to - from) / edge)));
    for (int k = 1; k < steps; ++k) lines.push_back(from + (to - from) * k / steps);
    lines.push_back(to);
  }
  return lines;
}

// Which column of the grid belongs to which hole.
template <typename GeomTraits>
class Prism_columns {
public:
  Prism_columns(const Prism_3<GeomTraits>& prism, const Prism_grid& grid) : m_prism(prism), m_grid(grid) {}

  int width() const { return int(m_grid.x.size()) - 1; }
  int depth() const { return int(m_grid.y.size()) - 1; }

  // The rim whose wall one meets when entering column (i, j): 0 outside, 1 + k in hole k, -1 in the solid.
  int rim(int i, int j) const {
    if (i < 0 || j < 0 || i >= width() || j >= depth()) return 0;
    const auto middle = [](const std::vector<double>& lines, int k) { return (lines[k] + lines[k + 1]) / 2; };
    const typename GeomTraits::Point_2 p(middle(m_grid.x, i), middle(m_grid.y, j));
    for (std::size_t k = 0; k < m_prism.number_of_holes(); ++k)
      if (m_prism.hole(k).bounded_side(p) != ON_UNBOUNDED_SIDE) return int(k) + 1;
    return -1;
  }
  bool is_solid(int i, int j) const { return rim(i, j) < 0; }

  std::size_t count() const {
    std::size_t n = 0;
    for (int j = 0; j < depth(); ++j)
      for (int i = 0; i < width(); ++i) n += is_solid(i, j);
    return n;
  }

private:
  const Prism_3<GeomTraits>& m_prism;
  const Prism_grid& m_grid;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns the grid of about cubic cells of edge `edge`.
*/
template <typename GeomTraits>
Prism_grid prism_grid(const Prism_3<GeomTraits>& prism, double edge) {
  std::vector<double> x, y;
  for (std::size_t r = 0; r < prism.number_of_rims(); ++r) {
    x.insert(x.end(), {prism.rim(r).xmin, prism.rim(r).xmax});
    y.insert(y.end(), {prism.rim(r).ymin, prism.rim(r).ymax});
  }
  const std::size_t layers = (std::max)(1l, std::lround(prism.height() / edge));
  return {internal::grid_lines(x, edge), internal::grid_lines(y, edge), layers};
}

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns how many hexahedra the grid has.
*/
template <typename GeomTraits>
std::size_t number_of_hexahedra(const Prism_3<GeomTraits>& prism, const Prism_grid& grid) {
  return internal::Prism_columns<GeomTraits>(prism, grid).count() * grid.layers;
}

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

returns the grid of about cubic cells whose number of hexahedra is nearest to `target` among edges around the one
that the volume suggests.
*/
template <typename GeomTraits>
Prism_grid prism_grid_of_size(const Prism_3<GeomTraits>& prism, std::size_t target) {
  const double edge =
      std::cbrt(prism.base_area() * prism.height() / double((std::max)(target, std::size_t(1))));
  constexpr int trials = 40;
  constexpr double least = 0.5, greatest = 2; // shares of that edge
  Prism_grid best = prism_grid(prism, edge);
  const auto miss = [&](const Prism_grid& g) {
    return CGAL::abs(double(number_of_hexahedra(prism, g)) - double(target));
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

  template <typename Column>
  Status build(const Column& column) {
    const Status status = add_points(column);
    if (!status.ok()) return status;
    for (int j = 0; j < m_columns.depth(); ++j)
      for (int i = 0; i < m_columns.width(); ++i)
        if (m_columns.is_solid(i, j)) add_column(i, j);
    return {};
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  template <typename Column>
  Status add_points(const Column& column) {
    const int lines = m_columns.width() + 1;
    for (int j = 0; j <= m_columns.depth(); ++j)
      for (int i = 0; i < lines; ++i) {
        const bool is_used = m_columns.is_solid(i - 1, j - 1) || m_columns.is_solid(i, j - 1) ||
                             m_columns.is_solid(i - 1, j) || m_columns.is_solid(i, j);
        m_first.push_back(is_used ? m_mesh.points.size() : none);
        if (!is_used) continue;
        const Status status =
            column(typename GeomTraits::Point_2(m_grid.x[i], m_grid.y[j]), m_grid.layers, m_mesh.points);
        if (!status.ok()) return status;
        if (m_mesh.points.size() != m_first.back() + m_grid.layers + 1)
          return {ERROR_WRONG_PARAMETER, "a column has not one point more than layers"};
      }
    return {};
  }

  std::size_t node(int i, int j, std::size_t layer) const {
    return m_first[j * (m_columns.width() + 1) + i] + layer;
  }

  void add_column(int i, int j) {
    for (std::size_t k = 0; k < m_grid.layers; ++k) {
      std::array<std::size_t, 8> h;
      for (int top = 0; top < 2; ++top) {
        h[4 * top] = node(i, j, k + top);
        h[4 * top + 1] = node(i + 1, j, k + top);
        h[4 * top + 2] = node(i + 1, j + 1, k + top);
        h[4 * top + 3] = node(i, j + 1, k + top);
      }
      m_mesh.hexahedra.push_back(h);
      if (k == 0) m_mesh.facets.push_back({{h[0], h[3], h[2], h[1]}, FLOOR});
      if (k + 1 == m_grid.layers) m_mesh.facets.push_back({{h[4], h[5], h[6], h[7]}, CEILING});
      add_wall(m_columns.rim(i, j - 1), {h[0], h[1], h[5], h[4]});
      add_wall(m_columns.rim(i + 1, j), {h[1], h[2], h[6], h[5]});
      add_wall(m_columns.rim(i, j + 1), {h[2], h[3], h[7], h[6]});
      add_wall(m_columns.rim(i - 1, j), {h[3], h[0], h[4], h[7]});
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
like the sides of the prism. Linear in the number of hexahedra and of evaluations.

\tparam Column a function object `Status column(const Point_2& p, std::size_t layers, std::vector<Point>& points)` that
  appends `layers` + 1 points, from the floor to the ceiling over `p`

\returns `ERROR_WRONG_PARAMETER` if `prism` is not valid, `grid` is empty or a column has a wrong length, or the status of
  the first column that fails; then the mesh is left empty
*/
template <typename GeomTraits, typename Column, typename Point>
Status hexahedral_mesh(const Prism_3<GeomTraits>& prism, const Prism_grid& grid, const Column& column,
                       Hexahedron_soup_3<Point>& mesh) {
  mesh = Hexahedron_soup_3<Point>();
  if (!prism.is_valid()) return {ERROR_WRONG_PARAMETER, "the prism"};
  if (grid.x.size() < 2 || grid.y.size() < 2 || grid.layers == 0) return {ERROR_WRONG_PARAMETER, "the grid"};
  const Status status = internal::Hexahedra_builder<GeomTraits, Point>(prism, grid, mesh).build(column);
  if (!status.ok()) mesh = Hexahedron_soup_3<Point>();
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_HEXAHEDRAL_MESH_H
