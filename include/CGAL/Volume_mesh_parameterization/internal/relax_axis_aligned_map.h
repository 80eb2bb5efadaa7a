// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RELAX_AXIS_ALIGNED_MAP_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RELAX_AXIS_ALIGNED_MAP_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/internal/Axis_aligned_map.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// Until it gets slower is enough to compare maps, roughly for what is relaxed again. To the minimum, so that the result
// depends less on how vertices are numbered.
enum Relaxation { WHILE_FAST, ROUGHLY, TO_MINIMUM };

/*
Lessens the symmetric Dirichlet energy of an axis-aligned map of a surface (the area integral of |J|^2 + |J^-1|^2, infinite
where a triangle turns over) by Newton's method with the Hessian made positive as in B. Smith, F. de Goes, T. Kim,
Analytic eigensystems for isotropic distortion energies, 2019.

The unknowns are the positions of the planes that are not fixed and the coordinates in which vertices may slide.
*/
class Axis_aligned_relaxation {
public:
  using Triangle = Axis_aligned_map::Triangle;
  using Point_3 = Axis_aligned_map::Point_3;

  Axis_aligned_relaxation(const std::vector<Triangle>& triangles, const std::vector<Point_3>& points,
                          Axis_aligned_map& map)
      : m_triangles(triangles), m_map(map) {
    number_places();
    for (const Triangle& t : triangles) m_rest_shapes.push_back(rest_shape(t, points));
  }

  // Returns the energy over the area: 4 for an isometry.
  double run(Relaxation goal) {
    constexpr int most_steps = 150;                          // about 15 are usual
    const double little = goal == WHILE_FAST ? .02 : .005;   // of the energy
    const int most_idle_steps = goal == TO_MINIMUM ? 20 : 1; // up to 10 are usual near a minimum
    int idle_steps = 0;
    Eigen::VectorXd x = m_start;
    double value = energy(x);
    if (!std::isfinite(value)) return value;
    for (int i = 0; i < most_steps && idle_steps <= most_idle_steps; ++i) {
      const double before = value;
      if (!step(value, x)) break;
      const bool is_idle = goal == TO_MINIMUM ? m_is_near : value > (1 - little) * before;
      idle_steps = is_idle ? idle_steps + 1 : 0;
    }
    write_back(x);
    return value / total_area();
  }

private:
  static constexpr Eigen::Index no_place = -1;
  static constexpr double at_rounding = 1e-14; // differences of the energy, relative, that tell nothing
  enum Hessian_type { TRUE_HESSIAN, POSITIVE_HESSIAN, SECANT_HESSIAN };

  // A triangle at rest: its area, and the gradients of its barycentric coordinates.
  struct Rest_shape {
    double area;
    Eigen::Matrix<double, 3, 2> gradients;
  };

  // Places in the vector of coordinates: first the unknowns, then what is fixed.
  void number_places() {
    std::vector<double> values;
    m_place_of_plane.resize(m_map.planes.size());
    const auto place_planes = [&](bool fixed) {
      for (std::size_t p = 0; p < m_map.planes.size(); ++p)
        if (m_map.planes[p].is_fixed == fixed) {
          m_place_of_plane[p] = Eigen::Index(values.size());
          values.push_back(m_map.planes[p].value);
        }
    };
    place_planes(false);
    place_free_coordinates(values);
    m_number_of_unknowns = Eigen::Index(values.size());
    place_planes(true);
    for (std::size_t v = 0; v < m_places.size(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (m_map.vertex_planes[v][axis] != Axis_aligned_map::no_plane)
          m_places[v][axis] = m_place_of_plane[m_map.vertex_planes[v][axis]];
    m_start = Eigen::Map<const Eigen::VectorXd>(values.data(), Eigen::Index(values.size()));
  }

  // Those of vertices of the surface.
  void place_free_coordinates(std::vector<double>& values) {
    m_places.assign(m_map.images.size(), {no_place, no_place, no_place});
    for (const Triangle& t : m_triangles)
      for (std::uint32_t v : t)
        for (int axis = 0; axis < 3; ++axis)
          if (m_places[v][axis] == no_place && m_map.vertex_planes[v][axis] == Axis_aligned_map::no_plane) {
            m_places[v][axis] = Eigen::Index(values.size());
            values.push_back(m_map.images[v][axis]);
          }
  }

  void write_back(const Eigen::VectorXd& x) {
    for (std::size_t p = 0; p < m_map.planes.size(); ++p) m_map.planes[p].value = x[m_place_of_plane[p]];
    for (const Triangle& t : m_triangles)
      for (std::uint32_t v : t)
        m_map.images[v] = Point_3(x[m_places[v][0]], x[m_places[v][1]], x[m_places[v][2]]);
  }

  static Rest_shape rest_shape(const Triangle& t, const std::vector<Point_3>& p) {
    // a needle is taken for a thicker one: it weighs little, and would only spoil the condition of the matrix
    constexpr double least_height = 1e-3;
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

  double total_area() const {
    double area = 0;
    for (const Rest_shape& r : m_rest_shapes) area += r.area;
    return area;
  }

  // Coordinate k % 2 of corner k / 2, in the frame of the triangle.
  Eigen::Index place(std::size_t t, int k) const {
    const Plane_frame frame = m_map.frames[t];
    return m_places[m_triangles[t][k / 2]][k % 2 == 0 ? frame.first : frame.second];
  }

  Eigen::Matrix<double, 2, 3> corners(std::size_t t, const Eigen::VectorXd& x) const {
    Eigen::Matrix<double, 2, 3> result;
    for (int k = 0; k < 6; ++k) result(k % 2, k / 2) = x[place(t, k)];
    return result;
  }

  Eigen::Matrix2d jacobian(std::size_t t, const Eigen::VectorXd& x) const {
    return corners(t, x) * m_rest_shapes[t].gradients;
  }

  double energy(const Eigen::VectorXd& x) const {
    double sum = 0;
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
    constexpr double near = 1e-3;                       // the energy to gain, relative
    constexpr double least_gain = .2, far_energy = 100; // with less gain, the other Hessian is tried next
    Eigen::VectorXd gradient, direction;
    // the true Hessian converges quadratically, but only near the minimum it is sure to be positive
    const bool has_direction =
        (m_is_near && find_direction(TRUE_HESSIAN, x, gradient, direction)) ||
        find_direction(m_is_far ? SECANT_HESSIAN : POSITIVE_HESSIAN, x, gradient, direction);
    if (!has_direction) return false;
    const double slope = gradient.dot(direction), before = value;
    m_is_near = -slope < near * value;
    const bool has_descended = descend(direction, slope, value, x), was_far = m_is_far;
    if (value > (1 - least_gain) * before) m_is_far = !m_is_far && value > far_energy * total_area();
    return (has_descended || was_far) && -slope > at_rounding * value;
  }

  // The minimum of the quadratic model; false if the model has none.
  bool find_direction(Hessian_type type, const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                      Eigen::VectorXd& direction) {
    const Eigen::Index n = m_number_of_unknowns;
    gradient = Eigen::VectorXd::Zero(x.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(21 * m_rest_shapes.size());
    for (std::size_t t = 0; t < m_rest_shapes.size(); ++t) add_triangle(t, type, x, gradient, entries);
    gradient.tail(x.size() - n).setZero();
    Eigen::SparseMatrix<double> hessian(n, n);
    hessian.setFromTriplets(entries.begin(), entries.end());
    if (!m_is_analyzed) m_solver.analyzePattern(hessian);
    m_is_analyzed = true;
    m_solver.factorize(hessian);
    if (m_solver.info() != Eigen::Success) return false;
    if (type == TRUE_HESSIAN && !(m_solver.vectorD().minCoeff() > 0)) return false;
    direction = Eigen::VectorXd::Zero(x.size());
    direction.head(n) = m_solver.solve(-gradient.head(n));
    return true;
  }

  // Moves x by at most the whole direction, and less than what flattens a triangle, to sufficiently less energy.
  bool descend(const Eigen::VectorXd& direction, double slope, double& value, Eigen::VectorXd& x) const {
    constexpr double sufficient = 1e-4, least_step = 1e-10, share_of_room = 0.9;
    const double room = slope < 0 ? share_of_room * room_along(direction, x) : 0;
    for (double s = (std::min)(1., room); s > least_step; s /= 2) {
      const Eigen::VectorXd y = x + s * direction;
      const double e = energy(y);
      if (!(e <= value + sufficient * s * slope + at_rounding * value)) continue;
      x = y;
      value = e;
      return true;
    }
    return false;
  }

  // The first step at which a triangle is flat: the least positive root of quadratic polynomials.
  double room_along(const Eigen::VectorXd& direction, const Eigen::VectorXd& x) const {
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < m_triangles.size(); ++t) {
      const Eigen::Matrix2d a = edges(corners(t, x)), d = edges(corners(t, direction));
      const double c = a.determinant(), q = d.determinant();
      const double b = a(0, 0) * d(1, 1) + d(0, 0) * a(1, 1) - a(0, 1) * d(1, 0) - d(0, 1) * a(1, 0);
      const double discriminant = b * b - 4 * q * c;
      if (discriminant < 0 || (b >= 0 && q >= 0)) continue;
      const double root = 2 * c / (-b + std::sqrt(discriminant)); // stable, for q = 0 too
      if (root > 0) room = (std::min)(room, root);
    }
    return room;
  }

  static Eigen::Matrix2d edges(const Eigen::Matrix<double, 2, 3>& c) {
    return c.rightCols<2>() - c.col(0).rowwise().replicate<2>();
  }

  // The second derivative of f(s) = s^2 + s^-2. Where that is steep, it lets s grow by a third only; the slope of the
  // secant of f' to the minimum at 1 points there at once, as in M. Rabinovich et al., Scalable locally injective mappings,
  // 2017.
  static double stretch_stiffness(Hessian_type type, double s) {
    return type == SECANT_HESSIAN && s < 1 ? 2 * (1 + s) * (1 + s * s) / (s * s * s)
                                           : 2 + 6 / (s * s * s * s);
  }

  // With J = U diag(a, b) V^T, the eigenvectors of the Hessian are two stretches, a turn and a shear.
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
    const std::array<double, 4> values = {stretch_stiffness(type, a), stretch_stiffness(type, b),
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

  void add_gradient(std::size_t t, const Eigen::Matrix<double, 2, 3>& g, Eigen::VectorXd& gradient) const {
    for (int k = 0; k < 6; ++k) gradient[place(t, k)] += g(k % 2, k / 2);
  }

  // The lower half, which is all that the solver reads.
  void add_hessian(std::size_t t, const Eigen::Matrix<double, 6, 6>& h,
                   std::vector<Eigen::Triplet<double>>& entries) const {
    for (int k = 0; k < 6; ++k)
      for (int l = 0; l < 6; ++l) {
        const Eigen::Index row = place(t, k), column = place(t, l);
        if (row < m_number_of_unknowns && column <= row) entries.emplace_back(int(row), int(column), h(k, l));
      }
  }

  const std::vector<Triangle>& m_triangles;
  Axis_aligned_map& m_map;
  std::vector<std::array<Eigen::Index, 3>> m_places; // of the coordinates of vertices
  std::vector<Eigen::Index> m_place_of_plane;
  Eigen::Index m_number_of_unknowns = 0;
  Eigen::VectorXd m_start;
  std::vector<Rest_shape> m_rest_shapes;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_solver;
  bool m_is_analyzed = false, m_is_near = false, m_is_far = true;
};

// Returns the energy over the area. The map stays one to one; where it was not, nothing is changed.
inline double relax_axis_aligned_map(Relaxation goal,
                                     const std::vector<Axis_aligned_map::Triangle>& triangles,
                                     const std::vector<Axis_aligned_map::Point_3>& points,
                                     Axis_aligned_map& map) {
  return Axis_aligned_relaxation(triangles, points, map).run(goal);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_RELAX_AXIS_ALIGNED_MAP_H
