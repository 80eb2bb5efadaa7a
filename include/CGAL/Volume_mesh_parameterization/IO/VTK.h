// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTK_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTK_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_grid.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_reader.h>

#include <istream>
#include <string>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads tetrahedra and labelled triangles from an ASCII file in the legacy format of VTK, in linear time.

Labels are the integers of the cell data: the array named `label`, else the first one. Without it triangles are
ignored.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_CANNOT_READ_FILE`, `ERROR_WRONG_FORMAT`, `ERROR_COORDINATE_NOT_FINITE` or `ERROR_INDEX_OUT_OF_RANGE`;
then `soup` is left as it was
*/
template <typename Point>
Status read_VTK(std::istream& is, Tetrahedron_soup_3<Point>& soup) {
  std::string text;
  internal::VTK_grid grid;
  Status status = internal::read_all(is, text);
  if (status.ok()) status = internal::VTK_reader(text, grid).read();
  return status.ok() ? grid.make_soup(soup) : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads the file `filename`, as the function above.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status read_VTK(const std::string& filename, Tetrahedron_soup_3<Point>& soup) {
  return internal::read_file(filename, [&](std::istream& is) { return read_VTK(is, soup); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTK_H
