// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MEDIT_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MEDIT_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// How the elements of a soup are called in a file.
struct MEDIT_tetrahedra {
  static constexpr const char *cells = "Tetrahedra", *facets = "Triangles";
  template <typename Point>
  static auto& cells_of(Tetrahedron_soup_3<Point>& soup) {
    return soup.cells;
  }
};
struct MEDIT_hexahedra {
  static constexpr const char *cells = "Hexahedra", *facets = "Quadrilaterals";
  template <typename Point>
  static auto& cells_of(Hexahedron_soup_3<Point>& soup) {
    return soup.hexahedra;
  }
};

// Reads an ASCII MEDIT file into a soup of tetrahedra or of hexahedra. What belongs to neither is skipped, but
// volume elements of another kind are refused: without them the solid would have holes.
template <typename Names, typename Soup>
class MEDIT_reader {
public:
  MEDIT_reader(std::string_view text, Soup& soup) : m_scanner(text), m_soup(soup) {}

  Status read() {
    Status status = read_header();
    for (m_section = m_scanner.word(); status.ok() && m_section != "End"; m_section = m_scanner.word())
      status = m_section.empty() ? wrong("no section End: the file is truncated") : read_section();
    if (status.ok() && m_sections_read.count("Vertices") == 0) status = wrong("there is no section Vertices");
    if (status.ok()) status = number_from_zero(Names::cells_of(m_soup), Names::cells);
    if (status.ok()) status = number_facets_from_zero();
    return status;
  }

private:
  using Point = typename Soup::Point_3;

  struct Skipped_section {
    const char* name;
    int words_per_entry;
    bool is_volume;
  };
  static constexpr Skipped_section skipped_sections[] = {{"Edges", 3, false},
                                                         {"Triangles", 4, false},
                                                         {"Quadrilaterals", 5, false},
                                                         {"Tetrahedra", 5, true},
                                                         {"Hexahedra", 9, true},
                                                         {"Prisms", 7, true},
                                                         {"Pyramids", 6, true},
                                                         {"Corners", 1, false},
                                                         {"Ridges", 1, false},
                                                         {"RequiredVertices", 1, false},
                                                         {"RequiredEdges", 1, false},
                                                         {"RequiredTriangles", 1, false},
                                                         {"Normals", 3, false},
                                                         {"NormalAtVertices", 2, false},
                                                         {"Tangents", 3, false},
                                                         {"TangentAtVertices", 2, false},
                                                         {"TangentAtEdges", 3, false},
                                                         {"SubDomainFromGeom", 4, false},
                                                         {"SubDomainFromMesh", 4, false},
                                                         {"RequiredQuadrilaterals", 1, false}};

  Status wrong(const std::string& what) const {
    return {ERROR_WRONG_FORMAT, "line " + std::to_string(m_scanner.line()) + ": " + what};
  }
  std::string here(std::size_t entry) const {
    return std::string(m_section) + ", entry " + std::to_string(entry + 1);
  }

  Status read_header() {
    if (m_scanner.at_end()) return {ERROR_WRONG_FORMAT, "the file is empty"};
    int version = 0;
    if (m_scanner.word() != "MeshVersionFormatted" || !m_scanner.read(version))
      return wrong("an ASCII MEDIT file starts with MeshVersionFormatted and a number");
    return {};
  }

  Status read_section() {
    if (m_section == "Dimension") return read_dimension();
    const auto known = std::find_if(std::begin(skipped_sections), std::end(skipped_sections),
                                    [&](const Skipped_section& s) { return m_section == s.name; });
    if (known == std::end(skipped_sections) && m_section != "Vertices")
      return wrong("unknown section '" + std::string(m_section.substr(0, 40)) + "'");
    if (!m_sections_read.insert(m_section).second) return wrong("a second section " + std::string(m_section));
    std::size_t n = 0;
    if (!m_scanner.read(n))
      return wrong("section " + std::string(m_section) + " does not start with a count");
    if (!m_scanner.has_room_for(n, m_section == "Vertices" ? 4 : std::size_t(known->words_per_entry)))
      return wrong("the file is truncated: " + std::to_string(n) + " entries announced in section " +
                   std::string(m_section));
    if (m_section == "Vertices") return read_points(n);
    if (m_section == Names::cells) return read_cells(n);
    if (m_section == Names::facets) return read_facets(n);
    return known->is_volume && n > 0
               ? wrong("section " + std::string(m_section) + ": all cells must be " + Names::cells)
               : skip(n, known->words_per_entry);
  }

  Status read_dimension() {
    int dimension = 0;
    return m_scanner.read(dimension) && dimension == 3 ? Status() : wrong("Dimension is not 3");
  }

  Status read_points(std::size_t n) {
    m_soup.points.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      double x, y, z;
      if (!m_scanner.read(x) || !m_scanner.read(y) || !m_scanner.read(z) || m_scanner.word().empty())
        return bad_entry(i);
      if (!are_finite(x, y, z)) return {ERROR_COORDINATE_NOT_FINITE, here(i)};
      m_soup.points.emplace_back(x, y, z);
    }
    return {};
  }

  Status bad_entry(std::size_t i) {
    return wrong(here(i) +
                 (m_scanner.at_end() ? ": the file is truncated" : ": not the numbers that it must be"));
  }

  template <std::size_t N>
  bool read_indices(std::array<std::size_t, N>& indices) {
    for (std::size_t& index : indices)
      if (!m_scanner.read(index)) return false;
    return true;
  }

  Status read_cells(std::size_t n) {
    auto& cells = Names::cells_of(m_soup);
    cells.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      if (!read_indices(cells[i]) || m_scanner.word().empty()) return bad_entry(i);
    return {};
  }

  Status read_facets(std::size_t n) {
    m_soup.facets.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      if (!read_indices(m_soup.facets[i].vertices) || !m_scanner.read(m_soup.facets[i].label))
        return bad_entry(i);
    return {};
  }

  Status skip(std::size_t n, int words_per_entry) {
    for (std::size_t i = 0; i < n; ++i)
      for (int k = 0; k < words_per_entry; ++k)
        if (m_scanner.word().empty()) return bad_entry(i);
    return {};
  }

  template <std::size_t N>
  Status number_from_zero(std::array<std::size_t, N>& vertices, const char* section,
                          std::size_t entry) const {
    for (std::size_t& v : vertices)
      if (v < 1 || v > m_soup.points.size())
        return {ERROR_INDEX_OUT_OF_RANGE, std::string(section) + ", entry " + std::to_string(entry + 1) +
                                              ": vertex " + std::to_string(v) + " of " +
                                              std::to_string(m_soup.points.size())};
      else
        --v;
    return {};
  }

  template <typename Cells>
  Status number_from_zero(Cells& cells, const char* section) const {
    Status status;
    for (std::size_t i = 0; i < cells.size() && status.ok(); ++i)
      status = number_from_zero(cells[i], section, i);
    return status;
  }

  Status number_facets_from_zero() {
    Status status;
    for (std::size_t i = 0; i < m_soup.facets.size() && status.ok(); ++i)
      status = number_from_zero(m_soup.facets[i].vertices, Names::facets, i);
    return status;
  }

  Text_scanner m_scanner;
  Soup& m_soup;
  std::string_view m_section;
  std::set<std::string_view> m_sections_read;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_MEDIT_READER_H
