// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_SEARCH_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_SEARCH_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Partition_maker.h>
#include <CGAL/Volume_mesh_parameterization/internal/picked_facets.h>
#include <CGAL/Volume_mesh_parameterization/measure_partition.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/// \ingroup PkgVolumeMeshParameterizationPartition
/// tells what the labels of a solid that is to be partitioned mean.
enum Given_labels {
  IGNORE_LABELS, ///< nothing
  KEEP_LABELS,   ///< facets with labels keep them, split ones in their largest part; the others are free
  MEND_LABELS    ///< the partition is to be like the labels, which need not be legal
};

/*!
\ingroup PkgVolumeMeshParameterizationPartition

steers the search for partitions.
*/
struct Partition_options {
  /// from the floor to the ceiling, of any length; if there are none, that of the labels to be mended, or
  /// `propose_directions()`
  std::vector<Sweep_direction_3> directions = {};
  Given_labels given_labels = IGNORE_LABELS; ///< what labels of the input are for
  /// no further direction is tried as soon as there are so many partitions, of which the best is taken
  std::size_t number_of_candidates = 4;
  /// neither creases nor normals are tried: on solids that are no plates, loops may lead to less distortion
  bool only_by_loops = false;
  /// the width of walls on smooth surfaces, as a share of the way from the middle of the floor to that of the ceiling
  double wall_width = .5;
  /// parts of a patch that lie apart and have less than this share of the area are flipped
  double island_share = .15;
  /// on solids with more cells than this no trial is made: only the shape of the patches counts
  std::size_t most_cells_of_trial = 200000;
};

/// \ingroup PkgVolumeMeshParameterizationPartition
/// tells how a partition was made.
enum Partition_method {
  BY_CREASES, ///< facets are labelled by their normals, with rims along creases
  BY_NORMALS, ///< rims run beside the curve where averaged normals turn from one side to the other
  BY_LOOPS,   ///< rims run beside loops that belong to a basis of the homology of the solid
  BY_LABELS   ///< rims run near those of given labels
};

/// \ingroup PkgVolumeMeshParameterizationPartition
/// returns "creases", "normals", "loops" or "labels".
inline const char* method_name(Partition_method method) {
  constexpr const char* names[] = {"creases", "normals", "loops", "labels"};
  return names[method];
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

describes a partition that was found.
*/
struct Partition_candidate_3 {
  Partition_method method = BY_CREASES; ///< how it was made
  /// from the floor to the ceiling
  Sweep_direction_3 direction = CGAL::NULL_VECTOR;
  Boundary_partition_3 partition;       ///< its patches
  Partition_quality quality;            ///< what was measured
  double cost = 0; ///< of `quality`, infinite if the trial failed; the least is the best
};

/*!
\ingroup PkgVolumeMeshParameterizationPartition

searches partitions of the boundary of a solid. All that it finds are legal: they pass `validate_partition()` and
`validate_fundamental_group()`.

Each direction is tried in several ways, see `Partition_method`. On smooth surfaces edges are split, so that rims are smooth
and walls broad. Where directions give no partition, or a single one of many, loops are tried, too. What is found gets
measured, also by a trial: the harmonic function between floor and ceiling, on the given solid.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Partition_search_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the type of the solid

  /// \name Search
  /// @{

  /// prepares a search. A surface is filled with tetrahedra first, coarsely: by `tetrahedralize()`.
  /// \param solid is kept by reference; `check_tetrahedral_mesh()` accepted it
  /// \param options steer the search
  explicit Partition_search_3(const Mesh& solid, const Partition_options& options = {})
      : m_solid(solid), m_options(options), m_given(solid) {}

  Partition_search_3(const Partition_search_3&) = delete;
  Partition_search_3& operator=(const Partition_search_3&) = delete;

  /// searches; may be called once.
  /// \param visitor is asked by its function `advance()` whether to go on
  /// \returns `ERROR_WRONG_PARAMETER` for a direction or walls of no length or width, or if no partition is wanted,
  /// `ERROR_EMPTY_MESH`, `ERROR_NON_MANIFOLD`, `ERROR_SEVERAL_COMPONENTS`, `ERROR_NOT_A_HANDLEBODY`, `ERROR_PICKED_FACET`,
  /// `ERROR_NO_PARTITION` with the reason for the last direction, `ERROR_CANCELLED`
  template <typename Visitor>
  Status run(Visitor&& visitor) {
    Status status = check_options();
    if (status.ok()) status = certify();
    if (!status.ok()) return status;
    if (m_options.given_labels == MEND_LABELS) try_labels();
    if (m_options.directions.empty()) m_options.directions = propose_directions(m_solid);
    status = try_directions(visitor);
    if (status.ok()) status = try_loops(visitor);
    if (status.ok() && m_found.empty()) status = refusal();
    if (status.ok()) status = rank(visitor);
    return status;
  }

  /// @}
  /// \name Result
  /// @{

  /// returns what was found, the best first; nothing if `run()` failed.
  const std::vector<Partition_candidate_3>& candidates() const { return m_candidates; }
  /// returns how many ways of making a partition were tried.
  std::size_t number_of_trials() const { return m_number_of_trials; }

  /// labels the solid by the i-th candidate. `solid` is the one that was searched, or a copy; splits are repeated in it: the
  /// vertices that it had come first. On failure it is left as it was.
  /// \pre `i < candidates().size()`
  /// \returns `ERROR_CANNOT_SPLIT`
  Status label(std::size_t i, Mesh& solid) const { return m_found[i].surface.write_to(solid); }

  /// labels the surface that the solid was made of by the i-th candidate. Its triangles are replaced by parts of them, its
  /// points come first.
  /// \pre `i < candidates().size()`
  void label(std::size_t i, Triangle_soup_3<typename GeomTraits::Point_3>& surface) const {
    m_found[i].surface.write_to(surface);
  }

  /// @}

private:
  struct Found {
    internal::Labelled_surface surface;
    Partition_candidate_3 candidate;
  };

  static constexpr std::size_t few = 2;       // partitions by other methods, that make loops worth trying
  static constexpr double most_ragged = .1;   // share of rims that follow no creases
  static constexpr double share_of_same = .9; // of the area, with which partitions count as the same

  Status check_options() const {
    if (!(m_options.wall_width > 0) || !std::isfinite(m_options.wall_width))
      return {ERROR_WRONG_PARAMETER, "the walls have no width"};
    if (m_options.number_of_candidates == 0) return {ERROR_WRONG_PARAMETER, "no partition is wanted"};
    return internal::check_directions(m_options.directions);
  }

  Status certify() {
    const internal::Facet_adjacency surface = internal::boundary_adjacency(m_solid);
    if (!surface.status().ok()) return surface.status();
    if (internal::genus_of(surface) < 0) return {ERROR_SEVERAL_COMPONENTS, "the boundary is not connected"};
    const Status status = certify_handlebody(m_solid, m_certificate);
    if (status.ok())
      m_maker.emplace(m_given, m_certificate, picks(), m_options.wall_width, m_options.island_share);
    return status;
  }

  std::vector<int> picks() const {
    const bool has_picks = m_options.given_labels == KEEP_LABELS;
    return has_picks ? m_given.labels : std::vector<int>(m_given.labels.size(), INTERIOR);
  }

  bool is_enough() const { return m_found.size() >= m_options.number_of_candidates; }

  // Keeps what `make` returns if it is legal.
  template <typename Make>
  Status try_one(Partition_method method, const Sweep_direction_3& direction, const Make& make) {
    ++m_number_of_trials;
    internal::Labelled_surface surface;
    const Status status = make(surface);
    if (!status.ok()) remember(status, method);
    if (status.ok()) {
      Partition_candidate_3 candidate = measure(surface, method, direction);
      keep({std::move(surface), std::move(candidate)});
    }
    return status;
  }

  // Of several refusals, the last of those that tell most: of a picked facet, as the partition is legal but for it; or of any
  // method but loops, which only care for a direction.
  void remember(const Status& refusal, Partition_method method) {
    const int telling = 2 * (refusal.code() == ERROR_PICKED_FACET) + (method != BY_LOOPS);
    if (telling < m_telling) return;
    m_telling = telling;
    m_refusal = refusal;
  }

  // Of partitions in which all but a small part of the facets have the same labels, the one of least cost.
  void keep(Found found) {
    const auto same = std::find_if(m_found.begin(), m_found.end(), [&](const Found& other) {
      return m_maker->share_of_common_labels(found.surface, other.surface) > share_of_same;
    });
    if (same == m_found.end())
      m_found.push_back(std::move(found));
    else if (found.candidate.cost < same->candidate.cost)
      *same = std::move(found);
  }

  // From the shape of the patches alone.
  static Partition_candidate_3 measure(const internal::Labelled_surface& labelled, Partition_method method,
                                       const Sweep_direction_3& direction) {
    const internal::Approximate_surface surface = labelled.approximate_surface();
    Partition_candidate_3 result = {
        method, direction, internal::summarize(surface.adjacency, labelled.labels, surface.areas), {}, 0};
    internal::measure_partition(surface, labelled.labels, direction, result.quality);
    result.cost = cost(result.quality);
    return result;
  }

  void try_labels() {
    const Sweep_direction_3 direction = m_maker->ascent(m_given.labels);
    const auto make = [&](internal::Labelled_surface& result) {
      return m_maker->by_labels(m_given.labels, result);
    };
    if (try_one(BY_LABELS, direction, make).ok()) m_options.number_of_candidates = 1;
    if (m_options.directions.empty() && internal::length(direction) > 0) m_options.directions = {direction};
  }

  template <typename Visitor>
  Status try_directions(Visitor& visitor) {
    const auto& directions = m_options.directions;
    for (std::size_t k = 0; k < directions.size() && !m_options.only_by_loops && !is_enough(); ++k) {
      if (!visitor.advance(k, directions.size())) return {ERROR_CANCELLED, "while partitioning"};
      try_direction(internal::normalized(directions[k]));
    }
    return {};
  }

  // Rims along creases if there are creases where they should run.
  void try_direction(const Sweep_direction_3& d) {
    const std::vector<int> labels = m_maker->labels_by_creases(d);
    const auto by_creases = [&](internal::Cleaning_order order) {
      return try_one(BY_CREASES, d, [&](internal::Labelled_surface& result) {
        return m_maker->by_creases(labels, order, most_ragged, result);
      });
    };
    const bool has_creases = by_creases(internal::APART_BASES_FIRST).ok();
    const bool has_pockets = by_creases(internal::POCKETS_FIRST).ok();
    const auto by_normals = [&](internal::Labelled_surface& result) {
      return m_maker->by_normals(d, result);
    };
    if (!has_creases && !has_pockets) static_cast<void>(try_one(BY_NORMALS, d, by_normals));
  }

  // There are loops on every handlebody, but rims beside them are not always where a person would draw them.
  template <typename Visitor>
  Status try_loops(Visitor& visitor) {
    const auto& directions = m_options.directions;
    if (!m_options.only_by_loops && m_found.size() >= std::min(directions.size(), few)) return {};
    for (std::size_t k = 0; k < directions.size() && !is_enough(); ++k) {
      if (!visitor.advance(k, directions.size())) return {ERROR_CANCELLED, "while searching for loops"};
      const Sweep_direction_3 d = internal::normalized(directions[k]);
      static_cast<void>(try_one(
          BY_LOOPS, d, [&](internal::Labelled_surface& result) { return m_maker->by_loops(d, result); }));
    }
    return {};
  }

  Status refusal() const {
    if (m_refusal.code() == ERROR_PICKED_FACET) return m_refusal;
    return {ERROR_NO_PARTITION,
            std::to_string(m_options.directions.size()) + " direction(s) tried, the last one fails so: " +
                (m_refusal.code() == ERROR_NO_PARTITION ? m_refusal.detail() : m_refusal.message())};
  }

  template <typename Visitor>
  Status rank(Visitor& visitor) {
    const bool makes_trial = m_solid.number_of_cells() <= m_options.most_cells_of_trial;
    for (std::size_t i = 0; i < m_found.size() && makes_trial; ++i) {
      if (!visitor.advance(i, m_found.size())) return {ERROR_CANCELLED, "while comparing partitions"};
      try_on_solid(m_found[i]);
    }
    std::stable_sort(m_found.begin(), m_found.end(),
                     [](const Found& a, const Found& b) { return a.candidate.cost < b.candidate.cost; });
    m_found.resize(std::min(m_found.size(), m_options.number_of_candidates)); // one direction may give two
    for (const Found& found : m_found) m_candidates.push_back(found.candidate);
    return {};
  }

  // On the given solid, though rims do not follow its edges: each facet has the label of its largest part.
  void try_on_solid(Found& found) const {
    Mesh trial = m_solid;
    const std::vector<int> labels = internal::labels_of_given_facets(found.surface);
    for (Facet_index f : trial.boundary_facets()) trial.set_label(f, labels[f]);
    Partition_candidate_3& candidate = found.candidate;
    const Status status = try_partition(trial, candidate.quality);
    candidate.cost = status.ok() ? cost(candidate.quality) : std::numeric_limits<double>::infinity();
  }

  const Mesh& m_solid;
  Partition_options m_options;
  internal::Labelled_surface m_given;
  Handlebody_certificate m_certificate;
  std::optional<internal::Partition_maker> m_maker;
  std::vector<Found> m_found;
  std::vector<Partition_candidate_3> m_candidates;
  std::size_t m_number_of_trials = 0;
  Status m_refusal;
  int m_telling = 0; // of the refusal
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_SEARCH_3_H
