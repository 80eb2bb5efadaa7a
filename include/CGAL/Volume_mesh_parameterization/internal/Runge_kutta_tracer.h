// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUNGE_KUTTA_TRACER_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUNGE_KUTTA_TRACER_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Follows a vector field that is given at the vertices and interpolated linearly, in the direction of the field with
// unit speed, by the classical method of Runge and Kutta. Space is Volume_space or Wall_space.
template <typename Space>
class Runge_kutta_tracer {
public:
  static constexpr int corners = Space::corners;
  using Simplex = typename Space::Simplex;
  using Vector_3 = Double_kernel::Vector_3;
  using Point_3 = Double_kernel::Point_3;

  struct Place {
    Simplex simplex;
    std::array<double, corners> weights{}; // barycentric
  };
  enum Outcome { INSIDE, AT_BORDER, LOST };

  // `sign` -1 follows the field backwards.
  Runge_kutta_tracer(const Space& space, const std::vector<Vector_3>& field, int sign)
      : m_space(space), m_field(field), m_sign(sign) {}

  Point_3 point(const Place& place) const {
    const auto vertices = m_space.vertices(place.simplex);
    const Point_3 origin = approximate(m_space.mesh().point(vertices[0]));
    Vector_3 offset = NULL_VECTOR;
    for (int i = 1; i < corners; ++i)
      offset += place.weights[i] * (approximate(m_space.mesh().point(vertices[i])) - origin);
    return origin + offset;
  }

  // returns `v` in the simplex around it into which the field points most; invalid if there is none.
  Place place(Vertex_index v) const {
    Place best;
    double best_depth = -std::numeric_limits<double>::infinity();
    for (Simplex s : m_space.star(v)) {
      const double d = depth(s, v, m_sign * m_field[v]);
      if (best.simplex.is_valid() && d <= best_depth) continue;
      best_depth = d;
      best.simplex = s;
    }
    if (!best.simplex.is_valid()) return best;
    const auto vertices = m_space.vertices(best.simplex);
    for (int i = 0; i < corners; ++i) best.weights[i] = vertices[i] == v;
    return best;
  }

  // makes one step of length `step`; at a border `side` tells through which side of the simplex it would leave.
  Outcome advance(Place& place, double step, int& side) const {
    Vector_3 slopes[4];
    slopes[0] = direction(place);
    if (!(slopes[0].squared_length() > 0)) return LOST;
    const double reach[4] = {0, step / 2, step / 2, step};
    for (int k = 1; k < 4; ++k) {
      Place probe = place;
      // next to the border Euler's step decides where the curve leaves
      if (walk(probe, reach[k] * slopes[k - 1], side) != INSIDE) return walk(place, step * slopes[0], side);
      slopes[k] = direction(probe);
    }
    return walk(place, step / 6 * (slopes[0] + 2 * slopes[1] + 2 * slopes[2] + slopes[3]), side);
  }

private:
  // A straight segment shorter than a simplex meets a handful of them, or turns around a vertex.
  static constexpr int maximal_number_of_crossings = 1000;

  Vector_3 direction(const Place& place) const {
    const auto vertices = m_space.vertices(place.simplex);
    Vector_3 sum = NULL_VECTOR;
    for (int i = 0; i < corners; ++i) sum += place.weights[i] * m_field[vertices[i]];
    const double norm = std::sqrt(sum.squared_length());
    return norm > 0 ? m_sign / norm * sum : Vector_3(NULL_VECTOR);
  }

  // how far a short way from v along d stays inside all sides at v
  double depth(Simplex s, Vertex_index v, const Vector_3& d) const {
    const auto gradients = m_space.gradients(s);
    const auto vertices = m_space.vertices(s);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < corners; ++i)
      if (vertices[i] != v)
        least = (std::min)(least, d * gradients[i] / std::sqrt(gradients[i].squared_length()));
    return least;
  }

  // moves `place` along d; on a surface d is projected to each facet in turn.
  Outcome walk(Place& place, Vector_3 d, int& side) const {
    double left = 1;
    int entry = -1;
    for (int crossings = 0; crossings < maximal_number_of_crossings; ++crossings) {
      const auto gradients = m_space.gradients(place.simplex);
      if (entry >= 0) keep_from_turning_back(d, gradients[entry]);
      const auto [exit, time] = next_exit(place, d, gradients);
      move(place, (std::min)(time, left) * d, gradients);
      if (time >= left) return INSIDE;
      left -= time;
      side = exit;
      place.weights[exit] = 0;
      if (!m_space.neighbor(place.simplex, exit).is_valid()) return AT_BORDER;
      entry = cross(place, exit);
    }
    return LOST;
  }

  // Where two wall facets both push towards their common edge, the curve follows the edge.
  static void keep_from_turning_back(Vector_3& d, const Vector_3& gradient) {
    const double rate = d * gradient;
    if (rate < 0) d -= rate / gradient.squared_length() * gradient;
  }

  // returns the side that is reached first, of several the one that is crossed most directly.
  std::pair<int, double> next_exit(const Place& place, const Vector_3& d,
                                   const std::array<Vector_3, corners>& gradients) const {
    int exit = -1;
    double time = std::numeric_limits<double>::infinity(), speed = 0;
    for (int i = 0; i < corners; ++i) {
      const double rate = d * gradients[i];
      if (!(rate < 0)) continue;
      const double t = place.weights[i] / -rate, s = -rate / std::sqrt(gradients[i].squared_length());
      if (t > time || (t == time && s <= speed)) continue;
      exit = i, time = t, speed = s;
    }
    return {exit, time};
  }

  static void move(Place& place, const Vector_3& d, const std::array<Vector_3, corners>& gradients) {
    double sum = 0;
    for (int i = 0; i < corners; ++i)
      sum += place.weights[i] = (std::max)(0., place.weights[i] + d * gradients[i]);
    for (double& w : place.weights) w /= sum;
  }

  // goes to the simplex beyond side `exit` and returns which of its sides that is.
  int cross(Place& place, int exit) const {
    const Simplex next = m_space.neighbor(place.simplex, exit);
    const auto from = m_space.vertices(place.simplex), to = m_space.vertices(next);
    std::array<double, corners> weights{};
    int entry = -1;
    for (int j = 0; j < corners; ++j) {
      const auto i = std::find(from.begin(), from.end(), to[j]) - from.begin();
      if (i == corners)
        entry = j;
      else
        weights[j] = place.weights[i];
    }
    place = {next, weights};
    return entry;
  }

  const Space& m_space;
  const std::vector<Vector_3>& m_field;
  int m_sign;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RUNGE_KUTTA_TRACER_H
