// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Corner_energy.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The energy of the corners and centres of hexahedra around a node as a function of the step that the node takes. For each
// of them, d is affine in the step and q is quadratic, so that neither is computed from edges again.
class Star_energy {
  using Cube = Reference_hexahedron;
  using Vector = Eigen::Vector3d;
  using Matrix = Eigen::Matrix3d;
  using Nodes = std::vector<Vector>;
  using Hexahedron = std::array<std::size_t, 8>;

public:
  struct Derivatives {
    double value = 0;
    Vector gradient = Vector::Zero();
    Matrix hessian = Matrix::Zero();
  };

  Star_energy(const Corner_energy& energy, std::size_t number_of_hexahedra) : m_energy(energy) {
    m_corners.reserve(5 * number_of_hexahedra);
  }

  // Adds what depends on the node with number `vertex` in the hexahedron: four corners and the centre. Lengths are rest lengths,
  // or, with `own_lengths`, the present ones, but no less than a share of those, lest edges collapse.
  void add(const Nodes& nodes, const Hexahedron& hexahedron, int vertex, const Vector& lengths, bool own_lengths) {
    const int* n = Cube::neighbors[vertex];
    for (int place : {vertex, n[0], n[1], n[2], centre}) {
      Matrix j;
      Vector weights;
      for (int k = 0; k < 3; ++k) {
        const Vector e = edge(nodes, hexahedron, place, k);
        const double rest = lengths[place == centre ? k : neighbor_axes[place][k]];
        const double length = own_lengths ? (std::max)(e.norm(), least_ratio * rest) : rest;
        j.col(k) = e / length;
        weights[k] = weight(vertex, place, k) / length;
      }
      m_corners.emplace_back(j, weights);
    }
  }

  double operator()(const Vector& step) const {
    double sum = 0;
    for (const Corner& c : m_corners)
      sum += m_energy(c.q + c.dq.dot(step) + c.hq / 2 * step.squaredNorm(), c.d + c.dd.dot(step));
    return sum;
  }

  // Before any step.
  Derivatives derivatives() const {
    Derivatives sum;
    double diagonal = 0;
    for (const Corner& c : m_corners) {
      const Corner_energy::Derivatives e = m_energy.derivatives(c.q, c.d);
      sum.value += e.f;
      sum.gradient += e.q * c.dq + e.d * c.dd;
      sum.hessian += (e.qq * c.dq + e.qd * c.dd) * c.dq.transpose() + (e.qd * c.dq + e.dd * c.dd) * c.dd.transpose();
      diagonal += e.q * c.hq;
    }
    sum.hessian.diagonal().array() += diagonal;
    return sum;
  }

  // The edge from a corner to its neighbor k, or the mean edge along axis k.
  static Vector edge(const Nodes& nodes, const Hexahedron& h, int place, int k) {
    if (place != centre) return nodes[h[Cube::neighbors[place][k]]] - nodes[h[place]];
    Vector sum = Vector::Zero();
    for (const auto& e : Cube::axis_edges[k]) sum += nodes[h[e[1]]] - nodes[h[e[0]]];
    return sum / 4;
  }

private:
  static constexpr int centre = 8;
  static constexpr double least_ratio = 0.2; // of a length to the rest length

  // The axis of the edge to each neighbor in Reference_hexahedron::neighbors.
  static constexpr int neighbor_axes[8][3] = {{0, 1, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2},
                                              {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {0, 1, 2}};
  static constexpr bool coordinates[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                             {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

  // The matrix J of edges in units of their lengths, by |J|^2 / 3 and det J with their derivatives.
  struct Corner {
    Corner(const Matrix& j, const Vector& weights) : q(j.squaredNorm() / 3), hq(2. / 3 * weights.squaredNorm()) {
      const Vector cross[] = {j.col(1).cross(j.col(2)), j.col(2).cross(j.col(0)), j.col(0).cross(j.col(1))};
      d = j.col(0).dot(cross[0]);
      dq = 2. / 3 * (j * weights);
      dd = weights[0] * cross[0] + weights[1] * cross[1] + weights[2] * cross[2];
    }

    double q, d, hq;
    Vector dq, dd;
  };

  // The derivative of edge() by the position of a vertex.
  static double weight(int vertex, int place, int k) {
    if (place == centre) return coordinates[vertex][k] ? 0.25 : -0.25;
    return int(Cube::neighbors[place][k] == vertex) - int(place == vertex);
  }

  Corner_energy m_energy;
  std::vector<Corner> m_corners;
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_STAR_ENERGY_H
