// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SORT_SPATIALLY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SORT_SPATIALLY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

// The numbers of the points, those from `first` on along a Hilbert curve.
inline std::vector<std::size_t> order_along_curve(const std::vector<Double_kernel::Point_3>& points,
                                                  std::size_t first = 0) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (points.empty()) return order; // there is no property map of no points
  const auto point_of = CGAL::make_property_map(points);
  using Traits = Spatial_sort_traits_adapter_3<Double_kernel, decltype(point_of)>;
  CGAL::hilbert_sort(order.begin() + first, order.end(), Traits(point_of));
  return order;
}

template <typename T>
void permute(std::vector<T>& values, const std::vector<std::size_t>& order) {
  std::vector<T> result;
  result.reserve(values.size());
  for (std::size_t i : order) result.push_back(std::move(values[i]));
  values.swap(result);
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationMesh

numbers the points and the cells of a mesh anew, along a curve that fills space: what is close in space is then mostly close
in memory as well, and all stages wait less for it. Meshers and refinement leave cells in an order that makes large meshes
two to three times as slow.

\tparam Point a point type of a \cgal kernel

\param soup a mesh; all vertex numbers are in range and coordinates are finite
\param number_of_points_to_keep how many of the first points keep their numbers, at most all

Complexity: \f$ O(n \log n) \f$.
*/
template <typename Point>
void sort_spatially(Tetrahedron_soup_3<Point>& soup, std::size_t number_of_points_to_keep = 0) {
  std::vector<internal::Double_kernel::Point_3> points, centroids;
  for (const Point& p : soup.points) points.push_back(internal::approximate(p));
  for (const auto& v : soup.cells)
    centroids.push_back(CGAL::centroid(points[v[0]], points[v[1]], points[v[2]], points[v[3]]));
  internal::permute(soup.cells, internal::order_along_curve(centroids));
  const std::vector<std::size_t> order = internal::order_along_curve(points, number_of_points_to_keep);
  internal::permute(soup.points, order);
  std::vector<std::size_t> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  for (auto& cell : soup.cells)
    for (std::size_t& v : cell) v = number[v];
  for (Labelled_facet& facet : soup.facets)
    for (std::size_t& v : facet.vertices) v = number[v];
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SORT_SPATIALLY_H
