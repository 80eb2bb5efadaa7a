// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_ALONG_LEVEL_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_ALONG_LEVEL_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Splits every edge at whose ends `values` lie on different sides of `level`; the new vertices get this level as their
// value. Afterwards no triangle has values on both sides.
inline void cut_along_level(Labelled_surface& labelled, Vertex_field& values, double level) {
  constexpr double least_part = .2; // splits closer to an end would make needles
  Refined_surface& surface = labelled.surface;
  std::vector<std::array<std::uint32_t, 2>> crossed;
  for (Refined_surface::Id h = 0; h < surface.number_of_half_edges(); ++h)
    if (values[surface.source(h)] < level && values[surface.target(h)] > level)
      crossed.push_back({surface.source(h), surface.target(h)});
  sort_longest_first(crossed, [&](std::uint32_t v) { return surface.points()[v]; });
  for (const auto& [v, w] : crossed) {
    const double part = (level - values[v]) / (values[w] - values[v]);
    labelled.split(v, w, std::clamp(part, least_part, 1 - least_part));
  }
  const Eigen::Index n = values.size();
  values.conservativeResize(Eigen::Index(surface.number_of_vertices()));
  values.tail(values.size() - n).setConstant(level);
}

// No facet has values on both sides of `level`.
inline std::vector<int> labels_by_level(const Facet_adjacency& surface, const Vertex_field& values,
                                        double level, int below, int above) {
  std::vector<int> labels;
  for (Facet_index f : surface.facets()) {
    const auto& t = surface.triangle(f);
    labels.push_back(std::min({values[t[0]], values[t[1]], values[t[2]]}) < level ? below : above);
  }
  return labels;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_CUT_ALONG_LEVEL_H
