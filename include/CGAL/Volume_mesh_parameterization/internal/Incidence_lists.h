// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INCIDENCE_LISTS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INCIDENCE_LISTS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Turns "which elements has a cell" around into "which cells has an element": compressed rows, each in increasing
// order, built in linear time.
template <typename Element, typename Cell>
class Incidence_lists {
public:
  Incidence_lists() = default;

  // elements_of(Cell) is a range of the elements of a cell, each of which is less than number_of_elements.
  template <typename ElementsOf>
  Incidence_lists(std::size_t number_of_elements, std::size_t number_of_cells, const ElementsOf& elements_of)
      : m_first(number_of_elements + 2, 0) {
    for (std::size_t c = 0; c < number_of_cells; ++c)
      for (Element e : elements_of(Cell(c))) ++m_first[e + 2];
    for (std::size_t e = 2; e < m_first.size(); ++e) m_first[e] += m_first[e - 1];
    m_cells.resize(m_first.back());
    // filling row e moves m_first[e + 1] from the start of row e to its end, where row e + 1 starts
    for (std::size_t c = 0; c < number_of_cells; ++c)
      for (Element e : elements_of(Cell(c))) m_cells[m_first[e + 1]++] = Cell(c);
    m_first.pop_back();
  }

  std::size_t size() const { return m_first.empty() ? 0 : m_first.size() - 1; }

  auto operator[](Element e) const {
    return boost::make_iterator_range(m_cells.begin() + m_first[e], m_cells.begin() + m_first[e + 1]);
  }

  // returns all rows, one after the other.
  const std::vector<Cell>& cells() const { return m_cells; }

private:
  std::vector<std::uint32_t> m_first;
  std::vector<Cell> m_cells;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_INCIDENCE_LISTS_H
