// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_FIELDS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_FIELDS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

using Vertex_field = Eigen::VectorXd; // one value for each vertex, 0 off the surface

// One implicit step of heat flow on a surface, (M + time L) x = M b: an average over distances up to sqrt(time).
// Cotangents below 0 count as 0, so that averages stay within the range of b. Vertices may be given more weight than their
// part of the area.
class Surface_diffusion {
public:
  Surface_diffusion(const Approximate_surface& surface, double time)
      : Surface_diffusion(surface, time, Vertex_field::Zero(Eigen::Index(surface.points.size()))) {}

  Surface_diffusion(const Approximate_surface& surface, double time, const Vertex_field& more_mass)
      : m_mass(lumped_mass(surface) + more_mass) {
    using Triplet = Eigen::Triplet<double>;
    std::vector<Triplet> entries;
    for (Eigen::Index v = 0; v < m_mass.size(); ++v)
      entries.emplace_back(v, v, m_mass[v] > 0 ? m_mass[v] : 1);
    for (Facet_index f : surface.adjacency.facets())
      for (int i = 0; i < 3; ++i) {
        const double w = time * cotangent(surface, f, i) / 2;
        const int v = int(surface.adjacency.source({f, i})), u = int(surface.adjacency.target({f, i}));
        for (const auto& e : {Triplet(v, v, w), Triplet(u, u, w), Triplet(v, u, -w), Triplet(u, v, -w)})
          entries.push_back(e);
      }
    m_matrix.resize(m_mass.size(), m_mass.size());
    m_matrix.setFromTriplets(entries.begin(), entries.end());
    m_solver.setTolerance(tolerance);
    m_solver.compute(m_matrix);
  }

  // `density` is integrated already: M b.
  Vertex_field average_of_integral(const Vertex_field& density) const { return m_solver.solve(density); }
  Vertex_field average(const Vertex_field& values) const {
    return m_solver.solve(m_mass.cwiseProduct(values));
  }

private:
  static constexpr double tolerance = 1e-6; // relative; what is averaged here only guides where to cut

  static Vertex_field lumped_mass(const Approximate_surface& surface) {
    Vertex_field mass = Vertex_field::Zero(Eigen::Index(surface.points.size()));
    for (Facet_index f : surface.adjacency.facets())
      for (Vertex_index v : surface.adjacency.triangle(f)) mass[v] += surface.areas[f] / 3;
    return mass;
  }

  // of the angle at corner i; a flat triangle counts as a right-angled one
  static double cotangent(const Approximate_surface& surface, Facet_index f, int i) {
    const auto& t = surface.adjacency.triangle(f);
    const auto a = surface.points[t[(i + 1) % 3]] - surface.points[t[i]];
    const auto b = surface.points[t[(i + 2) % 3]] - surface.points[t[i]];
    return surface.areas[f] > 0 ? std::max(0., a * b / (2 * surface.areas[f])) : 0.;
  }

  Vertex_field m_mass;
  Eigen::SparseMatrix<double> m_matrix;
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> m_solver;
};

// The integral of the facets' normals over a third of each vertex's star, by coordinate.
inline std::array<Vertex_field, 3> integrated_normals(const Approximate_surface& surface) {
  std::array<Vertex_field, 3> normals;
  normals.fill(Vertex_field::Zero(Eigen::Index(surface.points.size())));
  for (Facet_index f : surface.adjacency.facets()) {
    const auto n = surface.area_vector(f) / 3;
    for (Vertex_index v : surface.adjacency.triangle(f))
      for (int k = 0; k < 3; ++k) normals[k][v] += n[k];
  }
  return normals;
}

// Distances along the surface from a set of vertices, by fast marching: R. Kimmel, J. Sethian, Computing geodesic
// paths on manifolds, PNAS 95 (1998).
class Surface_distance {
public:
  explicit Surface_distance(const Approximate_surface& surface)
      : m_surface(surface),
        m_values(Vertex_field::Constant(Eigen::Index(surface.points.size()), unreached)) {}

  Vertex_field from(const std::vector<Vertex_index>& sources) {
    return from(sources, std::vector<double>(sources.size(), 0));
  }

  // The sources count as if they lay `offsets` away.
  Vertex_field from(const std::vector<Vertex_index>& sources, const std::vector<double>& offsets) {
    for (std::size_t k = 0; k < sources.size(); ++k) improve(sources[k], offsets[k]);
    while (!m_queue.empty()) {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      if (distance <= m_values[v])
        for (Facet_index f : m_surface.adjacency.star(Vertex_index(v))) update(f);
    }
    return m_values.unaryExpr([](double d) { return d == unreached ? 0. : d; });
  }

private:
  static constexpr double unreached = std::numeric_limits<double>::max();
  using Entry = std::pair<double, std::uint32_t>;

  void improve(Vertex_index v, double distance) {
    if (!(distance < m_values[v])) return;
    m_values[v] = distance;
    m_queue.push({distance, v});
  }

  void update(Facet_index f) {
    const auto& t = m_surface.adjacency.triangle(f);
    for (int i = 0; i < 3; ++i) improve(t[i], distance_across(t[(i + 1) % 3], t[(i + 2) % 3], t[i]));
  }

  // The least distance at c over the points of edge ab, between whose ends the distance is linear.
  double distance_across(Vertex_index a, Vertex_index b, Vertex_index c) const {
    const double at_a = m_values[a], at_b = m_values[b];
    const auto& p = m_surface.points;
    const auto edge = p[b] - p[a], side = p[c] - p[a];
    const double along_a = length(side), along_b = length(p[c] - p[b]);
    const double by_ends = std::min(at_a == unreached ? unreached : at_a + along_a,
                                    at_b == unreached ? unreached : at_b + along_b);
    const double l = length(edge), slope = (at_b - at_a) / l;
    if (at_a == unreached || at_b == unreached || !(std::abs(slope) < 1)) return by_ends;
    const double x = side * edge / l, height = std::sqrt(std::max(0., along_a * along_a - x * x));
    const double y = x - height * slope / std::sqrt(1 - slope * slope);
    return y > 0 && y < l ? std::min(by_ends, at_a + slope * y + std::hypot(x - y, height)) : by_ends;
  }

  static double length(const Double_kernel::Vector_3& v) { return std::sqrt(v.squared_length()); }

  const Approximate_surface& m_surface;
  Vertex_field m_values;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> m_queue;
};

} // namespace internal

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_SURFACE_FIELDS_H
