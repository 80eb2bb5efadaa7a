// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_OFF_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_OFF_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Reads the triangles of an ASCII OFF file. Normals, colors and texture coordinates are skipped. CGAL's own reader does
// not tell what is wrong, and believes any count.
template <typename Point>
class OFF_reader {
public:
  OFF_reader(std::string_view text, Triangle_soup_3<Point>& soup) : m_scanner(text), m_soup(soup) {}

  Status read() {
    Status status = read_header();
    if (status.ok()) status = read_points();
    return status.ok() ? read_triangles() : status;
  }

private:
  Status wrong(const std::string& what) const {
    return {ERROR_WRONG_FORMAT, "line " + std::to_string(m_scanner.line()) + ": " + what};
  }
  Status bad_entry(const std::string& name) {
    return wrong(name +
                 (m_scanner.at_end() ? ": the file is truncated" : ": not the numbers that it must be"));
  }

  Status read_header() {
    if (m_scanner.at_end()) return {ERROR_WRONG_FORMAT, "the file is empty"};
    const std::string_view keyword = m_scanner.word();
    const bool is_off = keyword.size() >= 3 && keyword.substr(keyword.size() - 3) == "OFF";
    if (!is_off || keyword.find_first_of("4n") != std::string_view::npos)
      return wrong("an OFF file in three dimensions starts with OFF");
    m_has_extras = keyword.size() > 3;
    Text_scanner ahead = m_scanner;
    if (ahead.word() == "BINARY") return wrong("the file is binary: convert it to ASCII");
    if (!m_scanner.read(m_number_of_points) || !m_scanner.read(m_number_of_faces))
      return bad_entry("the counts");
    m_scanner.rest_of_line(); // the number of edges
    if (!m_scanner.has_room_for(m_number_of_points, 3) || !m_scanner.has_room_for(m_number_of_faces, 4))
      return wrong("the file is truncated: " + std::to_string(m_number_of_points) + " vertices and " +
                   std::to_string(m_number_of_faces) + " faces announced");
    return {};
  }

  Status read_points() {
    m_soup.points.reserve(m_number_of_points);
    for (std::size_t v = 0; v < m_number_of_points; ++v) {
      double x, y, z;
      if (!m_scanner.read(x) || !m_scanner.read(y) || !m_scanner.read(z))
        return bad_entry("vertex " + std::to_string(v));
      if (!are_finite(x, y, z)) return {ERROR_COORDINATE_NOT_FINITE, "vertex " + std::to_string(v)};
      if (m_has_extras) m_scanner.rest_of_line();
      m_soup.points.emplace_back(x, y, z);
    }
    return {};
  }

  // All faces are looked at, even if one is no triangle: a caller may give the file to CGAL's reader then.
  Status read_triangles() {
    m_soup.triangles.resize(m_number_of_faces);
    Status status;
    for (std::size_t f = 0; f < m_number_of_faces; ++f) {
      const std::string name = "face " + std::to_string(f);
      std::size_t n = 0;
      if (!m_scanner.read(n)) return bad_entry(name);
      if (n != 3 && status.ok())
        status = {ERROR_NOT_TRIANGULATED, name + " has " + std::to_string(n) + " vertices"};
      for (std::size_t i = 0; i < n; ++i) {
        std::size_t v;
        if (!m_scanner.read(v)) return bad_entry(name);
        if (v >= m_number_of_points)
          return {ERROR_INDEX_OUT_OF_RANGE,
                  name + ": vertex " + std::to_string(v) + " of " + std::to_string(m_number_of_points)};
        if (i < 3) m_soup.triangles[f][i] = v;
      }
      m_scanner.rest_of_line(); // a color
    }
    return status;
  }

  Text_scanner m_scanner;
  Triangle_soup_3<Point>& m_soup;
  std::size_t m_number_of_points = 0, m_number_of_faces = 0;
  bool m_has_extras = false;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_OFF_READER_H
