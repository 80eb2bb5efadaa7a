// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRALIZE_POLYCUBE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRALIZE_POLYCUBE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/Box_grid_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/boxes_of_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/internal/cut_boxes.h>
#include <CGAL/Volume_mesh_parameterization/internal/enclosed_boxes.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

template <typename FT, typename GeomTraits>
Status tetrahedralize_grid(Box_grid_3<FT> grid, Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                           std::size_t number_of_cells) {
  constexpr std::size_t cells_of_box = 6;
  Status status = check_contacts(grid);
  if (status.ok()) status = check_connected(grid);
  if (!status.ok()) return status;
  if (grid.boxes.size() * cells_of_box < number_of_cells)
    grid = Box_grid_refinement<FT>(grid, number_of_cells / cells_of_box).refined();
  Compact_tetrahedral_mesh_3<GeomTraits> result;
  status = result.assign(Box_cutter<typename GeomTraits::Point_3, FT>(grid).run());
  if (status.ok()) status = check_tetrahedral_mesh(result);
  if (status.ok()) mesh = std::move(result);
  return status;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationMesh

fills a polycube that is given as hexahedra with tetrahedra: six for each box of the grid of all its planes, or of a finer
one. Labels of quadrilaterals become those of the boundary facets; other boundary facets get none.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param boxes hexahedra that are boxes along the axes, in any order of their vertices; they need not have common vertices
\param mesh receives the mesh; on failure it is left as it was
\param number_of_cells about how many tetrahedra are wanted; there may be more if the polycube has many planes

\returns `ERROR_EMPTY_MESH`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_INDEX_OUT_OF_RANGE`; `ERROR_NOT_A_POLYCUBE` if a
hexahedron is no box, or two overlap; `ERROR_LABEL_NOT_ON_BOUNDARY`; `ERROR_NON_MANIFOLD` if boxes meet in an edge or vertex
only; `ERROR_SEVERAL_COMPONENTS`, also if there is a cavity; `ERROR_WRONG_PARAMETER` if the grid has too many boxes

Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ boxes of the grid.
*/
template <typename GeomTraits>
Status tetrahedralize_polycube(const Hexahedron_soup_3<typename GeomTraits::Point_3>& boxes,
                               Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                               std::size_t number_of_cells = 0) {
  internal::Box_grid_3<typename GeomTraits::FT> grid;
  const Status status = internal::Boxes_of_hexahedra<typename GeomTraits::Point_3>(boxes, grid).run();
  return status.ok() ? internal::tetrahedralize_grid(std::move(grid), mesh, number_of_cells) : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

fills a polycube that is given by its surface, as the function above. The polycube is all that the surface separates from
infinity: it does not matter how the surface is cut into polygons, which way these are oriented, and whether there are
more of them inside, as in a file of unit cubes; cavities are filled. Labels of polygons become those of the boundary
facets in the places that they cover, or that they lie in.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param surface simple polygons that are orthogonal to an axis
\param mesh receives the mesh; on failure it is left as it was
\param number_of_cells about how many tetrahedra are wanted; there may be more if the polycube has many planes

\returns `ERROR_NOT_A_POLYCUBE` if a facet is orthogonal to no axis; `ERROR_OPEN_SURFACE` if a facet has the outside on both
sides; and the errors of the function above

Complexity: \f$ O(n \log n) \f$ for \f$ n \f$ boxes between planes of facets, inside and outside, and polygons, if their
extents overlap little.
*/
template <typename GeomTraits>
Status tetrahedralize_polycube(const Polygon_soup_3<typename GeomTraits::Point_3>& surface,
                               Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                               std::size_t number_of_cells = 0) {
  internal::Box_grid_3<typename GeomTraits::FT> grid;
  const Status status = internal::Enclosed_boxes<typename GeomTraits::Point_3>(surface, grid).run();
  return status.ok() ? internal::tetrahedralize_grid(std::move(grid), mesh, number_of_cells) : status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRALIZE_POLYCUBE_H
