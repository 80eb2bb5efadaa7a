// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/IO/Data_array.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_XML_writer.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>
#include <CGAL/Volume_mesh_parameterization/internal/write_atomically.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

template <typename Point>
void write_polylines(VTK_XML_writer& xml, const std::vector<std::vector<Point>>& polylines) {
  xml.element("Points", [&] {
    xml.array("Points", "Float64", 3, [&](Text_writer& out) {
      for (const auto& line : polylines)
        for (const Point& p : line) VTK_XML_writer::write_point(out, p);
    });
  });
  xml.element("Lines", [&] {
    std::size_t n = 0;
    xml.array("connectivity", "Int64", 1, [&](Text_writer& out) {
      for (const auto& line : polylines)
        for (std::size_t i = 0; i < line.size(); ++i) out << n++ << (i + 1 < line.size() ? ' ' : '\n');
    });
    n = 0;
    xml.array("offsets", "Int64", 1, [&](Text_writer& out) {
      for (const auto& line : polylines) out << (n += line.size()) << '\n';
    });
  });
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes curves as an ASCII VTP file (XML PolyData of VTK).

\tparam Point a point type of a \cgal kernel

\param os the stream
\param polylines the points of each curve
\param point_data arrays with a value for each point of the first curve, then of the second, ...
\param line_data arrays with a value for each curve

\returns `ERROR_COORDINATE_NOT_FINITE`, `ERROR_WRONG_PARAMETER` (the size of an array, or a value that is not finite) or
`ERROR_CANNOT_WRITE_FILE`
*/
template <typename Point>
Status write_VTP(std::ostream& os, const std::vector<std::vector<Point>>& polylines,
                 const std::vector<Data_array>& point_data = {},
                 const std::vector<Data_array>& line_data = {}) {
  std::size_t n = 0;
  for (const auto& line : polylines) {
    const Status status = internal::check_coordinates(line.size(), [&](std::size_t i) { return line[i]; });
    if (!status.ok()) return status;
    n += line.size();
  }
  Status status = internal::check_data_arrays(point_data, n, "points");
  if (status.ok()) status = internal::check_data_arrays(line_data, polylines.size(), "curves");
  if (!status.ok()) return status;
  {
    internal::VTK_XML_writer xml(os, "PolyData");
    xml.text() << "<Piece NumberOfPoints=\"" << n << "\" NumberOfLines=\"" << polylines.size() << "\">\n";
    internal::write_polylines(xml, polylines);
    xml.data_arrays("PointData", point_data);
    xml.data_arrays("CellData", line_data);
    xml.text() << "</Piece>\n";
  }
  return internal::check_stream(os);
}

/*!
\ingroup PkgVolumeMeshParameterizationIO

writes the file `filename`, as the function above, under a temporary name first: on failure nothing is changed.

\tparam Point a point type of a \cgal kernel
*/
template <typename Point>
Status write_VTP(const std::string& filename, const std::vector<std::vector<Point>>& polylines,
                 const std::vector<Data_array>& point_data = {},
                 const std::vector<Data_array>& line_data = {}) {
  return internal::write_atomically(
      filename, [&](std::ostream& os) { return write_VTP(os, polylines, point_data, line_data); });
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_VTP_H
