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
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

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

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels a closed surface as the function above labels the solid inside, of which it makes a coarse mesh for that. Needs TetGen,
which keeps the triangles of the surface.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\tparam Visitor as above

\param surface a surface that `check_surface()` accepted. It gets labels, and where edges are split more triangles. On
failure it is left as it was
\param options as above; labels that facets must have are those of the surface
\param chosen as above
\param visitor as above

\returns also the errors of `tetrahedralize()`
*/
template <typename GeomTraits, typename Visitor = Default_parameterization_visitor>
Status partition_surface(Triangle_soup_3<typename GeomTraits::Point_3>& surface,
                         const Partition_options& options = {}, Partition_candidate_3* chosen = nullptr,
                         Visitor&& visitor = Visitor()) {
  Compact_tetrahedral_mesh_3<GeomTraits> solid;
  Triangle_soup_3<typename GeomTraits::Point_3> labelled = surface;
  labelled.labels.resize(surface.triangles.size(), INTERIOR);
  Status status = tetrahedralize(labelled, solid); // as coarsely as the surface allows
  if (status.ok() && solid.number_of_boundary_facets() != surface.triangles.size())
    status = {ERROR_TETRAHEDRALIZATION, "the mesher has cut triangles of the surface"};
  if (!status.ok()) return status;
  Partition_search_3<GeomTraits> search(solid, options);
  status = search.run(visitor);
  if (!status.ok()) return status;
  if (chosen) *chosen = search.candidates()[0];
  search.label(0, surface);
  return status;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

fills a surface with tetrahedra, its boundary labelled by `partition_surface()`, or by `partition_boundary()` without TetGen.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\tparam Visitor as for `partition_surface()`

\param surface, options, chosen, visitor as for `partition_surface()`; the surface is copied
\param number_of_cells as for `tetrahedralize()`
\param solid receives the mesh; on failure it is left as it was

\returns the errors of `partition_surface()` and `tetrahedralize()`
*/
template <typename GeomTraits, typename Visitor = Default_parameterization_visitor>
Status partition_and_tetrahedralize(Triangle_soup_3<typename GeomTraits::Point_3> surface,
                                    const Partition_options& options, std::size_t number_of_cells,
                                    Compact_tetrahedral_mesh_3<GeomTraits>& solid,
                                    Partition_candidate_3* chosen = nullptr, Visitor&& visitor = Visitor()) {
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN
  const Status status = partition_surface<GeomTraits>(surface, options, chosen, visitor);
  return status.ok() ? tetrahedralize(surface, solid, number_of_cells) : status;
#else // the constrained Delaunay triangulation cuts triangles: the solid is divided as it is then
  Compact_tetrahedral_mesh_3<GeomTraits> filled;
  surface.labels.resize(surface.triangles.size(), INTERIOR);
  Status status = tetrahedralize(surface, filled, number_of_cells);
  if (status.ok()) status = partition_boundary(filled, options, chosen, visitor);
  if (status.ok()) solid = std::move(filled);
  return status;
#endif
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PARTITION_BOUNDARY_H
