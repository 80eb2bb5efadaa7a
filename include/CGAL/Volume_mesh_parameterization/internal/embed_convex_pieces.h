// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EMBED_CONVEX_PIECES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EMBED_CONVEX_PIECES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/tutte_embedding.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Embeds pieces of a surface whose borders are fixed along convex polygons. In theory any positive weights do; in doubles,
bulges behind a neck shrink beyond the precision of numbers, and other weights may help. `area(k)` is the signed area of
the image of triangle k, `count_flipped()` counts those that are not positive by exact signs.
*/
template <typename Point, typename Area, typename CountFlipped>
Status embed_convex_pieces(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                           const std::vector<Double_kernel::Point_3>& points,
                           const std::vector<char>& is_fixed, const Area& area,
                           const CountFlipped& count_flipped, std::vector<Point>& images) {
  constexpr int most_attempts = 30;
  Status status = tutte_embedding(triangles, is_fixed, Mean_value_weights{points}, images);
  if (!status.ok() || count_flipped() == 0) return status;
  status = tutte_embedding(triangles, is_fixed, Uniform_weights(), images);
  Stretch_weights weights(points.size());
  for (int i = 0; i < most_attempts && status.ok() && count_flipped() > 0; ++i) {
    weights.adapt(triangles, points, area);
    status = tutte_embedding(triangles, is_fixed, weights, images);
  }
  return status;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_EMBED_CONVEX_PIECES_H
