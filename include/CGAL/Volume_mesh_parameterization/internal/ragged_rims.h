// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RAGGED_RIMS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RAGGED_RIMS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Labelled_surface.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
Tells how ragged rims are that follow edges of a mesh: the share of their length where the surface is almost flat, or next to
vertices where they turn by more than 30 degrees though not along a crease. At a crease facets meet at 20 degrees or more,
where the surface is flat at less than 10.
*/
class Ragged_rims {
public:
  explicit Ragged_rims(const Labelled_surface& labelled)
      : m_labelled(labelled), m_surface(labelled.surface) {}

  double share() const {
    double ragged = 0, all = 0;
    for (Id h = 0; h < m_surface.number_of_half_edges(); ++h) {
      if (m_labelled.label(h) < FIRST_WALL || !m_labelled.is_rim(h)) continue;
      const Id g = next_on_rim(h);
      const double length = (std::sqrt(edge(h).squared_length()) + std::sqrt(edge(g).squared_length())) / 2;
      all += length;
      const double bend = std::max(cosine_between_facets(h), cosine_between_facets(g));
      if (bend > cosine_of_flat || (turns(h, g) && bend > cosine_of_crease)) ragged += length;
    }
    return all > 0 ? ragged / all : 0;
  }

private:
  using Id = Refined_surface::Id;
  static constexpr double cosine_of_turn = .866, cosine_of_crease = .940, cosine_of_flat = .985;

  Double_kernel::Vector_3 edge(Id h) const {
    return m_surface.points()[m_surface.target(h)] - m_surface.points()[m_surface.source(h)];
  }

  Id next_on_rim(Id h) const {
    Id g = Refined_surface::next(h);
    while (!m_labelled.is_rim(g)) g = Refined_surface::next(m_surface.opposite(g));
    return g;
  }

  bool turns(Id h, Id g) const {
    const auto e = edge(h), f = edge(g);
    return e * f < cosine_of_turn * std::sqrt(e.squared_length() * f.squared_length());
  }

  double cosine_between_facets(Id h) const {
    return m_surface.unit_normal(h / 3) * m_surface.unit_normal(m_surface.opposite(h) / 3);
  }

  const Labelled_surface& m_labelled;
  const Refined_surface& m_surface;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RAGGED_RIMS_H
