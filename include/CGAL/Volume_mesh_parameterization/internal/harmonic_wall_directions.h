// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HARMONIC_WALL_DIRECTIONS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HARMONIC_WALL_DIRECTIONS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Prism_wall.h>

#include <CGAL/number_utils.h>

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

/*
The angles of the vertices of walls: places on the perimeters of the rectangles below, in shares of a turn. Creases run
where the angle is that of a corner.

They are harmonic, with the angles of the floor; the ceiling is free. A picture, the images of the vertices under a map to the
prism, tells the way around the walls: angles differ from the picture's by turns that are continuous on each wall and vanish
on the floor.
*/
class Harmonic_wall_angles {
public:
  using Id = Refined_surface::Id;
  using Point_2 = Double_kernel::Point_2;
  using Point_3 = Double_kernel::Point_3;

  // picture: of the first vertices of the surface; the others have split an edge
  Harmonic_wall_angles(const Labelled_surface& surface, const std::vector<Prism_wall>& walls,
                       const std::vector<Point_3>& picture)
      : m_surface(surface),
        m_walls(walls),
        m_pictured(surface.surface.number_of_vertices(), Point_2(0, 0)),
        m_turn(m_pictured.size(), 0),
        m_state(m_pictured.size(), OFF_WALLS) {
    const auto& triangles = surface.surface.triangles();
    for (Id t = 0; t < triangles.size(); ++t)
      for (const Prism_wall& wall : walls)
        if (surface.labels[t] == wall.label)
          for (Id v : triangles[t]) {
            m_state[v] = FREE;
            if (v < picture.size()) m_pictured[v] = wall.direction(picture[v].x(), picture[v].y());
          }
    for (Id v = Id(picture.size()); v < m_pictured.size(); ++v) {
      const auto& ends = surface.surface.split_edge(v);
      m_pictured[v] = CGAL::midpoint(m_pictured[ends[0]], m_pictured[ends[1]]);
    }
    for (const Prism_wall& wall : walls)
      for (Id v : wall_rim(surface, wall.label, FLOOR)) m_state[v] = FIXED;
    smooth();
  }

  // Spaces the vertices of the ceiling more evenly: `share` of the way to the arc length. Harmonic in between.
  void space_evenly(double share) {
    std::vector<char> state = m_state;
    for (const Prism_wall& wall : m_walls) space_evenly(wall_rim(m_surface, wall.label, CEILING), share);
    smooth();
    m_state = std::move(state);
  }

  // The points of the unit circle, about, at the angles.
  std::vector<Point_2> directions() const {
    std::vector<Point_2> result;
    for (std::size_t v = 0; v < m_turn.size(); ++v) {
      const Point_2& p = m_pictured[v];
      const double c = std::cos(m_turn[v]), s = std::sin(m_turn[v]);
      result.emplace_back(c * p.x() - s * p.y(), s * p.x() + c * p.y());
    }
    return result;
  }

private:
  enum State : char { OFF_WALLS, FREE, FIXED };

  // From v to its neighbor w, in the picture; between -pi and pi.
  double pictured_angle(Id v, Id w) const {
    const Point_2 &p = m_pictured[v], &q = m_pictured[w];
    return std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y());
  }

  void space_evenly(const std::vector<Id>& rim, double share) {
    const std::size_t n = rim.size();
    std::vector<double> lag(n, 0), arc(n, 0); // of the angle, which may pass a turn, behind the arc length
    double angle = m_turn[rim[0]];
    for (std::size_t i = 1; i < n; ++i) {
      arc[i] = arc[i - 1] + m_surface.surface.length(rim[i - 1], rim[i]);
      angle += pictured_angle(rim[i - 1], rim[i]) + m_turn[rim[i]] - m_turn[rim[i - 1]];
      lag[i] = -angle;
    }
    lag[0] = -m_turn[rim[0]];
    const double total = arc[n - 1] + m_surface.surface.length(rim[n - 1], rim[0]);
    double mean = 0;
    for (std::size_t i = 0; i < n; ++i) {
      lag[i] += 2 * CGAL_PI * arc[i] / total;
      mean += lag[i] / double(n);
    }
    for (std::size_t i = 0; i < n; ++i) {
      m_turn[rim[i]] += share * (lag[i] - mean);
      m_state[rim[i]] = FIXED;
    }
  }

  // Cotangents below a bound count as that.
  double weight(Id v, Id w, Id opposite) const {
    constexpr double least = 1e-3, greatest = 1e3;
    const auto& p = m_surface.surface.points();
    const auto a = p[v] - p[opposite], b = p[w] - p[opposite];
    const double cross = std::sqrt(CGAL::cross_product(a, b).squared_length());
    const double dot = a * b;
    return dot >= greatest * cross ? greatest : (std::max)(least, dot / cross);
  }

  // The turns of free vertices minimize the Dirichlet energy of the angle.
  void smooth() {
    const Refined_surface& s = m_surface.surface;
    std::vector<int> row(m_turn.size());
    int n = 0;
    for (Id v = 0; v < m_turn.size(); ++v) row[v] = m_state[v] == FREE ? n++ : -1;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
    const auto add = [&](Id v, Id w, double k) {
      if (row[v] < 0) return;
      entries.emplace_back(row[v], row[v], k);
      right[row[v]] += k * pictured_angle(v, w);
      if (row[w] >= 0)
        entries.emplace_back(row[v], row[w], -k);
      else
        right[row[v]] += k * m_turn[w];
    };
    for (Id h = 0; h < s.number_of_half_edges(); ++h) {
      if (m_surface.label(h) < FIRST_WALL) continue;
      const Id v = s.source(h), w = s.target(h);
      const double k = weight(v, w, s.source(s.previous(h)));
      add(v, w, k);
      add(w, v, k);
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success) return;
    const Eigen::VectorXd turns = solver.solve(right);
    for (Id v = 0; v < m_turn.size(); ++v)
      if (row[v] >= 0) m_turn[v] = turns[row[v]];
  }

  const Labelled_surface& m_surface;
  const std::vector<Prism_wall>& m_walls;
  std::vector<Point_2> m_pictured; // directions of the vertices in the picture
  std::vector<double> m_turn;      // of each vertex, off its direction in the picture
  std::vector<char> m_state;
};

// The directions of the vertices of walls, whose angles are harmonic.
inline std::vector<Double_kernel::Point_2>
harmonic_wall_directions(const Labelled_surface& surface, const std::vector<Prism_wall>& walls,
                         const std::vector<Double_kernel::Point_3>& picture, double evenness) {
  Harmonic_wall_angles angles(surface, walls, picture);
  if (evenness > 0) angles.space_evenly(evenness);
  return angles.directions();
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HARMONIC_WALL_DIRECTIONS_H
