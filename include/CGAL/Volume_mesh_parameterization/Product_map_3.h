// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PRODUCT_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PRODUCT_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is the map \f$ \varphi \f$ from a solid M to a prism P, and its inverse.

A point p of M goes down its curve to a floor point, which the floor map takes to (u, v). The share w of the level that
the curve has gained at p is kept: the image is (u, v, w times the height of P). In P the curves are vertical.

If the curves are certified and the floor map is bijective, so is \f$ \varphi \f$. With exact number types both directions
are exact, and \f$ \varphi^{-1}(\varphi(p)) = p \f$.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Product_map_3 {
public:
  using Curves = Integral_curves_3<GeomTraits>;
  using Floor_map = Floor_map_2<GeomTraits>;
  using Location = Location_3<GeomTraits>;
  using Base_point = Base_point_3<GeomTraits>;
  using FT = typename GeomTraits::FT;
  using Point_2 = typename GeomTraits::Point_2;
  using Point_3 = typename GeomTraits::Point_3;

  /// keeps references to what the arguments refer to, and to `floor_map`.
  Product_map_3(const Curves& curves, const Floor_map& floor_map) : m_curves(curves), m_floor_map(&floor_map) {}

  const Curves& curves() const { return m_curves; }
  const Floor_map& floor_map() const { return *m_floor_map; }

  /// computes \f$ \varphi(p) \f$.
  /// \returns `ERROR_CURVE_LOST`, for uncertified curves only
  Status image(const Location& p, Point_3& result) const {
    Base_point floor, ceiling;
    FT below, above;
    Status status = m_curves.trace_to_base(p, DOWN, floor, below);
    if (status.ok()) status = m_curves.trace_to_base(p, UP, ceiling, above);
    if (!status.ok()) return status;
    const Point_2 uv = m_floor_map->image(floor.facet, floor.barycentric);
    result = Point_3(uv.x(), uv.y(), height() * below / (below + above));
    return {};
  }

  /// computes \f$ \varphi^{-1}(q) \f$.
  /// \returns `ERROR_OUTSIDE` if q is not in P; `ERROR_CURVE_LOST`, for uncertified curves only
  Status preimage(const Point_3& q, Location& result) const {
    if (q.z() < FT(0) || q.z() > height()) return {ERROR_OUTSIDE, "the third coordinate is not in the height of the prism"};
    Base_point floor;
    Status status = m_floor_map->preimage(Point_2(q.x(), q.y()), floor);
    if (!status.ok()) return status;
    Integral_curve_3<GeomTraits> curve;
    status = m_curves.trace_curve(floor, curve);
    if (status.ok()) result = curve.at(q.z() / height() * curve.total_level());
    return status;
  }

  /// appends the preimages of the points of the vertical line over `uv` at heights 0, 1 / `layers`, …, 1.
  Status column(const Point_2& uv, std::size_t layers, std::vector<Point_3>& points) const {
    Base_point floor;
    Status status = m_floor_map->preimage(uv, floor);
    Integral_curve_3<GeomTraits> curve;
    if (status.ok()) status = m_curves.trace_curve(floor, curve);
    if (!status.ok()) return status;
    const FT total = curve.total_level();
    for (std::size_t k = 0; k < layers; ++k) points.push_back(curve.at(total * FT(int(k)) / FT(int(layers))).point(mesh()));
    points.push_back(curve.segments().back().end.point(mesh()));
    return {};
  }

  /// computes the images of all vertices of M.
  /// \returns `ERROR_CURVE_LOST`, for uncertified curves only; then `images` is left as it was
  Status vertex_images(std::vector<Point_3>& images) const {
    const internal::Vertex_stars stars(mesh());
    std::vector<Point_3> result(mesh().number_of_vertices());
    for (Vertex_index v : mesh().vertices()) {
      const Status status = image(location(*stars.cells(v).begin(), v), result[v]);
      if (!status.ok()) return status;
    }
    images = std::move(result);
    return {};
  }

private:
  const Compact_tetrahedral_mesh_3<GeomTraits>& mesh() const { return m_curves.mesh(); }
  FT height() const { return FT(m_floor_map->domain().height()); }

  Location location(Cell_index c, Vertex_index v) const {
    Location result{c, {FT(0), FT(0), FT(0), FT(0)}};
    result.barycentric[mesh().index(c, v)] = FT(1);
    return result;
  }

  Curves m_curves;
  const Floor_map* m_floor_map;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PRODUCT_MAP_3_H
