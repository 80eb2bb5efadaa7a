// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRALIZE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRALIZE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/Delaunay_mesher.h>
#include <CGAL/Volume_mesh_parameterization/internal/Tetgen_mesher.h>
#include <CGAL/Volume_mesh_parameterization/sort_spatially.h>

#include <CGAL/Kernel_traits.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

// A mesher is asked to do well, not trusted: TetGen returns flat cells and pinched meshes now and then.
template <typename Point>
Status check_mesher_output(const Tetrahedron_soup_3<Point>& soup) {
  Compact_tetrahedral_mesh_3<typename Kernel_traits<Point>::Kernel> mesh;
  Status status = mesh.assign(soup);
  if (status.ok()) status = check_tetrahedral_mesh(mesh);
  return status.ok()
             ? status
             : Status(ERROR_TETRAHEDRALIZATION, "the mesher returned a bad mesh: " + status.message());
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

// Near the wanted number the number of cells goes like the inverse of the bound on their volume, unless the given
// triangles determine it.
template <typename Point>
Status mesh_with_about(std::size_t number_of_cells, const Tetgen_mesher<Point>& mesher, double volume,
                       Tetrahedron_soup_3<Point>& soup) {
  constexpr int attempts = 4;
  constexpr double good_enough = .25, no_progress = .1; // relative differences
  double ratio = 0;
  double bound = volume / double(number_of_cells);
  for (int i = 0; i < attempts; ++i) {
    const Status status = mesher.mesh(bound, soup); // on failure the soup is that of the attempt before
    if (!status.ok()) return i == 0 ? status : Status();
    const double last_ratio = std::exchange(ratio, double(soup.cells.size()) / double(number_of_cells));
    if (std::abs(ratio - 1) < good_enough || std::abs(ratio - last_ratio) < no_progress * ratio) break;
    bound *= ratio;
  }
  return {};
}

template <typename Point>
Status fill_surface(const Triangle_soup_3<Point>& surface, std::size_t number_of_cells,
                    Tetrahedron_soup_3<Point>& soup) {
  const Tetgen_mesher<Point> mesher(surface);
  return number_of_cells == 0
             ? mesher.mesh(0, soup)
             : mesh_with_about(number_of_cells, mesher, sixfold_volume<double>(surface) / 6, soup);
}

#elif defined(CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CONSTRAINED_DELAUNAY)

template <typename Point>
Status fill_surface(const Triangle_soup_3<Point>& surface, std::size_t number_of_cells,
                    Tetrahedron_soup_3<Point>& soup) {
  const Status status = Delaunay_mesher<Point>(surface).mesh(soup);
  return status.ok() ? bisect_longest_edges(number_of_cells, soup) : status;
}

#else

template <typename Point>
Status fill_surface(const Triangle_soup_3<Point>&, std::size_t, Tetrahedron_soup_3<Point>&) {
  return {ERROR_MISSING_LIBRARY,
          "TetGen or the constrained Delaunay triangulation of CGAL 6.1, to fill a surface with tetrahedra"};
}

#endif

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationMesh

fills a surface with tetrahedra. The labels of its triangles become those of the boundary facets; if it has none, each
boundary facet gets as label the number of its triangle. The points of the surface come first; the other points and the
cells are sorted by `sort_spatially()`.

There are two meshers, each of which needs a macro. If both are defined, the first one is taken.
- `CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN`: TetGen 1.5 makes well-shaped cells, and keeps the surface triangle for
  triangle.
- `CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CONSTRAINED_DELAUNAY`: the constrained Delaunay triangulation of \cgal 6.1 or later,
  of which the longest edges are bisected until there are enough cells. Triangles are cut for that, and cells may be thin:
  certificates hold, distortion is greater.

\tparam Point a point type of a \cgal kernel

\param surface a closed surface
\param soup receives the mesh; on failure it is left as it was
\param number_of_cells about how many cells are wanted, as far as the given triangles allow (long and thin ones prevent
small cells); 0: as many as their shapes need

\returns the errors of `check_surface()`, `ERROR_TETRAHEDRALIZATION` or `ERROR_MISSING_LIBRARY`
*/
template <typename Point>
Status tetrahedralize(const Triangle_soup_3<Point>& surface, Tetrahedron_soup_3<Point>& soup,
                      std::size_t number_of_cells = 0) {
  Triangle_soup_3<Point> checked = surface;
  Status status = check_surface(checked);
  Tetrahedron_soup_3<Point> result;
  if (status.ok()) status = internal::fill_surface(checked, number_of_cells, result);
  if (status.ok()) status = internal::check_mesher_output(result);
  if (!status.ok()) return status;
  sort_spatially(result, checked.points.size());
  soup = std::move(result);
  return status;
}

/*!
\ingroup PkgVolumeMeshParameterizationMesh

fills a surface as the function above and copies the result to `mesh`, which is left as it was on failure.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3` with the points of the surface

\returns the errors of the function above
*/
template <typename GeomTraits>
Status tetrahedralize(const Triangle_soup_3<typename GeomTraits::Point_3>& surface,
                      Compact_tetrahedral_mesh_3<GeomTraits>& mesh, std::size_t number_of_cells = 0) {
  Tetrahedron_soup_3<typename GeomTraits::Point_3> soup;
  const Status status = tetrahedralize(surface, soup, number_of_cells);
  return status.ok() ? mesh.assign(soup) : status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_TETRAHEDRALIZE_H
