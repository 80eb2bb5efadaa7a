// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Carriers_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The energy of a corner of a hexahedron, which is least when its edges are orthogonal and have their rest lengths. With the
matrix J of edges divided by rest lengths, q = |J|^2 / 3 and d = det J it is
  ((1 - w) q / chi(d)^(2/3) + w (d^2 + 1) / (2 chi(d)))^power,   chi(d) = (d + sqrt(d^2 + epsilon^2)) / 2.
The sum is that of V. Garanzha, I. Kaporin, L. Kudryavtseva, F. Protais, N. Ray, D. Sokolov, Foldover-free maps in 50
lines of code, 2021, equations (2) and (3); a high power looks after the worst corners.
*/
struct Corner_energy {
  double power = 1, volume_weight = 0.8, epsilon = 0;

  struct Derivatives {
    double f, q, d, qq, qd, dd;
  };

  double chi(double d) const { return (d + std::hypot(d, epsilon)) / 2; }

  double operator()(double q, double d) const { return std::pow(base(q, d), power); }

  Derivatives derivatives(double q, double d) const {
    const double w = volume_weight, x = chi(d), root = std::hypot(d, epsilon);
    const double x1 = x / root, x2 = epsilon * epsilon / (2 * root * root * root);
    const double r1 = x1 / x, r2 = x2 / x;
    const double shape = (1 - w) * std::pow(x, -2. / 3), volume = w * (d * d + 1) / (2 * x);
    const double b = shape * q + volume, bq = shape, bqd = -2. / 3 * shape * r1;
    const double bd = q * bqd + w * d / x - volume * r1;
    const double bdd = q * shape * (10. / 9 * r1 * r1 - 2. / 3 * r2) + w * (1 - 2 * d * r1) / x +
                       volume * (2 * r1 * r1 - r2);
    const double f = std::pow(b, power), f1 = power * f / b, f2 = (power - 1) * f1 / b;
    return {f, f1 * bq, f1 * bd, f2 * bq * bq, f1 * bqd + f2 * bq * bd, f1 * bdd + f2 * bd * bd};
  }

private:
  double base(double q, double d) const {
    const double x = chi(d);
    return (1 - volume_weight) * q / std::cbrt(x * x) + volume_weight * (d * d + 1) / (2 * x);
  }
};

// Moves the nodes of a hexahedral mesh one by one, each on its carrier, by Newton steps that lessen the energy of the
// corners around. No step increases the number of inverted hexahedra.
class Hexahedra_optimizer {
  using Cube = Reference_hexahedron;
  using Hexahedron = std::array<std::size_t, 8>;
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

public:
  Hexahedra_optimizer(std::vector<Vector> nodes, const std::vector<Hexahedron>& hexahedra,
                      const std::vector<Carriers_3::Handle>& carriers)
      : m_nodes(std::move(nodes)),
        m_hexahedra(hexahedra),
        m_carriers(carriers),
        m_stars(m_nodes.size(), hexahedra.size(), [&](std::size_t h) { return hexahedra[h]; }) {
    for (const Hexahedron& h : hexahedra) m_inverted.push_back(is_inverted(h));
  }

  // First with fixed rest lengths, which untangles and spreads the nodes. Then with the edges' own lengths as rest
  // lengths: only angles count, for by the inequality of means the energy is a bound, which the present nodes attain, for
  // the same function of the scaled Jacobian. The power grows until `target` is reached, or is not worth it.
  void run(int most_sweeps, double target) {
    constexpr double first_volume_weight = 0.8, last_volume_weight = 0.2;
    constexpr double first_powers[] = {1, 2, 4}, last_powers[] = {2, 4, 8, 16, 32};
    m_rest_lengths = smooth_lengths();
    for (double power : first_powers) run_pass({power, first_volume_weight}, most_sweeps);
    m_has_rest_lengths = false;
    for (double power : last_powers) {
      const std::vector<Vector> old_nodes = m_nodes;
      const Badness old_badness = badness();
      run_pass({power, last_volume_weight}, most_sweeps);
      if (least_scaled_jacobian() >= target) return;
      if (power == last_powers[0] || badness() < old_badness) continue;
      m_nodes = old_nodes;
      return;
    }
  }

  const std::vector<Vector>& nodes() const { return m_nodes; }

private:
  // The vertex of a corner, its three neighbors, and the rest lengths of the edges to these.
  struct Corner {
    std::array<std::size_t, 4> nodes;
    Vector rest_lengths;
  };

  // The axis of the edge to each neighbor in Reference_hexahedron::neighbors.
  static constexpr int neighbor_axes[8][3] = {{0, 1, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2},
                                              {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {0, 1, 2}};

  // Rest lengths.

  // The mean length of a hexahedron's edges along each axis, averaged with hexahedra that share such an edge.
  std::vector<Vector> smooth_lengths() const {
    constexpr int rounds = 20;
    struct Edge {
      std::array<std::size_t, 2> nodes;
      std::size_t hexahedron;
      int axis;
      bool operator<(const Edge& e) const { return nodes < e.nodes; }
    };
    std::vector<Vector> lengths(m_hexahedra.size(), Vector::Zero());
    std::vector<Edge> edges;
    for (std::size_t h = 0; h < m_hexahedra.size(); ++h)
      for (int axis = 0; axis < 3; ++axis)
        for (const auto& e : Cube::axis_edges[axis]) {
          const std::size_t v = m_hexahedra[h][e[0]], w = m_hexahedra[h][e[1]];
          lengths[h][axis] += (m_nodes[v] - m_nodes[w]).norm() / 4;
          edges.push_back({{(std::min)(v, w), (std::max)(v, w)}, h, axis});
        }
    std::stable_sort(edges.begin(), edges.end());
    for (int round = 0; round < rounds; ++round) {
      std::vector<Vector> means(lengths.size(), Vector::Zero());
      for (auto e = edges.begin(), end = e; e != edges.end(); e = end) {
        double sum = 0;
        for (; end != edges.end() && end->nodes == e->nodes; ++end)
          sum += lengths[end->hexahedron][end->axis];
        for (auto i = e; i != end; ++i) means[i->hexahedron][i->axis] += sum / double(end - e) / 4;
      }
      lengths = std::move(means);
    }
    return lengths;
  }

  // Energy.

  Corner corner(std::size_t hexahedron, int vertex) const {
    constexpr double least_ratio = 1e-3; // of a length to the rest length: edges may collapse
    const Hexahedron& h = m_hexahedra[hexahedron];
    Corner c{{h[vertex]}, {}};
    for (int k = 0; k < 3; ++k) {
      c.nodes[k + 1] = h[Cube::neighbors[vertex][k]];
      const double rest = m_rest_lengths[hexahedron][neighbor_axes[vertex][k]];
      const double length = (m_nodes[c.nodes[k + 1]] - m_nodes[c.nodes[0]]).norm();
      c.rest_lengths[k] = m_has_rest_lengths ? rest : (std::max)(length, least_ratio * rest);
    }
    return c;
  }

  Matrix jacobian(const Corner& c) const {
    Matrix j;
    for (int k = 0; k < 3; ++k)
      j.col(k) = (m_nodes[c.nodes[k + 1]] - m_nodes[c.nodes[0]]) / c.rest_lengths[k];
    return j;
  }

  double energy(const Corner& c) const {
    const Matrix j = jacobian(c);
    return m_energy(j.squaredNorm() / 3, j.determinant());
  }

  double energy(const std::vector<Corner>& corners) const {
    double sum = 0;
    for (const Corner& c : corners) sum += energy(c);
    return sum;
  }

  double total_energy() const {
    double sum = 0;
    for (std::size_t h = 0; h < m_hexahedra.size(); ++h)
      for (int i = 0; i < 8; ++i) sum += energy(corner(h, i));
    return sum;
  }

  // Quality.

  double least_scaled_jacobian() const {
    double least = 1;
    for (const Hexahedron& h : m_hexahedra)
      for (int i = 0; i < 8; ++i) {
        Matrix j;
        for (int k = 0; k < 3; ++k)
          j.col(k) = (m_nodes[h[Cube::neighbors[i][k]]] - m_nodes[h[i]]).normalized();
        least = (std::min)(least, j.determinant());
      }
    return least;
  }

  bool is_inverted(const Hexahedron& h) const {
    const auto point = [&](int i) {
      const Vector& p = m_nodes[h[i]];
      return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    for (int i = 0; i < 8; ++i) {
      const int* n = Cube::neighbors[i];
      if (CGAL::orientation(point(i), point(n[0]), point(n[1]), point(n[2])) != POSITIVE) return true;
    }
    return false;
  }

  // What is to be lessened: the number of inverted hexahedra, then the opposite of the least scaled Jacobian.
  using Badness = std::pair<std::ptrdiff_t, double>;
  Badness badness() const {
    return {std::count(m_inverted.begin(), m_inverted.end(), 1), -least_scaled_jacobian()};
  }

  // Steps.

  void run_pass(Corner_energy energy, int most_sweeps) {
    constexpr double least_gain = 1e-3; // of the energy, in one sweep
    constexpr double least_epsilon =
        0.05; // below it the energy is too steep for steps across kinks of carriers
    m_energy = energy;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      m_energy.epsilon = (std::max)(least_epsilon, -2 * least_scaled_jacobian());
      const double old_energy = total_energy();
      for (std::size_t v = 0; v < m_nodes.size(); ++v) move(sweep % 2 == 0 ? v : m_nodes.size() - 1 - v);
      if (old_energy - total_energy() < least_gain * old_energy) return;
    }
  }

  // All corners that v belongs to.
  std::vector<Corner> corners_around(std::size_t v) const {
    std::vector<Corner> corners;
    for (std::size_t h : m_stars[v]) {
      const Hexahedron& nodes = m_hexahedra[h];
      const int i = int(std::find(nodes.begin(), nodes.end(), v) - nodes.begin());
      corners.push_back(corner(h, i));
      for (int n : Cube::neighbors[i]) corners.push_back(corner(h, n));
    }
    return corners;
  }

  void move(std::size_t v) {
    constexpr int most_halvings = 5;
    const std::vector<Corner> corners = corners_around(v);
    const Vector start = m_nodes[v];
    const double old_energy = energy(corners);
    Vector step = newton_step(v, corners);
    for (int k = 0; k <= most_halvings; ++k, step /= 2) {
      m_nodes[v] = Carriers_3::project(m_carriers[v], start + step).point;
      if (energy(corners) < old_energy && accept_star(v)) return;
    }
    m_nodes[v] = start;
  }

  // Takes note of the inverted hexahedra around v, unless they have become more.
  bool accept_star(std::size_t v) {
    const auto star = m_stars[v];
    std::vector<char> inverted;
    int more = 0;
    for (std::size_t h : star) {
      inverted.push_back(is_inverted(m_hexahedra[h]));
      more += inverted.back() - m_inverted[h];
    }
    if (more > 0) return false;
    auto flag = inverted.begin();
    for (std::size_t h : star) m_inverted[h] = *flag++;
    return true;
  }

  // In the directions in which the carrier goes on, with the absolute values of the Hessian's eigenvalues.
  Vector newton_step(std::size_t v, const std::vector<Corner>& corners) const {
    constexpr double least_curvature = 1e-6; // of the greatest
    Vector gradient = Vector::Zero();
    Matrix hessian = Matrix::Zero();
    for (const Corner& c : corners) add_derivatives(c, v, gradient, hessian);
    const auto basis = Carriers_3::project(m_carriers[v], m_nodes[v]).directions;
    using Small_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
    const Eigen::SelfAdjointEigenSolver<Small_matrix> modes(
        Small_matrix(basis.transpose() * hessian * basis));
    const Small_matrix directions = basis * modes.eigenvectors();
    const double greatest = modes.eigenvalues().cwiseAbs().maxCoeff();
    Vector step = Vector::Zero();
    for (int i = 0; i < directions.cols() && greatest > 0; ++i) {
      const double curvature = (std::max)(std::abs(modes.eigenvalues()[i]), least_curvature * greatest);
      step -= directions.col(i).dot(gradient) / curvature * directions.col(i);
    }
    return step;
  }

  // d is affine in the position of one node, q is quadratic.
  void add_derivatives(const Corner& c, std::size_t v, Vector& gradient, Matrix& hessian) const {
    const Matrix j = jacobian(c);
    Vector dq = Vector::Zero(), dd = Vector::Zero();
    double hq = 0;
    for (int k = 0; k < 3; ++k) {
      const double weight = (int(c.nodes[k + 1] == v) - int(c.nodes[0] == v)) / c.rest_lengths[k];
      dq += 2. / 3 * weight * j.col(k);
      dd += weight * j.col((k + 1) % 3).cross(j.col((k + 2) % 3));
      hq += 2. / 3 * weight * weight;
    }
    const Corner_energy::Derivatives e = m_energy.derivatives(j.squaredNorm() / 3, j.determinant());
    gradient += e.q * dq + e.d * dd;
    hessian += e.q * hq * Matrix::Identity() + e.qq * dq * dq.transpose() + e.dd * dd * dd.transpose() +
               e.qd * (dq * dd.transpose() + dd * dq.transpose());
  }

  std::vector<Vector> m_nodes;
  const std::vector<Hexahedron>& m_hexahedra;
  const std::vector<Carriers_3::Handle>& m_carriers;
  Incidence_lists<std::size_t, std::size_t> m_stars; // the hexahedra around each node
  std::vector<char> m_inverted;
  std::vector<Vector> m_rest_lengths; // of each hexahedron along its three axes
  bool m_has_rest_lengths = true;     // else an edge's own length serves
  Corner_energy m_energy;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H
