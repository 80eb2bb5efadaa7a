// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Best_nodes.h>
#include <CGAL/Volume_mesh_parameterization/internal/Carriers_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Corner_energy.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/internal/Star_energy.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_attraction.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_watch.h>
#include <CGAL/Volume_mesh_parameterization/internal/color_nodes.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/node_quality.h>
#include <CGAL/Volume_mesh_parameterization/internal/smooth_edge_lengths.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Moves the nodes of a hexahedral mesh one by one, each on its carrier, by Newton steps that lessen the energy of the
// corners and centres of the hexahedra around. Nodes that share no hexahedron move at the same time, so that the result does
// not depend on the number of threads.
template <typename ConcurrencyTag>
class Hexahedra_optimizer {
  using Hexahedron = std::array<std::size_t, 8>;
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;

  // The lower the better: the number of inverted hexahedra; what the least scaled Jacobian lacks and the distance of the
  // surface exceeds; the opposite of the mean.
  using Grade = std::tuple<std::ptrdiff_t, double, double>;
  using Best = Best_nodes<Grade>;
  // The same but for the distance, the least scaled Jacobian up to the target as its opposite.
  using Quality = std::tuple<std::ptrdiff_t, double, double>;

public:
  Hexahedra_optimizer(std::vector<Vector> nodes, const std::vector<Hexahedron>& hexahedra,
                      const std::vector<Carriers_3::Handle>& carriers,
                      Surface_watch<ConcurrencyTag> watch)
      : m_nodes(std::move(nodes)),
        m_watch(std::move(watch)),
        m_hexahedra(hexahedra),
        m_carriers(carriers),
        m_stars(m_nodes.size(), hexahedra.size(), [&](std::size_t h) { return hexahedra[h]; }),
        m_classes(color_nodes(m_stars, hexahedra)),
        m_slacks(m_nodes.size(), 0) {
    look_at_all();
  }

  // First with fixed rest lengths, which untangles and spreads the nodes. Then with the edges' own lengths as rest
  // lengths: only angles count, for by the inequality of means the energy is a bound, which the present nodes attain, for
  // the same function of the scaled Jacobian. Then what of the surface is left out is covered, without losing the angles.
  void run(int most_sweeps, double target, double tolerance) {
    constexpr int most_rounds = 4;
    m_most_sweeps = most_sweeps;
    m_rest_lengths = smooth_edge_lengths(m_nodes, m_hexahedra);
    spread();
    const std::vector<Vector> spread_out = m_nodes;
    straighten(target, tolerance);
    if (number_of_inverted() > 0) untwist(spread_out, target, tolerance);
    Best best(m_nodes, grade(target, m_watch.attractions(m_nodes)));
    bool helps = true;
    for (int round = 0; round < most_rounds && helps && lacks_something(best); ++round) {
      helps = cover_surface(target, tolerance, round == 0 ? 2 : 8, best);
      straighten_covered(target, tolerance, best);
    }
    m_nodes = best.nodes();
  }

  const std::vector<Vector>& nodes() const { return m_nodes; }

private:
  // Stages.

  // Untangles.
  void spread() {
    constexpr int powers[] = {1, 2, 4};
    constexpr double volume_weight = 0.8, least_gain = 1e-3;
    m_has_rest_lengths = true;
    for (int power : powers) run_pass({power, volume_weight}, least_gain);
    m_has_rest_lengths = false;
  }

  // What is inverted in the end may have good corners, but be twisted. So angles are mended anew, from `start` on, where rest
  // lengths make boxes of hexahedra that are inverted. Nothing changes unless that is better.
  void untwist(const std::vector<Vector>& start, double target, double tolerance) {
    constexpr int most_rounds = 4;
    Best_nodes<Quality> best(m_nodes, quality(target));
    m_slacks.assign(m_slacks.size(), 0);
    go_back_to(start);
    m_untwists = true;
    for (int round = 0; round == 0 || (round < most_rounds && number_of_inverted() > 0); ++round) straighten(target, tolerance);
    m_untwists = false;
    best.offer(m_nodes, quality(target));
    go_back_to(best.nodes());
  }

  void straighten(double target, double tolerance) {
    raise_least(target);
    if (tolerance > 0) leave_carriers(target, tolerance);
    raise_mean(target);
  }

  // Lessens the energy of the corners, and that of the distance between surface and hexahedra, together, from the best nodes on.
  // A distance that is just not too far counts as much as a corner that just reaches the target; the power grows, so that in the
  // end the worst counts, whichever it is. Hexahedra may become flatter on the way, and places are looked for again and again.
  // Returns whether that helps.
  bool cover_surface(double target, double tolerance, int first_power, Best& best) {
    constexpr int greatest_power = 32, most_searches = 20, most_sweeps = 3;
    constexpr double least_allowed = 0.15, least_gain = 1e-2, least_target = 0.1;
    go_back_to(best.nodes());
    m_is_covering = true;
    bool helps = false;
    std::vector<Attraction> attractions = m_watch.attractions(m_nodes);
    for (int power = first_power; power <= greatest_power; power *= 2) {
      let_leave_carriers(target, tolerance);
      for (int search = 0; search < most_searches && lacks_something(best); ++search) {
        m_attraction = {std::move(attractions), m_nodes.size(), power, (std::max)(target, least_target) * m_watch.too_far()};
        m_least_allowed = (std::min)(least_allowed, least_scaled_jacobian());
        start_pass({power, 0});
        for (int k = 0; k < (std::min)(most_sweeps, m_most_sweeps); ++k) sweep(k, least_gain);
        attractions = m_watch.attractions(m_nodes);
        helps |= best.offer(m_nodes, grade(target, attractions));
      }
    }
    m_least_allowed = -1;
    m_attraction = {};
    m_is_covering = false;
    return helps;
  }

  // What is covered has to remain so.
  void straighten_covered(double target, double tolerance, Best& best) {
    m_is_covered = true;
    go_back_to(best.nodes());
    if (lacks_something(best))
      straighten(target, tolerance);
    else
      raise_mean(target);
    m_is_covered = false;
    best.offer(m_nodes, grade(target, m_watch.attractions(m_nodes)));
  }

  // The power grows until `target` is reached, or that does not help. On the way the worst may become worse, but not flat:
  // the energy of a flat corner is finite. What is good at once is smoothed a little nevertheless.
  void raise_least(double target) {
    constexpr int powers[] = {2, 4, 8, 16, 32}, fewest_sweeps = 10;
    constexpr double volume_weight = 0.2, least_gain = 1e-2, least_share = 0.5;
    Best_nodes<Quality> best(m_nodes, quality(target));
    for (int power : powers) {
      const auto [inverted, least, mean] = best.grade();
      m_least_allowed = inverted > 0 ? -1 : -least_share * least;
      run_pass({power, volume_weight}, least_gain, target, power == powers[0] ? fewest_sweeps : 0);
      const bool is_better = best.offer(m_nodes, quality(target));
      if (least_scaled_jacobian() >= target || (!is_better && power > powers[0])) break;
    }
    m_least_allowed = -1;
    go_back_to(best.nodes());
  }

  // The mean is looked after as long as a sweep raises it notably, and the worst hexahedra only kept from becoming worse than
  // `target`.
  void raise_mean(double target) {
    constexpr int power = 1, fewest_sweeps = 10;
    constexpr double volume_weight = 0, least_gain = 1e-5, least_rise = 1e-5;
    m_least_allowed = (std::min)(target, least_scaled_jacobian());
    start_pass({power, volume_weight});
    double mean = -1;
    for (int sweep = 0; sweep < m_most_sweeps; ++sweep) {
      if (sweep >= fewest_sweeps && mean_scaled_jacobian() - mean < least_rise) break;
      mean = mean_scaled_jacobian();
      this->sweep(sweep, least_gain);
    }
    m_least_allowed = -1;
  }

  // On a smooth surface a hexahedron with two facets there is flat at the edge between them, and inverted where the surface is
  // concave. Nodes of those that are worse than `target` may leave the surface, a little farther in each round.
  void leave_carriers(double target, double tolerance) {
    constexpr int most_rounds = 5, powers[] = {2, 8, 16}, fewest_sweeps = 10;
    constexpr double volume_weight = 0.2, least_gain = 1e-2;
    Best_nodes<Quality> best(m_nodes, quality(target));
    const auto is_inverted = [&] { return std::get<0>(best.grade()) > 0; };
    for (int round = 0; round < most_rounds && (is_inverted() || -std::get<1>(best.grade()) < target); ++round) {
      let_leave_carriers(target, tolerance * (round + 1) / most_rounds);
      if (round % 2 == 1 && is_inverted()) spread();
      for (int power : powers) run_pass({power, volume_weight}, least_gain, target, fewest_sweeps);
      look_at_all();
      best.offer(m_nodes, quality(target));
    }
    go_back_to(best.nodes());
  }

  // The nodes of hexahedra that are worse than `target`, by a share of the edges around.
  void let_leave_carriers(double target, double share) {
    for (std::size_t h = 0; h < m_hexahedra.size(); ++h)
      if (m_inverted[h] || m_qualities[h] < target)
        for (std::size_t v : m_hexahedra[h]) m_slacks[v] = slack(v, share);
  }

  void go_back_to(const std::vector<Vector>& nodes) {
    m_nodes = nodes;
    look_at_all();
  }

  // Energy.

  static int place(const Hexahedron& h, std::size_t v) {
    return int(std::find(h.begin(), h.end(), v) - h.begin());
  }

  Star_energy energy_around(std::size_t v) const {
    const auto star = m_stars[v];
    Star_energy energy(m_energy, star.size());
    for (std::size_t h : star)
      energy.add(m_nodes, m_hexahedra[h], place(m_hexahedra[h], v), m_rest_lengths[h], !has_rest_lengths(h));
    return energy;
  }

  bool has_rest_lengths(std::size_t h) const { return m_has_rest_lengths || (m_untwists && m_inverted[h]); }

  // As it was when each node was tried last.
  double mean_energy() const {
    return std::accumulate(m_energies.begin(), m_energies.end(), 0.) / double(m_energies.size());
  }

  // Quality.

  double least_scaled_jacobian() const { return *std::min_element(m_qualities.begin(), m_qualities.end()); }

  std::ptrdiff_t number_of_inverted() const { return std::count(m_inverted.begin(), m_inverted.end(), 1); }

  double mean_scaled_jacobian() const {
    return std::accumulate(m_qualities.begin(), m_qualities.end(), 0.) / double(m_qualities.size());
  }

  // A share of the edges at v, but no farther than is near to the surface.
  double slack(std::size_t v, double share) const { return (std::min)(share * mean_edge(v), m_watch.enough()); }

  // Of the edges at v, each as often as hexahedra share it.
  double mean_edge(std::size_t v) const {
    double sum = 0;
    for (std::size_t h : m_stars[v]) {
      const Hexahedron& nodes = m_hexahedra[h];
      for (int k = 0; k < 3; ++k) sum += Star_energy::edge(m_nodes, nodes, place(nodes, v), k).norm() / 3;
    }
    return sum / double(m_stars[v].size());
  }

  // After all nodes have changed.
  void look_at_all() {
    m_qualities.resize(m_hexahedra.size());
    m_inverted.resize(m_hexahedra.size());
    for_each_index<ConcurrencyTag>(m_hexahedra.size(), [&](std::size_t h) {
      m_qualities[h] = corner_scaled_jacobian(m_nodes, m_hexahedra[h]);
      m_inverted[h] = is_inverted(m_nodes, m_hexahedra[h], m_qualities[h]);
    });
    m_watch.start(m_nodes);
    if (m_is_covered) m_watch.keep_covered(m_nodes);
  }

  Quality quality(double target) const {
    return {number_of_inverted(), -(std::min)(target, least_scaled_jacobian()),
            -mean_scaled_jacobian()};
  }

  Grade grade(double target, const std::vector<Attraction>& attractions) const {
    const auto [inverted, least, mean] = quality(target);
    return {inverted, target + least + m_watch.excess(attractions), mean};
  }

  // Whether no hexahedron is inverted, but not all is good.
  static bool lacks_something(const Best& best) { return std::get<0>(best.grade()) == 0 && std::get<1>(best.grade()) > 0; }

  // Steps.

  // Ends when all scaled Jacobians are at least `enough`, after the fewest sweeps.
  void run_pass(Corner_energy energy, double least_gain, double enough = 1, int fewest_sweeps = 0) {
    start_pass(energy);
    int number = 0;
    const auto goes_on = [&] { return number < fewest_sweeps || least_scaled_jacobian() < enough; };
    while (number < m_most_sweeps && goes_on() && sweep(number, least_gain)) ++number;
  }

  void start_pass(Corner_energy energy) {
    m_energy = energy;
    m_energies.assign(m_nodes.size(), 0);
    m_tried_at.assign(m_nodes.size(), 0);
    m_moved_at.assign(m_nodes.size(), 0);
    m_time = 0;
  }

  // Tries nodes that are awake, and returns whether one has moved. A node sleeps until one around it has gained a share of at
  // least `least_gain` of the mean energy around nodes: a high power leaves alone what is far better than the worst.
  bool sweep(int number, double least_gain) {
    constexpr double least_epsilon =
        0.05; // below it the energy is too steep for steps across kinks of carriers
    m_energy.epsilon = (std::max)(least_epsilon, -2 * least_scaled_jacobian());
    m_least_gain = least_gain * mean_energy();
    const int start = m_time;
    for (std::size_t k = 0; k < m_classes.size(); ++k) {
      const std::vector<std::size_t>& nodes = m_classes[number % 2 == 0 ? k : m_classes.size() - 1 - k];
      ++m_time;
      for_each_index<ConcurrencyTag>(nodes.size(), [&](std::size_t i) { wake_and_move(nodes[i]); });
    }
    return std::any_of(m_moved_at.begin(), m_moved_at.end(), [&](int time) { return time > start; });
  }

  void wake_and_move(std::size_t v) {
    if (!is_awake(v)) return;
    m_tried_at[v] = m_time;
    if (move(v)) m_moved_at[v] = m_time;
  }

  // Whether one around v, or v itself, has moved since v was tried.
  bool is_awake(std::size_t v) const {
    for (std::size_t h : m_stars[v])
      for (std::size_t w : m_hexahedra[h])
        if (m_moved_at[w] >= m_tried_at[v]) return true;
    return false;
  }

  // Returns whether that is worth trying those around again.
  bool move(std::size_t v) {
    constexpr int most_halvings = 5;
    const Star_energy energy = energy_around(v);
    Star_energy::Derivatives old = energy.derivatives();
    m_attraction.add_to(old, v, m_nodes);
    m_energies[v] = old.value;
    const Vector start = m_nodes[v];
    Vector step = newton_step(v, old);
    for (int k = 0; k <= most_halvings; ++k, step /= 2) {
      m_nodes[v] = carried(v, start + step);
      const double gain = old.value - energy(m_nodes[v] - start) - m_attraction(v, m_nodes);
      if (gain > 0 && accept_star(v)) return gain >= m_least_gain;
    }
    m_nodes[v] = start;
    return false;
  }

  // The nearest point to p where node v may be.
  Vector carried(std::size_t v, const Vector& p) const {
    const Vector foot = Carriers_3::project(m_carriers[v], p).point;
    const double distance = (p - foot).norm();
    return distance <= m_slacks[v] ? p : Vector(foot + m_slacks[v] / distance * (p - foot));
  }

  // Takes note of the hexahedra around v, unless one is worse than is allowed or more have become inverted, which is allowed
  // only while untangling: there they are pushed on from hexahedron to hexahedron until there is room.
  bool accept_star(std::size_t v) {
    const auto star = m_stars[v];
    std::vector<std::pair<double, char>> found; // quality, whether inverted
    found.reserve(star.size());
    int more = 0;
    for (std::size_t h : star) {
      const double quality = corner_scaled_jacobian(m_nodes, m_hexahedra[h]);
      if (!(quality >= m_least_allowed)) return false;
      found.emplace_back(quality, is_inverted(m_nodes, m_hexahedra[h], quality));
      more += found.back().second - m_inverted[h];
    }
    if ((more > 0 && !m_has_rest_lengths) || !(m_is_covering || m_watch.accepts(v, m_nodes))) return false;
    auto next = found.begin();
    for (std::size_t h : star) std::tie(m_qualities[h], m_inverted[h]) = *next++;
    if (!m_is_covering) m_watch.take_note(v, m_nodes);
    return true;
  }

  // In the directions in which the carrier goes on, with the absolute values of the Hessian's eigenvalues.
  Vector newton_step(std::size_t v, const Star_energy::Derivatives& energy) const {
    constexpr double least_curvature = 1e-6; // of the greatest
    auto basis = Carriers_3::project(m_carriers[v], m_nodes[v]).directions;
    if (m_slacks[v] > 0) basis = Matrix::Identity();
    using Small_matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
    const Eigen::SelfAdjointEigenSolver<Small_matrix> modes(Small_matrix(basis.transpose() * energy.hessian * basis));
    const Small_matrix directions = basis * modes.eigenvectors();
    const double greatest = modes.eigenvalues().cwiseAbs().maxCoeff();
    Vector step = Vector::Zero();
    for (int i = 0; i < directions.cols() && greatest > 0; ++i) {
      const double curvature = (std::max)(std::abs(modes.eigenvalues()[i]), least_curvature * greatest);
      step -= directions.col(i).dot(energy.gradient) / curvature * directions.col(i);
    }
    return step;
  }

  std::vector<Vector> m_nodes;
  Surface_watch<ConcurrencyTag> m_watch;
  const std::vector<Hexahedron>& m_hexahedra;
  const std::vector<Carriers_3::Handle>& m_carriers;
  Incidence_lists<std::size_t, std::size_t> m_stars; // the hexahedra around each node
  std::vector<std::vector<std::size_t>> m_classes;   // of nodes that may move at the same time
  std::vector<double> m_slacks;                      // how far nodes may be from their carriers
  std::vector<double> m_qualities;                   // scaled Jacobians of the hexahedra
  std::vector<char> m_inverted;                      // whether a hexahedron is, anywhere
  std::vector<int> m_tried_at, m_moved_at;           // the time at which each node was or did last
  int m_time = 0;                                    // number of classes that have moved in a pass
  std::vector<double> m_energies;                    // around each node
  double m_least_gain = 0;                           // of energy, for which nodes around are worth trying again
  int m_most_sweeps = 0;                             // in a pass
  std::vector<Vector> m_rest_lengths;                // of each hexahedron along its three axes
  bool m_is_covering = false;                        // meanwhile the boundary may leave the surface
  bool m_is_covered = false;                         // what of the surface is covered has to remain so
  bool m_untwists = false;                           // inverted hexahedra have rest lengths, too
  bool m_has_rest_lengths = true;                    // else an edge's own length serves
  double m_least_allowed = -1;                       // scaled Jacobian
  Corner_energy m_energy;
  Surface_attraction m_attraction; // while the surface is covered
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRA_OPTIMIZER_H
