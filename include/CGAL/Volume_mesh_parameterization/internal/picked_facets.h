// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PICKED_FACETS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PICKED_FACETS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>

#include <algorithm>
#include <string>
#include <vector>

// Labels of facets of a solid that its partition must have; INTERIOR where it is free.

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The label of each facet of the solid: that of its largest triangle.
inline std::vector<int> labels_of_given_facets(const Labelled_surface& labelled) {
  std::vector<int> result;
  std::vector<double> largest;
  const auto& points = labelled.surface.points();
  for (std::size_t t = 0; t < labelled.labels.size(); ++t) {
    const auto& v = labelled.surface.triangles()[t];
    const std::size_t f = labelled.surface.parent(Refined_surface::Id(t));
    const double area = CGAL::squared_area(points[v[0]], points[v[1]], points[v[2]]);
    if (f >= result.size()) {
      result.resize(f + 1, INTERIOR);
      largest.resize(f + 1, -1);
    }
    if (area <= largest[f]) continue;
    largest[f] = area;
    result[f] = labelled.labels[t];
  }
  return result;
}

/*
Numbers the walls as picks ask for, and refuses a partition that does not honour the picks.
*/
class Pick_checker {
public:
  // `given` is the surface of the solid.
  Pick_checker(const Facet_adjacency& given, const std::vector<int>& picks, Labelled_surface& labelled)
      : m_given(given), m_picks(picks), m_labelled(labelled), m_labels(labels_of_given_facets(labelled)) {}

  Status run() {
    const int last = *std::max_element(m_labelled.labels.begin(), m_labelled.labels.end());
    m_number_of.assign(last + 1, INTERIOR);
    for (std::size_t f = 0; f < m_picks.size(); ++f) {
      const Status status = check(f, last);
      if (!status.ok()) return status;
    }
    number_other_walls();
    for (int& label : m_labelled.labels) label = m_number_of[label];
    return {};
  }

private:
  Status check(std::size_t f, int last) {
    const int wish = m_picks[f], label = m_labels[f];
    if (wish == INTERIOR) return {};
    if (wish < FLOOR || wish > last)
      return {ERROR_PICKED_FACET,
              name(f) + " is to be " + patch_name(wish) + ", but the last patch is " + patch_name(last)};
    const bool is_free =
        label >= FIRST_WALL && wish >= FIRST_WALL && m_number_of[label] == INTERIOR && !is_taken(wish);
    if (is_free) m_number_of[label] = wish;
    const bool is_honoured = label < FIRST_WALL ? wish == label : m_number_of[label] == wish;
    return is_honoured
               ? Status()
               : Status(ERROR_PICKED_FACET, name(f) + " is to be " + patch_name(wish) + describe(label));
  }

  bool is_taken(int number) const {
    return std::find(m_number_of.begin(), m_number_of.end(), number) != m_number_of.end();
  }

  std::string describe(int label) const {
    if (label < FIRST_WALL) return ", but is " + patch_name(label);
    return ", but lies in " +
           (m_number_of[label] == INTERIOR ? "a different wall" : patch_name(m_number_of[label]));
  }

  // By its vertices: the surface that the solid was made of may number its facets differently.
  std::string name(std::size_t facet) const {
    const auto& v = m_given.triangle(Facet_index(facet));
    return "the facet with vertices " + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
           std::to_string(v[2]);
  }

  void number_other_walls() {
    int next = FIRST_WALL;
    for (int label = FLOOR; label < int(m_number_of.size()); ++label) {
      if (label < FIRST_WALL) m_number_of[label] = label;
      if (m_number_of[label] != INTERIOR) continue;
      while (is_taken(next)) ++next;
      m_number_of[label] = next;
    }
  }

  const Facet_adjacency& m_given;
  const std::vector<int>& m_picks;
  Labelled_surface& m_labelled;
  std::vector<int> m_labels;    // of the facets of the solid
  std::vector<int> m_number_of; // what the walls will be called, by label
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PICKED_FACETS_H
