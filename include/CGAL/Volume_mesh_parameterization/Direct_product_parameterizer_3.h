// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_PARAMETERIZER_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_PARAMETERIZER_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

parameterizes a handlebody with a labelled boundary over a prism: checks, prepares, solves, sweeps, maps. Every stage
leaves its result here, so that what holds can be used even if a later stage fails.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
*/
template <typename GeomTraits, typename Solver = Default_solver_traits_3>
class Direct_product_parameterizer_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Point_3 = typename GeomTraits::Point_3;
  using Harmonic_function = Harmonic_function_3<Mesh, Solver>;
  using Dual_potential = Dual_potential_3<Mesh, Solver>;
  using Flux_field = Flux_field_3<Mesh, Solver>;
  using Product_structure = Product_structure_3<GeomTraits>;
  using Curve_field = Curve_field_3<GeomTraits>;
  using Curves = Integral_curves_3<GeomTraits>;
  using Floor_map = Floor_map_2<GeomTraits>;
  using Product_map = Product_map_3<GeomTraits>;

  Direct_product_parameterizer_3() = default;
  // The stages refer to each other.
  Direct_product_parameterizer_3(const Direct_product_parameterizer_3&) = delete;
  Direct_product_parameterizer_3& operator=(const Direct_product_parameterizer_3&) = delete;

  /*!
  runs all stages. The object may be used once.

  \tparam TetrahedralMesh a model of `TetrahedralMesh_3`
  \param mesh a handlebody whose boundary facets are labelled
  \param np an optional sequence of named parameters among those of `parameterize()`

  \returns the failure of the first stage that failed
  */
  template <typename TetrahedralMesh, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Status run(const TetrahedralMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    auto visitor = choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_parameterization_visitor());
    const Curve_type type = choose_parameter(get_parameter(np, internal_np::curve_type), CERTIFIED_CURVES);
    const Level_function level = choose_parameter(get_parameter(np, internal_np::level_function), HARMONIC_LEVEL);

    Status status;
    const auto stage = [&](const char* name, const auto& function) {
      if (status.ok()) status = internal::run_stage(visitor, name, function);
    };
    stage("check the mesh", [&] { return read(mesh); });
    stage("validate the partition", [&] { return validate(); });
    stage("prepare the patches", [&] { return prepare_patches(m_mesh, m_preparation); });
    stage("solve for potential and flux, and sweep", [&] { return sweep_cells(); });
    stage("solve for the harmonic function", [&] { return solve(m_harmonic_function); });
    stage("choose the curves", [&] { return choose_curves(type, level); });
    stage("map the floor", [&] { return map_floor(); });
    stage("map the vertices", [&] { return m_product_map->vertex_images(m_vertex_images); });
    return status;
  }

  /// \name Results
  /// Pointers are null, and vectors empty, if their stage was not reached or failed.
  /// @{

  /// The mesh that all the others refer to: the input with the splits of `prepare_patches()`.
  const Mesh& mesh() const { return m_mesh; }
  const Boundary_partition_3& partition() const { return m_partition; }
  const Preparation& preparation() const { return m_preparation; }
  const Handlebody_certificate& handlebody_certificate() const { return m_certificate; }
  const Harmonic_function* harmonic_function() const { return pointer(m_harmonic_function); }
  const Dual_potential* dual_potential() const { return pointer(m_dual_potential); }
  const Flux_field* flux_field() const { return pointer(m_flux_field); }
  const Sweep_report& sweep_report() const { return m_sweep_report; }
  const Product_structure* product_structure() const { return pointer(m_structure); }
  const Curve_field* curve_field() const { return pointer(m_curve_field); }
  const Floor_map* floor_map() const { return pointer(m_floor_map); }
  const Product_map* product_map() const { return pointer(m_product_map); }
  /// The images of all vertices of `mesh()` in the prism.
  const std::vector<Point_3>& vertex_images() const { return m_vertex_images; }

  /// @}

private:
  template <typename T>
  static const T* pointer(const std::optional<T>& t) {
    return t ? &*t : nullptr;
  }

  template <typename TetrahedralMesh>
  Status read(const TetrahedralMesh& mesh) {
    const Status status = m_mesh.assign(mesh);
    return status.ok() ? check_tetrahedral_mesh(m_mesh) : status;
  }

  Status validate() {
    Status status = validate_partition(m_mesh, m_partition);
    if (status.ok()) status = certify_handlebody(m_mesh, m_certificate);
    if (status.ok()) status = validate_fundamental_group(m_mesh, m_certificate);
    return status;
  }

  template <typename Field>
  Status solve(std::optional<Field>& field) {
    Field solved(m_mesh);
    const Status status = solved.solve();
    if (status.ok()) field.emplace(std::move(solved));
    return status;
  }

  // The order is checked by code that shares nothing with the sweep.
  Status sweep_cells() {
    const auto guide = [this](const Mesh& mesh, Sweep_guide_3& result) {
      Status status = solve(m_dual_potential);
      if (status.ok()) status = solve(m_flux_field);
      if (!status.ok()) return status;
      result = Sweep_guide_3(m_dual_potential->values());
      for (Cell_index c : mesh.cells()) result.signs.push_back(m_flux_field->signs(c));
      return status;
    };
    Product_structure structure;
    Status status = sweep_with_repairs(m_mesh, guide, structure, m_sweep_report);
    if (status.ok()) status = verify_product(m_mesh, structure.order());
    if (status.ok()) m_structure.emplace(std::move(structure));
    return status;
  }

  Status choose_curves(Curve_type type, Level_function level) {
    if (type == CERTIFIED_CURVES)
      m_curve_field.emplace(m_mesh, *m_structure, *m_flux_field, *m_harmonic_function, level);
    else
      m_curve_field.emplace(m_mesh, *m_flux_field, *m_harmonic_function, level);
    return {};
  }

  Status map_floor() {
    Floor_map map;
    const Status status = map.build(m_mesh);
    if (!status.ok()) return status;
    m_floor_map.emplace(std::move(map));
    m_product_map.emplace(Curves(m_mesh, *m_curve_field), *m_floor_map);
    return {};
  }

  Mesh m_mesh;
  Boundary_partition_3 m_partition;
  Handlebody_certificate m_certificate;
  Preparation m_preparation;
  std::optional<Harmonic_function> m_harmonic_function;
  std::optional<Dual_potential> m_dual_potential;
  std::optional<Flux_field> m_flux_field;
  Sweep_report m_sweep_report;
  std::optional<Product_structure> m_structure;
  std::optional<Curve_field> m_curve_field;
  std::optional<Floor_map> m_floor_map;
  std::optional<Product_map> m_product_map;
  std::vector<Point_3> m_vertex_images;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_PARAMETERIZER_3_H
