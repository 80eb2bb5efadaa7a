// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CURVE_FIELD_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CURVE_FIELD_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Curve_cell.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/nearest_admissible_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

chooses what grows at unit speed along a curve, and so what the third parameter w measures.
*/
enum Level_function {
  /// The harmonic function f wherever it grows along the curve at an angle of less than about 84 degrees to its
  /// gradient; elsewhere a small positive share of its slope. So w grows strictly along every curve, and equals f on
  /// each curve along which f does.
  HARMONIC_LEVEL,
  ARC_LENGTH_LEVEL ///< the length of the curve
};

/*!
\ingroup PkgVolumeMeshParameterizationStructure

gives each cell the velocity of the curves that pass through it, as rates of the four barycentric coordinates. Time is
the level function: the rates say how coordinates change while the level grows by one.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Curve_field_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the mesh that it belongs to
  using FT = typename GeomTraits::FT;                  ///< the number type
  using Rates =
      std::array<FT, 4>; ///< how fast the barycentric coordinates change along a curve; their sum is 0
  using Vector_3 = internal::Double_kernel::Vector_3; ///< a vector of doubles

  static constexpr double default_least_slope = 0.02; ///< of the certified field

  Curve_field_3() = default;

  /*!
  constructs the certified field: in each cell the velocity nearest to that of `flux` among those that enter through
  the entry facets and leave through the exit facets of `structure`, parallel to the walls, and that meet every entry
  or exit facet at an angle whose sine is at least `least_slope`. The result does not depend on the `ConcurrencyTag`; if
  `FT` is no floating point type, one thread does all.

  \pre `least_slope` is positive

  Complexity: \f$ O(n) \f$.
  */
  template <typename Harmonic_function, typename Flux_field, typename ConcurrencyTag = Sequential_tag>
  Curve_field_3(const Mesh& mesh, const Product_structure_3<GeomTraits>& structure, const Flux_field& flux,
                const Harmonic_function& harmonic, Level_function level = HARMONIC_LEVEL,
                double least_slope = default_least_slope, ConcurrencyTag = ConcurrencyTag())
      : Curve_field_3(mesh) {
    const double slope = mean_slope(mesh, harmonic);
    using Tag = internal::Concurrency_for<ConcurrencyTag, FT>;
    internal::for_each_index<Tag>(mesh.number_of_cells(), [&](std::size_t i) {
      const Cell_index c(i);
      const internal::Cell_gradients gradients(mesh, c);
      m_cells[c].set_neighbors(mesh, c);
      m_cells[c].set_signs(structure.signs(c));
      const std::array<double, 4> rates = nearest_rates(gradients, m_cells[c].signs, flux.vector(c), least_slope);
      set_rates(mesh, c, rates, harmonic.gradient(c), level, slope);
    });
  }

  /// constructs the field of `flux` itself, whose curves carry no certificate.
  template <typename Harmonic_function, typename Flux_field>
  Curve_field_3(const Mesh& mesh, const Flux_field& flux, const Harmonic_function& harmonic,
                Level_function level = HARMONIC_LEVEL)
      : Curve_field_3(mesh) {
    const double slope = mean_slope(mesh, harmonic);
    for (Cell_index c : mesh.cells()) {
      m_cells[c].set_neighbors(mesh, c);
      m_cells[c].set_signs(flux.signs(c));
      set_rates(mesh, c, flux.rates(c), harmonic.gradient(c), level, slope);
    }
  }

  /// returns the rates in `c`.
  const Rates& rates(Cell_index c) const { return m_cells[c].rates; }

  /// returns +1 if curves enter `c` through facet `i`, -1 if they leave there, 0 if they are parallel to it.
  int sign(Cell_index c, int i) const { return m_cells[c].signs[i]; }

  /// returns the velocity in space, in units of length per level.
  Vector_3 vector(const Mesh& mesh, Cell_index c) const {
    Vector_3 v(0, 0, 0);
    const auto origin = internal::approximate(mesh.point(mesh.vertex(c, 0)));
    for (int i = 1; i < 4; ++i)
      v = v + CGAL::to_double(m_cells[c].rates[i]) * (internal::approximate(mesh.point(mesh.vertex(c, i))) - origin);
    return v;
  }

  /// tells whether the level of `c` grows as the harmonic function does.
  bool follows_harmonic_level(Cell_index c) const { return m_cells[c].follows_harmonic_level; }

#ifndef DOXYGEN_RUNNING
  // The facet through which most enters.
  int main_entry(Cell_index c) const {
    const Rates& r = m_cells[c].rates;
    return int(std::max_element(r.begin(), r.end()) - r.begin());
  }

  const internal::Curve_cell<FT>& cell(Cell_index c) const { return m_cells[c]; }
#endif

private:
  // Least cosine between a curve and grad f at which w still follows f.
  static constexpr double least_cosine = 0.1;
  // Least slope of w, in parts of the mean slope of f: keeps w growing in dead ends, where f is flat to rounding.
  static constexpr double least_relative_slope = 1e-3;

  using Cell = internal::Curve_cell<FT>;

  explicit Curve_field_3(const Mesh& mesh) : m_cells(mesh.number_of_cells()) {}

  template <typename Harmonic_function>
  static double mean_slope(const Mesh& mesh, const Harmonic_function& harmonic) {
    double sum = 0, volume = 0;
    for (Cell_index c : mesh.cells()) {
      const double v = internal::Cell_gradients(mesh, c).volume;
      sum += v * std::sqrt(harmonic.gradient(c).squared_length());
      volume += v;
    }
    return sum / volume;
  }

  static Eigen::Vector3d eigen(const Vector_3& v) { return {v.x(), v.y(), v.z()}; }

  static std::array<double, 4> nearest_rates(const internal::Cell_gradients& cell, const std::array<std::int8_t, 4>& signs,
                                             const Vector_3& wish, double least_slope) {
    if (wish == Vector_3(0, 0, 0)) return {double(signs[0]), double(signs[1]), double(signs[2]), double(signs[3])};
    std::array<Eigen::Vector3d, 4> normals;
    std::array<int, 4> facet_signs;
    for (int i = 0; i < 4; ++i) {
      normals[i] = eigen(cell.gradients[i]).normalized();
      facet_signs[i] = signs[i];
    }
    const double margin = least_slope * std::sqrt(wish.squared_length());
    const Eigen::Vector3d v = internal::Admissible_vectors(normals, facet_signs, margin).nearest_to(eigen(wish));
    std::array<double, 4> rates;
    for (int i = 0; i < 4; ++i) {
      const double height_rate = std::max(signs[i] * normals[i].dot(v), margin / 2); // the sign is kept whatever rounding did
      rates[i] = signs[i] * std::sqrt(cell.gradients[i].squared_length()) * height_rate;
    }
    return rates;
  }

  // Scales to the level function, then derives the rate of greatest size among the exits so that the sum is zero.
  void set_rates(const Mesh& mesh, Cell_index c, const std::array<double, 4>& rates, const Vector_3& gradient,
                 Level_function level, double slope) {
    Cell& cell = m_cells[c];
    for (int i = 0; i < 4; ++i) cell.rates[i] = FT(cell.signs[i] == 0 ? 0. : rates[i]);
    balance(cell);
    const double speed = level_speed(vector(mesh, c), gradient, level, slope, cell.follows_harmonic_level);
    for (int i = 0; i < 4; ++i) cell.rates[i] = cell.rates[i] / FT(speed);
    balance(cell);
  }

  // The exits take what the entries give: their rates are scaled to the same sum.
  static void balance(Cell& cell) {
    Rates& r = cell.rates;
    FT in(0), out(0);
    int largest = -1;
    for (int i = 0; i < 4; ++i) {
      if (cell.signs[i] > 0) in += r[i];
      if (cell.signs[i] < 0) {
        out -= r[i];
        if (largest < 0 || r[i] < r[largest]) largest = i;
      }
    }
    if (largest < 0 || in <= FT(0)) return;
    FT others(0);
    for (int i = 0; i < 4; ++i)
      if (cell.signs[i] < 0 && i != largest) {
        r[i] = r[i] * in / out;
        others -= r[i];
      }
    r[largest] = others - in;
  }

  static double level_speed(const Vector_3& v, const Vector_3& gradient, Level_function level, double slope, bool& follows) {
    const double speed = std::sqrt(v.squared_length());
    if (level == ARC_LENGTH_LEVEL) return speed > 0 ? speed : 1;
    const double least = std::max(least_cosine * std::sqrt(gradient.squared_length()), least_relative_slope * slope) * speed;
    const double growth = v * gradient;
    follows = growth >= least;
    return speed > 0 ? std::max(growth, least) : 1;
  }

  std::vector<Cell> m_cells;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CURVE_FIELD_3_H
