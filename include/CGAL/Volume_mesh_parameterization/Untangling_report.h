// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_UNTANGLING_REPORT_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_UNTANGLING_REPORT_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

tells what it took to find a map of tetrahedra without flips.
*/
struct Untangling_report {
  std::size_t flipped_at_start = 0; ///< flipped or flat tetrahedra of the first map of the interior
  std::size_t flipped_at_end = 0;   ///< those that resisted
  std::size_t rounds = 0;           ///< passes over the clusters of flipped tetrahedra
  std::size_t split_simplices = 0;  ///< edges and facets inside that were split where tetrahedra resisted
  std::size_t refilled_balls = 0;   ///< clusters of flipped tetrahedra whose surroundings were mapped anew
  double work = 0;                  ///< Newton steps of cells over the number of cells of the mesh
  std::size_t relaxed_clusters = 0; ///< clusters of badly distorted tetrahedra that were relaxed
  bool starts_along_curves =
      false; ///< whether the first map of the interior was that along curves, else the harmonic one
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_UNTANGLING_REPORT_H
