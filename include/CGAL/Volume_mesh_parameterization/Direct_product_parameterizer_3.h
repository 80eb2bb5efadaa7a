// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_PARAMETERIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_PARAMETERIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_images_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_3.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

parameterizes a handlebody with a labelled boundary over a domain: makes it a direct product, maps its floor, joins both
to the map of the solid. Every stage leaves its result here, so that what holds can be used even if a later stage fails.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
\tparam FloorMap a model of `VolumeFloorMap_3`: `Floor_map_2`, which finds a prism for the solid, or `Boundary_map_3`, for a
given polycube
*/
template <typename GeomTraits, typename Solver = Default_solver_traits_3, typename FloorMap = Floor_map_2<GeomTraits>>
class Direct_product_parameterizer_3 : public Direct_product_3<GeomTraits, Solver> {
  using Base = Direct_product_3<GeomTraits, Solver>;

public:
  using Geom_traits = GeomTraits;                          ///< a model of `VolumeParameterizationTraits_3`
  using Point_3 = typename GeomTraits::Point_3;            ///< the point type
  using Floor_map = FloorMap;                              ///< a model of `VolumeFloorMap_3`
  using Product_map = Product_map_3<GeomTraits, FloorMap>; ///< the map and its inverse

  Direct_product_parameterizer_3() = default;
  /// \param floor_map what is to map the floor; a `Boundary_map_3` knows the polycube and the images of the boundary
  explicit Direct_product_parameterizer_3(FloorMap floor_map) : m_floor_map(std::move(floor_map)) {}

  /*!
  runs all stages. The object may be used once.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; results do not depend on it.
  For kernels whose `FT` is no floating point type, one thread does all.
  \tparam TetrahedralMesh a model of `TetrahedralMesh_3`
  \param mesh a handlebody whose boundary facets are labelled
  \param np an optional sequence of named parameters among those of `parameterize()`

  \returns the failure of the first stage that failed
  */
  template <typename ConcurrencyTag = Sequential_tag, typename TetrahedralMesh,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Status run(const TetrahedralMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
    auto visitor = Base::visitor_of(np);
    Status status = Base::template build<ConcurrencyTag>(mesh, np, visitor);
    if (status.ok()) status = internal::run_stage(visitor, "map the floor", [&] { return map_floor(); });
    if (status.ok())
      status = internal::run_stage(visitor, "map the vertices",
                                   [&] { return m_product_map->template vertex_images<ConcurrencyTag>(m_vertex_images); });
    return status;
  }

  /*!
  maps the boundary piecewise linearly by the floor map's function of this name, and the vertices once more, as the floor map
  may have changed. `make_piecewise_linear()` calls it.

  \pre `run()` has succeeded
  \returns the failure of the floor map; then nothing is changed; `ERROR_CURVE_LOST`, for `FLUX_CURVES` only
  */
  template <typename ConcurrencyTag = Sequential_tag>
  Status map_boundary(Boundary_images_3<GeomTraits>& boundary) {
    const Status status = m_floor_map.map_boundary(this->mesh(), m_vertex_images, boundary);
    return status.ok() ? m_product_map->template vertex_images<ConcurrencyTag>(m_vertex_images) : status;
  }

  /// \name Results
  /// Pointers are null, and vectors empty, if their stage was not reached or failed.
  /// @{

  /// returns the map of the floor; its function `domain()` returns what the solid is mapped to.
  const Floor_map* floor_map() const { return m_product_map ? &m_floor_map : nullptr; }
  /// returns the map of the solid, and its inverse.
  const Product_map* product_map() const { return Base::pointer(m_product_map); }
  /// The images of all vertices of `mesh()` in the domain.
  const std::vector<Point_3>& vertex_images() const { return m_vertex_images; }

  /// @}

private:
  Status map_floor() {
    const Status status = m_floor_map.build(this->mesh());
    if (status.ok()) m_product_map.emplace(this->curves(), m_floor_map);
    return status;
  }

  FloorMap m_floor_map;
  std::optional<Product_map> m_product_map;
  std::vector<Point_3> m_vertex_images;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_PARAMETERIZER_3_H
