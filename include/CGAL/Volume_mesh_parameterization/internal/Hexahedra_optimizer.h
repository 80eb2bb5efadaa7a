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
#include <CGAL/Volume_mesh_parameterization/internal/Surface_watch.h>
#include <CGAL/Volume_mesh_parameterization/internal/node_quality.h>
#include <CGAL/Volume_mesh_parameterization/internal/smooth_edge_lengths.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
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
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

public:
  Hexahedra_optimizer(std::vector<Vector> nodes, const std::vector<Hexahedron>& hexahedra,
                      const std::vector<Carriers_3::Handle>& carriers,
                      Surface_watch watch)
      : m_nodes(std::move(nodes)),
        m_watch(std::move(watch)),
        m_hexahedra(hexahedra),
        m_carriers(carriers),
        m_stars(m_nodes.size(), hexahedra.size(), [&](std::size_t h) { return hexahedra[h]; }),
        m_slacks(m_nodes.size(), 0),
        m_places(m_nodes.size()) {
    look_at_all();
  }

  // First with fixed rest lengths, which untangles and spreads the nodes. Then with the edges' own lengths as rest
  // lengths: only angles count, for by the inequality of means the energy is a bound, which the present nodes attain, for
  // the same function of the scaled Jacobian. What is flat to the end may leave its carrier by a `tolerance`, a share of the
  // edges around.
  void run(int most_sweeps, double target, double second_target, double tolerance) {
    constexpr double flat = 0.1;
    m_most_sweeps = most_sweeps;
    m_rest_lengths = smooth_edge_lengths(m_nodes, m_hexahedra);
    spread();
    int passes = raise_least(target);
    if (tolerance > 0) leave_carriers((std::min)(flat, target), tolerance);
    if (cover_surface()) passes += raise_least(target);
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

  // Draws nodes to what of the surface is too far from the hexahedra; those that do not arrive are free again. Returns
  // whether there was any such place, unless hexahedra are inverted, which matters more.
  bool cover_surface() {
    constexpr int most_rounds = 8, power = 2;
    constexpr double volume_weight = 0.2, least_gain = 1e-2;
    if (badness().first > 0) return false;
    int round = 0;
    for (; round < most_rounds; ++round) {
      const std::vector<Drawn_node> drawn = m_watch.nodes_to_draw(m_nodes, m_carriers);
      if (drawn.empty()) break;
      for (const Drawn_node& d : drawn)
        if (!is_at_place(d.node)) m_places[d.node] = d.place;
      run_pass({power, volume_weight}, least_gain);
    }
    for (std::size_t v = 0; v < m_places.size(); ++v)
      if (!is_at_place(v)) m_places[v].reset();
    return round > 0;
  }

  bool is_at_place(std::size_t v) const { return m_places[v] && *m_places[v] == m_nodes[v]; }

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
    look_at_all();
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
      look_at_all();
      if (!(badness() < least)) continue;
      least = badness();
      best_nodes = m_nodes;
    }
    m_nodes = best_nodes;
    look_at_all();
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
    look_at_all();
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

  double scaled_jacobian(const Hexahedron& h) const { return corner_scaled_jacobian(m_nodes, h); }

  double least_scaled_jacobian() const {
    double least = 1;
    for (const Hexahedron& h : m_hexahedra) least = (std::min)(least, scaled_jacobian(h));
    return least;
  }

  double least_scaled_jacobian_around(std::size_t v) const {
    double least = 1;
    for (std::size_t h : m_stars[v]) least = (std::min)(least, scaled_jacobian(m_hexahedra[h]));
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

  // After all nodes have changed.
  void look_at_all() {
    m_inverted.clear();
    for (const Hexahedron& h : m_hexahedra) m_inverted.push_back(is_inverted(m_nodes, h, scaled_jacobian(h)));
    m_watch.start(m_nodes);
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

  // Goes on towards the place of v, as far as hexahedra remain good. Returns whether it moved.
  bool approach_place(std::size_t v) {
    constexpr double good = 0.25, least_share = 1. / 64;
    constexpr int most_halvings = 5;
    const Vector start = m_nodes[v], place = *m_places[v];
    const double least_allowed = (std::min)(good, least_scaled_jacobian_around(v));
    Vector step = place - start;
    for (int k = 0; k <= most_halvings; ++k, step /= 2) {
      m_nodes[v] = k == 0 ? place : carried(v, start + step);
      if ((m_nodes[v] - place).norm() < (1 - least_share) * (start - place).norm() &&
          least_scaled_jacobian_around(v) >= least_allowed && accept_star(v))
        return true;
    }
    m_nodes[v] = start;
    return false;
  }

  // Returns which share of the energy around v is gained.
  double move(std::size_t v) {
    if (m_places[v]) return approach_place(v);
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
      const double quality = scaled_jacobian(m_hexahedra[h]);
      if (!(quality >= m_least_allowed)) return false;
      inverted.push_back(is_inverted(m_nodes, m_hexahedra[h], quality));
      more += inverted.back() - m_inverted[h];
    }
    if ((more > 0 && !m_has_rest_lengths) || !m_watch.accepts(v, m_nodes)) return false;
    auto flag = inverted.begin();
    for (std::size_t h : star) m_inverted[h] = *flag++;
    m_watch.take_note(v, m_nodes);
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
  Surface_watch m_watch;
  const std::vector<Hexahedron>& m_hexahedra;
  const std::vector<Carriers_3::Handle>& m_carriers;
  Incidence_lists<std::size_t, std::size_t> m_stars; // the hexahedra around each node
  std::vector<double> m_slacks;                      // how far nodes may be from their carriers
  std::vector<std::optional<Vector>> m_places;       // where nodes are drawn to
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
