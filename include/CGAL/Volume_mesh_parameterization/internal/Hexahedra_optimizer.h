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
#include <CGAL/Volume_mesh_parameterization/internal/Corner_energy.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/enum.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Moves the nodes of a hexahedral mesh one by one, each on its carrier, by Newton steps that lessen the energy of the
// corners and centres of the hexahedra around.
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
        m_stars(m_nodes.size(), hexahedra.size(), [&](std::size_t h) { return hexahedra[h]; }),
        m_slacks(m_nodes.size(), 0) {
    find_inverted();
  }

  // First with fixed rest lengths, which untangles and spreads the nodes. Then with the edges' own lengths as rest
  // lengths: only angles count, for by the inequality of means the energy is a bound, which the present nodes attain, for
  // the same function of the scaled Jacobian. What is flat to the end may leave its carrier by a `tolerance`, a share of the
  // edges around.
  void run(int most_sweeps, double target, double second_target, double tolerance) {
    constexpr double flat = 0.1;
    m_most_sweeps = most_sweeps;
    m_rest_lengths = smooth_lengths();
    spread();
    const int passes = raise_least(target);
    if (tolerance > 0) leave_carriers((std::min)(flat, target), tolerance);
    raise_mean(target);
    constexpr int few = 2; // passes; else it would cost the mean
    if (second_target > target && passes <= few && least_scaled_jacobian() >= target)
      aim_higher(second_target);
  }

  const std::vector<Vector>& nodes() const { return m_nodes; }

private:
  static constexpr int centre = 8;

  // A corner of a hexahedron, or its centre, where the mean edge along each axis counts. With the rest lengths of the
  // three edges, and the derivatives of the edges in these units by the position of the node that is about to move.
  struct Corner {
    const Hexahedron* nodes;
    int place;
    Vector rest_lengths, weights;
  };

  // The axis of the edge to each neighbor in Reference_hexahedron::neighbors.
  static constexpr int neighbor_axes[8][3] = {{0, 1, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2},
                                              {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {0, 1, 2}};

  // Stages.

  // Untangles.
  void spread() {
    constexpr int powers[] = {1, 2, 4};
    constexpr double volume_weight = 0.8, least_gain = 1e-3;
    m_has_rest_lengths = true;
    for (int power : powers) run_pass({power, volume_weight}, least_gain);
    m_has_rest_lengths = false;
  }

  // The power grows until `target` is reached, or is not worth it. Returns the number of passes.
  int raise_least(double target) {
    constexpr int powers[] = {2, 4, 8, 16, 32};
    constexpr double volume_weight = 0.2, least_gain = 1e-2;
    int passes = 0;
    for (int power : powers) {
      const std::vector<Vector> old_nodes = m_nodes;
      const Badness old_badness = badness();
      run_pass({power, volume_weight}, least_gain);
      ++passes;
      if (least_scaled_jacobian() >= target) break;
      if (passes == 1 || badness() < old_badness) continue;
      m_nodes = old_nodes;
      break;
    }
    find_inverted();
    return passes;
  }

  // The mean is looked after, and the worst hexahedra only kept from becoming worse than `target`.
  void raise_mean(double target) {
    constexpr int power = 3;
    constexpr double volume_weight = 0, least_gain = 1e-5;
    m_least_allowed = (std::min)(target, least_scaled_jacobian());
    run_pass({power, volume_weight}, least_gain);
    m_least_allowed = -1;
  }

  // On a smooth surface a hexahedron with two facets there is flat at the edge between them, and inverted where the surface is
  // concave. Nodes of those that are less than `flat` may leave the surface, a little.
  void leave_carriers(double flat, double tolerance) {
    constexpr int most_rounds = 6, powers[] = {2, 8, 16};
    constexpr double volume_weight = 0.2, least_gain = 1e-3;
    std::vector<Vector> best_nodes = m_nodes;
    Badness least = badness();
    for (int round = 0; round < most_rounds && -least.second < flat; ++round) {
      for (const Hexahedron& h : m_hexahedra)
        if (scaled_jacobian(h) < flat)
          for (std::size_t v : h) m_slacks[v] = tolerance * mean_edge(v);
      if (round % 2 == 1) spread();
      for (int power : powers) run_pass({power, volume_weight}, least_gain);
      find_inverted();
      if (!(badness() < least)) continue;
      least = badness();
      best_nodes = m_nodes;
    }
    m_nodes = best_nodes;
    find_inverted();
  }

  // As long as the mean does not suffer.
  void aim_higher(double target) {
    constexpr double greatest_loss = 0.005;
    const std::vector<Vector> old_nodes = m_nodes;
    const double old_mean = mean_scaled_jacobian();
    const Badness old_badness = badness();
    raise_least(target);
    raise_mean(target);
    if (badness() < old_badness && mean_scaled_jacobian() >= old_mean - greatest_loss) return;
    m_nodes = old_nodes;
    find_inverted();
  }

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

  static int place(const Hexahedron& h, std::size_t v) {
    return int(std::find(h.begin(), h.end(), v) - h.begin());
  }

  Vector edge(const Hexahedron& h, int place, int k) const {
    if (place != centre) return m_nodes[h[Cube::neighbors[place][k]]] - m_nodes[h[place]];
    Vector sum = Vector::Zero();
    for (const auto& e : Cube::axis_edges[k]) sum += m_nodes[h[e[1]]] - m_nodes[h[e[0]]];
    return sum / 4;
  }

  // The derivative of that edge by the position of a vertex.
  static double weight(int vertex, int place, int k) {
    if (place != centre) return int(Cube::neighbors[place][k] == vertex) - int(place == vertex);
    const auto& edges = Cube::axis_edges[k];
    const auto ends_at_vertex = [vertex](const auto& e) { return e[1] == vertex; };
    return std::any_of(std::begin(edges), std::end(edges), ends_at_vertex) ? 0.25 : -0.25;
  }

  Corner corner(std::size_t hexahedron, int place, int vertex) const {
    constexpr double least_ratio = 0.2; // of a length to the rest length, lest edges collapse
    Corner c{&m_hexahedra[hexahedron], place, {}, {}};
    for (int k = 0; k < 3; ++k) {
      const double rest = m_rest_lengths[hexahedron][place == centre ? k : neighbor_axes[place][k]];
      c.rest_lengths[k] =
          m_has_rest_lengths ? rest : (std::max)(edge(*c.nodes, place, k).norm(), least_ratio * rest);
      c.weights[k] = weight(vertex, place, k) / c.rest_lengths[k];
    }
    return c;
  }

  Matrix jacobian(const Corner& c) const {
    Matrix j;
    for (int k = 0; k < 3; ++k) j.col(k) = edge(*c.nodes, c.place, k) / c.rest_lengths[k];
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

  // Quality.

  double scaled_jacobian(const Hexahedron& h) const {
    double least = 1;
    for (int place = 0; place <= centre; ++place) {
      Matrix j;
      for (int k = 0; k < 3; ++k) j.col(k) = edge(h, place, k).normalized();
      least = (std::min)(least, j.determinant());
    }
    return least;
  }

  double least_scaled_jacobian() const {
    double least = 1;
    for (const Hexahedron& h : m_hexahedra) least = (std::min)(least, scaled_jacobian(h));
    return least;
  }

  double mean_scaled_jacobian() const {
    double sum = 0;
    for (const Hexahedron& h : m_hexahedra) sum += scaled_jacobian(h);
    return sum / double(m_hexahedra.size());
  }

  // Of the edges at v, each as often as hexahedra share it.
  double mean_edge(std::size_t v) const {
    double sum = 0;
    for (std::size_t h : m_stars[v]) {
      const Hexahedron& nodes = m_hexahedra[h];
      for (int k = 0; k < 3; ++k) sum += edge(nodes, place(nodes, v), k).norm() / 3;
    }
    return sum / double(m_stars[v].size());
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
    return !(scaled_jacobian(h) > 0); // the centre
  }

  void find_inverted() {
    m_inverted.clear();
    for (const Hexahedron& h : m_hexahedra) m_inverted.push_back(is_inverted(h));
  }

  // What is to be lessened: the number of inverted hexahedra, then the opposite of the least scaled Jacobian.
  using Badness = std::pair<std::ptrdiff_t, double>;
  Badness badness() const {
    return {std::count(m_inverted.begin(), m_inverted.end(), 1), -least_scaled_jacobian()};
  }

  // Steps.

  // A node sleeps until one around it has gained a share of at least `least_gain` of the energy around.
  void run_pass(Corner_energy energy, double least_gain) {
    constexpr double least_epsilon =
        0.05; // below it the energy is too steep for steps across kinks of carriers
    m_energy = energy;
    m_is_awake.assign(m_nodes.size(), 1);
    bool some_moved = true;
    for (int sweep = 0; sweep < m_most_sweeps && some_moved; ++sweep) {
      m_energy.epsilon = (std::max)(least_epsilon, -2 * least_scaled_jacobian());
      some_moved = false;
      for (std::size_t k = 0; k < m_nodes.size(); ++k)
        some_moved |= wake_and_move(sweep % 2 == 0 ? k : m_nodes.size() - 1 - k, least_gain);
    }
  }

  bool wake_and_move(std::size_t v, double least_gain) {
    if (!m_is_awake[v]) return false;
    m_is_awake[v] = 0;
    if (move(v) < least_gain) return false;
    for (std::size_t h : m_stars[v])
      for (std::size_t w : m_hexahedra[h]) m_is_awake[w] = 1;
    return true;
  }

  // All corners and centres that depend on v.
  std::vector<Corner> corners_around(std::size_t v) const {
    std::vector<Corner> corners;
    for (std::size_t h : m_stars[v]) {
      const Hexahedron& nodes = m_hexahedra[h];
      const int i = place(nodes, v);
      const int* n = Cube::neighbors[i];
      for (int at : {i, n[0], n[1], n[2], centre + 0}) corners.push_back(corner(h, at, i));
    }
    return corners;
  }

  // Returns which share of the energy around v is gained.
  double move(std::size_t v) {
    constexpr int most_halvings = 5;
    const std::vector<Corner> corners = corners_around(v);
    const Vector start = m_nodes[v];
    const double old_energy = energy(corners);
    Vector step = newton_step(v, corners);
    for (int k = 0; k <= most_halvings; ++k, step /= 2) {
      m_nodes[v] = carried(v, start + step);
      const double new_energy = energy(corners);
      if (new_energy < old_energy && accept_star(v)) return 1 - new_energy / old_energy;
    }
    m_nodes[v] = start;
    return 0;
  }

  // The nearest point to p where node v may be.
  Vector carried(std::size_t v, const Vector& p) const {
    const Vector foot = Carriers_3::project(m_carriers[v], p).point;
    const double distance = (p - foot).norm();
    return distance <= m_slacks[v] ? p : Vector(foot + m_slacks[v] / distance * (p - foot));
  }

  // Takes note of the inverted hexahedra around v, unless they have become more, which is allowed only while untangling:
  // there they are pushed on from hexahedron to hexahedron until there is room.
  bool accept_star(std::size_t v) {
    const auto star = m_stars[v];
    std::vector<char> inverted;
    int more = 0;
    for (std::size_t h : star) {
      if (!(scaled_jacobian(m_hexahedra[h]) >= m_least_allowed)) return false;
      inverted.push_back(is_inverted(m_hexahedra[h]));
      more += inverted.back() - m_inverted[h];
    }
    if (more > 0 && !m_has_rest_lengths) return false;
    auto flag = inverted.begin();
    for (std::size_t h : star) m_inverted[h] = *flag++;
    return true;
  }

  // In the directions in which the carrier goes on, with the absolute values of the Hessian's eigenvalues.
  Vector newton_step(std::size_t v, const std::vector<Corner>& corners) const {
    constexpr double least_curvature = 1e-6; // of the greatest
    Vector gradient = Vector::Zero();
    Matrix hessian = Matrix::Zero();
    for (const Corner& c : corners) add_derivatives(c, gradient, hessian);
    auto basis = Carriers_3::project(m_carriers[v], m_nodes[v]).directions;
    if (m_slacks[v] > 0) basis = Matrix::Identity();
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
  void add_derivatives(const Corner& c, Vector& gradient, Matrix& hessian) const {
    const Matrix j = jacobian(c);
    Vector dq = Vector::Zero(), dd = Vector::Zero();
    double hq = 0;
    for (int k = 0; k < 3; ++k) {
      const double w = c.weights[k];
      dq += 2. / 3 * w * j.col(k);
      dd += w * j.col((k + 1) % 3).cross(j.col((k + 2) % 3));
      hq += 2. / 3 * w * w;
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
  std::vector<double> m_slacks;                      // how far nodes may be from their carriers
  std::vector<char> m_inverted, m_is_awake;          // hexahedra; nodes
  int m_most_sweeps = 0;                             // in a pass
  std::vector<Vector> m_rest_lengths;                // of each hexahedron along its three axes
  bool m_has_rest_lengths = true;                    // else an edge's own length serves
  double m_least_allowed = -1;                       // scaled Jacobian
  Corner_energy m_energy;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H
