// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TEXT_SCANNER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TEXT_SCANNER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Reads words and numbers one after the other from a text in memory. Blanks separate; '#' starts a comment.
class Text_scanner {
public:
  explicit Text_scanner(std::string_view text) : m_text(text) {}

  bool at_end() {
    skip_blanks();
    return m_position == m_text.size();
  }

  // returns an empty word at the end of the text.
  std::string_view word() {
    skip_blanks();
    const std::size_t begin = m_position;
    while (m_position < m_text.size() && !is_separator(m_text[m_position])) ++m_position;
    return m_text.substr(begin, m_position - begin);
  }

  // returns what is left of the current line and goes to the next one.
  std::string_view rest_of_line() {
    const std::size_t begin = m_position, end = std::min(m_text.find('\n', begin), m_text.size());
    m_position = std::min(end + 1, m_text.size());
    return m_text.substr(begin, end - begin);
  }

  // A word that is no number is not consumed.
  bool read(double& x) {
    const std::string_view rest = number_ahead();
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), x);
    if (error == std::errc::result_out_of_range) x = out_of_range(rest.data(), end);
    return error != std::errc::invalid_argument && consume(end);
  }
  template <typename Integer>
  bool read(Integer& i) {
    const std::string_view rest = number_ahead();
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), i);
    return error == std::errc() && consume(end);
  }

  // tells whether `n` entries of so many words each may follow: a count in a file is not to be trusted.
  bool has_room_for(std::size_t n, std::size_t words_per_entry) const {
    return words_per_entry == 0 || n <= ((m_text.size() - m_position) / 2 + 1) / words_per_entry;
  }

  std::size_t line() const {
    return 1 + std::size_t(std::count(m_text.begin(), m_text.begin() + std::ptrdiff_t(m_position), '\n'));
  }

private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  static bool is_separator(char c) { return is_blank(c) || c == '#'; }

  void skip_blanks() {
    for (; m_position < m_text.size() && is_separator(m_text[m_position]); ++m_position)
      if (m_text[m_position] == '#') m_position = std::min(m_text.find('\n', m_position), m_text.size() - 1);
  }

  std::string_view number_ahead() {
    skip_blanks();
    std::string_view rest = m_text.substr(m_position);
    if (rest.size() > 1 && rest[0] == '+' && rest[1] != '-')
      rest.remove_prefix(1); // from_chars takes no plus sign
    return rest;
  }

  bool consume(const char* end) {
    const std::size_t position = std::size_t(end - m_text.data());
    if (position < m_text.size() && !is_separator(m_text[position])) return false;
    m_position = position;
    return true;
  }

  static double out_of_range(const char* begin, const char* end) {
    const bool is_tiny =
        std::string_view(begin, std::size_t(end - begin)).find("-", 1) != std::string_view::npos;
    return is_tiny ? 0 : std::numeric_limits<double>::infinity();
  }

  std::string_view m_text;
  std::size_t m_position = 0;
};

inline Status read_all(std::istream& is, std::string& text) {
  text.clear();
  constexpr std::size_t block = 1 << 20;
  while (is) {
    const std::size_t size = text.size();
    text.resize(size + block);
    is.read(&text[size], block);
    text.resize(size + std::size_t(is.gcount()));
  }
  return is.bad() ? Status(ERROR_CANNOT_READ_FILE) : Status();
}

// Opens a file and hands it to read(std::istream&), whose complaint is completed by the name of the file.
template <typename Read>
Status read_file(const std::string& filename, const Read& read) {
  std::ifstream is(filename, std::ios::binary);
  if (!is) return {ERROR_CANNOT_READ_FILE, filename + ": " + std::generic_category().message(errno)};
  const Status status = read(is);
  if (status.ok()) return status;
  return {status.code(), status.detail().empty() ? filename : filename + ": " + status.detail()};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TEXT_SCANNER_H
