#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/internal/Laplacian.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

using CGAL::Volume_mesh_parameterization::internal::Laplacian;

// Elements with random nodes and weights; pairs of nodes occur more than once.
struct Random_network {
  static constexpr int size_of_element = 4;

  Random_network(std::size_t number_of_nodes, std::size_t n, unsigned seed) : elements(n), weights(n) {
    std::mt19937 random(seed);
    for (std::size_t e = 0; e < n; ++e) {
      for (int a = 0; a < 4; ++a)
        do elements[e][a] = std::uint32_t(random() % number_of_nodes);
        while (std::find(elements[e].begin(), elements[e].begin() + a, elements[e][a]) != elements[e].begin() + a);
      for (double& k : weights[e]) k = double(random() % 1000) - 200;
    }
  }

  std::size_t number_of_elements() const { return elements.size(); }
  std::array<std::uint32_t, 4> nodes(std::size_t e) const { return elements[e]; }
  std::array<double, 6> conductances(std::size_t e) const { return weights[e]; }

  std::vector<std::array<std::uint32_t, 4>> elements;
  std::vector<std::array<double, 6>> weights;
};

// The sum over the pairs, in a full matrix; all weights are integers, so that sums are exact in any order.
void test_against_full_matrix(std::size_t number_of_nodes, std::size_t number_of_elements, std::size_t every) {
  const Random_network network(number_of_nodes, number_of_elements, 5);
  std::vector<std::uint32_t> rows(number_of_nodes, Laplacian::known);
  std::vector<double> values(number_of_nodes, 0);
  std::size_t n = 0;
  for (std::size_t i = 0; i < number_of_nodes; ++i)
    if (i % every == 0)
      values[i] = double(i);
    else
      rows[i] = std::uint32_t(n++);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(Eigen::Index(number_of_nodes), Eigen::Index(number_of_nodes));
  for (std::size_t e = 0; e < number_of_elements; ++e)
    for (int a = 0, k = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b, ++k) {
        const auto i = network.elements[e][a], j = network.elements[e][b];
        full(i, i) += network.weights[e][k], full(j, j) += network.weights[e][k];
        full(i, j) -= network.weights[e][k], full(j, i) -= network.weights[e][k];
      }

  const Laplacian laplacian(network, rows, n, values);
  const auto& matrix = laplacian.matrix;
  assert(matrix.rows() == Eigen::Index(n) && matrix.isCompressed());
  const Eigen::MatrixXd assembled = matrix;
  for (std::size_t i = 0; i < number_of_nodes; ++i) {
    if (rows[i] == Laplacian::known) continue;
    double right = 0;
    for (std::size_t j = 0; j < number_of_nodes; ++j)
      if (rows[j] == Laplacian::known)
        right -= full(Eigen::Index(i), Eigen::Index(j)) * values[j];
      else
        assert(assembled(rows[i], rows[j]) == full(Eigen::Index(i), Eigen::Index(j)));
    assert(laplacian.right[rows[i]] == right);
  }
  for (int j = 0; j < matrix.outerSize(); ++j) // in order, without repetition
    for (int k = matrix.outerIndexPtr()[j] + 1; k < matrix.outerIndexPtr()[j + 1]; ++k)
      assert(matrix.innerIndexPtr()[k - 1] < matrix.innerIndexPtr()[k]);
}

// A matrix with more entries than can be counted is not written, but they are.
void test_too_large() {
  const Random_network network(10, 20, 3);
  const std::vector<std::uint32_t> rows = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  const std::size_t entries = Laplacian(network, rows, 10, {}).number_of_entries;
  const Laplacian just_small(network, rows, 10, {}, entries), too_large(network, rows, 10, {}, entries - 1);
  assert(std::size_t(just_small.matrix.nonZeros()) == entries);
  assert(too_large.number_of_entries == entries && too_large.matrix.nonZeros() == 0);
}

int main() {
  test_too_large();
  for (std::size_t every : {2, 3, 1000}) {
    test_against_full_matrix(7, 40, every);
    test_against_full_matrix(60, 200, every);
    test_against_full_matrix(60, 10, every); // nodes without edges
  }
  std::cout << "done\n";
  return EXIT_SUCCESS;
}
