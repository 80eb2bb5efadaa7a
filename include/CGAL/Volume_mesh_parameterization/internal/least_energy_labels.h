// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LEAST_ENERGY_LABELS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LEAST_ENERGY_LABELS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>

// GCC takes values that Boost's maximal flow always sets for uninitialized.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

#include <CGAL/property_map.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

// Floor, ceiling and walls (all of them FIRST_WALL) of least energy: what facets cost, and how long the rims are.

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

using Label_costs =
    std::vector<std::array<double, 3>>; // by facet: of FLOOR, CEILING, FIRST_WALL, per unit of area

// The null vector for a facet without area.
inline Approximate_surface::Vector_3 unit_normal(const Approximate_surface& surface, Facet_index f) {
  return surface.areas[f] > 0 ? surface.area_vector(f) / surface.areas[f]
                              : Approximate_surface::Vector_3(0, 0, 0);
}

// With a unit direction d and the normal n of a facet, floor and ceiling cost 1 +- n d, walls |n d|: bevels of 45 degrees
// belong to the bases.
inline Label_costs costs_by_direction(const Approximate_surface& surface,
                                      const Approximate_surface::Vector_3& unit_direction) {
  Label_costs costs;
  costs.reserve(surface.areas.size());
  for (Facet_index f : surface.adjacency.facets()) {
    const double rise = unit_normal(surface, f) * unit_direction;
    costs.push_back({1 + rise, 1 - rise, std::abs(rise)});
  }
  return costs;
}

/*
The sum over facets of area * cost[label] and over rims of length * weight of the edge, minimized by alpha expansion:
Y. Boykov, O. Veksler, R. Zabih, Fast approximate energy minimization via graph cuts (2001). Areas are shares of the
surface's, lengths of its root: the labels do not depend on the unit of length.
*/
class Label_energy {
public:
  Label_energy(const Approximate_surface& surface, const Label_costs& costs)
      : m_surface(surface), m_dual(costs.size()) {
    m_costs.reserve(costs.size());
    for (Facet_index f : surface.adjacency.facets()) {
      m_costs.push_back(costs[f]);
      for (double& cost : m_costs.back()) cost *= surface.areas[f] / surface.total_area;
      for (int i = 0; i < 3; ++i)
        if (f < surface.adjacency.neighbor(f, i)) add_edge({f, i});
    }
  }

  // The implementation with Boost: CGAL's faster one, MaxFlow, does not reset its flow (up to CGAL 6.1 at least), and stops
  // after one expansion.
  std::vector<int> minimize() {
    std::vector<std::size_t> best;
    best.reserve(m_costs.size());
    for (const auto& c : m_costs) best.push_back(std::min_element(c.begin(), c.end()) - c.begin());
    alpha_expansion_graphcut(m_dual, get(boost::edge_weight, m_dual), CGAL::make_property_map(m_costs),
                             CGAL::make_property_map(best),
                             CGAL::parameters::vertex_index_map(get(boost::vertex_index, m_dual)));
    constexpr int label_of[] = {FLOOR, CEILING, FIRST_WALL};
    std::vector<int> labels;
    labels.reserve(best.size());
    for (std::size_t k : best) labels.push_back(label_of[k]);
    return labels;
  }

private:
  using Dual_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                           boost::property<boost::edge_weight_t, double>>;

  void add_edge(Facet_adjacency::Side s) {
    const Facet_index g = m_surface.adjacency.opposite(s).facet;
    const double length = std::sqrt(CGAL::squared_distance(m_surface.points[m_surface.adjacency.source(s)],
                                                           m_surface.points[m_surface.adjacency.target(s)]));
    boost::add_edge(s.facet, g, rim_cost * length / std::sqrt(m_surface.total_area) * weight(s.facet, g),
                    m_dual);
  }

  // With t the tangent of half the angle between the normals, 1 / (1 + (t / t0)^2): 1 on flat edges, 1/2 where normals
  // turn by 10 degrees, less than 1/100 on right-angled creases. Next to facets without a normal, rims may run as on these.
  double weight(Facet_index f, Facet_index g) const {
    constexpr double sharpness = 131; // 1 / t0^2
    const double cosine = unit_normal(m_surface, f) * unit_normal(m_surface, g);
    const double flat = std::max(0., 1 + cosine), folded = std::max(0., 1 - cosine);
    return flat / (flat + sharpness * folded);
  }

  static constexpr double rim_cost = .05;

  const Approximate_surface& m_surface;
  Label_costs m_costs; // of whole facets
  Dual_graph m_dual;   // its vertices are the facets
};

// All facets are walls on a surface whose area is zero or too large for a number.
inline std::vector<int> least_energy_labels(const Approximate_surface& surface, const Label_costs& costs) {
  const bool is_measurable = surface.total_area > 0 && std::isfinite(surface.total_area);
  return is_measurable ? Label_energy(surface, costs).minimize() : std::vector<int>(costs.size(), FIRST_WALL);
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LEAST_ENERGY_LABELS_H
