// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LAPLACIAN_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LAPLACIAN_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Calls f(k, i, j) for each pair k of nodes i, j of element e of a network, in the order 01, 02, 03, 12, 13, 23.
template <typename Network, typename Function>
void for_each_pair(const Network& network, std::size_t e, const Function& f) {
  const auto nodes = network.nodes(e);
  int k = 0;
  for (int a = 0; a < Network::size_of_element; ++a)
    for (int b = a + 1; b < Network::size_of_element; ++b) f(k++, nodes[a], nodes[b]);
}

// The Laplacian of a weighted graph, assembled row by row, and the right-hand side that comes from nodes with known values.
//
// A network is a set of elements: nodes(e) are the nodes of element e, conductances(e) the weights of the edges between
// them. An edge may belong to several elements.
class Laplacian {
public:
  using Matrix = Eigen::SparseMatrix<double>;

  static constexpr std::uint32_t known = std::uint32_t(-1);
  // Eigen counts the entries of a matrix by numbers of this type.
  static constexpr std::size_t greatest_size = std::numeric_limits<Matrix::StorageIndex>::max();

  // `rows` tells the row of each of the n unknown nodes, and `known` for the others; these have the given `values`. A matrix of
  // more than `most_entries` is not written.
  template <typename Network>
  Laplacian(const Network& network, const std::vector<std::uint32_t>& rows, std::size_t n, const std::vector<double>& values,
            std::size_t most_entries = greatest_size)
      : right(n, 0), m_diagonal(n, 0), m_end(n + 1, 0) {
    count_entries(network, rows);
    add_entries(network, rows, values);
    sort_rows();
    number_of_entries = n + 2 * m_lower.size();
    if (number_of_entries <= most_entries) write_matrix();
  }

  std::size_t number_of_entries = 0; // those that the matrix has or would have
  Matrix matrix;                     // symmetric, with both halves, columns in order
  std::vector<double> right;

private:
  struct Entry {
    std::uint32_t column;
    double value;
  };

  // After this, m_end[i] is where row i of the lower half starts.
  template <typename Network>
  void count_entries(const Network& network, const std::vector<std::uint32_t>& rows) {
    for (std::size_t e = 0; e < network.number_of_elements(); ++e)
      for_each_pair(network, e, [&](int, std::uint32_t i, std::uint32_t j) {
        if (rows[i] != known && rows[j] != known) ++m_end[std::max(rows[i], rows[j])];
      });
    std::size_t sum = 0;
    for (std::size_t& end : m_end) sum += std::exchange(end, sum);
    m_lower.resize(sum);
  }

  // After this, m_end[i] is where row i ends.
  template <typename Network>
  void add_entries(const Network& network, const std::vector<std::uint32_t>& rows, const std::vector<double>& values) {
    for (std::size_t e = 0; e < network.number_of_elements(); ++e) {
      const auto conductances = network.conductances(e);
      for_each_pair(network, e, [&](int k, std::uint32_t i, std::uint32_t j) {
        const double conductance = conductances[k];
        if (rows[i] != known) m_diagonal[rows[i]] += conductance;
        if (rows[j] != known) m_diagonal[rows[j]] += conductance;
        if (rows[i] != known && rows[j] != known)
          m_lower[m_end[std::max(rows[i], rows[j])]++] = {std::min(rows[i], rows[j]), -conductance};
        else if (rows[i] != known)
          right[rows[i]] += conductance * values[j];
        else if (rows[j] != known)
          right[rows[j]] += conductance * values[i];
      });
    }
  }

  // Adds the entries of each row in the same column, closes the gaps, and sorts what is left.
  void sort_rows() {
    const auto before = [](const Entry& a, const Entry& b) { return a.column < b.column; };
    std::vector<std::size_t> place(m_diagonal.size(), 0); // of the last entry in a column
    std::size_t begin = 0, size = 0;
    for (std::size_t i = 0; i < m_diagonal.size(); ++i) {
      const std::size_t end = m_end[i], first = size;
      for (std::size_t k = begin; k < end; ++k) {
        const Entry entry = m_lower[k];
        std::size_t& p = place[entry.column];
        if (p >= first && p < size && m_lower[p].column == entry.column)
          m_lower[p].value += entry.value;
        else
          m_lower[p = size++] = entry;
      }
      std::sort(m_lower.begin() + first, m_lower.begin() + size, before);
      m_end[i] = size;
      begin = end;
    }
    m_lower.resize(size);
  }

  std::size_t begin(std::size_t i) const { return i == 0 ? 0 : m_end[i - 1]; }

  // Row i is the lower half of the row, the diagonal entry and, appended by later rows, the upper half.
  void write_matrix() {
    const Eigen::Index n = Eigen::Index(m_diagonal.size());
    matrix.resize(n, n);
    matrix.resizeNonZeros(n + 2 * Eigen::Index(m_lower.size()));
    int* first = matrix.outerIndexPtr();
    std::vector<int> end(m_diagonal.size(), 0);
    for (const Entry& e : m_lower) ++end[e.column];
    first[0] = 0;
    for (Eigen::Index i = 0; i < n; ++i)
      first[i + 1] = first[i] + std::exchange(end[i], first[i]) + 1 + int(m_end[i] - begin(i));
    const auto append = [&](std::size_t i, std::size_t j, double value) {
      matrix.innerIndexPtr()[end[i]] = int(j);
      matrix.valuePtr()[end[i]++] = value;
    };
    for (std::size_t i = 0; i < m_diagonal.size(); ++i) {
      for (std::size_t k = begin(i); k < m_end[i]; ++k) {
        append(i, m_lower[k].column, m_lower[k].value);
        append(m_lower[k].column, i, m_lower[k].value);
      }
      append(i, i, m_diagonal[i]);
    }
    m_diagonal = std::vector<double>(); // {} would keep the memory
    m_end = std::vector<std::size_t>();
    m_lower = std::vector<Entry>();
  }

  std::vector<double> m_diagonal;
  std::vector<std::size_t> m_end;
  std::vector<Entry> m_lower; // below the diagonal, row by row
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LAPLACIAN_H
