// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOX_GRID_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOX_GRID_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Disjoint_sets.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A place between planes, or a corner where three meet, by the numbers of planes. A box has the numbers of its lowest corner.
using Grid_site = std::array<std::int32_t, 3>;

inline Grid_site stepped(Grid_site s, int axis, std::int32_t by = 1) {
  s[axis] += by;
  return s;
}

// Calls visit(site) for all sites from `begin` up to but not including `end`, in lexicographic order.
template <typename Visit>
void for_each_site(const Grid_site& begin, const Grid_site& end, const Visit& visit) {
  for (std::int32_t x = begin[0]; x < end[0]; ++x)
    for (std::int32_t y = begin[1]; y < end[1]; ++y)
      for (std::int32_t z = begin[2]; z < end[2]; ++z) visit(Grid_site{x, y, z});
}

// Planes orthogonal to the axes, at any distances, and boxes between them that make up a solid.
template <typename FT>
struct Box_grid_3 {
  // A square of the grid, orthogonal to an axis; it has the site of the box above it.
  struct Square {
    int axis;
    Grid_site site;
    int label;
  };

  std::array<std::vector<FT>, 3> planes; // increasing
  std::vector<Grid_site> boxes;          // increasing
  std::vector<Square> squares;           // labelled ones

  // More are a slip of the hand.
  static constexpr std::size_t most_boxes = 2000000;

  void sort_planes() {
    for (std::vector<FT>& p : planes) {
      std::sort(p.begin(), p.end());
      p.erase(std::unique(p.begin(), p.end()), p.end());
    }
  }

  // The number of the first plane that is not below x.
  std::int32_t plane_from(int axis, const FT& x) const {
    return std::int32_t(std::lower_bound(planes[axis].begin(), planes[axis].end(), x) - planes[axis].begin());
  }

  // Which box has this site; the number of boxes if none has it.
  std::size_t number(const Grid_site& box) const {
    const auto found = std::lower_bound(boxes.begin(), boxes.end(), box);
    return found != boxes.end() && *found == box ? std::size_t(found - boxes.begin()) : boxes.size();
  }

  bool has(const Grid_site& box) const { return number(box) < boxes.size(); }
  bool is_on_boundary(int axis, const Grid_site& square) const {
    return has(square) != has(stepped(square, axis, -1));
  }

  double length(int axis, std::int32_t interval) const {
    return CGAL::to_double(FT(planes[axis][interval + 1] - planes[axis][interval]));
  }

  double volume() const {
    double sum = 0;
    for (const Grid_site& b : boxes) sum += length(0, b[0]) * length(1, b[1]) * length(2, b[2]);
    return sum;
  }
};

// Divides the intervals between planes into equal parts, so that there are about as many boxes as wanted, cubes if possible.
template <typename FT>
class Box_grid_refinement {
  using Grid = Box_grid_3<FT>;

public:
  Box_grid_refinement(const Grid& grid, std::size_t number_of_boxes) : m_grid(grid) {
    constexpr double growth = 1.1;
    double edge = std::cbrt(grid.volume() / double(number_of_boxes));
    for (divide(edge); number_of_parts() > double((std::max)(number_of_boxes, grid.boxes.size()));
         divide(edge))
      edge *= growth;
  }

  Grid refined() const {
    Grid result;
    for (int axis = 0; axis < 3; ++axis) result.planes[axis] = refined_planes(axis);
    const auto above = [](Grid_site s) { return Grid_site{s[0] + 1, s[1] + 1, s[2] + 1}; };
    for (const Grid_site& box : m_grid.boxes)
      for_each_site(first(box), first(above(box)), [&](const Grid_site& s) { result.boxes.push_back(s); });
    std::sort(result.boxes.begin(), result.boxes.end());
    for (const auto& square : m_grid.squares) {
      const Grid_site begin = first(square.site);
      Grid_site end = first(stepped(above(square.site), square.axis, -1));
      ++end[square.axis];
      for_each_site(begin, end, [&](const Grid_site& s) {
        result.squares.push_back({square.axis, s, square.label});
      });
    }
    return result;
  }

private:
  void divide(double edge) {
    constexpr double most_parts = 500; // keeps the numbers of planes in 32 bits
    for (int axis = 0; axis < 3; ++axis) {
      m_first[axis].assign(1, 0);
      for (std::size_t i = 0; i + 1 < m_grid.planes[axis].size(); ++i) {
        const double parts = std::round(m_grid.length(axis, std::int32_t(i)) / edge);
        m_first[axis].push_back(m_first[axis].back() +
                                std::int32_t((std::max)(1., (std::min)(parts, most_parts))));
      }
    }
  }

  std::int32_t parts(int axis, std::int32_t interval) const {
    return m_first[axis][interval + 1] - m_first[axis][interval];
  }

  double number_of_parts() const {
    double sum = 0;
    for (const Grid_site& b : m_grid.boxes)
      sum += double(parts(0, b[0])) * double(parts(1, b[1])) * double(parts(2, b[2]));
    return sum;
  }

  Grid_site first(const Grid_site& s) const { return {m_first[0][s[0]], m_first[1][s[1]], m_first[2][s[2]]}; }

  std::vector<FT> refined_planes(int axis) const {
    const std::vector<FT>& planes = m_grid.planes[axis];
    std::vector<FT> result;
    for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
      const std::int32_t n = parts(axis, std::int32_t(i));
      for (std::int32_t k = 0; k < n; ++k)
        result.push_back(planes[i] + (planes[i + 1] - planes[i]) * FT(k) / FT(n));
    }
    result.push_back(planes.back());
    return result;
  }

  const Grid& m_grid;
  std::array<std::vector<std::int32_t>, 3> m_first; // the number that each plane will have
};

// Whether octants around a point, given as bits, are connected through faces.
inline bool are_connected(unsigned octants) {
  unsigned reached = octants & (~octants + 1), last = 0;
  while (reached != last) {
    last = reached;
    reached |= (last & 0x55) << 1 | (last & 0xaa) >> 1;
    reached |= (last & 0x33) << 2 | (last & 0xcc) >> 2;
    reached |= (last & 0x0f) << 4 | (last & 0xf0) >> 4;
    reached &= octants;
  }
  return reached == octants;
}

template <typename FT>
Status check_connected(const Box_grid_3<FT>& grid) {
  if (grid.boxes.empty()) return {ERROR_EMPTY_MESH, "there are no boxes"};
  Disjoint_sets parts(grid.boxes.size());
  for (std::size_t i = 0; i < grid.boxes.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t next = grid.number(stepped(grid.boxes[i], axis));
      if (next < grid.boxes.size()) parts.join(std::uint32_t(i), std::uint32_t(next));
    }
  const std::size_t n = parts.number_of_sets();
  if (n == 1) return {};
  return {ERROR_SEVERAL_COMPONENTS, "the polycube has " + std::to_string(n) + " parts that share no face"};
}

// Checks that no boxes meet in an edge or a vertex only: around each corner those that are there and those that are not
// must be connected, so that they are two disks on a small sphere.
template <typename FT>
Status check_contacts(const Box_grid_3<FT>& grid) {
  std::vector<std::pair<Grid_site, unsigned>> octants; // at the corners
  for (const Grid_site& b : grid.boxes)
    for (int k = 0; k < 8; ++k)
      octants.emplace_back(Grid_site{b[0] + (k & 1), b[1] + (k >> 1 & 1), b[2] + (k >> 2)}, 1u << k);
  std::sort(octants.begin(), octants.end());
  for (std::size_t k = 0; k < octants.size();) {
    const Grid_site& at = octants[k].first;
    unsigned there = 0;
    for (; k < octants.size() && octants[k].first == at; ++k) there |= octants[k].second;
    if (are_connected(there) && are_connected(0xff ^ there)) continue;
    std::ostringstream text;
    text << "the polycube touches itself in an edge or a vertex at (";
    for (int i = 0; i < 3; ++i) text << (i == 0 ? "" : ", ") << CGAL::to_double(grid.planes[i][at[i]]);
    text << ")";
    return {ERROR_NON_MANIFOLD, text.str()};
  }
  return {};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_BOX_GRID_3_H
