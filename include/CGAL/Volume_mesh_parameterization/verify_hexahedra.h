// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_HEXAHEDRA_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_HEXAHEDRA_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/Surface_topology.h>
#include <CGAL/Volume_mesh_parameterization/internal/Trilinear_jacobian.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_hexahedra.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationVerification

is what `verify_hexahedra()` found out about a hexahedral mesh.
*/
struct Hexahedra_report {
  /// hexahedra whose trilinear map has somewhere a Jacobian that is not positive, or a centre that is not
  std::size_t inverted = 0;
  std::size_t poor = 0;                ///< hexahedra with a scaled Jacobian below 0.2
  double minimum_scaled_jacobian = 1;  ///< over all hexahedra
  double mean_scaled_jacobian = 0;     ///< over all hexahedra
  std::size_t irregular_edges = 0;     ///< interior edges that are not in four hexahedra
  std::size_t irregular_vertices = 0;  ///< interior vertices that are not in six edges
  std::size_t non_manifold_facets = 0; ///< facets in more than two hexahedra
  std::size_t boundary_components = 0; ///< number of components of the boundary
  bool boundary_is_manifold = false;   ///< whether the boundary is a closed surface
  long genus = -1;                     ///< genus of the boundary, -1 if that is not one closed surface
  long euler_characteristic =
      0;         ///< of the solid: vertices - edges + facets - hexahedra; 1 - n for a handlebody
  Status status; ///< the first fault

  /// returns whether no fault was found.
  bool is_valid() const { return status.ok(); }
};

namespace internal {

template <typename Point>
std::array<Point, 8> hexahedron_points(const Hexahedron_soup_3<Point>& soup, std::size_t hexahedron) {
  std::array<Point, 8> points;
  for (std::size_t i = 0; i < 8; ++i) points[i] = soup.points[soup.hexahedra[hexahedron][i]];
  return points;
}

inline double normalized_determinant(const Double_kernel::Vector_3& a, const Double_kernel::Vector_3& b,
                                     const Double_kernel::Vector_3& c) {
  const double lengths = std::sqrt(a.squared_length() * b.squared_length() * c.squared_length());
  return lengths > 0 ? CGAL::determinant(a, b, c) / lengths : -1;
}

// The least over the eight corners and the centre (Knupp 2003, as in VTK's Verdict).
template <typename Point>
double scaled_jacobian(const std::array<Point, 8>& p) {
  using Cube = Reference_hexahedron;
  using Vector = Double_kernel::Vector_3;
  const auto edge = [&](int a, int b) { return approximate(p[b]) - approximate(p[a]); };
  Vector centre[3] = {CGAL::NULL_VECTOR, CGAL::NULL_VECTOR, CGAL::NULL_VECTOR};
  for (int axis = 0; axis < 3; ++axis)
    for (const auto& e : Cube::axis_edges[axis]) centre[axis] = centre[axis] + edge(e[0], e[1]);
  double least = normalized_determinant(centre[0], centre[1], centre[2]);
  for (int i = 0; i < 8; ++i) {
    const int* n = Cube::neighbors[i];
    least = (std::min)(least, normalized_determinant(edge(i, n[0]), edge(i, n[1]), edge(i, n[2])));
  }
  return least;
}

template <typename Point>
class Hexahedra_verifier {
  using Soup = Hexahedron_soup_3<Point>;
  using Cube = Reference_hexahedron;
  using Edge = std::array<std::size_t, 2>;
  using Quadrilateral = Hexahedron_facets::Quadrilateral;

public:
  explicit Hexahedra_verifier(const Soup& soup) : m_soup(soup) {}

  Hexahedra_report report() && {
    if (!check_input()) return m_report;
    measure_quality();
    const Hexahedron_facets facets(m_soup.hexahedra);
    check_facets(facets);
    check_boundary(facets.boundary);
    count_edges(facets.boundary);
    return m_report;
  }

private:
  void refuse(Error_code code, const std::string& detail) {
    if (m_report.status.ok()) m_report.status = {code, detail};
  }

  bool check_input() {
    m_report.status = check_hexahedra(m_soup);
    return m_report.status.ok();
  }

  // Quality.

  void measure_quality() {
    double sum = 0;
    for (std::size_t h = 0; h < m_soup.hexahedra.size(); ++h) {
      const std::array<Point, 8> vertices = hexahedron_points(m_soup, h);
      const double quality = scaled_jacobian(vertices);
      sum += quality;
      m_report.minimum_scaled_jacobian = (std::min)(m_report.minimum_scaled_jacobian, quality);
      m_report.poor += quality < 0.2;
      if (quality > 0 && has_positive_jacobian(vertices)) continue;
      ++m_report.inverted;
      refuse(ERROR_INVERTED_HEXAHEDRON, "hexahedron " + std::to_string(h));
    }
    m_report.mean_scaled_jacobian = sum / double(m_soup.hexahedra.size());
  }

  // Topology.

  void check_facets(const Hexahedron_facets& facets) {
    m_report.non_manifold_facets = facets.non_manifold;
    if (m_report.non_manifold_facets > 0)
      refuse(ERROR_NON_MANIFOLD,
             std::to_string(m_report.non_manifold_facets) + " facets are in more than two hexahedra");
  }

  void check_boundary(const std::vector<Quadrilateral>& boundary) {
    const Surface_topology<4> surface(boundary);
    m_report.boundary_components = surface.number_of_components();
    m_report.boundary_is_manifold = surface.is_closed_manifold();
    if (!m_report.boundary_is_manifold) refuse(ERROR_NON_MANIFOLD, "the boundary is no closed surface");
    if (m_report.boundary_components != 1)
      refuse(ERROR_SEVERAL_COMPONENTS,
             "the boundary has " + std::to_string(m_report.boundary_components) + " components");
    if (m_report.boundary_is_manifold && m_report.boundary_components == 1)
      m_report.genus = 1 - surface.euler_characteristic() / 2;
  }

  static Edge sorted_edge(std::size_t a, std::size_t b) { return {(std::min)(a, b), (std::max)(a, b)}; }

  // Irregular ones, and those that Euler's characteristic is made of.
  void count_edges(const std::vector<Quadrilateral>& boundary) {
    std::vector<char> on_boundary(m_soup.points.size(), 0);
    std::vector<Edge> boundary_edges;
    for (const Quadrilateral& f : boundary)
      for (int i = 0; i < 4; ++i) {
        on_boundary[f[i]] = 1;
        boundary_edges.push_back(sorted_edge(f[i], f[(i + 1) % 4]));
      }
    std::sort(boundary_edges.begin(), boundary_edges.end());
    const std::vector<Edge> edges = sorted_edges();
    std::vector<std::size_t> degree(m_soup.points.size(), 0);
    long number_of_edges = 0;
    for (std::size_t k = 0, end; k < edges.size(); k = end, ++number_of_edges) {
      for (end = k + 1; end < edges.size() && edges[end] == edges[k];) ++end;
      ++degree[edges[k][0]], ++degree[edges[k][1]];
      if (end - k != 4)
        m_report.irregular_edges +=
            !std::binary_search(boundary_edges.begin(), boundary_edges.end(), edges[k]);
    }
    long vertices = 0;
    for (std::size_t v = 0; v < degree.size(); ++v) {
      vertices += degree[v] > 0;
      m_report.irregular_vertices += !on_boundary[v] && degree[v] > 0 && degree[v] != 6;
    }
    const long hexahedra = long(m_soup.hexahedra.size()),
               facets = (6 * hexahedra + long(boundary.size())) / 2;
    m_report.euler_characteristic = vertices - number_of_edges + facets - hexahedra;
  }

  // Each edge once for each hexahedron around it.
  std::vector<Edge> sorted_edges() const {
    std::vector<Edge> edges;
    edges.reserve(12 * m_soup.hexahedra.size());
    for (const auto& v : m_soup.hexahedra)
      for (const auto& axis : Cube::axis_edges)
        for (const auto& e : axis) edges.push_back(sorted_edge(v[e[0]], v[e[1]]));
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  const Soup& m_soup;
  Hexahedra_report m_report;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationVerification

returns the scaled Jacobian of each hexahedron: see `verify_hexahedra()`.

\tparam Point a point type of a \cgal kernel
\pre the vertices of the hexahedra exist
*/
template <typename Point>
std::vector<double> scaled_jacobians(const Hexahedron_soup_3<Point>& soup) {
  std::vector<double> result;
  for (std::size_t h = 0; h < soup.hexahedra.size(); ++h)
    result.push_back(internal::scaled_jacobian(internal::hexahedron_points(soup, h)));
  return result;
}

/*!
\ingroup PkgVolumeMeshParameterizationVerification

measures the quality and verifies the topology of a hexahedral mesh.

Whether a hexahedron is inverted is decided exactly, in the whole of it and not only at its corners, from Bernstein
coefficients of the determinant (A. Johnen, J.-C. Weill, J.-F. Remacle, Robust and efficient validation of the linear hexahedral
element, 2017); the quality is computed with `double`.
The scaled Jacobian of a hexahedron is the least determinant of normalized edges over its eight corners and its centre
(P. Knupp, Algebraic mesh quality metrics for unstructured initial meshes, 2003).

The function takes \f$ O(n \log n) \f$ time.

\tparam Point a point type of a \cgal kernel
\param soup a hexahedral mesh; its labelled facets are not looked at

\returns a report whose status is `ERROR_EMPTY_MESH`, `ERROR_INDEX_OUT_OF_RANGE` (also for a vertex named twice),
`ERROR_COORDINATE_NOT_FINITE`, `ERROR_INVERTED_HEXAHEDRON`, `ERROR_NON_MANIFOLD` or `ERROR_SEVERAL_COMPONENTS`
*/
template <typename Point>
Hexahedra_report verify_hexahedra(const Hexahedron_soup_3<Point>& soup) {
  return internal::Hexahedra_verifier<Point>(soup).report();
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_HEXAHEDRA_H
