// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_AVERAGED_GRADIENT_FIELD_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_AVERAGED_GRADIENT_FIELD_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Curve_spaces.h>
#include <CGAL/Volume_mesh_parameterization/internal/Runge_kutta_tracer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationFields

is a curve traced through an `Averaged_gradient_field_3`, and where it ended.
*/
struct Averaged_gradient_curve_3 {
  using Point_3 = Simple_cartesian<double>::Point_3; ///< a point of doubles

  /// tells how a curve ends.
  enum End {
    ARRIVED,           ///< at the base that was asked for
    LEFT_THROUGH_WALL, ///< or through the other base
    STUCK              ///< it did not end
  };

  End end = STUCK;   ///< where it ended
  Facet_index facet; ///< boundary facet of the end; invalid if stuck
  std::array<double, 3> weights = {0, 0,
                                   0}; ///< of the end in `facet`, in the order of `mesh.vertices(facet)`
  Point_3 point;                       ///< the end
  double length = 0;                   ///< its length
  std::vector<Point_3> polyline; ///< all steps, if asked for
};

/*!
\ingroup PkgVolumeMeshParameterizationFields

is the field of Xia et al. 2010, steps 3 to 5: gradients of the harmonic function averaged to the vertices (all cells
of a vertex count the same), interpolated linearly and followed by the method of Runge and Kutta with a step in
proportion to the size of the cell; on walls the same with the surface gradients of the wall facets.

Curves of this field may leave through a wall or never end, and finer meshes do not help: it is the baseline to
compare with, see `Product_structure_3` and `Flux_field_3` for better ones.

\tparam Mesh a `Compact_tetrahedral_mesh_3`; it must outlive the field
*/
template <typename Mesh>
class Averaged_gradient_field_3 {
public:
  using Vector_3 = Simple_cartesian<double>::Vector_3; ///< a vector of doubles
  using Curve = Averaged_gradient_curve_3;             ///< a curve that is integrated numerically

  /// counts how curves ended.
  struct Arrivals {
    std::size_t arrived = 0;           ///< curves that reached the floor or the ceiling
    std::size_t left_through_wall = 0; ///< curves that left the solid elsewhere
    std::size_t stuck = 0;             ///< curves that went nowhere
    /// returns the share that arrived.
    double share() const {
      const std::size_t all = arrived + left_through_wall + stuck;
      return all == 0 ? 1 : double(arrived) / double(all);
    }
  };

  /// \param mesh a mesh with a labelled boundary; it must outlive the field
  /// \param values the values of the harmonic function at the vertices: see `Harmonic_function_3::values()`
  /// \param relative_step the length of a step, relative to the edge length of a regular simplex of the same size
  /// \param maximal_number_of_steps after so many steps a curve counts as stuck
  /// \pre all cells are positive in double, as they are when `Harmonic_function_3::solve()` succeeded
  Averaged_gradient_field_3(const Mesh& mesh, const std::vector<double>& values, double relative_step = 0.25,
                            std::size_t maximal_number_of_steps = 20000)
      : m_volume(mesh),
        m_walls(mesh),
        m_gradients(average_gradients(m_volume, values)),
        m_wall_gradients(average_gradients(m_walls, values)),
        m_patches(mesh.number_of_vertices(), 0),
        m_relative_step(relative_step),
        m_maximal_number_of_steps(maximal_number_of_steps) {
    for (Facet_index f : mesh.boundary_facets())
      for (Vertex_index v : mesh.vertices(f)) m_patches[v] |= patch(mesh.label(f));
  }

  /// returns the averaged gradient at `v`.
  const Vector_3& vector(Vertex_index v) const { return m_gradients[v]; }
  /// returns the averaged surface gradient at a vertex of a wall.
  const Vector_3& wall_vector(Vertex_index v) const { return m_wall_gradients[v]; }

  /// follows the field from a vertex, on the wall if it lies there.
  /// \param v the vertex
  /// \param base `FLOOR` or `CEILING`: where to go
  /// \param with_polyline whether to keep all steps
  Curve trace(Vertex_index v, int base, bool with_polyline = false) const {
    if (m_patches[v] & patch(base)) return end_at(v, base);
    if (m_patches[v] & ON_WALL) {
      const Wall_tracer tracer(m_walls, m_wall_gradients, sign(base));
      return trace(m_walls, tracer, tracer.place(v), base, with_polyline);
    }
    const Volume_tracer tracer(m_volume, m_gradients, sign(base));
    return trace(m_volume, tracer, tracer.place(v), base, with_polyline);
  }

  /// follows the field from the point with these barycentric coordinates in `c`.
  Curve trace(Cell_index c, const std::array<double, 4>& weights, int base,
              bool with_polyline = false) const {
    const Volume_tracer tracer(m_volume, m_gradients, sign(base));
    return trace(m_volume, tracer, {c, weights}, base, with_polyline);
  }

  /// traces from all interior vertices.
  Arrivals arrivals(int base) const { return count(base, 0); }
  /// traces from all vertices of walls that lie on no base.
  Arrivals arrivals_on_walls(int base) const { return count(base, ON_WALL); }

private:
  using Volume_space = internal::Volume_space<Mesh>;
  using Wall_space = internal::Wall_space<Mesh>;
  using Volume_tracer = internal::Runge_kutta_tracer<Volume_space>;
  using Wall_tracer = internal::Runge_kutta_tracer<Wall_space>;

  enum Patch : unsigned char { ON_FLOOR = 1, ON_CEILING = 2, ON_WALL = 4, UNLABELLED = 8 };
  static Patch patch(int label) {
    return label == FLOOR        ? ON_FLOOR
           : label == CEILING    ? ON_CEILING
           : label >= FIRST_WALL ? ON_WALL
                                 : UNLABELLED;
  }
  static int sign(int base) { return base == FLOOR ? -1 : 1; }

  template <typename Space>
  static std::vector<Vector_3> average_gradients(const Space& space, const std::vector<double>& values) {
    std::vector<Vector_3> sums(values.size(), NULL_VECTOR);
    std::vector<int> counts(values.size(), 0);
    for (auto s : space.simplices()) {
      const auto vertices = space.vertices(s);
      const auto gradients = space.gradients(s);
      Vector_3 gradient = NULL_VECTOR;
      for (int i = 1; i < Space::corners; ++i)
        gradient += (values[vertices[i]] - values[vertices[0]]) * gradients[i];
      for (Vertex_index v : vertices) {
        sums[v] += gradient;
        ++counts[v];
      }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      if (counts[v] > 0) sums[v] = sums[v] / counts[v];
    return sums;
  }

  Curve end_at(Vertex_index v, int base) const {
    const Mesh& mesh = m_volume.mesh();
    Curve curve;
    for (Cell_index c : m_volume.star(v))
      for (int i = 0; i < 4; ++i)
        if (mesh.label(c, i) == base && mesh.vertex(c, i) != v) curve.facet = mesh.facet(c, i);
    const auto vertices = mesh.vertices(curve.facet);
    for (int i = 0; i < 3; ++i) curve.weights[i] = vertices[i] == v;
    curve.end = Curve::ARRIVED;
    curve.point = internal::approximate(mesh.point(v));
    return curve;
  }

  template <typename Space, typename Tracer>
  Curve trace(const Space& space, const Tracer& tracer, typename Tracer::Place place, int base,
              bool with_polyline) const {
    Curve curve;
    if (!place.simplex.is_valid()) return curve;
    curve.point = tracer.point(place);
    if (with_polyline) curve.polyline.push_back(curve.point);
    typename Tracer::Outcome outcome = Tracer::INSIDE;
    int side = 0;
    for (std::size_t k = 0; k < m_maximal_number_of_steps && outcome == Tracer::INSIDE; ++k) {
      outcome = tracer.advance(place, m_relative_step * space.size(place.simplex), side);
      const auto point = tracer.point(place);
      curve.length += std::sqrt((point - curve.point).squared_length());
      curve.point = point;
      if (with_polyline) curve.polyline.push_back(point);
    }
    if (outcome == Tracer::AT_BORDER) end_at_border(space, place, side, base, curve);
    return curve;
  }

  template <typename Space, typename Place>
  void end_at_border(const Space& space, const Place& place, int side, int base, Curve& curve) const {
    const Mesh& mesh = m_volume.mesh();
    curve.facet = space.border(place.simplex, side);
    curve.end = mesh.label(curve.facet) == base ? Curve::ARRIVED : Curve::LEFT_THROUGH_WALL;
    const auto from = space.vertices(place.simplex);
    const auto to = mesh.vertices(curve.facet);
    for (int j = 0; j < 3; ++j) {
      const auto i = std::find(from.begin(), from.end(), to[j]) - from.begin();
      curve.weights[j] = i < Space::corners ? place.weights[i] : 0;
    }
  }

  Arrivals count(int base, unsigned patches) const {
    Arrivals result;
    for (Vertex_index v : m_volume.mesh().vertices()) {
      if (m_patches[v] != patches) continue;
      const auto end = trace(v, base).end;
      ++(end == Curve::ARRIVED ? result.arrived
         : end == Curve::STUCK ? result.stuck
                               : result.left_through_wall);
    }
    return result;
  }

  Volume_space m_volume;
  Wall_space m_walls;
  std::vector<Vector_3> m_gradients;
  std::vector<Vector_3> m_wall_gradients;
  std::vector<unsigned char> m_patches; // of the vertices
  double m_relative_step;
  std::size_t m_maximal_number_of_steps;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_AVERAGED_GRADIENT_FIELD_3_H
