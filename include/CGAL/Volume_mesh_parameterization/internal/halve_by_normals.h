// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HALVE_BY_NORMALS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HALVE_BY_NORMALS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_halves.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Tells floor from ceiling by the sign of n * direction for averaged normals n. Facets that are known to be floor or ceiling
pull the average to their side, those of walls to 0.
*/
class Normal_halver {
public:
  // `picks` are the labels of facets that are known, INTERIOR for the others.
  Normal_halver(const Labelled_surface& surface, const Approximate_surface& approximate,
                const std::vector<int>& picks)
      : m_surface(surface),
        m_approximate(approximate),
        m_pull(Vertex_field::Zero(Eigen::Index(approximate.points.size()))),
        m_pulled_to(m_pull) {
    for (Facet_index f : approximate.adjacency.facets())
      if (picks[f] != INTERIOR) pull(f, picks[f]);
  }

  // There are more averages than one; pulled ones are tried up to all of the surface.
  std::size_t number_of_averages() const { return m_has_picks ? shares.size() : shares.size() - 2; }

  // By the k-th average.
  Status run(const Double_kernel::Vector_3& direction, std::size_t k, double island_share,
             Labelled_surface& halves) {
    return cut_halves(m_surface, rise(direction, k), island_share, halves);
  }

  // Between -1 and 1 for a unit vector.
  Vertex_field rise(const Double_kernel::Vector_3& d, std::size_t k) {
    if (m_averages[k].pulled.size() == 0) m_averages[k] = average(shares[k]);
    const auto& n = m_averages[k].normals;
    return d.x() * n[0] + d.y() * n[1] + d.z() * n[2] + m_averages[k].pulled;
  }

private:
  struct Average {
    std::array<Vertex_field, 3> normals; // by coordinate
    Vertex_field pulled;
  };

  // of the area, over which is averaged
  static constexpr std::array<double, 7> shares = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 1e-1, 10};

  void pull(Facet_index f, int label) {
    m_has_picks = true;
    const double mass = m_approximate.total_area;
    for (Vertex_index v : m_approximate.adjacency.triangle(f)) {
      m_pull[v] = mass;
      m_pulled_to[v] = (label == FLOOR ? -1 : label == CEILING ? 1 : 0) * mass;
    }
  }

  Average average(double share) const {
    const Surface_diffusion diffusion(m_approximate, share * m_approximate.total_area, m_pull);
    Average result = {integrated_normals(m_approximate), diffusion.average_of_integral(m_pulled_to)};
    for (Vertex_field& coordinate : result.normals) coordinate = diffusion.average_of_integral(coordinate);
    return result;
  }

  const Labelled_surface& m_surface;
  const Approximate_surface& m_approximate;
  Vertex_field m_pull, m_pulled_to;
  bool m_has_picks = false;
  std::array<Average, shares.size()> m_averages;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HALVE_BY_NORMALS_H
