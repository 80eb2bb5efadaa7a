// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RELAX_PLANAR_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RELAX_PLANAR_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_rim.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// How far to go: until little is to be gained, or to the minimum up to rounding. The minimum does not depend on how the
// vertices are numbered.
enum Relaxation { ROUGHLY, TO_MINIMUM };

/*
Lessens the symmetric Dirichlet energy of a planar map of the floor (the area integral of |J|^2 + |J^-1|^2, infinite
where a triangle turns over) by Newton's method with the Hessian made positive as in B. Smith, F. de Goes, T. Kim,
Analytic eigensystems for isotropic distortion energies, 2019.

The vertices of a side share one unknown, the coordinate of its line; in the other coordinate they slide. Sides of holes
that are on the same line stay so. Springs with the same energy keep the holes in a row.
*/
class Planar_map_relaxation {
public:
  using Id = Refined_surface::Id;
  using Point_2 = Double_kernel::Point_2;

  Planar_map_relaxation(const Refined_surface& surface, const std::vector<Floor_rim>& rims,
                        const std::vector<Rectangle_2>& rectangles, const std::vector<Point_2>& images)
      : m_surface(surface), m_unknowns(surface.number_of_vertices(), {unset, unset}) {
    for (std::size_t r = 0; r < rims.size(); ++r) add_planes(rims[r], rectangles[r]);
    for (std::size_t r = 2; r < rims.size(); ++r)
      add_spring(m_planes[r - 1][2], m_planes[r][0], rectangles[0].height());
    add_vertices(images);
    for (const auto& t : surface.triangles()) m_rest_shapes.push_back(rest_shape(t));
  }

  void run(Relaxation goal) {
    constexpr int most_steps = 150; // about 15 are usual
    const int most_near_steps = goal == ROUGHLY ? 0 : 20; // up to 10 are usual
    int near_steps = 0;
    Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(m_values.data(), Eigen::Index(m_values.size()));
    double value = energy(x);
    for (int i = 0; i < most_steps && near_steps <= most_near_steps && step(value, x); ++i)
      near_steps += m_is_near;
    Eigen::Map<Eigen::VectorXd>(m_values.data(), x.size()) = x;
  }

  Point_2 image(Id v) const { return Point_2(m_values[m_unknowns[v][0]], m_values[m_unknowns[v][1]]); }

  Rectangle_2 rectangle(std::size_t rim) const {
    const std::array<Eigen::Index, 4>& p = m_planes[rim];
    return {m_values[p[0]], m_values[p[1]], m_values[p[2]], m_values[p[3]]};
  }

private:
  static constexpr Eigen::Index unset = -1;
  static constexpr double at_rounding = 1e-14; // differences of the energy, relative, that tell nothing
  enum Hessian_type { TRUE_HESSIAN, POSITIVE_HESSIAN };

  // A triangle at rest: its area, and the gradients of its barycentric coordinates.
  struct Rest_shape {
    double area;
    Eigen::Matrix<double, 3, 2> gradients;
  };

  // Keeps two planes apart like a strip of the plane between them.
  struct Spring {
    Eigen::Index low, high;
    double rest_length, weight;

    double stretch(const Eigen::VectorXd& x) const { return (x[high] - x[low]) / rest_length; }
  };

  // The unknowns of a rim are xmin, ymin, xmax, ymax; side k lies on the line of number 1, 2, 3, 0.
  void add_planes(const Floor_rim& rim, const Rectangle_2& rectangle) {
    const std::array<double, 4> values = {rectangle.xmin, rectangle.ymin, rectangle.xmax, rectangle.ymax};
    std::array<Eigen::Index, 4> planes{};
    for (int k = 0; k < 4; ++k) planes[k] = plane(k % 2, values[k]);
    for (int k = 0; k < 4; ++k)
      for (Id v : rim.side(k)) m_unknowns[v][(k + 1) % 2] = planes[(k + 1) % 4];
    m_planes.push_back(planes);
  }

  Eigen::Index plane(int axis, double value) {
    for (const std::array<Eigen::Index, 4>& p : m_planes)
      for (int k : {axis, axis + 2})
        if (m_values[p[k]] == value) return p[k];
    m_values.push_back(value);
    return Eigen::Index(m_values.size()) - 1;
  }

  // The strip weighs little, like a part of the floor that is not there.
  void add_spring(Eigen::Index low, Eigen::Index high, double breadth) {
    constexpr double density = 0.02;
    const double length = m_values[high] - m_values[low];
    m_springs.push_back({low, high, length, density * length * breadth});
  }

  void add_vertices(const std::vector<Point_2>& images) {
    for (Id v = 0; v < images.size(); ++v)
      for (int axis = 0; axis < 2; ++axis)
        if (m_unknowns[v][axis] == unset) {
          m_unknowns[v][axis] = Eigen::Index(m_values.size());
          m_values.push_back(images[v][axis]);
        }
  }

  Rest_shape rest_shape(const Refined_surface::Triangle& t) const {
    // a needle is taken for a thicker one: it weighs little, and would only spoil the condition of the matrix
    constexpr double least_height = 1e-3;
    const auto& p = m_surface.points();
    const Double_kernel::Vector_3 a = p[t[1]] - p[t[0]], b = p[t[2]] - p[t[0]];
    const double base = (std::max)(std::sqrt(a * a), least_height * std::sqrt(b * b));
    const double foot = a * b / base, squared_height = b * b - foot * foot;
    const double height =
        std::sqrt((std::max)(squared_height, least_height * least_height * (std::max)(base * base, b * b)));
    Rest_shape rest;
    rest.area = base * height / 2;
    rest.gradients.row(1) << 1 / base, -foot / (base * height);
    rest.gradients.row(2) << 0, 1 / height;
    rest.gradients.row(0) = -rest.gradients.row(1) - rest.gradients.row(2);
    return rest;
  }

  Eigen::Matrix2d jacobian(std::size_t t, const Eigen::VectorXd& x) const {
    Eigen::Matrix<double, 2, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const auto& unknowns = m_unknowns[m_surface.triangles()[t][i]];
      corners.col(i) << x[unknowns[0]], x[unknowns[1]];
    }
    return corners * m_rest_shapes[t].gradients;
  }

  double energy(const Eigen::VectorXd& x) const {
    double sum = 0;
    for (const Spring& spring : m_springs) {
      const double a = spring.stretch(x);
      if (!(a > 0)) return std::numeric_limits<double>::infinity();
      sum += spring.weight * (a * a + 1 / (a * a));
    }
    for (std::size_t t = 0; t < m_rest_shapes.size(); ++t) {
      const Eigen::Matrix2d j = jacobian(t, x);
      const double det = j.determinant();
      if (!(det > 0)) return std::numeric_limits<double>::infinity();
      sum += m_rest_shapes[t].area * j.squaredNorm() * (1 + 1 / (det * det));
    }
    return sum;
  }

  // One Newton step; returns false at the minimum, or if there is no way down.
  bool step(double& value, Eigen::VectorXd& x) {
    constexpr double near = 1e-3; // the energy to gain, relative
    Eigen::VectorXd gradient, direction;
    // the true Hessian converges quadratically, but only near the minimum it is sure to be positive
    const bool has_direction = (m_is_near && find_direction(TRUE_HESSIAN, x, gradient, direction)) ||
                               find_direction(POSITIVE_HESSIAN, x, gradient, direction);
    if (!has_direction) return false;
    const double slope = gradient.dot(direction);
    m_is_near = -slope < near * value;
    return descend(direction, slope, value, x) && -slope > at_rounding * value;
  }

  // The minimum of the quadratic model; false if the model has none.
  bool find_direction(Hessian_type type, const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                      Eigen::VectorXd& direction) {
    gradient = Eigen::VectorXd::Zero(x.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t t = 0; t < m_rest_shapes.size(); ++t) add_triangle(t, type, x, gradient, entries);
    for (const Spring& spring : m_springs) add_spring_forces(spring, x, gradient, entries);
    for (Eigen::Index fixed : {0, 1}) fix(fixed, gradient, entries); // a map may be shifted
    Eigen::SparseMatrix<double> hessian(x.size(), x.size());
    hessian.setFromTriplets(entries.begin(), entries.end());
    if (!m_is_analyzed) m_solver.analyzePattern(hessian);
    m_is_analyzed = true;
    m_solver.factorize(hessian);
    if (m_solver.info() != Eigen::Success) return false;
    if (type == TRUE_HESSIAN && !(m_solver.vectorD().minCoeff() > 0)) return false;
    direction = m_solver.solve(-gradient);
    return true;
  }

  // Moves x by at most the whole direction to a point of sufficiently less energy.
  bool descend(const Eigen::VectorXd& direction, double slope, double& value, Eigen::VectorXd& x) const {
    constexpr double sufficient = 1e-4, least_step = 1e-10;
    for (double s = 1; s > least_step && slope < 0; s /= 2) {
      const Eigen::VectorXd y = x + s * direction;
      const double e = energy(y);
      if (!(e <= value + sufficient * s * slope + at_rounding * value)) continue;
      x = y;
      value = e;
      return true;
    }
    return false;
  }

  static void fix(Eigen::Index fixed, Eigen::VectorXd& gradient,
                  std::vector<Eigen::Triplet<double>>& entries) {
    gradient[fixed] = 0;
    for (Eigen::Triplet<double>& e : entries)
      if (e.row() == fixed || e.col() == fixed)
        e = Eigen::Triplet<double>(e.row(), e.col(), e.row() == e.col() ? 1 : 0);
  }

  static void add_spring_forces(const Spring& spring, const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                                std::vector<Eigen::Triplet<double>>& entries) {
    const double a = spring.stretch(x),
                 force = spring.weight * (2 * a - 2 / (a * a * a)) / spring.rest_length;
    const double stiffness =
        spring.weight * (2 + 6 / (a * a * a * a)) / (spring.rest_length * spring.rest_length);
    const int ends[] = {int(spring.low), int(spring.high)};
    for (int k = 0; k < 2; ++k) {
      gradient[ends[k]] += k == 0 ? -force : force;
      for (int l = 0; l < 2; ++l) entries.emplace_back(ends[k], ends[l], k == l ? stiffness : -stiffness);
    }
  }

  // With J = U diag(a, b) V^T and f(s) = s^2 + s^-2, the eigenvectors of the Hessian are two stretches, a turn and a
  // shear.
  void add_triangle(std::size_t t, Hessian_type type, const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                    std::vector<Eigen::Triplet<double>>& entries) const {
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(jacobian(t, x), Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix2d u = svd.matrixU(), v = svd.matrixV().transpose();
    const double a = svd.singularValues()[0], b = svd.singularValues()[1], ab = a * b;
    const double da = 2 * a - 2 / (a * a * a), db = 2 * b - 2 / (b * b * b), r = std::sqrt(0.5);
    const double turn = (da + db) / (a + b); // the only eigenvalue that may be negative
    const std::array<Eigen::Matrix2d, 4> modes = {u.col(0) * v.row(0), u.col(1) * v.row(1),
                                                  r * (u.col(1) * v.row(0) - u.col(0) * v.row(1)),
                                                  r * (u.col(1) * v.row(0) + u.col(0) * v.row(1))};
    const std::array<double, 4> values = {2 + 6 / (a * a * a * a), 2 + 6 / (b * b * b * b),
                                          type == TRUE_HESSIAN ? turn : (std::max)(0., turn),
                                          2 + 2 * (a * a + ab + b * b) / (ab * ab * ab)};
    const Rest_shape& rest = m_rest_shapes[t];
    const Eigen::Matrix2d stress = da * modes[0] + db * modes[1];
    add_gradient(t, rest.area * stress * rest.gradients.transpose(), gradient);
    Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();
    for (int k = 0; k < 4; ++k) {
      const Eigen::Matrix<double, 2, 3> move = modes[k] * rest.gradients.transpose();
      const Eigen::Map<const Eigen::Matrix<double, 6, 1>> m(move.data());
      hessian += rest.area * values[k] * m * m.transpose();
    }
    add_hessian(t, hessian, entries);
  }

  Eigen::Index unknown(std::size_t t, int k) const {
    return m_unknowns[m_surface.triangles()[t][k / 2]][k % 2];
  }

  void add_gradient(std::size_t t, const Eigen::Matrix<double, 2, 3>& g, Eigen::VectorXd& gradient) const {
    for (int k = 0; k < 6; ++k) gradient[unknown(t, k)] += g(k % 2, k / 2);
  }

  void add_hessian(std::size_t t, const Eigen::Matrix<double, 6, 6>& h,
                   std::vector<Eigen::Triplet<double>>& entries) const {
    for (int k = 0; k < 6; ++k)
      for (int l = 0; l < 6; ++l) entries.emplace_back(int(unknown(t, k)), int(unknown(t, l)), h(k, l));
  }

  const Refined_surface& m_surface;
  std::vector<std::array<Eigen::Index, 2>> m_unknowns; // of x and y of the vertices
  std::vector<std::array<Eigen::Index, 4>> m_planes;   // of xmin, ymin, xmax, ymax of the rims
  std::vector<double> m_values;                        // of the unknowns
  std::vector<Spring> m_springs;
  std::vector<Rest_shape> m_rest_shapes;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
  bool m_is_analyzed = false, m_is_near = false;
};

// Lessens the distortion of images; the rectangles follow.
inline void relax_planar_map(Relaxation goal, const Refined_surface& surface, const std::vector<Floor_rim>& rims,
                             std::vector<Rectangle_2>& rectangles,
                             std::vector<Double_kernel::Point_2>& images) {
  Planar_map_relaxation relaxation(surface, rims, rectangles, images);
  relaxation.run(goal);
  for (Refined_surface::Id v = 0; v < images.size(); ++v) images[v] = relaxation.image(v);
  for (std::size_t r = 0; r < rectangles.size(); ++r) rectangles[r] = relaxation.rectangle(r);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RELAX_PLANAR_MAP_H
