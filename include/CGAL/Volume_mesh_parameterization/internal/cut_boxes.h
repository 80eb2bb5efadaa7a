// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_BOXES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_BOXES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Box_grid_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Cuts each box into the six tetrahedra around its diagonal from the lowest to the highest corner (H. W. Kuhn, Some
// combinatorial lemmas in topology, 1960). Those of neighbors fit together.
template <typename Point, typename FT>
class Box_cutter {
public:
  explicit Box_cutter(const Box_grid_3<FT>& grid) : m_grid(grid) {}

  Tetrahedron_soup_3<Point> run() {
    number_corners();
    for (const Grid_site& box : m_grid.boxes) cut_box(box);
    for (const auto& square : m_grid.squares) cut_square(square);
    return std::move(m_soup);
  }

private:
  void number_corners() {
    for (const Grid_site& b : m_grid.boxes)
      for_each_site(b, {b[0] + 2, b[1] + 2, b[2] + 2}, [&](const Grid_site& s) { m_corners.push_back(s); });
    std::sort(m_corners.begin(), m_corners.end());
    m_corners.erase(std::unique(m_corners.begin(), m_corners.end()), m_corners.end());
    const auto& planes = m_grid.planes;
    for (const Grid_site& s : m_corners)
      m_soup.points.emplace_back(planes[0][s[0]], planes[1][s[1]], planes[2][s[2]]);
  }

  std::size_t number(const Grid_site& corner) const {
    return std::size_t(std::lower_bound(m_corners.begin(), m_corners.end(), corner) - m_corners.begin());
  }

  void cut_box(Grid_site box) {
    std::array<int, 3> axes = {0, 1, 2};
    do {
      Grid_site s = box;
      std::array<std::size_t, 4> cell = {number(s), 0, 0, 0};
      for (int i = 0; i < 3; ++i) {
        ++s[axes[i]];
        cell[i + 1] = number(s);
      }
      const bool is_positive = (axes[1] - axes[0] + 3) % 3 == 1;
      if (!is_positive) std::swap(cell[2], cell[3]);
      m_soup.cells.push_back(cell);
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  void cut_square(const typename Box_grid_3<FT>::Square& square) {
    const int a = (square.axis + 1) % 3, b = (square.axis + 2) % 3;
    const std::size_t low = number(square.site), high = number(stepped(stepped(square.site, a), b));
    for (int side : {a, b})
      m_soup.facets.push_back({{low, number(stepped(square.site, side)), high}, square.label});
  }

  const Box_grid_3<FT>& m_grid;
  std::vector<Grid_site> m_corners; // increasing
  Tetrahedron_soup_3<Point> m_soup;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_BOXES_H
