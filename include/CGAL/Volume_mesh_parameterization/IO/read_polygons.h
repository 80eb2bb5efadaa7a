// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_POLYGONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_POLYGONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/read_surface.h>
#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <exception>
#include <string>
#include <utility>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads polygons, as `read_surface()` reads triangles.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status read_polygons(const std::string& filename, Polygon_soup_3<Point>& soup) {
  Triangle_soup_3<Point> triangles;
  const Status status = read_surface(filename, triangles); // says what is wrong with a file
  Polygon_soup_3<Point> result;
  if (status.ok()) {
    result.points = std::move(triangles.points);
    for (const auto& t : triangles.triangles) result.polygons.push_back({t[0], t[1], t[2]});
  } else if (status.code() == ERROR_NOT_TRIANGULATED) {
    try {
      if (!CGAL::IO::read_polygon_soup(filename, result.points, result.polygons,
                                       CGAL::parameters::verbose(false)))
        return {ERROR_WRONG_FORMAT, filename + ": it is truncated or malformed"};
    } catch (const std::exception&) { // a failed allocation, or an assertion of the reader
      return {ERROR_WRONG_FORMAT, filename + ": it is malformed"};
    }
  } else
    return status;
  soup = std::move(result);
  return {};
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_POLYGONS_H
