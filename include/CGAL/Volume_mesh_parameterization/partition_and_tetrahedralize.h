// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_AND_TETRAHEDRALIZE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_AND_TETRAHEDRALIZE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>
#include <CGAL/Volume_mesh_parameterization/partition_by_loops.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Takes the first partition of `surface` with which the solid that make_solid(labelled surface, solid) makes is legal.
template <typename Surface, typename MakeSolid, typename GeomTraits>
Status find_legal_solid(const Surface& surface, const std::vector<Sweep_direction_3>& directions,
                        const MakeSolid& make_solid, Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                        Sweep_direction_3* direction) {
  Boundary_partition_search_3<Surface> search(surface, directions);
  Surface labelled;
  Status refusal;
  Status found;
  while ((found = search.next(labelled)).ok()) {
    Compact_tetrahedral_mesh_3<GeomTraits> solid;
    Status status = make_solid(labelled, solid);
    if (status.ok()) status = validate_solid(solid);
    if (status.ok()) {
      mesh = std::move(solid);
      if (direction) *direction = search.direction();
    }
    if (status.code() != ERROR_FLOOR_NOT_ONTO) return status;
    refusal = std::move(status);
  }
  if (found.code() != ERROR_NO_PARTITION) return found;
  return {ERROR_NO_PARTITION, std::to_string(directions.size()) +
                                  " direction(s) tried, the last one fails so: " +
                                  (refusal.ok() ? found.detail() : refusal.message())};
}

// The last resort after `refusal`.
template <typename GeomTraits>
Status find_loops(const Status& refusal, const std::vector<Sweep_direction_3>& directions,
                  Compact_tetrahedral_mesh_3<GeomTraits>& mesh, Sweep_direction_3* direction) {
  const Status status = partition_by_loops(mesh, directions, direction);
  if (status.code() != ERROR_NO_PARTITION) return status;
  return {ERROR_NO_PARTITION, refusal.detail() + "; by loops: " + status.detail()};
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels the boundary of `mesh` by the first legal partition along one of `directions`: one that passes
`validate_partition()` and `validate_fundamental_group()`. If there is none, `partition_by_loops()` is the last resort.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh gets the labels; where the partitioner splits edges it has more vertices, those that it had come first. On
failure it is left as it was
\param directions for example those of `propose_directions()`
\param direction if not null, receives the direction that was taken

\returns `ERROR_NO_PARTITION`, `ERROR_NOT_A_HANDLEBODY`, or the other errors of `Boundary_partition_search_3::next()`
*/
template <typename GeomTraits>
Status partition_solid(Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                       const std::vector<Sweep_direction_3>& directions,
                       Sweep_direction_3* direction = nullptr) {
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  const auto take = [](Mesh& labelled, Mesh& solid) {
    solid = std::move(labelled);
    return Status();
  };
  const Status status = internal::find_legal_solid(mesh, directions, take, mesh, direction);
  return status.code() == ERROR_NO_PARTITION ? internal::find_loops(status, directions, mesh, direction)
                                             : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

fills a surface with tetrahedra, its boundary labelled by the first legal partition along one of `directions`, or by
`partition_by_loops()` if there is none.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param surface a closed surface that `check_surface()` accepted
\param directions as for `partition_solid()`
\param number_of_cells as for `tetrahedralize()`
\param mesh receives the solid; on failure it is left as it was
\param direction if not null, receives the direction that was taken

\returns the errors of `partition_solid()` or `tetrahedralize()`
*/
template <typename GeomTraits>
Status partition_and_tetrahedralize(const Triangle_soup_3<typename GeomTraits::Point_3>& surface,
                                    const std::vector<Sweep_direction_3>& directions,
                                    std::size_t number_of_cells, Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                                    Sweep_direction_3* direction = nullptr) {
  using Point_3 = typename GeomTraits::Point_3;
  const auto fill = [number_of_cells](const Triangle_soup_3<Point_3>& labelled,
                                      Compact_tetrahedral_mesh_3<GeomTraits>& solid) {
    Tetrahedron_soup_3<Point_3> soup;
    const Status status = tetrahedralize(labelled, soup, number_of_cells);
    return status.ok() ? solid.assign(soup) : status;
  };
  Status status = internal::find_legal_solid(surface, directions, fill, mesh, direction);
  if (status.code() != ERROR_NO_PARTITION || directions.empty()) return status;
  Compact_tetrahedral_mesh_3<GeomTraits> solid;
  const Status filled = fill(surface, solid);
  if (!filled.ok()) return filled;
  status = internal::find_loops(status, directions, solid, direction);
  if (status.ok()) mesh = std::move(solid);
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_AND_TETRAHEDRALIZE_H
