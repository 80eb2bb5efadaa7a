// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

is the default visitor of a parameterization: it watches nothing and stops nothing. A visitor of the user has the same
functions.
*/
struct Default_parameterization_visitor {
  /// is called before each stage with its name; stops the parameterization by returning `false`.
  bool start_stage(const char* /*name*/) { return true; }
  /// is called within a long stage, when `done` of `all` steps are done; stops it by returning `false`.
  bool advance(std::size_t /*done*/, std::size_t /*all*/) { return true; }
};

/// \ingroup PkgVolumeMeshParameterizationRef
/// lists the curves that a map may follow.
enum Curve_type {
  CERTIFIED_CURVES, ///< curves of the product structure, nearest to the flux: they arrive, whatever the field does
  FLUX_CURVES       ///< curves of the Crouzeix-Raviart flux itself: straighter, but nothing is proved
};

/// \cond SKIP_IN_MANUAL
// Named parameters that CGAL does not have yet. They start a chain that CGAL's own parameters may follow.
namespace internal_np {
enum curve_type_t { curve_type };
enum level_function_t { level_function };
enum sweep_direction_t { sweep_direction };
enum number_of_cells_t { number_of_cells };
} // namespace internal_np

namespace parameters {

template <typename T>
Named_function_parameters<T, internal_np::curve_type_t> curve_type(const T& t) {
  return {t};
}

template <typename T>
Named_function_parameters<T, internal_np::level_function_t> level_function(const T& t) {
  return {t};
}

template <typename T>
Named_function_parameters<T, internal_np::sweep_direction_t> sweep_direction(const T& t) {
  return {t};
}

template <typename T>
Named_function_parameters<T, internal_np::number_of_cells_t> number_of_cells(const T& t) {
  return {t};
}

/// \endcond

/// \ingroup PkgVolumeMeshParameterizationRef
/// appends `p` to the chain of named parameters `np`, which may end with one of \cgal; from \cgal 5.6 on `np.combine(p)` does
/// the same.
/// \tparam NamedParameters the type of a chain
template <typename T, typename Tag, typename Base, typename NamedParameters>
Named_function_parameters<T, Tag, NamedParameters> combine(const NamedParameters& np,
                                                           const Named_function_parameters<T, Tag, Base>& p) {
  return {CGAL::parameters::get_parameter(p, Tag()), np};
}

} // namespace parameters

namespace internal {

template <typename Visitor, typename Function>
Status run_stage(Visitor& visitor, const char* name, const Function& function) {
  return visitor.start_stage(name) ? function() : Status(ERROR_CANCELLED, std::string("before ") + name);
}

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERS_H
