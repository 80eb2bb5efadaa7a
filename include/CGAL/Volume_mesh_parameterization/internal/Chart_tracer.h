// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHART_TRACER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHART_TRACER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Curve_chart_3.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Computes the charts of a few points. Their curves are followed by turns, a step of each: a step has to wait for divisions
// and memory, and meanwhile a processor can begin those of other curves.
template <typename GeomTraits, typename LocationOf>
class Chart_tracer {
public:
  using Chart = Curve_chart_3<GeomTraits>;
  using Curves = Integral_curves_3<GeomTraits>;

  // Of the points location_of(i) for i < n, the first one being `first`.
  Chart_tracer(const Curves& curves, const LocationOf& location_of, std::size_t first, std::size_t n)
      : m_curves(curves), m_location_of(location_of), m_first(first), m_size(n) {}

  // Writes the charts of all points; returns whether all curves arrive. Charts of those that do not are of no use.
  template <typename Charts>
  bool run(Charts& charts) {
    std::array<Walker, number_of_walkers> walkers;
    bool do_all_walk = true;
    for (int k = 0; k < number_of_walkers; ++k) do_all_walk &= start(walkers[k], std::size_t(k / 2));
    while (do_all_walk)
      for (int k = 0; k < number_of_walkers; ++k) do_all_walk &= walk(walkers[k], direction(k), charts);
    for (int k = 0; k < number_of_walkers; ++k)
      while (walkers[k].point < m_size) walk(walkers[k], direction(k), charts);
    return !m_is_one_lost;
  }

private:
  using FT = typename GeomTraits::FT;
  using Location = Location_3<GeomTraits>;

  // On the way from one point to a base; then from another point.
  struct Walker {
    Location at;
    FT elapsed;
    std::size_t point, steps;
  };

  // Two downwards and two upwards: more did not make it faster.
  static constexpr int number_of_walkers = 4;
  static Curve_direction direction(int walker) { return walker % 2 == 0 ? DOWN : UP; }

  // returns whether there is such a point
  bool start(Walker& walker, std::size_t point) const {
    walker.point = point;
    walker.steps = 0;
    walker.elapsed = FT(0);
    if (point < m_size) walker.at = m_location_of(m_first + point);
    return point < m_size;
  }

  // Goes through a cell; returns whether there is anything left to do for this walker. A curve that passes more cells than
  // there are is lost, in whatever cell it is then.
  template <typename Charts>
  bool walk(Walker& walker, Curve_direction direction, Charts& charts) {
    const auto& cell = m_curves.field().cell(walker.at.cell);
    const auto fetch = [this](Cell_index c) { prefetch(&m_curves.field().cell(c)); };
    const auto [exit, time] = cell.exit_of(walker.at.barycentric, direction, fetch);
    if (exit >= 0 && walker.steps++ <= m_curves.mesh().number_of_cells()) {
      auto end = cell.moved(walker.at.barycentric, FT(int(direction)) * time);
      end[exit] = FT(0);
      walker.elapsed += time;
      if (cell.neighbors[exit].is_valid()) {
        walker.at.cell = cell.neighbors[exit];
        cell.enter_neighbor(exit, end, walker.at.barycentric);
        return true;
      }
      walker.at.barycentric = end;
    }
    arrive(walker, exit, direction, charts[walker.point]);
    return start(walker, walker.point + number_of_walkers / 2);
  }

  void arrive(const Walker& walker, int exit, Curve_direction direction, Chart& chart) {
    const int base = direction == DOWN ? FLOOR : CEILING;
    if (exit < 0 || m_curves.mesh().label(walker.at.cell, exit) != base) {
      m_is_one_lost = true;
      return;
    }
    (direction == DOWN ? chart.floor : chart.ceiling) = m_curves.base_point(walker.at, {walker.at.cell, exit});
    (direction == DOWN ? chart.below : chart.above) = walker.elapsed;
  }

  const Curves& m_curves;
  const LocationOf& m_location_of;
  std::size_t m_first, m_size;
  bool m_is_one_lost = false;
};

// Calls use(i, chart), which returns whether it succeeds, for the chart of location_of(i), i < n, in any order. Returns
// whether all curves arrived and all calls succeeded; if not, some may have been left out.
template <typename ConcurrencyTag, typename GeomTraits, typename LocationOf, typename Use>
bool for_each_chart(const Integral_curves_3<GeomTraits>& curves, std::size_t n, const LocationOf& location_of, const Use& use) {
  constexpr std::size_t size_of_block = 128;
  const Index_blocks blocks(n, size_of_block);
  std::atomic<bool> is_good(true);
  for_each_index<Concurrency_for<ConcurrencyTag, typename GeomTraits::FT>>(blocks.size(), [&](std::size_t b) {
    if (!is_good) return;
    const auto block = blocks[b];
    const std::size_t first = *block.begin();
    std::array<Curve_chart_3<GeomTraits>, size_of_block> charts;
    bool succeeds = Chart_tracer<GeomTraits, LocationOf>(curves, location_of, first, block.size()).run(charts);
    for (std::size_t i : block) succeeds = succeeds && use(i, charts[i - first]);
    if (!succeeds) is_good = false;
  }, 1);
  return is_good;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CHART_TRACER_H
