// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SWEEP_GUIDE_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SWEEP_GUIDE_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

tells a sweep in which order to take the cells, as far as the rules leave a choice.
*/
struct Sweep_guide_3 {
  Sweep_guide_3() = default;
  /// takes one potential for each cell and, if there are any, the signs of the flux through its four facets.
  Sweep_guide_3(std::vector<double> potential, std::vector<std::array<std::int8_t, 4>> signs = {})
      : potential(std::move(potential)), signs(std::move(signs)) {}

  std::vector<double> potential; ///< one value for each cell, increasing from the floor to the ceiling
  /// for each facet of each cell +1 if it should be an entry, -1 if an exit: a cell all of whose wishes are met comes
  /// before any other; or empty
  std::vector<std::array<std::int8_t, 4>> signs;
  /// the order of cells of equal potential; or empty: then by number
  std::vector<std::uint32_t> ranks;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SWEEP_GUIDE_3_H
