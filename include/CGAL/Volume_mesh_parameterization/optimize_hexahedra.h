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
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedra_optimizer.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/measure_hexahedral_fit.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <CGAL/tags.h>

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

tells `optimize_hexahedra()` how far to go.
*/
struct Hexahedra_optimization {
  int most_sweeps =
      100; ///< over all nodes, in each of some dozens of passes; a node takes part while one around it moves
  double target = 0.52; ///< the least scaled Jacobian for which even sizes and the mean are given up
  /// how far a node may leave its patch or rim, as a share of the edges around, where the target is not reached otherwise; no
  /// farther than four fifths of `greatest_distance`
  double surface_tolerance = 0.35;
  /// how far the boundary and the surface may be from each other, in mean sides of boundary quadrilaterals, unless they were
  /// farther in the beginning
  double greatest_distance = 0.5;
  /// whether nodes of a rim, where that is no crease, may leave it for the patches at its sides, and nodes of these may
  /// cross it
  bool slides_over_smooth_rims = false;
};

namespace internal {

// The labelled quadrilaterals are the facets in one hexahedron, each once.
template <typename Point>
Status check_labels(const Hexahedron_soup_3<Point>& hexahedra) {
  using Quadrilaterals = std::vector<Hexahedron_facets::Quadrilateral>;
  Quadrilaterals boundary = Hexahedron_facets(hexahedra.hexahedra).boundary, labelled;
  for (const Labelled_quadrilateral& q : hexahedra.facets) labelled.push_back(q.vertices);
  for (Quadrilaterals* list : {&boundary, &labelled}) {
    for (auto& q : *list) std::sort(q.begin(), q.end());
    std::sort(list->begin(), list->end());
  }
  const auto [b, l] = std::mismatch(boundary.begin(), boundary.end(), labelled.begin(), labelled.end());
  if (b == boundary.end() && l == labelled.end()) return {};
  const bool lacks_label = l == labelled.end() || (b != boundary.end() && *b < *l);
  const auto& q = lacks_label ? *b : *l;
  return {lacks_label ? ERROR_UNLABELLED_FACET : ERROR_LABEL_NOT_ON_BOUNDARY,
          "quadrilateral " + std::to_string(q[0]) + ", " + std::to_string(q[1]) + ", " +
              std::to_string(q[2]) + ", " + std::to_string(q[3])};
}

// Nodes of quadrilaterals with one label move on that patch, with two on the rim between them, others freely.
template <typename Point>
Status find_carriers(const Carriers_3& carriers, const Hexahedron_soup_3<Point>& hexahedra,
                     const std::vector<Eigen::Vector3d>& nodes,
                     std::vector<Carriers_3::Handle>& carrier_of_node) {
  constexpr int none = (std::numeric_limits<int>::max)();
  std::vector<std::pair<int, int>> labels(hexahedra.points.size(), {none, -none}); // least and greatest
  for (const Labelled_quadrilateral& q : hexahedra.facets)
    for (std::size_t v : q.vertices)
      labels[v] = {(std::min)(labels[v].first, q.label), (std::max)(labels[v].second, q.label)};
  for (const Labelled_quadrilateral& q : hexahedra.facets)
    for (std::size_t v : q.vertices)
      if (q.label != labels[v].first && q.label != labels[v].second)
        return {ERROR_WRONG_PARAMETER, "vertex " + std::to_string(v) + " lies on three patches"};
  carrier_of_node.resize(labels.size());
  for (std::size_t v = 0; v < labels.size(); ++v)
    if (labels[v].first != none && !carriers.find(labels[v], nodes[v], carrier_of_node[v]))
      return {ERROR_WRONG_PARAMETER, "the labels " + std::to_string(labels[v].first) + " and " +
                                         std::to_string(labels[v].second) + " of vertex " +
                                         std::to_string(v) + " do not meet on the solid"};
  return {};
}

// Vertices and barycentres of triangles: those that measure_hexahedral_fit() looks at.
template <typename GeomTraits>
std::vector<Eigen::Vector3d> surface_points(const Compact_tetrahedral_mesh_3<GeomTraits>& object) {
  const auto position = [&](Vertex_index v) {
    const auto p = approximate(object.point(v));
    return Eigen::Vector3d(p.x(), p.y(), p.z());
  };
  std::vector<char> is_on_boundary(object.number_of_vertices(), 0);
  std::vector<Eigen::Vector3d> result;
  for (Facet_index f : object.boundary_facets()) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Vertex_index v : object.vertices(f)) {
      is_on_boundary[v] = 1;
      sum += position(v);
    }
    result.push_back(sum / 3);
  }
  for (std::size_t v = 0; v < is_on_boundary.size(); ++v)
    if (is_on_boundary[v]) result.push_back(position(Vertex_index(v)));
  return result;
}

// The lower the better: the number of inverted hexahedra; by how much the least scaled Jacobian falls short of the target and
// the distance to the surface exceeds the greatest, added; the opposite of the mean.
using Hexahedra_grade = std::tuple<std::size_t, double, double>;

template <typename GeomTraits, typename Point>
Hexahedra_grade grade_hexahedra(const Compact_tetrahedral_mesh_3<GeomTraits>& object,
                                const Hexahedron_soup_3<Point>& hexahedra, const Hexahedra_optimization& options) {
  const Hexahedra_report report = verify_hexahedra(hexahedra);
  const Hexahedral_fit fit = measure_hexahedral_fit(object, hexahedra);
  const double distance = (std::max)(fit.distance_to_solid, fit.distance_from_solid) / fit.edge;
  const double lack = (std::max)(0., options.target - report.minimum_scaled_jacobian) +
                      (std::max)(0., distance - options.greatest_distance);
  return {report.inverted, lack, -report.mean_scaled_jacobian};
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationHexahedra

moves the nodes of a hexahedral mesh so that no hexahedron is inverted and the least scaled Jacobian is large. Nodes in
the interior are free; those on a patch of the boundary stay on it, and those on the rim between two patches on that rim,
up to rounding. Where hexahedra fall short of `target` then, as they do where the surface is smooth at a rim, their nodes leave
patch and rim, as little as suffices and by no more than `surface_tolerance`. With `slides_over_smooth_rims`, rims count only
where the surface has a crease; elsewhere nodes move on the patches of both sides as on one, and labels tell where nodes were,
not where they are.

The boundary stays near to the surface: the middles of quadrilaterals and of their sides get no farther from it than four
fifths of `greatest_distance`. Where vertices or barycentres of triangles of the surface are too far from the quadrilaterals, at
tips and at creases inside a patch, or quadrilaterals from the surface, an energy of these distances is lessened together with
that of the corners, with growing powers, so that the worst of both count; what is covered then remains so while angles are
mended once more.

Nothing warrants that no hexahedron is inverted in the end: where the solid is smooth at a rim, the scaled Jacobian is small,
and without tolerance tends to zero under refinement, unless there is a layer of hexahedra as `pillow_hexahedra()` makes it.

The mesh is left as it was unless in the end fewer hexahedra are inverted, or as many and less is missing to `target` and
`greatest_distance` together, or as much and the mean scaled Jacobian is larger. The result is the same in each run. Use
`verify_hexahedra()` and `measure_hexahedral_fit()` for measures before and after.

Takes \f$ O(n \log m) \f$ time for each sweep over \f$ n \f$ nodes and a boundary of \f$ m \f$ triangles.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Point a point type of a \cgal kernel, constructible from three `double`

\param object the solid, whose labelled boundary facets are the true surface
\param hexahedra a mesh with a label on each boundary quadrilateral, as `hexahedral_mesh()` makes it
\param options how far to go
\pre nodes of labelled quadrilaterals lie on the patches with their labels

\returns `ERROR_WRONG_PARAMETER` if an option is outside its range, or a node has three labels or a label, or a pair of
labels, which the boundary of `object` does not have; `ERROR_EMPTY_MESH`, `ERROR_NON_MANIFOLD` (of `object`),
`ERROR_INDEX_OUT_OF_RANGE`, `ERROR_COORDINATE_NOT_FINITE`, `ERROR_UNLABELLED_FACET` or `ERROR_LABEL_NOT_ON_BOUNDARY`; then
`hexahedra` is left as it was
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename Point>
Status optimize_hexahedra(const Compact_tetrahedral_mesh_3<GeomTraits>& object,
                          Hexahedron_soup_3<Point>& hexahedra, const Hexahedra_optimization& options = {}) {
  if (options.most_sweeps < 0 || !(options.target <= 1) || !(options.surface_tolerance < 1) || !(options.greatest_distance > 0))
    return {ERROR_WRONG_PARAMETER, "the options"};
  const Hexahedra_report before = verify_hexahedra(hexahedra);
  for (Error_code code : {ERROR_EMPTY_MESH, ERROR_INDEX_OUT_OF_RANGE, ERROR_COORDINATE_NOT_FINITE})
    if (before.status.code() == code) return before.status;
  std::vector<Eigen::Vector3d> nodes;
  for (const Point& p : hexahedra.points) {
    const auto q = internal::approximate(p);
    nodes.emplace_back(q.x(), q.y(), q.z());
  }
  internal::Carriers_3 carriers;
  std::vector<internal::Carriers_3::Handle> carrier_of_node;
  Status status = internal::check_labels(hexahedra);
  if (status.ok()) status = carriers.build(object, !options.slides_over_smooth_rims);
  if (status.ok()) status = internal::find_carriers(carriers, hexahedra, nodes, carrier_of_node);
  if (!status.ok()) return status;
  internal::Surface_watch<ConcurrencyTag> watch(internal::Hexahedron_facets(hexahedra.hexahedra).boundary, carriers.surface(),
                                                internal::surface_points(object), nodes.size(), options.greatest_distance);
  internal::Hexahedra_optimizer<ConcurrencyTag> optimizer(nodes, hexahedra.hexahedra, carrier_of_node, std::move(watch));
  optimizer.run(options.most_sweeps, options.target, options.surface_tolerance);

  Hexahedron_soup_3<Point> result = hexahedra;
  for (std::size_t v = 0; v < nodes.size(); ++v) {
    const Eigen::Vector3d& p = optimizer.nodes()[v];
    if (p != nodes[v]) result.points[v] = Point(p.x(), p.y(), p.z());
  }
  const internal::Hexahedra_grade old_grade = internal::grade_hexahedra(object, hexahedra, options);
  if (internal::grade_hexahedra(object, result, options) < old_grade) hexahedra = std::move(result);
  return {};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_OPTIMIZE_HEXAHEDRA_H
