// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_COMPUTE_CHARTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_COMPUTE_CHARTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Curve_chart_3.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Chart_tracer.h>
#include <CGAL/Volume_mesh_parameterization/internal/order_by_feet.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

computes the charts of many points: the ends of the curves through them, and their levels, the same to the bit as
`Integral_curves_3::trace_to_base()` finds them one after the other. Points are sorted by where their curves start, roughly, so
that many of the cells of a curve are still in the cache.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it. If
`FT` is no floating point type, one thread does all.
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\param curves the curves of a solid
\param points of that solid
\param charts receives one for each point; on failure it is left as it was

\returns `ERROR_CURVE_LOST` of the first point whose curve does not arrive, for uncertified fields only

Complexity: linear in the number of cells of the solid, and of those that the curves pass.
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits>
Status compute_charts(const Integral_curves_3<GeomTraits>& curves, const std::vector<Location_3<GeomTraits>>& points,
                      std::vector<Curve_chart_3<GeomTraits>>& charts) {
  const auto order =
      internal::order_by_feet(curves.mesh(), curves.field(), points.size(), [&](std::size_t i) { return points[i].cell; });
  std::vector<Curve_chart_3<GeomTraits>> result(points.size());
  const auto point = [&](std::size_t k) { return points[order[k]]; };
  const auto keep = [&](std::size_t k, Curve_chart_3<GeomTraits>& chart) {
    result[order[k]] = std::move(chart);
    return true;
  };
  if (internal::for_each_chart<ConcurrencyTag>(curves, points.size(), point, keep)) {
    charts = std::move(result);
    return {};
  }
  Status status; // once more, one after the other, to know which one fails
  for (std::size_t i = 0; i < points.size() && status.ok(); ++i) {
    status = curves.trace_to_base(points[i], DOWN, result[i].floor, result[i].below);
    if (status.ok()) status = curves.trace_to_base(points[i], UP, result[i].ceiling, result[i].above);
  }
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_COMPUTE_CHARTS_H
