// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HALVE_BY_LOOPS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HALVE_BY_LOOPS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/primitive_loops.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_halves.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Halves the boundary of a handlebody of genus n. The words of its edges tell which loops are primitive: part of a basis of
the homology of the solid. n such loops, disjoint, short and steep, and one more curve separate floor from ceiling.
*/
class Loop_halver {
public:
  using Id = Refined_surface::Id;
  using Path = std::vector<Id>;

  Loop_halver(const Labelled_surface& given, const Handlebody_certificate& certificate)
      : m_given(given), m_certificate(certificate) {}

  // `averaged_rise` is the height of the outward normals at the vertices: a loop rather runs where it is 0, and the ceiling
  // takes what rises.
  Status run(const Sweep_direction_3& direction, const Vertex_field& averaged_rise,
             Labelled_surface& halves) const {
    std::vector<double> rise(averaged_rise.begin(), averaged_rise.end());
    Refined_surface surface = m_given.surface;
    std::vector<Path> loops;
    Edges splits;
    Status status = find_loops(surface, rise, loops, splits);
    if (!status.ok()) return status;
    Surface_halver halver(surface, loops, direction, rise);
    status = halver.run();
    if (!status.ok()) return status;
    halves = m_given;
    bisect(splits, halves);
    bisect(halver.splits(), halves);
    label_halves(halver, halves);
    return status;
  }

private:
  using Edges = std::vector<std::array<Id, 2>>;
  static constexpr double horizontal_length = 6; // of an edge that does not rise; of a steep one 1

  // Steep edges count as shorter. Each loop is cut on the surface, and chords are bisected, so that there is room for the
  // next one; `splits` receives them.
  Status find_loops(Refined_surface& surface, std::vector<double>& rise, std::vector<Path>& loops,
                    Edges& splits) const {
    const auto length = [&](Id v, Id w) {
      return surface.length(v, w) * (1 + (horizontal_length - 1) * std::abs(rise[v] + rise[w]) / 2);
    };
    Edge_classes classes(m_certificate, m_given.surface.number_of_vertices());
    Free_quotient quotient(m_certificate.genus());
    while (loops.size() < std::size_t(m_certificate.genus())) {
      Primitive_loop_search<decltype(length)> search(surface, classes, quotient, length);
      loops.push_back(search.run());
      if (loops.back().empty())
        return {ERROR_NO_PARTITION, "no primitive loop is disjoint from the " +
                                        std::to_string(loops.size() - 1) + " loops chosen before"};
      quotient.divide_by(search.loop_class());
      surface.cut(loops.back());
      for (const auto& [v, w] : surface.split_chords()) {
        splits.push_back({v, w});
        classes.add_midpoint(v);
        rise.push_back((rise[v] + rise[w]) / 2);
      }
    }
    return {};
  }

  // Later edges may end at the midpoints of earlier ones.
  static void bisect(const Edges& edges, Labelled_surface& halves) {
    for (const auto& [v, w] : edges) halves.split(v, w, .5);
  }

  // The halver knows the same triangles in another order.
  static void label_halves(const Surface_halver& halver, Labelled_surface& halves) {
    using Triangle = Refined_surface::Triangle;
    const auto sorted = [](Triangle t) {
      std::sort(t.begin(), t.end());
      return t;
    };
    std::vector<Triangle> ceiling;
    for (const Triangle& t : halver.triangles(true)) ceiling.push_back(sorted(t));
    std::sort(ceiling.begin(), ceiling.end());
    halves.labels.clear();
    for (const Triangle& t : halves.surface.triangles())
      halves.labels.push_back(std::binary_search(ceiling.begin(), ceiling.end(), sorted(t)) ? CEILING
                                                                                            : FLOOR);
  }

  const Labelled_surface& m_given;
  const Handlebody_certificate& m_certificate;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HALVE_BY_LOOPS_H
