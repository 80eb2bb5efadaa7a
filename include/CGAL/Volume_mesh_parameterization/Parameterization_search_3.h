// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_images_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Partition_sequence_3.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationRef

steers the search for a parameterization.
*/
struct Parameterization_search_options {
  /// no further partition is tried once a map of the boundary has no more energy, see `Boundary_images_3::energy`. 4 is that of
  /// an isometry; maps of less than 8 were extended to the inside of all solids that were tried but one, most within seconds
  double good_energy = 8;
  std::size_t most_partitions = 6; ///< so many are tried at most, and at least one
  /// so many maps of the boundary, those of least energy, are kept and extended to the inside, until one is. If 0, the first
  /// partition is taken, and there is no piecewise linear map
  std::size_t most_linear_maps = 3;
};

/*!
\ingroup PkgVolumeMeshParameterizationRef

tells how far the parameterization over one partition got.
*/
struct Parameterization_trial_3 {
  std::optional<Partition_candidate_3> partition; ///< nothing if labels were given
  std::size_t number_of_cells = 0;                ///< of the labelled solid
  Status status;                                  ///< of the map along curves
  Status boundary_status;                         ///< of the map of the boundary, if that was made
  /// of the map of the boundary, infinite if there is none
  double boundary_energy = std::numeric_limits<double>::infinity();
};

/*!
\ingroup PkgVolumeMeshParameterizationRef

parameterizes a solid over several partitions of its boundary, and keeps the best: the one whose map of the boundary has the
least energy among those that extend to a piecewise linear bijection.

The energy of a map of the boundary foretells whether it can be extended to the inside, at a small part of the cost. Of the
partitions that were tried, the solids and fields of the `most_linear_maps` best are in memory at a time.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
\tparam FloorMap a model of `VolumeFloorMap_3` that can be copied

\sa `parameterize_surface()`
*/
template <typename GeomTraits, typename Solver = Default_solver_traits_3, typename FloorMap = Floor_map_2<GeomTraits>>
class Parameterization_search_3 {
public:
  using Geom_traits = GeomTraits;               ///< a model of `VolumeParameterizationTraits_3`
  using Point_3 = typename GeomTraits::Point_3; ///< the point type
  using Parameterizer = Direct_product_parameterizer_3<GeomTraits, Solver, FloorMap>; ///< makes the map along curves
  using Linear_map = Piecewise_linear_map_3<GeomTraits>;                              ///< the piecewise linear map

  /// \param options steer the search
  explicit Parameterization_search_3(const Parameterization_search_options& options = {}) : m_options(options) {}

  /// \param options steer the search
  /// \param floor_map is copied for each partition
  Parameterization_search_3(const Parameterization_search_options& options, FloorMap floor_map)
      : m_options(options), m_floor_map(std::move(floor_map)) {}

  /*!
  searches. The object may be used once.

  \tparam ConcurrencyTag as for `parameterize()`
  \param partitions yields the labelled solids
  \param np an optional sequence of named parameters among those of `parameterize()`. Of the second partition and later ones,
  the visitor is told names of stages that begin with `"partition 2: "` and so on

  \returns the failure of the map along curves over the best partition, or that of the first partition if there is none;
  `ERROR_CANCELLED`: the best that was found holds nevertheless. See `linear_status()` for the piecewise linear map
  */
  template <typename ConcurrencyTag = Sequential_tag, typename NamedParameters = CGAL::parameters::Default_named_parameters>
  Status run(Partition_sequence_3<GeomTraits>& partitions,
             const NamedParameters& np = CGAL::parameters::default_values()) {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    auto visitor = choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_parameterization_visitor());
    Status status;
    while (status.ok() && is_another_wanted()) status = try_partition<ConcurrencyTag>(partitions, np, visitor);
    if (m_attempts.empty()) return status;
    if (status.code() != ERROR_CANCELLED) return choose(visitor);
    m_chosen = std::move(m_attempts.front());
    m_attempts.clear();
    return status;
  }

  /// \name Results
  /// @{

  /// returns the map along curves, as far as it got, over the partition that was chosen; null if there is no partition.
  const Parameterizer* parameterizer() const { return m_chosen ? &m_chosen->parameterizer : nullptr; }
  /// returns the trial of the partition that was chosen.
  /// \pre `parameterizer()` is not null
  const Parameterization_trial_3& chosen() const { return m_chosen->trial; }
  /// returns the piecewise linear map, if it is valid.
  const Linear_map& linear_map() const { return m_linear_map; }
  /// returns why there is no piecewise linear map; no failure if there is one, or if it was not tried: see `chosen()`.
  const Status& linear_status() const { return m_linear_status; }
  /// returns what was tried, in that order.
  const std::vector<Parameterization_trial_3>& trials() const { return m_trials; }

  /// @}

private:
  struct Attempt {
    explicit Attempt(const FloorMap& floor_map) : parameterizer(floor_map) {}

    Parameterizer parameterizer;
    Boundary_images_3<GeomTraits> boundary;
    Parameterization_trial_3 trial;
  };
  using Attempt_pointer = std::unique_ptr<Attempt>;

  // Says of which trial a stage is.
  template <typename Visitor>
  class Trial_visitor {
  public:
    Trial_visitor(Visitor& visitor, std::size_t trial)
        : m_visitor(&visitor), m_prefix(trial == 0 ? "" : "partition " + std::to_string(trial + 1) + ": ") {}

    bool start_stage(const char* name) { return m_visitor->start_stage((m_prefix + name).c_str()); }
    bool advance(std::size_t done, std::size_t all) { return m_visitor->advance(done, all); }

  private:
    Visitor* m_visitor;
    std::string m_prefix;
  };

  // Maps along curves that were certified come first.
  static bool is_better(const Attempt_pointer& a, const Attempt_pointer& b) {
    const auto badness = [](const Parameterization_trial_3& t) { return std::make_pair(!t.status.ok(), t.boundary_energy); };
    return badness(a->trial) < badness(b->trial);
  }

  bool is_another_wanted() const {
    if (m_attempts.empty()) return true;
    return m_options.most_linear_maps > 0 && m_trials.size() < m_options.most_partitions &&
           !(m_attempts.front()->trial.boundary_energy <= m_options.good_energy);
  }

  // The best first, and no more than can be chosen.
  void keep_best() {
    std::stable_sort(m_attempts.begin(), m_attempts.end(), is_better);
    m_attempts.resize((std::min)(m_attempts.size(), (std::max)(m_options.most_linear_maps, std::size_t(1))));
  }

  // Fails if there is no further partition, or if the visitor stops.
  template <typename ConcurrencyTag, typename NamedParameters, typename Visitor>
  Status try_partition(Partition_sequence_3<GeomTraits>& partitions, const NamedParameters& np, Visitor& visitor) {
    Trial_visitor<Visitor> trial_visitor(visitor, m_trials.size());
    typename Parameterizer::Mesh solid;
    const Status status = partitions.next(solid, trial_visitor);
    if (!status.ok()) return status;
    m_attempts.push_back(std::make_unique<Attempt>(m_floor_map));
    Attempt& attempt = *m_attempts.back();
    attempt.trial.partition = partitions.chosen();
    attempt.trial.number_of_cells = solid.number_of_cells();
    map<ConcurrencyTag>(solid, np, trial_visitor, attempt);
    m_trials.push_back(attempt.trial);
    keep_best();
    for (const Status& s : {m_trials.back().status, m_trials.back().boundary_status})
      if (s.code() == ERROR_CANCELLED) return s;
    return {};
  }

  template <typename ConcurrencyTag, typename Mesh, typename NamedParameters, typename Visitor>
  void map(const Mesh& solid, const NamedParameters& np, Visitor& visitor, Attempt& attempt) const {
    Parameterization_trial_3& trial = attempt.trial;
    trial.status = attempt.parameterizer.template run<ConcurrencyTag>(
        solid, parameters::combine(np, CGAL::parameters::visitor(visitor)));
    if (!trial.status.ok() || m_options.most_linear_maps == 0) return;
    trial.boundary_status = internal::run_stage(visitor, "map the boundary", [&] {
      return attempt.parameterizer.template map_boundary<ConcurrencyTag>(attempt.boundary);
    });
    if (trial.boundary_status.ok()) trial.boundary_energy = attempt.boundary.energy;
  }

  // The best of those that lead to a piecewise linear map, if there is one; else the best.
  template <typename Visitor>
  Status choose(Visitor& visitor) {
    std::vector<Attempt_pointer> attempts = std::exchange(m_attempts, {});
    Status status;
    for (std::size_t k = 0; k < attempts.size() && !m_linear_map.is_valid() && status.code() != ERROR_CANCELLED; ++k) {
      Linear_map linear;
      status = make_linear(*attempts[k], visitor, linear);
      if (k > 0 && !linear.is_valid()) continue;
      m_chosen = std::move(attempts[k]);
      m_linear_map = std::move(linear);
      m_linear_status = status;
    }
    return status.code() == ERROR_CANCELLED ? status : m_chosen->trial.status;
  }

  template <typename Visitor>
  Status make_linear(const Attempt& attempt, Visitor& visitor, Linear_map& linear) const {
    const Parameterization_trial_3& trial = attempt.trial;
    if (!trial.status.ok() || m_options.most_linear_maps == 0) return {};
    if (!trial.boundary_status.ok()) return trial.boundary_status;
    return internal::untangle(attempt.parameterizer, attempt.boundary, visitor, linear);
  }

  Parameterization_search_options m_options;
  FloorMap m_floor_map;
  std::vector<Attempt_pointer> m_attempts; // the best first
  std::vector<Parameterization_trial_3> m_trials;
  Attempt_pointer m_chosen;
  Linear_map m_linear_map;
  Status m_linear_status;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARAMETERIZATION_SEARCH_3_H
