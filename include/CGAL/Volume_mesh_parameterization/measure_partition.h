// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_PARTITION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_PARTITION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/critical_points.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Cell_gradients.h>
#include <CGAL/Volume_mesh_parameterization/internal/Edge_numbering.h>
#include <CGAL/Volume_mesh_parameterization/internal/surface_fields.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationPartition

tells how well a partition of the boundary of a solid suits a sweep. All numbers are without dimension, they stay when
the solid is moved or scaled. Lengths are divided by the square root of the total area; rims are the borders of the
floor and of the ceiling.
*/
struct Partition_quality {
  /// \name From the labels
  /// `measure_partition()` fills these in.
  /// @{
  double floor_share = 0;   ///< area of the floor over the total area
  double ceiling_share = 0; ///< area of the ceiling over the total area
  double wall_share = 0;    ///< area of all walls over the total area
  double balance = 1;       ///< area of the smaller base over that of the larger one
  double smallest_wall = 1; ///< area of the smallest wall over that of all walls
  double rim_length = 0;    ///< length of all rims
  /// how much longer the rims are than their smoothed curves; 1 for straight rims, \f$ \sqrt 2 \f$ for staircases.
  ///
  /// A smoothed curve moves on by the mean of the rim's unit tangents over a piece of the length of eight edges, that
  /// before or that after the place, whichever is straighter. So a corner between straight sides costs nothing. A
  /// piece is at most 1/16 of its rim, so that a circle has 1.01.
  double zigzag = 1;
  double wall_gap = 0;   ///< least distance from the floor to the ceiling along the surface
  double mean_width = 0; ///< area of the walls over half of the length of the rims
  /// mean by area of how well the unit normals \f$ n \f$ agree with the labels for the direction \f$ d \f$ of the
  /// sweep: \f$ \max(0, -n \cdot d) \f$ on the floor, \f$ \max(0, n \cdot d) \f$ on the ceiling and
  /// \f$ \sqrt{1 - (n \cdot d)^2} \f$ on the walls; 1 for a prism
  double alignment = 1;
  /// share of the total area that lies in walls though \f$ |n \cdot d| > 0.9 \f$: faces that a base should have
  double flat_walls = 0;
  /// @}

  /// \name From a trial solution
  /// `try_partition()` fills these in.
  /// @{

  /// standard deviation by volume of the logarithm of \f$ |\nabla f| \f$ for the harmonic function \f$ f \f$ that is 0
  /// on the floor and 1 on the ceiling; 0 for a prism. What is less than 1 % of the mean counts as 1 %.
  double gradient_spread = 0;
  /// standard deviation by area, over the ceiling, of the logarithm of the lengths of the steepest paths of edges down
  /// to the floor; 0 for a prism
  double length_spread = 0;
  std::size_t number_of_critical_points = 0; ///< of that function, counted with multiplicity
  /// @}
};

namespace internal {

using Rim = std::vector<Vertex_index>;

// The next side along the border of the patch of side s, which is one.
inline Facet_adjacency::Side next_border(const Facet_adjacency& surface, const std::vector<int>& labels,
                                         Facet_adjacency::Side s) {
  s.index = (s.index + 1) % 3;
  while (!is_border(surface, labels, s)) {
    s = surface.opposite(s);
    s.index = (s.index + 1) % 3;
  }
  return s;
}

// The loops around a patch. Where the patch touches itself at a vertex, they touch too.
inline std::vector<Rim> rims_of(const Facet_adjacency& surface, const std::vector<int>& labels, int label) {
  std::vector<Rim> rims;
  std::vector<char> is_done(3 * surface.number_of_facets(), 0);
  for (Facet_index f : surface.facets())
    for (int i = 0; i < 3; ++i) {
      if (labels[f] != label || is_done[3 * f + i] || !is_border(surface, labels, {f, i})) continue;
      rims.emplace_back();
      for (Facet_adjacency::Side s = {f, i}; !is_done[3 * s.facet + s.index];
           s = next_border(surface, labels, s)) {
        is_done[3 * s.facet + s.index] = 1;
        rims.back().push_back(surface.source(s));
      }
    }
  return rims;
}

inline Rim vertices_of(const std::vector<Rim>& rims) {
  Rim all;
  for (const Rim& rim : rims) all.insert(all.end(), rim.begin(), rim.end());
  return all;
}

// A closed polygon in space.
class Closed_polyline {
public:
  using Point_3 = Double_kernel::Point_3;

  Closed_polyline(const std::vector<Point_3>& points, const Rim& rim) {
    for (Vertex_index v : rim) m_points.push_back(points[v]);
    for (std::size_t i = 0; i < m_points.size(); ++i) m_length += edge_length(i);
  }

  double length() const { return m_length; }

  // as `Partition_quality::zigzag` says
  double smoothed_length() const {
    constexpr std::size_t samples_per_edge = 2, piece = 8 * samples_per_edge, least_number_of_pieces = 16;
    const std::size_t n = std::max(samples_per_edge * m_points.size(), piece * least_number_of_pieces);
    const std::vector<Point_3> p = spread_evenly(n);
    std::vector<double> chords;
    for (std::size_t k = 0; k < n; ++k)
      chords.push_back(std::sqrt(CGAL::squared_distance(p[k], p[(k + piece) % n])));
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) sum += std::max(chords[k], chords[(k + piece) % n]);
    return sum / double(piece);
  }

private:
  const Point_3& end(std::size_t edge) const { return m_points[(edge + 1) % m_points.size()]; }
  double edge_length(std::size_t i) const { return std::sqrt(CGAL::squared_distance(m_points[i], end(i))); }

  std::vector<Point_3> spread_evenly(std::size_t n) const {
    std::vector<Point_3> result;
    double passed = 0; // the length of the edges before edge i
    for (std::size_t i = 0; i < m_points.size(); ++i) {
      const double l = edge_length(i);
      for (double at; result.size() < n && (at = m_length * double(result.size()) / double(n)) <= passed + l;)
        result.push_back(m_points[i] + (l > 0 ? (at - passed) / l : 0) * (end(i) - m_points[i]));
      passed += l;
    }
    result.resize(n, m_points[0]); // what rounding left over lies at the end, which is the start
    return result;
  }

  std::vector<Point_3> m_points;
  double m_length = 0;
};

// How well a facet, whose unit normal has this inner product with the direction, suits the label.
inline double agreement(int label, double rise) {
  if (label == FLOOR) return std::max(0., -rise);
  if (label == CEILING) return std::max(0., rise);
  return std::sqrt(std::max(0., 1 - rise * rise));
}

inline void measure_alignment(const Approximate_surface& surface, const std::vector<int>& labels,
                              const Sweep_direction_3& direction, Partition_quality& quality) {
  constexpr double flat = .9;
  const Sweep_direction_3 d =
      normalized(direction == CGAL::NULL_VECTOR ? mean_direction(surface, labels) : direction);
  double aligned = 0, flat_walls = 0;
  for (Facet_index f : surface.adjacency.facets()) {
    if (!(surface.areas[f] > 0)) continue;
    const double rise = surface.area_vector(f) * d / surface.areas[f];
    aligned += surface.areas[f] * agreement(labels[f], rise);
    if (labels[f] != FLOOR && labels[f] != CEILING && std::abs(rise) > flat) flat_walls += surface.areas[f];
  }
  quality.alignment = aligned / surface.total_area;
  quality.flat_walls = flat_walls / surface.total_area;
}

inline void measure_areas(const Approximate_surface& surface, const std::vector<int>& labels,
                          Partition_quality& quality) {
  double floor = 0, ceiling = 0, walls = 0, smallest = surface.total_area;
  for (const Boundary_patch_3& patch : summarize(surface.adjacency, labels, surface.areas).patches) {
    (patch.label == FLOOR ? floor : patch.label == CEILING ? ceiling : walls) += patch.area;
    if (patch.label != FLOOR && patch.label != CEILING) smallest = std::min(smallest, patch.area);
  }
  quality.floor_share = floor / surface.total_area;
  quality.ceiling_share = ceiling / surface.total_area;
  quality.wall_share = walls / surface.total_area;
  quality.balance = std::min(floor, ceiling) / std::max(floor, ceiling);
  quality.smallest_wall = walls > 0 ? smallest / walls : 0;
}

// The least distance along the surface from one of the sources to one of the targets.
inline double gap_between(const Approximate_surface& surface, const Rim& sources, const Rim& targets) {
  const Vertex_field distance = Surface_distance(surface).from(sources);
  double gap = distance[targets[0]];
  for (Vertex_index v : targets) gap = std::min(gap, distance[v]);
  return gap;
}

// Fills in what the labels tell. The surface is connected, with floor and ceiling. A direction of length 0 stands for
// the mean one.
inline void measure_partition(const Approximate_surface& surface, const std::vector<int>& labels,
                              const Sweep_direction_3& direction, Partition_quality& quality) {
  measure_areas(surface, labels, quality);
  measure_alignment(surface, labels, direction, quality);
  const std::vector<Rim> floor_rims = rims_of(surface.adjacency, labels, FLOOR),
                         ceiling_rims = rims_of(surface.adjacency, labels, CEILING);
  double rim_length = 0, smoothed_length = 0;
  for (const std::vector<Rim>* rims : {&floor_rims, &ceiling_rims})
    for (const Rim& rim : *rims) {
      const Closed_polyline polyline(surface.points, rim);
      rim_length += polyline.length();
      smoothed_length += polyline.smoothed_length();
    }
  const double unit = std::sqrt(surface.total_area);
  quality.rim_length = rim_length / unit;
  quality.zigzag = rim_length / smoothed_length;
  quality.wall_gap = gap_between(surface, vertices_of(floor_rims), vertices_of(ceiling_rims)) / unit;
  quality.mean_width = 2 * quality.wall_share / quality.rim_length;
}

// Floor and ceiling may touch on a coarse mesh where its facets are broader than the walls: there some of its facets
// count as walls.
template <typename GeomTraits>
void separate_bases(Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  std::vector<std::array<char, FIRST_WALL>> touches(mesh.number_of_vertices(), {0, 0, 0});
  const auto is_base = [&](Facet_index f) { return mesh.label(f) == FLOOR || mesh.label(f) == CEILING; };
  for (Facet_index f : mesh.boundary_facets())
    if (is_base(f))
      for (Vertex_index v : mesh.vertices(f)) touches[v][mesh.label(f)] = 1;
  for (Facet_index f : mesh.boundary_facets()) {
    if (!is_base(f)) continue;
    const auto t = mesh.vertices(f);
    if (std::any_of(t.begin(), t.end(),
                    [&](Vertex_index v) { return touches[v][FLOOR] && touches[v][CEILING]; }))
      mesh.set_label(f, FIRST_WALL);
  }
}

// Values without weight do not count.
inline double standard_deviation(const std::vector<double>& values, const std::vector<double>& weights) {
  double total = 0, sum = 0, squares = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    total += weights[i];
    sum += weights[i] * values[i];
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += weights[i] * (values[i] - sum / total) * (values[i] - sum / total);
  return total > 0 ? std::sqrt(squares / total) : 0;
}

template <typename Mesh, typename Function>
double measure_gradient_spread(const Mesh& mesh, const Function& f) {
  constexpr double least = .01; // of the mean: what is slower is a dead end, and how slow depends on the mesh
  std::vector<double> slopes, volumes;
  double flow = 0, volume = 0;
  for (Cell_index c : mesh.cells()) {
    volumes.push_back(std::abs(Cell_gradients(mesh, c).volume));
    slopes.push_back(length(f.gradient(c)));
    flow += volumes.back() * slopes.back();
    volume += volumes.back();
  }
  for (double& s : slopes) s = std::log(std::max(s, least * flow / volume));
  return standard_deviation(slopes, volumes);
}

// For each vertex the length of the path of edges along which the function falls most steeply.
template <typename Mesh>
std::vector<double> lengths_of_descent(const Mesh& mesh, const std::vector<double>& values) {
  const Edge_numbering numbering(mesh);
  struct Step {
    Vertex_index to;
    double length = 0, slope = 0;
  };
  std::vector<Step> steps(mesh.number_of_vertices());
  for (Edge_index e : numbering.edges()) {
    auto [high, low] = numbering.ends(e);
    if (values[high] < values[low]) std::swap(high, low);
    const double l = length(approximate(mesh.point(high)) - approximate(mesh.point(low)));
    const double slope = (values[high] - values[low]) / l;
    if (slope > steps[high].slope) steps[high] = {low, l, slope};
  }
  std::vector<Vertex_index> order(mesh.vertices().begin(), mesh.vertices().end());
  std::sort(order.begin(), order.end(),
            [&](Vertex_index v, Vertex_index w) { return values[v] < values[w]; });
  std::vector<double> lengths(mesh.number_of_vertices(), 0);
  for (Vertex_index v : order)
    if (steps[v].to.is_valid()) lengths[v] = steps[v].length + lengths[steps[v].to];
  return lengths;
}

template <typename Mesh>
double measure_length_spread(const Mesh& mesh, const std::vector<double>& values) {
  std::vector<double> lengths = lengths_of_descent(mesh, values), areas(lengths.size(), 0);
  for (Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) == CEILING)
      for (Vertex_index v : mesh.vertices(f))
        if (lengths[v] > 0)
          areas[v] += std::sqrt(squared_area(mesh, f)); // else all neighbors are on the ceiling
  for (double& l : lengths) l = l > 0 ? std::log(l) : 0;
  return standard_deviation(lengths, areas);
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

returns how bad a partition is, to compare it with others of the same solid, all of them tried or none; infinite if floor
and ceiling touch, or if a number overflowed.

With balance \f$ b \f$, share \f$ w \f$ of the walls and \f$ w_0 \f$ of their flat parts, wall gap \f$ g \f$, alignment
\f$ a \f$, zigzag \f$ z \f$, spreads \f$ s_g, s_l \f$ and \f$ c \f$ critical points it is
\f$ -\log b - \log(1 - w) + 12 w_0 - \frac12 \log g + 4 (1 - a) + 2 \log z + s_g + s_l + \frac14 \log(1 + c) \f$. The
sizes of the smallest wall and of the rims depend on the solid more than on the partition and do not count.
*/
inline double cost(const Partition_quality& quality) {
  const double sum = -std::log(quality.balance) - std::log1p(-quality.wall_share) + 12 * quality.flat_walls -
                     std::log(quality.wall_gap) / 2 + 4 * (1 - quality.alignment) +
                     2 * std::log(quality.zigzag) + quality.gradient_spread + quality.length_spread +
                     std::log1p(double(quality.number_of_critical_points)) / 4;
  return std::isnan(sum) ? std::numeric_limits<double>::infinity() : sum;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

measures the labels of the boundary of `mesh`, legal or not, in \f$ O(n \log n) \f$. What is neither floor nor ceiling
counts as wall.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a solid with labels
\param direction from the floor to the ceiling, of any length; a vector of length 0 stands for the mean by area of the
ceiling's normals and of the opposites of the floor's
\param quality gets what the labels tell, the rest stays; on failure it is left as it was

\returns `ERROR_EMPTY_MESH`, `ERROR_NON_MANIFOLD`, `ERROR_SEVERAL_COMPONENTS` (of the boundary),
`ERROR_NUMBER_OF_PATCHES` (no floor or no ceiling) or `ERROR_WRONG_PARAMETER` (the direction is not finite)
*/
template <typename GeomTraits>
Status measure_partition(const Compact_tetrahedral_mesh_3<GeomTraits>& mesh,
                         const Sweep_direction_3& direction, Partition_quality& quality) {
  const internal::Approximate_surface surface = internal::approximate_surface(mesh);
  const std::vector<int> labels = internal::boundary_labels(mesh);
  if (!surface.adjacency.status().ok()) return surface.adjacency.status();
  if (internal::genus_of(surface.adjacency) < 0)
    return {ERROR_SEVERAL_COMPONENTS, "the boundary is not connected"};
  if (!std::isfinite(internal::length(direction)))
    return {ERROR_WRONG_PARAMETER, "the direction is not finite"};
  for (int base : {FLOOR, CEILING})
    if (std::find(labels.begin(), labels.end(), base) == labels.end())
      return {ERROR_NUMBER_OF_PATCHES, "there is no " + patch_name(base)};
  internal::measure_partition(surface, labels, direction, quality);
  return {};
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

measures a partition by the harmonic function of the solid, in the time of `Harmonic_function_3::solve()` and
\f$ O(n \log n) \f$. The solid may be a coarse copy of the one that matters, and its labels approximate: where floor and
ceiling touch, facets of both count as walls.

\tparam Solver a model of `SparseLinearAlgebraWithFactorTraits_d`
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param solid a mesh that `check_tetrahedral_mesh()` accepts, with labels
\param quality gets what the trial tells, the rest stays; on failure it is left as it was

\returns `ERROR_FLAT_TETRAHEDRON`, `ERROR_NUMBER_OF_PATCHES` (no floor or no ceiling, but where they touch),
`ERROR_SEVERAL_COMPONENTS` or `ERROR_CANNOT_SOLVE`
*/
template <typename Solver = Default_solver_traits_3, typename GeomTraits>
Status try_partition(const Compact_tetrahedral_mesh_3<GeomTraits>& solid, Partition_quality& quality) {
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  Mesh trial = solid;
  internal::separate_bases(trial);
  Harmonic_function_3<Mesh, Solver> function(trial);
  std::vector<Critical_vertex> critical;
  Status status = function.solve();
  if (status.ok()) status = find_critical_points(trial, function.values(), critical);
  if (!status.ok()) return status;
  quality.gradient_spread = internal::measure_gradient_spread(trial, function);
  quality.length_spread = internal::measure_length_spread(trial, function.values());
  quality.number_of_critical_points = 0;
  for (const Critical_vertex& c : critical) quality.number_of_critical_points += c.multiplicity;
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_MEASURE_PARTITION_H
