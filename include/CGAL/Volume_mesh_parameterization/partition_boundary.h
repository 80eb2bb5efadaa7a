// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>

#include <cstddef>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels the boundary of a solid as floor, ceiling and walls, by the best partition of a `Partition_search_3` whose splits can
be repeated in the solid.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Visitor a class with the functions of `Default_parameterization_visitor`

\param solid a mesh that `check_tetrahedral_mesh()` accepted. It gets the labels; where edges are split it has more vertices,
those that it had come first. On failure it is left as it was
\param options directions, labels that facets must have, and the like
\param chosen if not null, receives the partition that was taken
\param visitor is asked whether to go on

\returns the errors of `Partition_search_3::run()` and `Partition_search_3::label()`
*/
template <typename GeomTraits, typename Visitor = Default_parameterization_visitor>
Status partition_boundary(Compact_tetrahedral_mesh_3<GeomTraits>& solid,
                          const Partition_options& options = {}, Partition_candidate_3* chosen = nullptr,
                          Visitor&& visitor = Visitor()) {
  Partition_search_3<GeomTraits> search(solid, options);
  Status status = search.run(visitor);
  for (std::size_t i = 0; i < search.candidates().size(); ++i) {
    status = search.label(i, solid);
    if (status.code() == ERROR_CANNOT_SPLIT) continue;
    if (status.ok() && chosen) *chosen = search.candidates()[i];
    break;
  }
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H
