// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_LINEAR_CELL_COMPLEX_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_LINEAR_CELL_COMPLEX_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_topology.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_hexahedra.h>

#include <CGAL/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Two sides on one facet, each in its hexahedron; the first edge of the first one is edge `turn` of the second one, reversed.
struct Hexahedron_contact {
  Hexahedron_side sides[2];
  int turn;
};

// Whether the sides fit together: they have the same vertices in opposite order.
inline bool find_turn(const Hexahedron_side& a, const Hexahedron_side& b, int& turn) {
  const auto second = std::find(b.vertices.begin(), b.vertices.end(), a.vertices[1]);
  turn = int(second - b.vertices.begin());
  for (int i = 0; i < 4; ++i)
    if (b.vertices[std::size_t(turn + i) % 4] != a.vertices[std::size_t(5 - i) % 4]) return false;
  return true;
}

inline Status find_contacts(const std::vector<Hexahedron_side>& sorted_sides,
                            std::vector<Hexahedron_contact>& contacts) {
  Status status;
  for_each_facet(sorted_sides, [&](const Hexahedron_side* sides, std::size_t n) {
    if (n == 1 || !status.ok()) return;
    Hexahedron_contact contact = {{sides[0], sides[1]}, 0};
    if (n == 2 && find_turn(sides[0], sides[1], contact.turn))
      contacts.push_back(contact);
    else
      status = {ERROR_NON_MANIFOLD, "hexahedra " + std::to_string(sides[0].hexahedron) + " and " +
                                        std::to_string(sides[1].hexahedron) +
                                        (n == 2 ? " do not lie on opposite sides of their common facet"
                                                : " share a facet with a third one")};
  });
  return status;
}

template <typename LinearCellComplex>
class Hexahedra_sewer {
public:
  using Dart = decltype(std::declval<LinearCellComplex&>().make_combinatorial_hexahedron());

  explicit Hexahedra_sewer(LinearCellComplex& complex) : m_complex(complex) {}

  // CGAL's hexahedra are turned the other way around: the vertices are mirrored, so that darts run counterclockwise.
  template <typename Point>
  Dart add(const std::vector<Point>& points, const std::array<std::size_t, 8>& v) {
    const auto p = [&](std::size_t i) { return typename LinearCellComplex::Point(points[v[i]]); };
    m_darts.push_back(m_complex.make_hexahedron(p(0), p(3), p(2), p(1), p(5), p(4), p(7), p(6)));
    return m_darts.back();
  }

  void sew(const Hexahedron_contact& contact) {
    Dart opposite = first_dart(contact.sides[1]);
    for (int i = 0; i < contact.turn; ++i) opposite = m_complex.beta(opposite, 1);
    m_complex.template sew<3>(first_dart(contact.sides[0]), opposite);
  }

private:
  // Along the first edge of a facet of Reference_hexahedron. The dart of the hexahedron leads from vertex 0 to vertex 4 in
  // facet 5.
  Dart first_dart(const Hexahedron_side& side) const {
    const Dart d = m_darts[side.hexahedron];
    switch (side.facet) {
    case 0:
      return m_complex.beta(d, 0, 2);
    case 1:
      return m_complex.beta(d, 1, 2, 1);
    case 2:
      return m_complex.beta(d, 2, 1);
    case 3:
      return m_complex.beta(d, 2, 1, 1, 2, 1);
    case 4:
      return m_complex.beta(d, 1, 1, 2, 0);
    default:
      return m_complex.beta(d, 0);
    }
  }

  LinearCellComplex& m_complex;
  std::vector<Dart> m_darts;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

adds hexahedra to a linear cell complex as 3-cells, sewn along their common facets.

The darts of each facet run counterclockwise seen from outside of their hexahedron. One dart of each hexahedron is handed
out, in the order of the hexahedra: the one from vertex 0 to vertex 4 in the facet with vertices 0, 4, 7 and 3, by the
numbers that `Hexahedron_soup_3` gives to the vertices of a hexahedron. Labels of quadrilaterals are not looked at, nor are
points that no hexahedron has.

The function takes \f$ O(n \log n) \f$ time if the number of hexahedra around a vertex is bounded.

\tparam LinearCellComplex `Linear_cell_complex_for_combinatorial_map<3>`, with any traits and items; its points are
constructed from those of `soup`
\tparam OutputIterator an output iterator for darts; by default they are dropped
\tparam Point a point type of a \cgal kernel

\returns `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE` or `ERROR_NON_MANIFOLD`: a facet in
more than two hexahedra, two hexahedra on the same side of their common facet, or a boundary that is no closed surface; then
`complex` is left as it was
*/
template <typename Point, typename LinearCellComplex, typename OutputIterator = Emptyset_iterator>
Status make_linear_cell_complex(const Hexahedron_soup_3<Point>& soup, LinearCellComplex& complex,
                                OutputIterator darts = {}) {
  const Status status = internal::check_hexahedra(soup);
  if (!status.ok()) return status;
  const std::vector<internal::Hexahedron_side> sides = internal::sorted_sides(soup.hexahedra);
  std::vector<internal::Hexahedron_contact> contacts;
  const Status fitting = internal::find_contacts(sides, contacts);
  if (!fitting.ok()) return fitting;
  const internal::Hexahedron_facets facets(sides);
  if (!internal::Surface_topology<4>(facets.boundary).is_closed_manifold())
    return {ERROR_NON_MANIFOLD, "the boundary is no closed surface"};
  internal::Hexahedra_sewer<LinearCellComplex> sewer(complex);
  for (const auto& hexahedron : soup.hexahedra) *darts++ = sewer.add(soup.points, hexahedron);
  for (const internal::Hexahedron_contact& contact : contacts) sewer.sew(contact);
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MAKE_LINEAR_CELL_COMPLEX_H
