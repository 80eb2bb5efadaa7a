// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SPARSE_ROWS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SPARSE_ROWS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The rows of a sparse matrix, which somebody else stores: entries first[i] to first[i + 1] are row i.
struct Sparse_rows_view {
  const int* first;
  const int* columns;
  const double* values;
  int size;

  // the product of row i with a vector
  template <typename Vector>
  double times(int i, const Vector& x) const {
    return times(first[i], first[i + 1], x);
  }
  // the same for a part of the row
  template <typename Vector>
  double times(int begin, int end, const Vector& x) const {
    double sum = 0;
    for (int k = begin; k < end; ++k) sum += values[k] * x[columns[k]];
    return sum;
  }
  // adds the product of a number and row i to a vector
  template <typename Vector>
  void add_transposed(int i, double factor, Vector& result) const {
    for (int k = first[i]; k < first[i + 1]; ++k) result[columns[k]] += factor * values[k];
  }
};

// The rows of a sparse matrix, appended one after the other; equal columns of a row add up.
class Sparse_rows {
public:
  Sparse_rows() = default;
  explicit Sparse_rows(int number_of_columns) : m_place(std::size_t(number_of_columns), -1) {}

  int number_of_columns() const { return int(m_place.size()); }
  int size() const { return int(m_first.size()) - 1; }
  Sparse_rows_view view() const { return {m_first.data(), m_columns.data(), m_values.data(), size()}; }

  // adds to the row at the end
  void add(int column, double value) {
    int& place = m_place[std::size_t(column)];
    if (place >= m_first.back()) {
      m_values[std::size_t(place)] += value;
      return;
    }
    place = int(m_columns.size());
    m_columns.push_back(column);
    m_values.push_back(value);
  }
  void end_row() { m_first.push_back(int(m_columns.size())); }

  // Room for all entries at once spares the copies, and the space, of arrays that grow.
  void reserve(std::size_t number_of_rows, std::size_t number_of_entries) {
    m_first.reserve(number_of_rows + 1);
    m_columns.reserve(number_of_entries);
    m_values.reserve(number_of_entries);
  }
  void shrink_to_fit() {
    m_columns.shrink_to_fit();
    m_values.shrink_to_fit();
  }

  // The columns of the result increase within each row.
  Sparse_rows transposed() const {
    Sparse_rows result(size());
    result.m_first.assign(std::size_t(number_of_columns()) + 1, 0);
    result.m_columns.resize(m_columns.size());
    result.m_values.resize(m_values.size());
    std::vector<int>& end = result.m_first; // entry j + 1 runs from the start of row j to its end
    for (int j : m_columns)
      if (j + 2 < int(end.size())) ++end[std::size_t(j) + 2];
    std::partial_sum(end.begin(), end.end(), end.begin());
    for (int i = 0; i < size(); ++i)
      for (int k = m_first[std::size_t(i)]; k < m_first[std::size_t(i) + 1]; ++k) {
        const int place = end[std::size_t(m_columns[std::size_t(k)]) + 1]++;
        result.m_columns[std::size_t(place)] = i;
        result.m_values[std::size_t(place)] = m_values[std::size_t(k)];
      }
    return result;
  }

private:
  std::vector<int> m_first = {0};
  std::vector<int> m_columns;
  std::vector<double> m_values;
  std::vector<int> m_place; // where a column was added last
};

inline std::size_t number_of_entries_of_product(const Sparse_rows_view& a, const Sparse_rows& b) {
  const Sparse_rows_view rows = b.view();
  std::vector<int> last_row(std::size_t(b.number_of_columns()), -1);
  std::size_t result = 0;
  for (int i = 0; i < a.size; ++i)
    for (int k = a.first[i]; k < a.first[i + 1]; ++k)
      for (int l = rows.first[a.columns[k]]; l < rows.first[a.columns[k] + 1]; ++l)
        if (std::exchange(last_row[std::size_t(rows.columns[l])], i) != i) ++result;
  return result;
}

// returns a * b, row by row (Gustavson 1978).
inline Sparse_rows product(const Sparse_rows_view& a, const Sparse_rows& b) {
  const Sparse_rows_view rows = b.view();
  Sparse_rows result(b.number_of_columns());
  result.reserve(std::size_t(a.size), number_of_entries_of_product(a, b));
  for (int i = 0; i < a.size; ++i) {
    for (int k = a.first[i]; k < a.first[i + 1]; ++k)
      for (int l = rows.first[a.columns[k]]; l < rows.first[a.columns[k] + 1]; ++l)
        result.add(rows.columns[l], a.values[k] * rows.values[l]);
    result.end_row();
  }
  return result;
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SPARSE_ROWS_H
