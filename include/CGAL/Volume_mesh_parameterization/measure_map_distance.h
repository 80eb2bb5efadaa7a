// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_MAP_DISTANCE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_MAP_DISTANCE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>

#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

tells how far a piecewise linear map is from \f$ \varphi \f$, in lengths of the domain.
*/
struct Map_distance {
  Weighted_statistics at_vertices;    ///< each vertex counts the same
  Weighted_statistics at_barycentres; ///< of the tetrahedra, weighted by their volumes
};

namespace internal {

template <typename Point>
std::vector<double> distances(const std::vector<Point>& p, const std::vector<Point>& q) {
  std::vector<double> result;
  result.reserve(p.size());
  for (std::size_t i = 0; i < p.size(); ++i)
    result.push_back(std::sqrt(CGAL::to_double(CGAL::squared_distance(p[i], q[i]))));
  return result;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

measures the distance between \f$ \varphi \f$ and the map that is linear on each tetrahedron and takes vertex \f$ v \f$ of the
solid to `images[v]`: at the vertices, where it is zero for `Product_map_3::vertex_images()`, and at the barycentres.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\param map \f$ \varphi \f$
\param images one for each vertex
\param distance receives the statistics; on failure it is left as it was

\returns `ERROR_WRONG_PARAMETER` if there are more or fewer images; the errors of `Product_map_3::images()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename FloorMap>
Status measure_map_distance(const Product_map_3<GeomTraits, FloorMap>& map,
                            const std::vector<typename GeomTraits::Point_3>& images, Map_distance& distance) {
  using FT = typename GeomTraits::FT;
  using Point_3 = typename GeomTraits::Point_3;
  const Compact_tetrahedral_mesh_3<GeomTraits>& mesh = map.curves().mesh();
  if (images.size() != mesh.number_of_vertices())
    return {ERROR_WRONG_PARAMETER, std::to_string(images.size()) + " images for " +
                                       std::to_string(mesh.number_of_vertices()) + " vertices"};
  std::vector<Location_3<GeomTraits>> barycentres;
  std::vector<Point_3> linear, exact, exact_at_vertices;
  std::vector<double> volumes;
  for (Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    barycentres.push_back({c, {FT(.25), FT(.25), FT(.25), FT(.25)}});
    linear.push_back(CGAL::centroid(images[v[0]], images[v[1]], images[v[2]], images[v[3]]));
    volumes.push_back(internal::Cell_gradients(mesh, c).volume);
  }
  Status status = map.template vertex_images<ConcurrencyTag>(exact_at_vertices);
  if (status.ok()) status = map.template images<ConcurrencyTag>(barycentres, exact);
  if (!status.ok()) return status;
  const std::vector<double> ones(images.size(), 1.);
  distance.at_vertices = Weighted_statistics(internal::distances(images, exact_at_vertices), ones);
  distance.at_barycentres = Weighted_statistics(internal::distances(linear, exact), volumes);
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_MAP_DISTANCE_H
