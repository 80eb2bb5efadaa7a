// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/OFF_reader.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <cctype>
#include <cstddef>
#include <exception>
#include <istream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

inline std::string lower_case_extension(const std::string& filename) {
  const std::size_t dot = filename.find_last_of("./");
  std::string extension = dot == std::string::npos || filename[dot] == '/' ? "" : filename.substr(dot + 1);
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

template <typename Point>
Status read_OFF(std::istream& is, Triangle_soup_3<Point>& soup) {
  std::string text;
  const Status status = read_all(is, text);
  return status.ok() ? OFF_reader<Point>(text, soup).read() : status;
}

// CGAL's reader crashes if it does.
inline bool starts_with_property(std::istream& ply) {
  std::string keyword;
  for (std::string line; keyword != "property" && keyword != "element" && std::getline(ply, line);)
    std::istringstream(line) >> keyword;
  return keyword == "property";
}

template <typename Point>
Status copy_polygons(const std::vector<std::vector<std::size_t>>& polygons, Triangle_soup_3<Point>& soup) {
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    const std::vector<std::size_t>& p = polygons[f];
    if (p.size() != 3)
      return {ERROR_NOT_TRIANGULATED,
              "face " + std::to_string(f) + " has " + std::to_string(p.size()) + " vertices"};
    for (std::size_t v : p)
      if (v >= soup.points.size())
        return {ERROR_INDEX_OUT_OF_RANGE, "face " + std::to_string(f) + ": vertex " + std::to_string(v) +
                                              " of " + std::to_string(soup.points.size())};
    soup.triangles.push_back({p[0], p[1], p[2]});
  }
  return {};
}

template <typename Point>
Status read_polygons(const std::string& filename, Triangle_soup_3<Point>& soup) {
  std::vector<std::vector<std::size_t>> polygons;
  try {
    if (!CGAL::IO::read_polygon_soup(filename, soup.points, polygons, CGAL::parameters::verbose(false)))
      return {ERROR_WRONG_FORMAT, "it is truncated or not of the type " + lower_case_extension(filename)};
  } catch (const std::exception&) { // a failed allocation, or an assertion of the reader
    return {ERROR_WRONG_FORMAT, "it is not of the type " + lower_case_extension(filename)};
  }
  return copy_polygons(polygons, soup);
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgVolumeMeshParameterizationIO

reads a triangle surface from a file of type `.off` (ASCII), `.obj`, `.ply` or `.stl`. Points that are in no triangle
are left out, equal points of an STL file are one. Whether the surface is closed and so on is not asked: see
`check_surface()`.

\tparam Point a point type of a \cgal kernel

\returns `ERROR_CANNOT_READ_FILE`, `ERROR_WRONG_FORMAT`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_NOT_TRIANGULATED`,
`ERROR_INDEX_OUT_OF_RANGE` or `ERROR_EMPTY_MESH`; then `soup` is left as it was
*/
template <typename Point>
Status read_surface(const std::string& filename, Triangle_soup_3<Point>& soup) {
  const std::string type = internal::lower_case_extension(filename);
  Triangle_soup_3<Point> result;
  Status status = internal::read_file(filename, [&](std::istream& is) -> Status {
    if (type == "off") return internal::read_OFF(is, result);
    if (is.peek() == std::istream::traits_type::eof()) return {ERROR_WRONG_FORMAT, "the file is empty"};
    if (type == "ply" && internal::starts_with_property(is))
      return {ERROR_WRONG_FORMAT, "a property comes before all elements"};
    if (type == "obj" || type == "ply" || type == "stl") return internal::read_polygons(filename, result);
    return {ERROR_WRONG_FORMAT, "the type of a surface must be .off, .obj, .ply or .stl"};
  });
  if (status.ok() && result.triangles.empty())
    status = {ERROR_EMPTY_MESH, filename + ": it has no triangles"};
  if (!status.ok()) return status;
  remove_isolated_points(result);
  soup = std::move(result);
  return {};
}

} // namespace IO
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_IO_READ_SURFACE_H
