// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_BOUNDARY_MAPPER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_BOUNDARY_MAPPER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Prism_boundary_embedding.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Tries several choices of corners and creases, until a map of the boundary of a solid onto that of a prism is little
// distorted: it is hard to foretell what suits a wall.
template <typename FloorMap>
class Prism_boundary_mapper {
public:
  using Embedding = Prism_boundary_embedding<FloorMap>;

  Status run(const Embedding& start) {
    constexpr double good = 8; // the energy of maps that extend inside with ease; 4 is that of an isometry
    Status status;
    for (double evenness : {0., .75}) {
      auto candidate = std::make_unique<Embedding>(start);
      const Status of_candidate = candidate->embed(evenness);
      if (!of_candidate.ok())
        status = of_candidate;
      else if (!m_best || candidate->energy() < m_best->energy())
        m_best = std::move(candidate);
      if (m_best && m_best->energy() < good) break;
    }
    if (!m_best) return status;
    m_best->relax(ROUGHLY);
    return {};
  }

  // The one with the least energy.
  const Embedding& best() const { return *m_best; }

private:
  std::unique_ptr<Embedding> m_best;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_PRISM_BOUNDARY_MAPPER_H
