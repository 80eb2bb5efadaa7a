// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TEXT_WRITER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TEXT_WRITER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Error_code.h>

#include <CGAL/number_utils.h>

#include <charconv>
#include <cstddef>
#include <ios>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Collects text in large blocks and hands them to a stream. Numbers are written with the fewest digits from which
// they are read back to the bit, whatever the locale.
class Text_writer {
public:
  explicit Text_writer(std::ostream& os) : m_os(os) {}
  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;
  ~Text_writer() { hand_over(); }

  template <typename Item>
  Text_writer& operator<<(const Item& item) {
    append(item);
    if (m_text.size() > block) hand_over();
    return *this;
  }

private:
  static constexpr std::size_t block = 1 << 16;

  // A stream may have been told to throw: what writes returns a `Status`, for which check_stream() asks the stream.
  void hand_over() {
    try {
      m_os.write(m_text.data(), std::streamsize(m_text.size()));
    } catch (const std::ios_base::failure&) {
    }
    m_text.clear();
  }

  template <typename Item>
  void append(const Item& item) {
    if constexpr (std::is_same_v<Item, char>)
      m_text += item;
    else if constexpr (std::is_arithmetic_v<Item>)
      append_number(item);
    else if constexpr (std::is_convertible_v<Item, std::string_view>)
      m_text += std::string_view(item);
    else
      append_number(CGAL::to_double(item));
  }

  template <typename Number>
  void append_number(Number x) {
    char digits[32]; // 24 are the most that a double needs
    m_text.append(digits, std::to_chars(digits, digits + sizeof(digits), x).ptr);
  }

  std::ostream& m_os;
  std::string m_text;
};

// after a writer is gone
inline Status check_stream(const std::ostream& os) { return os ? Status() : Status(ERROR_CANNOT_WRITE_FILE); }

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_TEXT_WRITER_H
