// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_OPTIMIZE_HEXAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_OPTIMIZE_HEXAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Carriers_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <cstdio>
#include <cstdlib>
static double env(const char* n, double d) { const char* s = std::getenv(n); return s ? std::atof(s) : d; }

namespace CGAL {
namespace Volume_mesh_parameterization {

struct Hexahedra_optimization {
  int most_sweeps = 100;
  double target = 0.3;
};

namespace internal {

class Hexahedra_optimizer {
  using Cube = Reference_hexahedron;
  using Hexahedron = std::array<std::size_t, 8>;
  using Vector = Eigen::Vector3d;
  using Kernel = Exact_predicates_inexact_constructions_kernel;

public:
  Hexahedra_optimizer(std::vector<Vector> points, const std::vector<Hexahedron>& hexahedra,
                      const std::vector<Carriers_3::Handle>& carriers)
      : m_points(std::move(points)), m_hexahedra(hexahedra), m_carriers(carriers),
        m_stars(m_points.size(), hexahedra.size(), [&](std::size_t h) { return hexahedra[h]; }) {
    for (std::size_t h = 0; h < hexahedra.size(); ++h) m_rest.push_back(axis_lengths(hexahedra[h]));
  }

  void run(int most_sweeps) {
    T = env("T", 1); L = env("L", .2); C = env("C", 0);
    for (int i = 0; i < env("S", 0); ++i) { smooth(); if (env("V", 0)) std::printf("smooth %d least %g\n", i, least()); }
    rest();
    const double p1 = env("P1", 1), p2 = env("P2", 4), g = env("G", 2), tol = env("TOL", 1e-3);
    m_epsilon = (std::max)(1e-3, -2 * least());
    int k = 0;
    for (double p = p1; p <= p2 * g * .99 + env("PF", 0); p *= g) {
      if (p > p2 * 1.01) { if (env("PF", 0) == 0) break; p = 1e9; T = env("TF", .2); C = 0; L = env("LF", .1); }
      m_power = p == 1e9 ? env("PF", 8) : p;
      double old = std::numeric_limits<double>::infinity();
      for (; k < most_sweeps; ++k) {
        for (std::size_t v = 0; v < m_points.size(); ++v) improve(k % 2 ? m_points.size() - 1 - v : v);
        const double e = total(), l = least();
        int inv = 0; double mean = 0;
        for (auto& h : m_hexahedra) { inv += is_inverted(h); mean += hex_least(h); }
        if (env("V", 0)) std::printf("p %g sweep %d energy %g eps %g least %g mean %g inv %d\n", p, k, e, m_epsilon, l, mean / m_hexahedra.size(), inv);
        if (l > 0 && old - e < tol * old) break;
        const double s = (std::max)(.1, 1 - e / old);
        const double r = std::sqrt(l * l + m_epsilon * m_epsilon);
        if (l < 0) m_epsilon *= 1 - s * r / (std::abs(l) + r); else m_epsilon *= 1 - s;
        m_epsilon = (std::max)(m_epsilon, env("EM", 1e-2));
        old = total();
      }
    }
  }

  const std::vector<Vector>& points() const { return m_points; }

private:
  double T, L, C;
  std::array<double, 3> axis_lengths(const Hexahedron& h) const {
    std::array<double, 3> l;
    for (int a = 0; a < 3; ++a) { l[a] = 0; for (auto& e : Cube::axis_edges[a]) l[a] += (m_points[h[e[1]]] - m_points[h[e[0]]]).norm() / 4; }
    return l;
  }
  static int axis(int c, int k) { int d = c ^ Cube::neighbors[c][k]; (void)d; int n = Cube::neighbors[c][k]; 
    if ((c < 4) != (n < 4)) return 2; int x = (c % 4) + (n % 4); return x == 1 || x == 5 ? 0 : 1; }

  void rest() {
    m_rest.clear(); for (auto& h : m_hexahedra) m_rest.push_back(axis_lengths(h));
    const double mode = env("R", 1);
    if (mode == 0) return;
    // neighbours through parallel edges
    std::vector<std::pair<std::array<std::size_t, 2>, std::size_t>> edges;
    for (std::size_t h = 0; h < m_hexahedra.size(); ++h) for (int a = 0; a < 3; ++a) for (auto& e : Cube::axis_edges[a]) {
      auto x = m_hexahedra[h][e[0]], y = m_hexahedra[h][e[1]]; edges.push_back({{(std::min)(x, y), (std::max)(x, y)}, 3 * h + a}); }
    std::sort(edges.begin(), edges.end());
    for (int it = 0; it < mode; ++it) {
      std::vector<double> sum(3 * m_hexahedra.size()), n(sum.size());
      for (std::size_t k = 0, end; k < edges.size(); k = end) {
        double s = 0, c = 0;
        for (end = k; end < edges.size() && edges[end].first == edges[k].first; ++end) { s += m_rest[edges[end].second / 3][edges[end].second % 3]; c += 1; }
        for (std::size_t j = k; j < end; ++j) { sum[edges[j].second] += s; n[edges[j].second] += c; }
      }
      for (std::size_t i = 0; i < sum.size(); ++i) m_rest[i / 3][i % 3] = sum[i] / n[i];
    }
  }
  void smooth() {
    for (std::size_t v = 0; v < m_points.size(); ++v) {
      Vector sum = Vector::Zero(); double n = 0;
      for (std::size_t h : m_stars[v]) {
        const auto& x = m_hexahedra[h];
        const int i = int(std::find(x.begin(), x.end(), v) - x.begin());
        for (int k : Cube::neighbors[i]) sum += m_points[x[k]], n += 1;
      }
      m_points[v] = Carriers_3::project(m_carriers[v], sum / n).point;
    }
  }
  double smooth_sign(double d) const { return (d + std::sqrt(d * d + m_epsilon * m_epsilon)) / 2; }

  struct Corner { Eigen::Matrix3d e; std::array<double, 3> a; };
  Corner corner(std::size_t h, int c) const {
    const auto& x = m_hexahedra[h];
    Corner r;
    for (int k = 0; k < 3; ++k) {
      r.e.col(k) = m_points[x[Cube::neighbors[c][k]]] - m_points[x[c]];
      double l = r.e.col(k).norm(), l0 = m_rest[h][axis(c, k)];
      r.a[k] = std::pow(l0, T) * std::pow((std::max)(l, 1e-3 * l0), 1 - T);
    }
    return r;
  }
  double value(std::size_t h, int c, const std::array<double, 3>& a) const {
    const auto& x = m_hexahedra[h];
    Eigen::Matrix3d e;
    for (int k = 0; k < 3; ++k) e.col(k) = (m_points[x[Cube::neighbors[c][k]]] - m_points[x[c]]) / a[k];
    const double d = e.determinant(), X = smooth_sign(d);
    return std::pow((1 - L) * e.squaredNorm() / 3 / std::cbrt(X * X) + L * (d * d + 1) / 2 / X + C * (1 / e.col(0).squaredNorm() + 1 / e.col(1).squaredNorm() + 1 / e.col(2).squaredNorm() + e.squaredNorm()) / 6, m_power);
  }
  double total() const {
    double s = 0;
    for (std::size_t h = 0; h < m_hexahedra.size(); ++h)
      for (int c = 0; c < 8; ++c) s += value(h, c, corner(h, c).a);
    return s;
  }
  double hex_least(const Hexahedron& x) const {
    double s = 1;
      for (int c = 0; c < 8; ++c) {
        Eigen::Matrix3d e;
        for (int k = 0; k < 3; ++k) e.col(k) = (m_points[x[Cube::neighbors[c][k]]] - m_points[x[c]]).normalized();
        s = (std::min)(s, e.determinant());
      }
    return s;
  }
  double least() const {
    double s = 1;
    for (auto& x : m_hexahedra) s = (std::min)(s, hex_least(x));
    return s;
  }
  bool is_inverted(const Hexahedron& x) const {
    auto p = [&](int i) { const Vector& v = m_points[x[i]]; return Kernel::Point_3(v[0], v[1], v[2]); };
    for (int i = 0; i < 8; ++i) {
      const int* n = Cube::neighbors[i];
      if (CGAL::orientation(p(i), p(n[0]), p(n[1]), p(n[2])) != POSITIVE) return true;
    }
    return false;
  }

  void improve(std::size_t v) {
    struct Ref { std::size_t h; int c; std::array<double, 3> a; };
    std::vector<Ref> refs;
    Vector g = Vector::Zero(); Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
    double old = 0; int inv = 0;
    for (std::size_t h : m_stars[v]) {
      const auto& x = m_hexahedra[h];
      inv += is_inverted(x);
      const int i = int(std::find(x.begin(), x.end(), v) - x.begin());
      for (int j = -1; j < 3; ++j) {
        const int c = j < 0 ? i : Cube::neighbors[i][j];
        Corner k = corner(h, c);
        refs.push_back({h, c, k.a});
        Eigen::Matrix3d J; std::array<double, 3> w{};
        for (int m = 0; m < 3; ++m) {
          J.col(m) = k.e.col(m) / k.a[m];
          w[m] = j < 0 ? -1 / k.a[m] : Cube::neighbors[c][m] == i ? 1 / k.a[m] : 0;
        }
        const double d = J.determinant(), q = J.squaredNorm() / 3, r = std::sqrt(d * d + m_epsilon * m_epsilon);
        const double X = (d + r) / 2, X1 = X / r, X2 = m_epsilon * m_epsilon / (2 * r * r * r);
        double cc = 0; Vector dc = Vector::Zero(); Eigen::Matrix3d Hc = Eigen::Matrix3d::Zero();
        Vector dd = Vector::Zero(), dq = Vector::Zero(); double hq = 0;
        for (int m = 0; m < 3; ++m) {
          dd += w[m] * J.col((m + 1) % 3).cross(J.col((m + 2) % 3));
          const double j2 = J.col(m).squaredNorm();
          cc += C / 6 * (j2 + 1 / j2); dc += C / 3 * w[m] * (1 - 1 / (j2 * j2)) * J.col(m);
          Hc += C / 3 * w[m] * w[m] * ((1 - 1 / (j2 * j2)) * Eigen::Matrix3d::Identity() + 4 / (j2 * j2 * j2) * J.col(m) * J.col(m).transpose());
          dq += 2. / 3 * w[m] * J.col(m); hq += 2. / 3 * w[m] * w[m];
        }
        const double X23 = 1 / std::cbrt(X * X);
        const double f = (1 - L) * q * X23 + L * (d * d + 1) / 2 / X + cc;
        const double fq = (1 - L) * X23, fqd = -2. / 3 * (1 - L) * X23 * X1 / X;
        const double fd = q * fqd + L * (d / X - (d * d + 1) * X1 / (2 * X * X));
        const double fdd = (1 - L) * q * X23 * (10. / 9 * X1 * X1 / (X * X) - 2. / 3 * X2 / X) + L * (1 / X - 2 * d * X1 / (X * X) + (d * d + 1) * (X1 * X1 / (X * X * X) - X2 / (2 * X * X)));
        const double F = std::pow(f, m_power), F1 = m_power * F / f, F2 = (m_power - 1) * F1 / f;
        const Vector df = fq * dq + fd * dd + dc;
        g += F1 * df;
        H += F1 * (Hc + fq * hq * Eigen::Matrix3d::Identity() + fqd * (dq * dd.transpose() + dd * dq.transpose()) + fdd * dd * dd.transpose()) + F2 * df * df.transpose();
        old += F;
      }
    }
    const Vector here = m_points[v];
    const Foot_point foot = Carriers_3::project(m_carriers[v], here);
    const auto& B = foot.directions;
    const Eigen::MatrixXd HH = B.transpose() * H * B;
    const Eigen::VectorXd gg = B.transpose() * g;
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> es(HH);
    Eigen::VectorXd ev = es.eigenvalues().cwiseAbs().cwiseMax(1e-6 * es.eigenvalues().cwiseAbs().maxCoeff());
    const Vector step = -B * (es.eigenvectors() * (es.eigenvectors().transpose() * gg).cwiseQuotient(ev));
    double t = 1;
    for (int k = 0; k < 6; ++k, t /= 2) {
      m_points[v] = Carriers_3::project(m_carriers[v], here + t * step).point;
      double now = 0;
      for (auto& r : refs) now += value(r.h, r.c, r.a);
      if (!(now < old)) continue;
      int ninv = 0;
      for (std::size_t h : m_stars[v]) ninv += is_inverted(m_hexahedra[h]);
      if (ninv <= inv) return;
    }
    m_points[v] = here;
  }

  std::vector<Vector> m_points;
  const std::vector<Hexahedron>& m_hexahedra;
  const std::vector<Carriers_3::Handle>& m_carriers;
  Incidence_lists<std::size_t, std::size_t> m_stars;
  std::vector<std::array<double, 3>> m_rest;
  double m_epsilon = 1e-3, m_power = 1;
};

} // namespace internal

template <typename GeomTraits, typename Point>
Status optimize_hexahedra(const Compact_tetrahedral_mesh_3<GeomTraits>& object, Hexahedron_soup_3<Point>& hexahedra,
                          const Hexahedra_optimization& options = {}) {
  internal::Carriers_3 carriers;
  Status status = carriers.build(object);
  if (!status.ok()) return status;
  std::vector<internal::Carriers_3::Handle> h(hexahedra.points.size());
  std::vector<std::pair<int, int>> labels(hexahedra.points.size(), {1000000, -1});
  for (auto& f : hexahedra.facets) for (auto v : f.vertices) { labels[v].first = (std::min)(labels[v].first, f.label); labels[v].second = (std::max)(labels[v].second, f.label); }
  for (std::size_t v = 0; v < h.size(); ++v) if (labels[v].second >= 0 && !carriers.find(labels[v], h[v])) return {ERROR_WRONG_PARAMETER, "node"};
  std::vector<Eigen::Vector3d> points;
  for (auto& p : hexahedra.points) points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  internal::Hexahedra_optimizer o(points, hexahedra.hexahedra, h);
  o.run(options.most_sweeps);
  for (std::size_t v = 0; v < h.size(); ++v) hexahedra.points[v] = Point(o.points()[v][0], o.points()[v][1], o.points()[v][2]);
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_OPTIMIZE_HEXAHEDRA_H
