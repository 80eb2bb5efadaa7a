// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
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
\ingroup PkgVolumeMeshParameterizationStructure

is a handlebody with a labelled boundary as the direct product of its floor and an interval: checked, prepared, with the
fields on it, swept, with the curves that join floor and ceiling. Every stage leaves its result here, so that what holds
can be used even if a later stage fails.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
*/
template <typename GeomTraits, typename Solver = Default_solver_traits_3>
class Direct_product_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;         ///< the type of the solid
  using Point_3 = typename GeomTraits::Point_3;                ///< the point type
  using Harmonic_function = Harmonic_function_3<Mesh, Solver>; ///< the levels of vertices
  using Dual_potential = Dual_potential_3<Mesh, Solver>;       ///< what guides the sweep
  using Flux_field = Flux_field_3<Mesh, Solver>;               ///< what the curves are to follow
  using Product_structure = Product_structure_3<GeomTraits>;   ///< the order of the sweep
  using Curve_field = Curve_field_3<GeomTraits>;               ///< the direction of the curve in each cell
  using Curves = Integral_curves_3<GeomTraits>;                ///< the curves

  Direct_product_3() = default;
  // The stages refer to each other.
  Direct_product_3(const Direct_product_3&) = delete;
  Direct_product_3& operator=(const Direct_product_3&) = delete;

  /*!
  builds the product stage by stage. The object may be used once.

  \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; results do not depend on it.
  For kernels whose `FT` is no floating point type, one thread does all.
  \tparam TetrahedralMesh a model of `TetrahedralMesh_3`
  \param mesh a handlebody whose boundary facets are labelled
  \param np an optional sequence of named parameters among those of `parameterize()`

  \returns the failure of the first stage that failed
  */
  template <typename ConcurrencyTag = Sequential_tag, typename TetrahedralMesh,
            typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Status build(const TetrahedralMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values()) {
    auto visitor = visitor_of(np);
    return build<ConcurrencyTag>(mesh, np, visitor);
  }

  /// \name Results
  /// Pointers are null if their stage was not reached, or no such result was found; all fields are null if one of them failed.
  /// @{

  /// The mesh that all the others refer to: the input with the splits of `prepare_patches()` and of the sweep.
  const Mesh& mesh() const { return m_mesh; }
  /// returns the patches of the boundary.
  const Boundary_partition_3& partition() const { return m_partition; }
  /// returns what was split before the sweep.
  const Preparation& preparation() const { return m_preparation; }
  /// returns whether the solid is proved to be a handlebody, and every loop to be one of the floor and of the ceiling.
  bool is_certified() const { return m_is_certified; }
  /// returns the words of the edges of the mesh as `prepare_patches()` left it, empty ones unless `is_certified()`.
  const Handlebody_certificate& handlebody_certificate() const { return m_certificate; }
  /// returns the function that is 0 on the floor and 1 on the ceiling.
  const Harmonic_function* harmonic_function() const { return pointer(m_harmonic_function); }
  /// returns the potential that guides the sweep.
  const Dual_potential* dual_potential() const { return pointer(m_dual_potential); }
  /// returns the flux, one vector for each cell.
  const Flux_field* flux_field() const { return pointer(m_flux_field); }
  /// returns what the sweep took.
  const Sweep_report& sweep_report() const { return m_sweep_report; }
  /// returns the order of the sweep, which is the certificate.
  const Product_structure* product_structure() const { return pointer(m_structure); }
  /// returns the direction of the curve in each cell.
  const Curve_field* curve_field() const { return pointer(m_curve_field); }

  /// @}

  /// returns the integral curves.
  /// \pre `curve_field()` is not null
  Curves curves() const { return Curves(m_mesh, *m_curve_field); }

protected:
  template <typename NamedParameters>
  static auto visitor_of(const NamedParameters& np) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    return choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_parameterization_visitor());
  }

  template <typename ConcurrencyTag, typename TetrahedralMesh, typename NamedParameters, typename Visitor>
  Status build(const TetrahedralMesh& mesh, const NamedParameters& np, Visitor& visitor) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const Curve_type type = choose_parameter(get_parameter(np, internal_np::curve_type), CERTIFIED_CURVES);
    const Level_function level = choose_parameter(get_parameter(np, internal_np::level_function), HARMONIC_LEVEL);
    using Tag = internal::Concurrency_for<ConcurrencyTag, typename GeomTraits::FT>;
    Status status;
    const auto stage = [&](const char* name, const auto& function) {
      if (status.ok()) status = internal::run_stage(visitor, name, function);
    };
    stage("check the mesh", [&] { return read<Tag>(mesh); });
    stage("validate the partition", [&] { return validate_partition(m_mesh, m_partition); });
    stage("prepare the patches", [&] { return prepare_patches<Tag>(m_mesh, m_preparation); });
    stage("solve for the fields, and sweep", [&] { return sweep_cells<Tag>(type); });
    stage("choose the curves", [&] { return choose_curves<Tag>(type, level); });
    return status;
  }

  template <typename T>
  static const T* pointer(const std::optional<T>& t) {
    return t ? &*t : nullptr;
  }

private:
  template <typename ConcurrencyTag, typename TetrahedralMesh>
  Status read(const TetrahedralMesh& mesh) {
    const Status status = m_mesh.template assign<ConcurrencyTag>(mesh);
    return status.ok() ? check_tetrahedral_mesh<ConcurrencyTag>(m_mesh) : status;
  }

  // Refinement does not change whether the solid is a handlebody.
  template <typename ConcurrencyTag>
  Status certify() {
    if (m_is_certified) return {};
    Status status = certify_handlebody<ConcurrencyTag>(m_mesh, m_certificate);
    if (status.ok()) status = validate_fundamental_group(m_mesh, m_certificate);
    m_is_certified = status.ok();
    return status;
  }

  // Apart from the harmonic function, what needs no field is made at the same time; that the solid is no handlebody is told first.
  // Curves that are to be those of the flux itself are worth the smoother flux.
  template <typename ConcurrencyTag>
  Status make_fields(Curve_type type) {
    m_harmonic_function.emplace(m_mesh);
    m_flux_field.emplace(m_mesh);
    m_dual_potential.emplace(m_mesh);
    const bool is_equilibrated = type != FLUX_CURVES;
    Status solved;
    Status status = internal::try_all<ConcurrencyTag>(
        [&] {
          solved = m_harmonic_function->solve();
          return Status();
        },
        [&] { return certify<ConcurrencyTag>(); },
        [&] {
          if (is_equilibrated) m_flux_field->template prepare_to_equilibrate<ConcurrencyTag>();
          return Status();
        });
    if (status.ok()) status = solved;
    if (!status.ok()) return status;
    return internal::try_all<ConcurrencyTag>(
        [&] {
          if (!is_equilibrated) return m_flux_field->solve();
          m_flux_field->template equilibrate<ConcurrencyTag>(*m_harmonic_function);
          return Status();
        },
        [&] { return m_dual_potential->template approximate<ConcurrencyTag>(m_harmonic_function->values()); });
  }

  void forget_fields() {
    if (!m_is_certified) m_certificate = {};
    m_harmonic_function.reset();
    m_flux_field.reset();
    m_dual_potential.reset();
  }

  // The order is checked by code that shares nothing with the sweep but parallel loops.
  template <typename ConcurrencyTag>
  Status sweep_cells(Curve_type type) {
    const auto guide = [&](const Mesh& mesh, Sweep_guide_3& result) {
      const Status status = make_fields<ConcurrencyTag>(type);
      if (!status.ok()) {
        forget_fields();
        return status;
      }
      result = Sweep_guide_3(m_dual_potential->values());
      for (Cell_index c : mesh.cells()) result.signs.push_back(m_flux_field->signs(c));
      return status;
    };
    Product_structure structure;
    Status status = sweep_with_repairs<ConcurrencyTag>(m_mesh, guide, structure, m_sweep_report);
    if (status.ok()) status = verify_product<ConcurrencyTag>(m_mesh, structure.order());
    if (status.ok()) m_structure.emplace(std::move(structure));
    return status;
  }

  template <typename ConcurrencyTag>
  Status choose_curves(Curve_type type, Level_function level) {
    if (type == CERTIFIED_CURVES)
      m_curve_field.emplace(m_mesh, *m_structure, *m_flux_field, *m_harmonic_function, level,
                            Curve_field::default_least_slope, ConcurrencyTag());
    else
      m_curve_field.emplace(m_mesh, *m_flux_field, *m_harmonic_function, level);
    return {};
  }

  Mesh m_mesh;
  Boundary_partition_3 m_partition;
  Handlebody_certificate m_certificate;
  bool m_is_certified = false;
  Preparation m_preparation;
  std::optional<Harmonic_function> m_harmonic_function;
  std::optional<Dual_potential> m_dual_potential;
  std::optional<Flux_field> m_flux_field;
  Sweep_report m_sweep_report;
  std::optional<Product_structure> m_structure;
  std::optional<Curve_field> m_curve_field;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_DIRECT_PRODUCT_3_H
