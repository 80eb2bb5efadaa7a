// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARTITION_MAKER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARTITION_MAKER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_halves.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_walls.h>
#include <CGAL/Volume_mesh_parameterization/internal/halve_by_loops.h>
#include <CGAL/Volume_mesh_parameterization/internal/halve_by_normals.h>
#include <CGAL/Volume_mesh_parameterization/internal/least_energy_labels.h>
#include <CGAL/Volume_mesh_parameterization/internal/patch_cleanup.h>
#include <CGAL/Volume_mesh_parameterization/internal/picked_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/ragged_rims.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Makes partitions of the boundary of a certified handlebody: each way of making one returns the first that is legal and
honours the picks, labels that some facets of the solid must have.
*/
class Partition_maker {
public:
  Partition_maker(const Labelled_surface& given, const Handlebody_certificate& certificate,
                  std::vector<int> picks, double wall_width, double island_share)
      : m_given(given),
        m_certificate(certificate),
        m_picks(std::move(picks)),
        m_wall_width(wall_width),
        m_island_share(island_share),
        m_approximate(given.approximate_surface()),
        m_normals(m_given, m_approximate, m_picks),
        m_loops(m_given, m_certificate) {}

  // From the floor to the ceiling, by the normals of labelled facets.
  Sweep_direction_3 ascent(const std::vector<int>& labels) const {
    return mean_direction(m_approximate, labels);
  }

  // The share of the area that has the same label in two partitions, whichever base is called floor.
  double share_of_common_labels(const Labelled_surface& a, const Labelled_surface& b) const {
    const std::vector<int> labels_a = labels_of_given_facets(a), labels_b = labels_of_given_facets(b);
    double same = 0, reversed = 0;
    for (Facet_index f : m_approximate.adjacency.facets()) {
      const int label_a = std::min<int>(labels_a[f], FIRST_WALL),
                label_b = std::min<int>(labels_b[f], FIRST_WALL);
      if (label_a == label_b) same += m_approximate.areas[f];
      if (label_a == (label_b < FIRST_WALL ? FLOOR + CEILING - label_b : label_b))
        reversed += m_approximate.areas[f];
    }
    return std::max(same, reversed) / m_approximate.total_area;
  }

  // The labels of least energy for a unit vector: their rims run along creases if there are some.
  std::vector<int> labels_by_creases(const Sweep_direction_3& direction) const {
    return least_energy_labels(m_approximate, with_picks(costs_by_direction(m_approximate, direction)));
  }

  // Takes such labels once they are clean. At most this share of the rims may be ragged.
  Status by_creases(std::vector<int> labels, Cleaning_order order, double most_ragged,
                    Labelled_surface& result) const {
    Labelled_surface labelled = m_given;
    labelled.labels = std::move(labels);
    Status status = clean_patches(m_approximate, labelled.labels, m_island_share, order);
    if (status.ok() && Ragged_rims(labelled).share() > most_ragged)
      status = {ERROR_NO_PARTITION, "there are no creases where rims should run"};
    if (status.ok()) status = check_group_and_picks(labelled);
    if (status.ok()) result = std::move(labelled);
    return status;
  }

  // Rims near those of a given partition that is not quite legal.
  Status by_labels(const std::vector<int>& labels, Labelled_surface& result) const {
    const std::vector<int> smooth = least_energy_labels(m_approximate, with_picks(costs_by_labels(labels)));
    const Status status = by_creases(smooth, APART_BASES_FIRST, 1, result);
    return status.ok() ? status : by_sides(labels, result);
  }

  // Rims beside the curve where averaged normals turn from one side of a unit vector to the other.
  Status by_normals(const Sweep_direction_3& direction, Labelled_surface& result) {
    Status refusal;
    for (std::size_t k = 0; k < m_normals.number_of_averages(); ++k) {
      Labelled_surface halves;
      Status status = m_normals.run(direction, k, m_island_share, halves);
      if (status.ok()) status = widen(halves, result);
      if (status.ok()) return status;
      if (refusal.code() != ERROR_PICKED_FACET) refusal = status; // which tells most
    }
    return refusal;
  }

  // Rims beside primitive loops and one more curve, which only care for a unit vector.
  Status by_loops(const Sweep_direction_3& direction, Labelled_surface& result) {
    Labelled_surface halves;
    const Status status = m_loops.run(direction, m_normals.rise(direction, average_for_loops), halves);
    if (!status.ok()) return status;
    Labelled_surface smooth = halves;
    smooth_halves(smooth);
    if (widen(std::move(smooth), result).ok()) return {};
    return widen(std::move(halves), result);
  }

private:
  static constexpr std::size_t average_for_loops = 2;

  static Label_costs costs_by_labels(const std::vector<int>& labels) {
    Label_costs costs;
    for (int label : labels) {
      costs.push_back({1, 1, 1});
      if (label >= FLOOR) costs.back()[std::min<int>(label, FIRST_WALL) - FLOOR] = 0;
    }
    return costs;
  }

  // Rims beside the curve in the middle between floor and ceiling.
  Status by_sides(const std::vector<int>& labels, Labelled_surface& result) const {
    Status status;
    for (double share : {1e-4, 1e-3, 1e-2}) {
      Labelled_surface halves;
      status = cut_halves(m_given, averaged_sides(m_approximate, labels, share), m_island_share, halves);
      if (status.ok()) status = widen(halves, result);
      if (status.ok()) return status;
    }
    return status;
  }

  Label_costs with_picks(Label_costs costs) const {
    constexpr double very_much = 1e6;
    for (std::size_t f = 0; f < m_picks.size(); ++f)
      if (m_picks[f] >= FLOOR) {
        costs[f].fill(very_much);
        costs[f][std::min<int>(m_picks[f], FIRST_WALL) - FLOOR] = 0;
      }
    return costs;
  }

  Status widen(Labelled_surface halves, Labelled_surface& result) const {
    Labelled_surface labelled;
    Status status = make_walls(std::move(halves), m_wall_width, labelled);
    if (status.ok()) status = check_group_and_picks(labelled);
    if (status.ok()) result = std::move(labelled);
    return status;
  }

  // What counting does not tell.
  Status check_group_and_picks(Labelled_surface& labelled) const {
    const auto triangle = [&](std::size_t t) { return labelled.surface.triangles()[t]; };
    const Status status =
        check_bases_carry_group(m_certificate, labelled.labels, triangle, labelled.origins());
    return status.ok() ? Pick_checker(m_approximate.adjacency, m_picks, labelled).run() : status;
  }

  const Labelled_surface& m_given;
  const Handlebody_certificate& m_certificate;
  std::vector<int> m_picks; // by facet of the solid
  double m_wall_width, m_island_share;
  Approximate_surface m_approximate;
  Normal_halver m_normals;
  Loop_halver m_loops;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PARTITION_MAKER_H
