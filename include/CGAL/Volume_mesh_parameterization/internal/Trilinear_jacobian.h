// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRILINEAR_JACOBIAN_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRILINEAR_JACOBIAN_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/FPU.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Uncertain.h>
#include <CGAL/determinant.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The determinant of the Jacobian of the map of a cube onto a hexahedron that is linear along each axis: a polynomial of degree
2 along each axis, by its coefficients with respect to Bernstein's polynomials. It lies between the least and the greatest
coefficient, and at corners it is the coefficient there. (A. Johnen, J.-C. Weill, J.-F. Remacle, Robust and efficient validation
of the linear hexahedral element, 2017)
*/
template <typename NT>
class Trilinear_jacobian {
public:
  using Vector = std::array<NT, 3>;

  // vertices: in the order of Hexahedron_soup_3
  explicit Trilinear_jacobian(const std::array<Vector, 8>& vertices) {
    m_coefficients.fill(NT(0));
    const auto edge = [&](int axis, int a, int b) {
      const Vector &from = vertices[vertex(axis, 0, a, b)], &to = vertices[vertex(axis, 1, a, b)];
      return Vector{to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    };
    for (int bits = 0; bits < 64; ++bits) {
      const auto bit = [bits](int k) { return bits >> k & 1; };
      // each edge by its places along the next axes in cyclic order
      const Vector x = edge(0, bit(0), bit(1)), y = edge(1, bit(2), bit(3)), z = edge(2, bit(4), bit(5));
      add(determinant(x[0], x[1], x[2], y[0], y[1], y[2], z[0], z[1], z[2]), bit(3) + bit(4), bit(0) + bit(5),
          bit(1) + bit(2));
    }
  }

  // Whether it is positive everywhere. Indeterminate if intervals are too wide to tell. If its minimum is zero, or positive but
  // less than most_halvings can tell from zero, it counts as not positive.
  Uncertain<bool> is_positive() const { return is_positive(0); }

private:
  static constexpr int most_halvings = 30; // all axes together

  // The end of an edge along an axis, whose places along the next two axes, in cyclic order, are a and b.
  static std::size_t vertex(int axis, int end, int a, int b) {
    constexpr int number[2][2][2] = {{{0, 4}, {3, 7}}, {{1, 5}, {2, 6}}}; // by x, y, z
    int place[3];
    place[axis] = end;
    place[(axis + 1) % 3] = a;
    place[(axis + 2) % 3] = b;
    return std::size_t(number[place[0]][place[1]][place[2]]);
  }

  // Along one axis, the product of linear Bernstein polynomials i and j is polynomial i + j of degree 2, halved if that is 1.
  void add(const NT& product, int i, int j, int k) {
    const int ones = (i == 1) + (j == 1) + (k == 1);
    m_coefficients[std::size_t(9 * i + 3 * j + k)] += product / NT(1 << ones);
  }

  Uncertain<bool> is_positive(int halvings) const {
    const Uncertain<bool> corners = all_positive(2);
    if (!certainly(corners)) return corners;
    if (certainly(all_positive(1))) return true;
    if (halvings == most_halvings)
      return std::is_same<NT, Interval_nt_advanced>::value ? Uncertain<bool>::indeterminate()
                                                           : Uncertain<bool>(false);
    Trilinear_jacobian lower = *this, upper = *this;
    halve(halvings % 3, lower, upper);
    const Uncertain<bool> below = lower.is_positive(halvings + 1);
    return certainly(below) ? upper.is_positive(halvings + 1) : below;
  }

  // Of all coefficients if the stride is 1, of those at corners if it is 2.
  Uncertain<bool> all_positive(int stride) const {
    Uncertain<bool> result = true;
    for (int i = 0; i < 3; i += stride)
      for (int j = 0; j < 3; j += stride)
        for (int k = 0; k < 3; k += stride) {
          const Uncertain<bool> positive = m_coefficients[std::size_t(9 * i + 3 * j + k)] > NT(0);
          if (certainly_not(positive)) return false;
          if (!certainly(positive)) result = Uncertain<bool>::indeterminate();
        }
    return result;
  }

  // De Casteljau's algorithm.
  void halve(int axis, Trilinear_jacobian& lower, Trilinear_jacobian& upper) const {
    const std::size_t step = axis == 0 ? 9 : axis == 1 ? 3 : 1;
    for (std::size_t n = 0; n < 27; ++n) {
      if (n / step % 3 != 0) continue;
      const NT &a = m_coefficients[n], &b = m_coefficients[n + step], &c = m_coefficients[n + 2 * step];
      const NT ab = (a + b) / NT(2), bc = (b + c) / NT(2), middle = (ab + bc) / NT(2);
      lower.m_coefficients[n + step] = ab;
      lower.m_coefficients[n + 2 * step] = upper.m_coefficients[n] = middle;
      upper.m_coefficients[n + step] = bc;
    }
  }

  std::array<NT, 27> m_coefficients;
};

template <typename NT, typename Point>
Uncertain<bool> has_positive_jacobian_in(const std::array<Point, 8>& vertices) {
  std::array<std::array<NT, 3>, 8> v;
  for (std::size_t i = 0; i < 8; ++i) v[i] = {NT(vertices[i].x()), NT(vertices[i].y()), NT(vertices[i].z())};
  return Trilinear_jacobian<NT>(v).is_positive();
}

// Whether the trilinear map onto a hexahedron has a positive Jacobian everywhere. Exact: by intervals, else by rational numbers;
// with the number type of the points if that is no floating point type.
template <typename Point>
bool has_positive_jacobian(const std::array<Point, 8>& vertices) {
  using FT = typename Kernel_traits<Point>::Kernel::FT;
  if constexpr (std::is_floating_point<FT>::value) {
    const auto decide = [&] {
      const Protect_FPU_rounding<true> protection;
      return has_positive_jacobian_in<Interval_nt_advanced>(vertices);
    };
    const Uncertain<bool> filtered = decide();
    return is_certain(filtered) ? get_certain(filtered)
                                : get_certain(has_positive_jacobian_in<Exact_rational>(vertices));
  } else
    return get_certain(has_positive_jacobian_in<FT>(vertices));
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TRILINEAR_JACOBIAN_H
