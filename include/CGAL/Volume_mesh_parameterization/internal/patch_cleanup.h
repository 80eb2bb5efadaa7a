// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PATCH_CLEANUP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PATCH_CLEANUP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The edge-connected parts of equal label: their labels and areas, and which labels they meet.
struct Labelled_parts {
  Labelled_parts(const Approximate_surface& surface, const std::vector<int>& facet_labels)
      : part_of(surface.adjacency,
                [&](Facet_index f, Facet_index g) { return facet_labels[f] == facet_labels[g]; }),
        labels(part_of.size()),
        areas(part_of.size(), 0),
        meets(part_of.size(), {false, false, false, false}) {
    for (Facet_index f : surface.adjacency.facets()) {
      labels[part_of[f]] = facet_labels[f];
      areas[part_of[f]] += surface.areas[f];
      for (int i = 0; i < 3; ++i) meets[part_of[f]][facet_labels[surface.adjacency.neighbor(f, i)]] = true;
    }
    for (std::size_t p = 0; p < size(); ++p) {
      std::size_t& l = largest[labels[p]];
      if (l == none || areas[p] > areas[l]) l = p;
    }
  }

  std::size_t size() const { return labels.size(); }

  static constexpr std::size_t none = std::size_t(-1);
  Facet_components part_of;
  std::vector<int> labels;
  std::vector<double> areas;
  std::vector<std::array<bool, FIRST_WALL + 1>> meets;                        // by label
  std::array<std::size_t, FIRST_WALL + 1> largest = {none, none, none, none}; // part of each label
};

// Gives whole parts another label, as `new_label(parts, p)` says, until nothing changes. Each round that changes
// something merges parts, but two labels could chase each other: hence the bound.
template <typename NewLabel>
void relabel_parts(const Approximate_surface& surface, std::vector<int>& labels, const NewLabel& new_label) {
  bool has_changed = true;
  for (int round = 0; round < 10 && has_changed; ++round) {
    const Labelled_parts parts(surface, labels);
    has_changed = false;
    for (Facet_index f : surface.adjacency.facets()) {
      const int label = new_label(parts, parts.part_of[f]);
      has_changed |= label != labels[f];
      labels[f] = label;
    }
  }
}

// Flips small parts of the floor within the ceiling, and of the ceiling within the floor.
inline void remove_islands(const Approximate_surface& surface, std::vector<int>& labels, double share) {
  relabel_parts(surface, labels, [&](const Labelled_parts& parts, std::size_t p) {
    const int label = parts.labels[p];
    const bool is_island = p != parts.largest[label] && parts.areas[p] < share * surface.total_area;
    return is_island ? FLOOR + CEILING - label : label;
  });
}

// What becomes of a bore with a step that faces a base: it is part of the wall, or the bore is base down to the step.
enum Cleaning_order { APART_BASES_FIRST, POCKETS_FIRST };

// Small parts of floor or ceiling that lie apart go to the walls, and walls that meet one base only go to it: one as long as
// something changes, then the other. All walls are labelled FIRST_WALL here.
inline void remove_fragments(const Approximate_surface& surface, std::vector<int>& labels, double share,
                             Cleaning_order order) {
  const auto to_walls = [&](const Labelled_parts& parts, std::size_t p) {
    const bool is_apart = parts.labels[p] < FIRST_WALL && p != parts.largest[parts.labels[p]];
    return is_apart && parts.areas[p] < share * surface.total_area ? int(FIRST_WALL) : parts.labels[p];
  };
  const auto to_bases = [](const Labelled_parts& parts, std::size_t p) {
    const bool is_pocket = parts.labels[p] == FIRST_WALL && parts.meets[p][FLOOR] != parts.meets[p][CEILING];
    return !is_pocket ? parts.labels[p] : parts.meets[p][FLOOR] ? int(FLOOR) : int(CEILING);
  };
  if (order == POCKETS_FIRST) relabel_parts(surface, labels, to_bases);
  relabel_parts(surface, labels, to_walls);
  relabel_parts(surface, labels, to_bases);
}

// Numbers the parts labelled FIRST_WALL from the largest to the smallest.
inline void number_walls(const Approximate_surface& surface, std::vector<int>& labels) {
  const Labelled_parts parts(surface, labels);
  std::vector<std::pair<double, std::size_t>> walls;
  for (std::size_t p = 0; p < parts.size(); ++p)
    if (parts.labels[p] == FIRST_WALL) walls.push_back({-parts.areas[p], p});
  std::sort(walls.begin(), walls.end());
  std::vector<int> label_of = parts.labels;
  for (std::size_t k = 0; k < walls.size(); ++k) label_of[walls[k].second] = FIRST_WALL + int(k);
  for (Facet_index f : surface.adjacency.facets()) labels[f] = label_of[parts.part_of[f]];
}

// Whether floor, ceiling and walls are those of a product, as far as counting can tell.
inline Status validate_labels(const Approximate_surface& surface, const std::vector<int>& labels) {
  const Boundary_partition_3 summary = summarize(surface.adjacency, labels, surface.areas);
  return Partition_validator(surface.adjacency, labels, summary).validate();
}

// From labels where all walls are FIRST_WALL to legal ones, without fragments of less than `share`.
inline Status clean_patches(const Approximate_surface& surface, std::vector<int>& labels, double share,
                            Cleaning_order order = APART_BASES_FIRST) {
  remove_fragments(surface, labels, share, order);
  number_walls(surface, labels);
  return validate_labels(surface, labels);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PATCH_CLEANUP_H
