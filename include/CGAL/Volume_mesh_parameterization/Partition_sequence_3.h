// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_SEQUENCE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_SEQUENCE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels a solid in one way after the other, the best first, as long as there are ways that are worth a trial. A solid that is
given by its surface is filled with tetrahedra for each partition, so that rims may run where the surface is cut.

First come the partitions that a `Partition_search_3` with the given options finds; they suit plates and the like. Then come
some with rims beside loops, with walls so broad that tubes stay tubes. A partition that was made as an earlier one, along
nearly the same line and with walls as broad, is left out.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Partition_sequence_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;           ///< the type of the solids
  using Surface = Triangle_soup_3<typename GeomTraits::Point_3>; ///< the type of the surface

  /// \param solid a mesh that `check_tetrahedral_mesh()` accepted
  /// \param options steer the search
  explicit Partition_sequence_3(Mesh solid, const Partition_options& options = {})
      : m_options(options), m_solid(std::make_unique<Mesh>(std::move(solid))), m_is_filled(true) {}

  /// \param surface a surface that `check_surface()` accepted; its labels are what `Partition_options::given_labels` says
  /// \param number_of_cells as for `tetrahedralize()`
  /// \param options steer the search
  Partition_sequence_3(Surface surface, std::size_t number_of_cells, const Partition_options& options = {})
      : m_options(options),
        m_surface(std::move(surface)),
        m_number_of_cells(number_of_cells),
        m_solid(std::make_unique<Mesh>()) {}

  /// returns the sequence of one partition, that of a solid that has labels already.
  static Partition_sequence_3 of_labels(Mesh solid) { return Partition_sequence_3(std::move(solid), Labels()); }

  /*!
  makes the next labelled solid.

  \param solid receives it; on failure it is left as it was. Where edges are split it has more vertices than what was given,
  whose vertices come first
  \param visitor has the functions of `Default_parameterization_visitor`

  \returns `ERROR_NO_PARTITION` if there is no further one; the errors of `Partition_search_3::run()` and `tetrahedralize()`;
  `ERROR_CANNOT_SPLIT` if no partition can be made in the solid
  */
  template <typename Visitor>
  Status next(Mesh& solid, Visitor&& visitor) {
    if (m_is_labelled) return take_labels(solid);
    Status status = m_is_filled ? Status() : fill(visitor);
    while (status.ok()) {
      if (!m_search || m_next == m_search->candidates().size()) {
        status = search(visitor);
      } else if (const std::size_t i = m_next++; !is_like_one_tried(m_search->candidates()[i])) {
        status = label(i, solid, visitor);
        if (status.code() != ERROR_CANNOT_SPLIT && status.code() != ERROR_TETRAHEDRALIZATION) return status;
        m_refusal = std::exchange(status, {});
      }
    }
    return status;
  }

  /// returns what was found about the partition that `next()` made last; nothing if it was given.
  std::optional<Partition_candidate_3> chosen() const {
    return m_tried.empty() ? std::nullopt : std::make_optional(m_tried.back().candidate);
  }

private:
  using Search = Partition_search_3<GeomTraits>;
  struct Labels {};
  struct Tried {
    Partition_candidate_3 candidate;
    double wall_width;
  };

  Partition_sequence_3(Mesh solid, Labels)
      : m_solid(std::make_unique<Mesh>(std::move(solid))), m_is_labelled(true) {}

  // Why, if candidates were found but none could be made.
  Status no_further_one() const {
    return m_tried.empty() && !m_refusal.ok() ? m_refusal : Status(ERROR_NO_PARTITION, "there is no further one");
  }

  Status take_labels(Mesh& solid) {
    if (!m_solid) return no_further_one();
    solid = std::move(*m_solid);
    m_solid.reset();
    return {};
  }

  // As coarsely as the surface allows, to try partitions on; and at once as wanted if the mesher cuts its triangles.
  template <typename Visitor>
  Status fill(Visitor& visitor) {
    m_surface.labels.resize(m_surface.triangles.size(), INTERIOR);
    const Status status = internal::run_stage(visitor, "tetrahedralize, to try partitions", [&] {
      const Status coarse = tetrahedralize(m_surface, *m_solid);
      if (!coarse.ok() || m_solid->number_of_boundary_facets() == m_surface.triangles.size()) return coarse;
      const Surface surface = std::exchange(m_surface, {});
      return tetrahedralize(surface, *m_solid, m_number_of_cells);
    });
    m_is_filled = status.ok();
    return status;
  }

  template <typename Visitor>
  Status search(Visitor& visitor) {
    constexpr int most_searches = 2;
    constexpr double broad = .8;
    constexpr std::size_t few = 2;
    if (m_searches == most_searches) return no_further_one();
    if (m_searches++ > 0) {
      m_options.only_by_loops = true;
      m_options.wall_width = broad;
      m_options.number_of_candidates = few;
    }
    m_next = 0;
    m_search = std::make_unique<Search>(*m_solid, m_options);
    const Status status = internal::run_stage(visitor, "partition", [&] { return m_search->run(visitor); });
    if (!status.ok()) m_searches = most_searches;
    return status;
  }

  template <typename Visitor>
  Status label(std::size_t i, Mesh& solid, Visitor& visitor) {
    Mesh labelled;
    const Status status = m_surface.triangles.empty()
                              ? m_search->label(i, labelled = *m_solid)
                              : internal::run_stage(visitor, "tetrahedralize", [&] {
                                  Surface surface = m_surface;
                                  m_search->label(i, surface);
                                  return tetrahedralize(surface, labelled, m_number_of_cells);
                                });
    if (!status.ok()) return status;
    solid = std::move(labelled);
    m_tried.push_back({m_search->candidates()[i], m_options.wall_width});
    return status;
  }

  // One made in the same way, along nearly the same line.
  bool is_like_one_tried(const Partition_candidate_3& candidate) const {
    constexpr double cosine_of_same = .866; // 30 degrees
    const Sweep_direction_3& d = candidate.direction;
    return std::any_of(m_tried.begin(), m_tried.end(), [&](const Tried& other) {
      const Sweep_direction_3& e = other.candidate.direction;
      return other.candidate.method == candidate.method && other.wall_width == m_options.wall_width &&
             std::abs(d * e) > cosine_of_same * std::sqrt(d.squared_length() * e.squared_length());
    });
  }

  Partition_options m_options; // of the search that runs
  Surface m_surface;           // unless the mesher cuts its triangles, or the solid was given
  std::size_t m_number_of_cells = 0;
  std::unique_ptr<Mesh> m_solid; // stays where it is, as a search refers to it; null once its labels are taken
  bool m_is_filled = false, m_is_labelled = false;
  std::unique_ptr<Search> m_search;
  int m_searches = 0;
  std::size_t m_next = 0; // candidate of the search
  std::vector<Tried> m_tried;
  Status m_refusal; // of the last candidate that could not be made
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_SEQUENCE_3_H
