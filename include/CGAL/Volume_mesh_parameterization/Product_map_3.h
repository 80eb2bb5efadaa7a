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
#include <CGAL/Volume_mesh_parameterization/internal/Chart_tracer.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/order_by_feet.h>

#include <boost/range/irange.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is the map \f$ \varphi \f$ from a solid M to a domain P, and its inverse.

A point p of M goes down its curve to a floor point, which the floor map takes to a floor point of P. The share of the
level that the curve has gained at p is kept: the image is the point over that floor point at this share of the way up.

If the curves of both solids are certified and the floor map is bijective, so is \f$ \varphi \f$. With exact number types
both directions are exact, and \f$ \varphi^{-1}(\varphi(p)) = p \f$.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam FloorMap a model of `VolumeFloorMap_3`
*/
template <typename GeomTraits, typename FloorMap = Floor_map_2<GeomTraits>>
class Product_map_3 {
public:
  using Curves = Integral_curves_3<GeomTraits>;     ///< the curves of the solid
  using Floor_map = FloorMap;                       ///< a model of `VolumeFloorMap_3`
  using Domain = typename FloorMap::Domain;         ///< a model of `ParameterDomain_3`
  using Floor_point = typename Domain::Floor_point; ///< a point of the floor of the domain
  using Location = Location_3<GeomTraits>;          ///< a point of the solid
  using Base_point = Base_point_3<GeomTraits>;      ///< a point of the floor of the solid
  using FT = typename GeomTraits::FT;               ///< the number type
  using Point_3 = typename GeomTraits::Point_3;     ///< the point type

  /// keeps references to what the arguments refer to, and to `floor_map`.
  Product_map_3(const Curves& curves, const Floor_map& floor_map)
      : m_curves(curves), m_floor_map(&floor_map) {}

  /// returns the curves of the solid.
  const Curves& curves() const { return m_curves; }
  /// returns the map of the floor.
  const Floor_map& floor_map() const { return *m_floor_map; }
  /// returns what the solid is mapped to.
  const Domain& domain() const { return m_floor_map->domain(); }

  /// computes \f$ \varphi(p) \f$.
  /// \returns `ERROR_CURVE_LOST`, for uncertified curves only
  Status image(const Location& p, Point_3& result) const {
    Base_point floor, ceiling;
    FT below, above;
    Status status = m_curves.trace_to_base(p, DOWN, floor, below);
    if (status.ok()) status = m_curves.trace_to_base(p, UP, ceiling, above);
    return status.ok() ? domain().point(m_floor_map->image(floor), below / (below + above), result) : status;
  }

  /// computes \f$ \varphi^{-1}(q) \f$.
  /// \returns `ERROR_OUTSIDE` if q is not in P; `ERROR_CURVE_LOST`, for uncertified curves only
  Status preimage(const Point_3& q, Location& result) const {
    Floor_point foot;
    FT share(0);
    Integral_curve_3<GeomTraits> curve;
    Status status = domain().locate(q, foot, share);
    if (status.ok()) status = curve_over(foot, curve);
    if (status.ok()) result = curve.at(share * curve.total_level());
    return status;
  }

  /// computes the curve of M whose image stands on `foot`, a point of the floor of P.
  Status curve_over(const Floor_point& foot, Integral_curve_3<GeomTraits>& curve) const {
    Base_point floor;
    const Status status = m_floor_map->preimage(foot, floor);
    return status.ok() ? m_curves.trace_curve(floor, curve) : status;
  }

  /// appends the preimages of the points over `foot` at these shares of the way up, the first of which is 0 and the last 1.
  Status column(const Floor_point& foot, const std::vector<double>& shares,
                std::vector<Point_3>& points) const {
    Integral_curve_3<GeomTraits> curve;
    const Status status = curve_over(foot, curve);
    if (!status.ok()) return status;
    const FT total = curve.total_level();
    for (std::size_t k = 0; k + 1 < shares.size(); ++k)
      points.push_back(curve.at(total * FT(shares[k])).point(mesh()));
    points.push_back(curve.segments().back().end.point(mesh()));
    return {};
  }

  /// \name Batches
  /// `ConcurrencyTag` is `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it.
  /// If `FT` is no floating point type, one thread does all. If a point fails, the failure of the first one that does is
  /// returned, and `result` is left as it was.
  /// @{

  /// computes \f$ \varphi \f$ at points.
  /// \returns `ERROR_CURVE_LOST`, for uncertified curves only
  template <typename ConcurrencyTag = Sequential_tag>
  Status images(const std::vector<Location>& points, std::vector<Point_3>& result) const {
    return trace_each<ConcurrencyTag>(points.size(), result, [&](std::size_t i) { return points[i]; });
  }

  /// computes \f$ \varphi^{-1} \f$ at points.
  /// \returns `ERROR_OUTSIDE`; `ERROR_CURVE_LOST`, for uncertified curves only
  template <typename ConcurrencyTag = Sequential_tag>
  Status preimages(const std::vector<Point_3>& points, std::vector<Location>& result) const {
    return map_each<ConcurrencyTag>(boost::irange(std::size_t(0), points.size()), result,
                                    [&](std::size_t i, Location& p) { return preimage(points[i], p); });
  }

  /// computes the images of all vertices of M.
  /// \returns `ERROR_CURVE_LOST`, for uncertified curves only
  template <typename ConcurrencyTag = Sequential_tag>
  Status vertex_images(std::vector<Point_3>& result) const {
    std::vector<Cell_index> cells(mesh().number_of_vertices());
    for (Cell_index c : mesh().cells())
      for (Vertex_index v : mesh().cell(c))
        if (!cells[v].is_valid()) cells[v] = c;
    return trace_each<ConcurrencyTag>(cells.size(), result,
                                      [&](std::size_t v) { return location(cells[v], Vertex_index(v)); });
  }

  /// @}

private:
  const Compact_tetrahedral_mesh_3<GeomTraits>& mesh() const { return m_curves.mesh(); }

  template <typename ConcurrencyTag, typename LocationOf>
  Status trace_each(std::size_t n, std::vector<Point_3>& result, const LocationOf& location) const {
    const auto order = internal::order_by_feet(mesh(), m_curves.field(), n, [&](std::size_t i) { return location(i).cell; });
    std::vector<Point_3> values(n);
    const auto place = [&](std::size_t k) { return location(order[k]); };
    const auto map = [&](std::size_t k, const Curve_chart_3<GeomTraits>& chart) {
      return domain().point(m_floor_map->image(chart.floor), chart.share(), values[order[k]]).ok();
    };
    if (!internal::for_each_chart<ConcurrencyTag>(m_curves, n, place, map)) // once more, to know which one fails
      return map_each<ConcurrencyTag>(order, result, [&](std::size_t i, Point_3& q) { return image(location(i), q); });
    result = std::move(values);
    return {};
  }

  template <typename ConcurrencyTag, typename Order, typename Result, typename Map>
  static Status map_each(const Order& order, std::vector<Result>& result, const Map& map) {
    std::vector<Result> values(order.size());
    using Tag = internal::Concurrency_for<ConcurrencyTag, FT>;
    const Status status =
        internal::try_each_in_order<Tag>(order, [&](std::size_t i) { return map(i, values[i]); });
    if (status.ok()) result = std::move(values);
    return status;
  }

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
