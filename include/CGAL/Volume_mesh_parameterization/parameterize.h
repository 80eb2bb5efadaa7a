// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Partition_sequence_3.h>
#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>
#include <CGAL/Volume_mesh_parameterization/remesh_thin_triangles.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

maps a solid with a labelled boundary one to one onto a prism, or onto a given domain.

For a given polycube, build a `Polycube_3`, make a `Boundary_map_3` of it and of the images of the vertices on the boundary,
call its function `label_boundary()` for the mesh, and construct `result` with it.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; results do not depend on it. For
  kernels whose `FT` is no floating point type, one thread does all.
\tparam TetrahedralMesh a model of `TetrahedralMesh_3`
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
\tparam FloorMap a model of `VolumeFloorMap_3`
\tparam NamedParameters a sequence of named parameters

\param mesh a handlebody whose boundary facets are labelled: 1 floor, 2 ceiling, 3 + k wall k. `partition_boundary()` finds
labels for one that has none
\param result receives what every stage computes; may be used once
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is told which stage begins, and may stop; copies are used, so what it counts must be elsewhere}
    \cgalParamType{a class with the functions of `Default_parameterization_visitor`}
    \cgalParamDefault{`Default_parameterization_visitor()`}
  \cgalParamNEnd
  \cgalParamNBegin{curve_type}
    \cgalParamDescription{the curves that the map follows}
    \cgalParamType{`Curve_type`}
    \cgalParamDefault{`CERTIFIED_CURVES`}
  \cgalParamNEnd
  \cgalParamNBegin{level_function}
    \cgalParamDescription{what the third coordinate measures along a curve}
    \cgalParamType{`Level_function`}
    \cgalParamDefault{`HARMONIC_LEVEL`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the failure of the first stage that failed: the errors of `Compact_tetrahedral_mesh_3::assign()`,
`check_tetrahedral_mesh()`, `validate_partition()`, `prepare_patches()`, `certify_handlebody()`,
`validate_fundamental_group()`, `sweep()` and `FloorMap::build()`; `ERROR_CANNOT_SOLVE`; for `FLUX_CURVES` also
`ERROR_CURVE_LOST`; `ERROR_CANCELLED` if the visitor stopped
*/
template <typename ConcurrencyTag = Sequential_tag, typename TetrahedralMesh, typename GeomTraits, typename Solver,
          typename FloorMap, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status parameterize(const TetrahedralMesh& mesh, Direct_product_parameterizer_3<GeomTraits, Solver, FloorMap>& result,
                    const NamedParameters& np = CGAL::parameters::default_values()) {
  return result.template run<ConcurrencyTag>(mesh, np);
}

namespace internal {

inline std::vector<Sweep_direction_3> directions_to_try(CGAL::internal_np::Param_not_found) { return {}; }

template <typename Vector>
std::vector<Sweep_direction_3> directions_to_try(const Vector& given) {
  return {
      Sweep_direction_3(CGAL::to_double(given.x()), CGAL::to_double(given.y()), CGAL::to_double(given.z()))};
}

// Over the first partition.
template <typename ConcurrencyTag, typename GeomTraits, typename Solver, typename FloorMap, typename NamedParameters,
          typename Visitor>
Status parameterize_over(Partition_sequence_3<GeomTraits>& partitions,
                         Direct_product_parameterizer_3<GeomTraits, Solver, FloorMap>& result, const NamedParameters& np,
                         Visitor& visitor) {
  Compact_tetrahedral_mesh_3<GeomTraits> solid;
  const Status status = partitions.next(solid, visitor);
  return status.ok() ? parameterize<ConcurrencyTag>(solid, result, np) : status;
}

// Over the best partition, if the result is a `Parameterization_search_3`.
template <typename ConcurrencyTag, typename GeomTraits, typename Result, typename NamedParameters, typename Visitor>
Status parameterize_over(Partition_sequence_3<GeomTraits>& partitions, Result& result, const NamedParameters& np, Visitor&) {
  return result.template run<ConcurrencyTag>(partitions, np);
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationRef

maps the solid inside a closed surface one to one onto a prism: checks the surface, divides it into floor, ceiling and
walls, fills it with tetrahedra, and parameterizes it. The surface may be oriented either way.

Needs TetGen, or \cgal 6.1: see `tetrahedralize()`.

\tparam ConcurrencyTag as for `parameterize()`
\tparam Point the point type of the model of `VolumeParameterizationTraits_3`
\tparam Result `Direct_product_parameterizer_3`, for the map along curves over the first partition of a
`Partition_sequence_3`; or `Parameterization_search_3`, for that and a piecewise linear map over the best of several
\tparam NamedParameters a sequence of named parameters

\param surface the boundary of a handlebody; its labels are not used
\param result receives what every stage computes; may be used once
\param np an optional sequence of named parameters among those of `parameterize()` and these:

\cgalNamedParamsBegin
  \cgalParamNBegin{sweep_direction}
    \cgalParamDescription{the direction from the floor to the ceiling}
    \cgalParamType{a vector of a \cgal kernel, of any length but 0}
    \cgalParamDefault{those of `propose_directions()` are tried}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_cells}
    \cgalParamDescription{about how many tetrahedra are wanted, as far as the given triangles allow; 0: as many as their
    shapes need}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{30000}
  \cgalParamNEnd
\cgalNamedParamsEnd

A surface of thin triangles is cut by `remesh_thin_triangles()` first, if possible.

\returns the errors of `check_surface()`, `Partition_sequence_3::next()` and `parameterize()`, or of
`Parameterization_search_3::run()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Point, typename Result,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status parameterize_surface(const Triangle_soup_3<Point>& surface, Result& result,
                            const NamedParameters& np = CGAL::parameters::default_values()) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  auto visitor =
      choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_parameterization_visitor());
  const std::size_t number_of_cells =
      choose_parameter(get_parameter(np, internal_np::number_of_cells), std::size_t(30000));
  Triangle_soup_3<Point> checked = surface;
  const Status status = internal::run_stage(visitor, "check the surface", [&] { return check_surface(checked); });
  if (!status.ok()) return status;
  static_cast<void>(remesh_thin_triangles(checked)); // what cannot be cut is taken as it is
  Partition_options options;
  options.directions = internal::directions_to_try(get_parameter(np, internal_np::sweep_direction));
  Partition_sequence_3<typename Result::Geom_traits> partitions(std::move(checked), number_of_cells, options);
  return internal::parameterize_over<ConcurrencyTag>(partitions, result, np, visitor);
}

/*!
\ingroup PkgVolumeMeshParameterizationRef

maps the solid inside a closed triangle mesh, as the function above.

\tparam ConcurrencyTag as for `parameterize()`
\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph`
\tparam Result as above
\tparam NamedParameters a sequence of named parameters

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map with the point of each vertex, of the point type of the geometric traits}
    \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns also `ERROR_NOT_TRIANGULATED`
*/
template <typename ConcurrencyTag = Sequential_tag, typename TriangleMesh, typename Result,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status parameterize_surface(const TriangleMesh& mesh, Result& result,
                            const NamedParameters& np = CGAL::parameters::default_values()) {
  Triangle_soup_3<typename Result::Point_3> surface;
  const Status status = make_triangle_soup(mesh, surface, np);
  return status.ok() ? parameterize_surface<ConcurrencyTag>(surface, result, np) : status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZE_H
