// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_FLUX_FIELD_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_FLUX_FIELD_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Circulation_relaxation.h>
#include <CGAL/Volume_mesh_parameterization/internal/Dirichlet_problem.h>
#include <CGAL/Volume_mesh_parameterization/internal/Flux_equilibration.h>
#include <CGAL/Volume_mesh_parameterization/internal/Gradient_network.h>
#include <CGAL/Volume_mesh_parameterization/internal/balance_rates.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFields

is the gradient of the harmonic function as a field without sources: one constant vector per cell, one flux per facet,
the same seen from both cells, exactly 0 through walls.

There are two such fields, in fluxes of the lowest-order elements of Raviart and Thomas. Both point upwards, from the floor to
the ceiling. That of `equilibrate()` is made from the harmonic function, around each vertex and then around each edge on its
own: it costs about as much as the harmonic function did. That of `solve()` has the least energy: it is the gradient of the
non-conforming solution of Crouzeix and Raviart (Marini 1985), a linear system with one unknown per facet.

Its integral curves need no certificate to be computed, and have none: the field may have cycles, and where the
harmonic function is flat the signs of its fluxes are noise. See `Product_structure_3` for the certified curves.

\tparam Mesh a `Compact_tetrahedral_mesh_3`; it must outlive the field
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
*/
template <typename Mesh, typename Solver = Default_solver_traits_3>
class Flux_field_3 {
public:
  using Vector_3 = Simple_cartesian<double>::Vector_3; ///< a vector of doubles

  /// is the flux per area, relative to the largest one, below which a flux is taken for noise of the solver and set
  /// to 0, 2^-40: else a facet parallel to the field would get a random sign, and its two cells could form a cycle.
  static constexpr double flux_noise = 1. / (1ull << 40);

  /// keeps a reference to the mesh.
  explicit Flux_field_3(const Mesh& mesh) : m_mesh(&mesh) {}

  /// computes the fluxes of the non-conforming method, in the time of a linear system with one unknown per facet.
  /// \returns `ERROR_FLAT_TETRAHEDRON`, `ERROR_NUMBER_OF_PATCHES` (no floor or no ceiling),
  /// `ERROR_SEVERAL_COMPONENTS` or `ERROR_CANNOT_SOLVE`
  Status solve() {
    std::vector<double> volumes;
    Status status = internal::compute_volumes(*m_mesh, volumes);
    if (!status.ok()) return status;
    internal::Dirichlet_problem<Solver> problem("facet", label_facets());
    const auto facet = [this](Cell_index c, int i) { return m_mesh->facet(c, i); };
    status = problem.solve(internal::Gradient_network<Mesh, decltype(facet)>(*m_mesh, 9, facet));
    if (!status.ok()) return status;
    m_residual = problem.residual();
    compute_fluxes(problem.values());
    finish<Sequential_tag>(volumes);
    return {};
  }

  /// makes what `equilibrate()` needs apart from the harmonic function, in linear time; `equilibrate()` calls it if it was not
  /// called before. The mesh must not change in between.
  /// \tparam ConcurrencyTag as for `equilibrate()`
  template <typename ConcurrencyTag = Sequential_tag>
  void prepare_to_equilibrate() {
    m_relaxation.emplace(*m_mesh, Tag<ConcurrencyTag>());
  }

  /// computes fluxes from the gradient of `harmonic_function`, which jumps across facets: the means of both sides, made
  /// conservative around each vertex (Braess and Schöberl 2008), and smoothed by taking circulations away around each edge
  /// (Hiptmair 1998). No linear system of the size of the mesh is solved: the time is linear. What is left of the roughness
  /// depends on the numbering of the cells; `solve()` does not.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
  /// \tparam Harmonic_function `Harmonic_function_3` of the same mesh
  /// \pre `harmonic_function` is solved
  template <typename ConcurrencyTag = Sequential_tag, typename Harmonic_function>
  void equilibrate(const Harmonic_function& harmonic_function) {
    m_residual = harmonic_function.residual();
    m_fluxes = internal::Flux_equilibration<Mesh>(*m_mesh).template fluxes<Tag<ConcurrencyTag>>(harmonic_function.values());
    if (!m_relaxation) prepare_to_equilibrate<ConcurrencyTag>();
    m_relaxation->template run<Tag<ConcurrencyTag>>(relaxation_rounds, m_fluxes);
    m_relaxation.reset();
    finish<Tag<ConcurrencyTag>>(internal::volumes(*m_mesh));
  }

  /// returns the flux through `f` from the cell of `half_facet(f)` to the other one, or outwards on the boundary.
  double flux(Facet_index f) const { return m_fluxes[f]; }

  /// returns the flux through a facet into its cell.
  double inflow(Half_facet h) const {
    const Facet_index f = m_mesh->facet(h.cell, h.index);
    const Half_facet first = m_mesh->half_facet(f);
    return first.cell == h.cell && first.index == h.index ? -m_fluxes[f] : m_fluxes[f];
  }

  /// returns how fast the barycentric coordinates change along the field: rate `i` is the inflow through facet `i`
  /// divided by three times the volume. The four sum to 0 in exact arithmetic.
  const std::array<double, 4>& rates(Cell_index c) const { return m_rates[c]; }

  /// returns +1 where the field enters `c` through facet `i`, -1 where it leaves, 0 where it does not cross.
  std::array<std::int8_t, 4> signs(Cell_index c) const {
    std::array<std::int8_t, 4> result;
    for (int i = 0; i < 4; ++i) result[i] = std::int8_t((m_rates[c][i] > 0) - (m_rates[c][i] < 0));
    return result;
  }

  /// returns the field in `c`.
  Vector_3 vector(Cell_index c) const {
    Vector_3 result = NULL_VECTOR;
    const auto origin = internal::approximate(m_mesh->point(m_mesh->vertex(c, 0)));
    for (int i = 1; i < 4; ++i)
      result += m_rates[c][i] * (internal::approximate(m_mesh->point(m_mesh->vertex(c, i))) - origin);
    return result;
  }

  /// returns the flux that leaves the solid through the facets with this label.
  double total_flux(int label) const {
    double sum = 0;
    for (Facet_index f : m_mesh->boundary_facets())
      if (m_mesh->label(f) == label) sum += m_fluxes[f];
    return sum;
  }

  /// returns the norm of the residual divided by that of the sums of the sizes of its terms.
  double residual() const { return m_residual; }

  /// returns the largest sum of the four fluxes of a cell, as the solver left them, divided by the largest flux.
  double largest_divergence() const { return m_largest_divergence; }

private:
  // More rounds bring less than one percent of the volume more where the sweep obeys the flux (`benchmark_fluxes`).
  static constexpr int relaxation_rounds = 6;
  static constexpr std::size_t size_of_block = 4096; // of parallel loops

  template <typename ConcurrencyTag>
  using Tag = internal::Concurrency_for<ConcurrencyTag, typename Mesh::FT>;

  bool is_wall(Facet_index f) const {
    const int label = m_mesh->label(f);
    return m_mesh->is_boundary(f) && label != FLOOR && label != CEILING;
  }

  std::vector<int> label_facets() const {
    std::vector<int> labels(m_mesh->number_of_facets());
    for (Facet_index f : m_mesh->facets()) labels[f] = m_mesh->label(f);
    return labels;
  }

  // The function with value u_i on facet i is the sum of u_i (1 - 3 lambda_i). Both sides of a facet give the same
  // flux but for the residual: take the mean.
  void compute_fluxes(const std::vector<double>& values) {
    m_fluxes.assign(m_mesh->number_of_facets(), 0);
    for (Cell_index c : m_mesh->cells()) {
      const internal::Cell_gradients cell(*m_mesh, c);
      const Vector_3 gradient =
          -3 * cell.interpolate({values[m_mesh->facet(c, 0)], values[m_mesh->facet(c, 1)],
                                 values[m_mesh->facet(c, 2)], values[m_mesh->facet(c, 3)]});
      for (int i = 0; i < 4; ++i) {
        const Facet_index f = m_mesh->facet(c, i);
        const double outflow = -3 * cell.volume * (gradient * cell.gradients[i]);
        const double share = m_mesh->is_boundary(f) ? 1 : 0.5;
        if (!is_wall(f)) m_fluxes[f] += m_mesh->half_facet(f).cell == c ? share * outflow : -share * outflow;
      }
    }
  }

  template <typename ConcurrencyTag>
  void finish(const std::vector<double>& volumes) {
    m_largest_divergence = compute_largest_divergence();
    remove_noise<ConcurrencyTag>();
    remove_dead_ends();
    m_rates.resize(m_mesh->number_of_cells());
    internal::for_each_index<ConcurrencyTag>(
        m_rates.size(), [&](std::size_t c) { m_rates[c] = compute_rates(Cell_index(c), volumes[c]); }, size_of_block);
  }

  double compute_largest_divergence() const {
    double sum = 0, flux = 0;
    for (Cell_index c : m_mesh->cells()) {
      double divergence = 0;
      for (int i = 0; i < 4; ++i) divergence += inflow({c, i});
      sum = (std::max)(sum, std::abs(divergence));
    }
    for (double f : m_fluxes) flux = (std::max)(flux, std::abs(f));
    return flux == 0 ? 0 : sum / flux;
  }

  template <typename ConcurrencyTag>
  void remove_noise() {
    std::vector<double> areas(m_mesh->number_of_facets());
    internal::for_each_index<ConcurrencyTag>(
        areas.size(), [&](std::size_t f) { areas[f] = std::sqrt(internal::squared_area(*m_mesh, Facet_index(f))); },
        size_of_block);
    double largest_density = 0;
    for (Facet_index f : m_mesh->facets()) largest_density = (std::max)(largest_density, std::abs(m_fluxes[f]) / areas[f]);
    for (Facet_index f : m_mesh->facets())
      if (std::abs(m_fluxes[f]) <= flux_noise * largest_density * areas[f]) m_fluxes[f] = 0;
  }

  bool is_dead_end(Cell_index c) const {
    bool enters = false, leaves = false;
    for (int i = 0; i < 4; ++i) {
      enters |= inflow({c, i}) > 0;
      leaves |= inflow({c, i}) < 0;
    }
    return enters != leaves;
  }

  // Without its smallest fluxes a cell may be left with an entrance and no exit, or the other way round.
  void remove_dead_ends() {
    std::vector<Cell_index> candidates(m_mesh->cells().begin(), m_mesh->cells().end());
    while (!candidates.empty()) {
      const Cell_index c = candidates.back();
      candidates.pop_back();
      if (!is_dead_end(c)) continue;
      for (int i = 0; i < 4; ++i) {
        if (inflow({c, i}) == 0) continue;
        m_fluxes[m_mesh->facet(c, i)] = 0;
        if (m_mesh->neighbor(c, i).is_valid()) candidates.push_back(m_mesh->neighbor(c, i));
      }
    }
  }

  std::array<double, 4> compute_rates(Cell_index c, double volume) const {
    std::array<double, 4> rates;
    for (int i = 0; i < 4; ++i) rates[i] = inflow({c, i}) / (3 * volume);
    return internal::balance_rates(rates);
  }

  const Mesh* m_mesh;
  std::optional<internal::Circulation_relaxation<Mesh>> m_relaxation; // until it is used
  std::vector<double> m_fluxes;
  std::vector<std::array<double, 4>> m_rates;
  double m_residual = 0;
  double m_largest_divergence = 0;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_FLUX_FIELD_3_H
