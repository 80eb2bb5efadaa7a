// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_READER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_READER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Text_scanner.h>
#include <CGAL/Volume_mesh_parameterization/internal/VTK_grid.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Reads the ASCII form of VTK's legacy files, of any version up to 5.1.
class VTK_reader {
public:
  VTK_reader(std::string_view text, VTK_grid& grid) : m_scanner(text), m_grid(grid) {}

  Status read() {
    Status status = read_header();
    while (status.ok() && !m_scanner.at_end()) status = read_section();
    return status;
  }

private:
  struct Attribute {
    const char* name;
    std::size_t components;
  };
  static constexpr Attribute attributes[] = {
      {"VECTORS", 3}, {"NORMALS", 3}, {"TENSORS", 9}, {"GLOBAL_IDS", 1}, {"PEDIGREE_IDS", 1}};

  Status wrong(const std::string& what) const {
    return {ERROR_WRONG_FORMAT, "line " + std::to_string(m_scanner.line()) + ": " + what};
  }
  Status wrong_section() {
    const bool truncated = m_scanner.at_end();
    return wrong("section " + m_section + (truncated ? ": the file is truncated" : ": not what it must be"));
  }
  Status require(bool condition) { return condition ? Status() : wrong_section(); }

  std::string upper_case_word() {
    std::string word(m_scanner.word());
    for (char& c : word) c = char(std::toupper(static_cast<unsigned char>(c)));
    return word;
  }

  Status read_header() {
    if (m_scanner.rest_of_line().substr(0, 14) != "# vtk DataFile")
      return {ERROR_WRONG_FORMAT, "the first line does not start with '# vtk DataFile'"};
    m_scanner.rest_of_line(); // the title
    const std::string encoding = upper_case_word();
    if (encoding == "BINARY")
      return {ERROR_WRONG_FORMAT, "the file is binary: convert it to ASCII, in ParaView by File > Save Data"};
    if (encoding != "ASCII") return wrong("neither ASCII nor BINARY");
    if (upper_case_word() != "DATASET" || upper_case_word() != "UNSTRUCTURED_GRID")
      return wrong("the data set is no UNSTRUCTURED_GRID");
    return {};
  }

  Status read_section() {
    m_section = upper_case_word();
    if (m_section == "POINTS") return read_points();
    if (m_section == "CELLS") return read_cells();
    if (m_section == "CELL_TYPES") return read_types();
    if (m_section == "POINT_DATA" || m_section == "CELL_DATA") return read_data_size();
    if (m_section == "METADATA") return skip_paragraph();
    if (m_section == "FIELD") return read_field();
    if (m_section == "SCALARS") return read_scalars();
    return skip_attribute();
  }

  template <typename Number>
  Status read_numbers(std::size_t n, std::vector<Number>& numbers) {
    if (!m_scanner.has_room_for(n, 1)) return wrong("section " + m_section + ": the file is truncated");
    numbers.resize(n);
    for (Number& x : numbers)
      if (!m_scanner.read(x)) return wrong_section();
    return {};
  }

  Status skip_words(std::size_t n, std::size_t words_per_entry) {
    if (!m_scanner.has_room_for(n, words_per_entry))
      return wrong("section " + m_section + ": the file is truncated");
    for (std::size_t i = 0; i < n * words_per_entry; ++i)
      if (m_scanner.word().empty()) return wrong_section();
    return {};
  }

  Status read_points() {
    std::size_t n = 0;
    if (!m_scanner.read(n) || m_scanner.word().empty() || !m_scanner.has_room_for(n, 3))
      return wrong_section();
    return read_numbers(3 * n, m_grid.coordinates);
  }

  Status read_cells() {
    std::size_t n = 0, size = 0;
    if (!m_scanner.read(n) || !m_scanner.read(size)) return wrong_section();
    Text_scanner ahead = m_scanner;
    if (ahead.word() != "OFFSETS") return read_cell_lists(n, size);
    m_scanner.word(), m_scanner.word();
    Status status = read_numbers(n, m_grid.offsets);
    if (status.ok()) status = require(m_scanner.word() == "CONNECTIVITY" && !m_scanner.word().empty());
    return status.ok() ? read_numbers(size, m_grid.connectivity) : status;
  }

  // Before version 5.1 each cell is preceded by its number of vertices.
  Status read_cell_lists(std::size_t n, std::size_t size) {
    if (!m_scanner.has_room_for(size, 1) || n > size) return wrong_section();
    m_grid.offsets.assign(1, 0);
    m_grid.connectivity.clear();
    for (std::size_t c = 0; c < n; ++c) {
      std::size_t k = 0;
      if (!m_scanner.read(k) || k > size) return wrong_section();
      for (std::int64_t v; k > 0; --k) {
        if (!m_scanner.read(v)) return wrong_section();
        m_grid.connectivity.push_back(v);
      }
      m_grid.offsets.push_back(std::int64_t(m_grid.connectivity.size()));
    }
    return {};
  }

  Status read_types() {
    std::size_t n = 0;
    return m_scanner.read(n) ? read_numbers(n, m_grid.types) : wrong_section();
  }

  Status read_data_size() {
    m_is_cell_data = m_section == "CELL_DATA";
    return require(m_scanner.read(m_data_size));
  }

  Status read_scalars() {
    const std::string name(m_scanner.word()), type = upper_case_word();
    Text_scanner rest(m_scanner.rest_of_line());
    std::size_t components = 1;
    if (!rest.at_end() && !rest.read(components)) return wrong_section();
    Text_scanner ahead = m_scanner;
    if (ahead.word() == "LOOKUP_TABLE") m_scanner.word(), m_scanner.word();
    return read_values(name, type, m_data_size, components);
  }

  Status read_field() {
    std::size_t number_of_arrays = 0;
    Status status = require(!m_scanner.word().empty() && m_scanner.read(number_of_arrays));
    for (; status.ok() && number_of_arrays > 0 && !m_scanner.at_end(); --number_of_arrays) {
      const std::string name(m_scanner.word());
      if (name == "METADATA") { // belongs to the array before
        status = skip_paragraph();
        ++number_of_arrays;
        continue;
      }
      std::size_t components = 0, n = 0;
      status = require(m_scanner.read(components) && m_scanner.read(n));
      if (status.ok()) status = read_values(name, upper_case_word(), n, components);
    }
    return status;
  }

  Status read_values(const std::string& name, const std::string& type, std::size_t n,
                     std::size_t components) {
    const bool is_integer = type == "INT" || type == "LONG" || type == "SHORT" || type == "CHAR" ||
                            type.substr(0, 8) == "UNSIGNED" || type == "VTKIDTYPE" ||
                            type.substr(0, 10) == "VTKTYPEINT";
    if (!is_integer || components != 1 || !m_is_cell_data) return skip_words(n, components);
    std::vector<std::int64_t> values;
    const Status status = read_numbers(n, values);
    if (status.ok()) m_grid.offer_labels(name, std::move(values));
    return status;
  }

  Status skip_attribute() {
    const auto known = std::find_if(std::begin(attributes), std::end(attributes),
                                    [&](const Attribute& a) { return m_section == a.name; });
    if (known != std::end(attributes)) {
      m_scanner.rest_of_line();
      return skip_words(m_data_size, known->components);
    }
    std::size_t count = 0;
    const bool is_table = m_section == "LOOKUP_TABLE", is_texture = m_section == "TEXTURE_COORDINATES";
    if (!is_table && !is_texture && m_section != "COLOR_SCALARS")
      return wrong("unknown section '" + m_section.substr(0, 40) + "'");
    if (m_scanner.word().empty() || !m_scanner.read(count)) return wrong_section();
    if (is_texture) m_scanner.word(); // the type
    return is_table ? skip_words(count, 4) : skip_words(m_data_size, count);
  }

  // Metadata end with an empty line.
  Status skip_paragraph() {
    m_scanner.rest_of_line();
    while (m_scanner.rest_of_line().find_first_not_of(" \r\t") != std::string_view::npos) {
    }
    return {};
  }

  Text_scanner m_scanner;
  VTK_grid& m_grid;
  std::string m_section;
  std::size_t m_data_size = 0;
  bool m_is_cell_data = false;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_VTK_READER_H
