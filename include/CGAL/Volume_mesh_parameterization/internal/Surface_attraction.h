// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_ATTRACTION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_ATTRACTION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/internal/Star_energy.h>

#include <CGAL/number_utils.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A point of a quadrilateral, as a mean of its nodes, and the place on the surface where it should be.
struct Attraction {
  std::array<std::size_t, 4> nodes;
  std::array<double, 4> weights;
  Eigen::Vector3d place;
  double distance; // between quadrilateral and surface there
};

// The energy of points that are not at their places: (|r| / unit)^power for each, where r is the way that is left. With the
// power and a unit of the energy of corners, both are looked after alike.
class Surface_attraction {
  using Vector = Eigen::Vector3d;
  using Nodes = std::vector<Vector>;

public:
  // Of nothing.
  Surface_attraction() = default;

  // The power is even.
  Surface_attraction(std::vector<Attraction> attractions, std::size_t number_of_nodes, int power, double unit)
      : m_attractions(std::move(attractions)),
        m_stars(number_of_nodes, m_attractions.size(), [this](std::size_t a) { return m_attractions[a].nodes; }),
        m_half_power(power / 2),
        m_squared_unit(unit * unit) {}

  // Of the points that node v has a share in.
  double operator()(std::size_t v, const Nodes& nodes) const {
    double sum = 0;
    if (m_attractions.empty()) return sum;
    for (std::size_t a : m_stars[v])
      sum += CGAL::ipower(way(m_attractions[a], nodes).squaredNorm() / m_squared_unit, m_half_power);
    return sum;
  }

  // Adds value and derivatives by the position of node v.
  void add_to(Star_energy::Derivatives& sum, std::size_t v, const Nodes& nodes) const {
    if (m_attractions.empty()) return;
    for (std::size_t a : m_stars[v]) {
      const Vector r = way(m_attractions[a], nodes);
      const double weight = weight_of(v, m_attractions[a]), s = r.squaredNorm() / m_squared_unit;
      const double f1 = m_half_power * CGAL::ipower(s, m_half_power - 1);
      const double f2 = m_half_power > 1 ? m_half_power * (m_half_power - 1) * CGAL::ipower(s, m_half_power - 2) : 0;
      const Vector ds = 2 * weight / m_squared_unit * r;
      sum.value += CGAL::ipower(s, m_half_power);
      sum.gradient += f1 * ds;
      sum.hessian += f2 * ds * ds.transpose();
      sum.hessian.diagonal().array() += f1 * 2 * weight * weight / m_squared_unit;
    }
  }

private:
  static Vector way(const Attraction& a, const Nodes& nodes) {
    Vector result = -a.place;
    for (int i = 0; i < 4; ++i) result += a.weights[i] * nodes[a.nodes[i]];
    return result;
  }

  static double weight_of(std::size_t v, const Attraction& a) {
    double result = 0;
    for (int i = 0; i < 4; ++i)
      if (a.nodes[i] == v) result = a.weights[i];
    return result;
  }

  std::vector<Attraction> m_attractions;
  Incidence_lists<std::size_t, std::size_t> m_stars; // those of each node
  int m_half_power = 1;
  double m_squared_unit = 1;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_ATTRACTION_H
