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
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_places.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>

#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
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

// The barycentre of a refined cell in the cell that it is a part of. places: of the vertices of the refined mesh
template <typename GeomTraits>
Location_3<GeomTraits> barycentre(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh, Cell_index origin,
                                  const std::array<Vertex_index, 4>& refined_cell,
                                  const std::vector<Location_3<GeomTraits>>& places) {
  using FT = typename GeomTraits::FT;
  Location_3<GeomTraits> result{origin, {FT(0), FT(0), FT(0), FT(0)}};
  for (Vertex_index v : refined_cell)
    for (int i = 0; i < 4; ++i) {
      const FT& share = places[v].barycentric[i];
      if (share != FT(0))
        result.barycentric[mesh.index(origin, mesh.vertex(places[v].cell, i))] += share / FT(4);
    }
  return result;
}

template <typename ConcurrencyTag, typename GeomTraits, typename FloorMap>
Status measure_distance(const Product_map_3<GeomTraits, FloorMap>& map,
                        const std::vector<Location_3<GeomTraits>>& places,
                        const std::vector<typename GeomTraits::Point_3>& images,
                        const std::vector<double>& weights, Weighted_statistics& result) {
  std::vector<typename GeomTraits::Point_3> exact;
  const Status status = map.template images<ConcurrencyTag>(places, exact);
  if (!status.ok()) return status;
  std::vector<double> distances;
  distances.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    distances.push_back(std::sqrt(CGAL::to_double(CGAL::squared_distance(images[i], exact[i]))));
  result = Weighted_statistics(distances, weights);
  return status;
}

// refined: the mesh of the map, some simplices of which were split, on which the other map is linear
template <typename ConcurrencyTag, typename GeomTraits, typename FloorMap>
Status measure_distance(const Product_map_3<GeomTraits, FloorMap>& map,
                        const Compact_tetrahedral_mesh_3<GeomTraits>& refined,
                        const std::vector<typename GeomTraits::Point_3>& images, Map_distance& distance) {
  const Compact_tetrahedral_mesh_3<GeomTraits>& mesh = map.curves().mesh();
  const Refined_places<GeomTraits> places(mesh, refined);
  std::vector<Location_3<GeomTraits>> vertices, barycentres;
  std::vector<typename GeomTraits::Point_3> linear;
  for (Vertex_index v : refined.vertices()) vertices.push_back(places.location(v));
  for (Cell_index c : refined.cells()) {
    const auto& v = refined.cell(c);
    barycentres.push_back(barycentre(mesh, places.origin(v), v, vertices));
    linear.push_back(CGAL::centroid(images[v[0]], images[v[1]], images[v[2]], images[v[3]]));
  }
  const std::vector<double> ones(images.size(), 1.), volumes = measure_volumes(refined, refined.points());
  Map_distance result;
  Status status = measure_distance<ConcurrencyTag>(map, vertices, images, ones, result.at_vertices);
  if (status.ok())
    status = measure_distance<ConcurrencyTag>(map, barycentres, linear, volumes, result.at_barycentres);
  if (status.ok()) distance = std::move(result);
  return status;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

measures the distance between \f$ \varphi \f$ and the map that is linear on each tetrahedron and takes vertex \f$ v \f$ of the
solid to `images[v]`: at the vertices, where it is zero for `Product_map_3::vertex_images()`, and at the barycentres.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam FloorMap a model of `VolumeFloorMap_3`
\param map \f$ \varphi \f$
\param images one for each vertex
\param distance receives the statistics; on failure it is left as it was

\returns `ERROR_WRONG_PARAMETER` if there are more or fewer images; the errors of `Product_map_3::images()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename FloorMap>
Status measure_map_distance(const Product_map_3<GeomTraits, FloorMap>& map,
                            const std::vector<typename GeomTraits::Point_3>& images, Map_distance& distance) {
  const Compact_tetrahedral_mesh_3<GeomTraits>& mesh = map.curves().mesh();
  if (images.size() != mesh.number_of_vertices())
    return {ERROR_WRONG_PARAMETER, std::to_string(images.size()) + " images for " +
                                       std::to_string(mesh.number_of_vertices()) + " vertices"};
  return internal::measure_distance<ConcurrencyTag>(map, mesh, images, distance);
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

measures the distance between \f$ \varphi \f$ and a piecewise linear bijection from the same solid to the same domain, at the
vertices and the barycentres of the mesh of the latter.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam FloorMap a model of `VolumeFloorMap_3`
\param map \f$ \varphi \f$
\param linear what `make_piecewise_linear()` computed for the solid of `map`
\param distance receives the statistics; on failure it is left as it was

\returns `ERROR_WRONG_PARAMETER` if `linear` is not valid; the errors of `Product_map_3::images()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename FloorMap>
Status measure_map_distance(const Product_map_3<GeomTraits, FloorMap>& map,
                            const Piecewise_linear_map_3<GeomTraits>& linear, Map_distance& distance) {
  if (!linear.is_valid()) return {ERROR_WRONG_PARAMETER, "there is no piecewise linear map"};
  return internal::measure_distance<ConcurrencyTag>(map, linear.mesh(), linear.images(), distance);
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_MAP_DISTANCE_H
