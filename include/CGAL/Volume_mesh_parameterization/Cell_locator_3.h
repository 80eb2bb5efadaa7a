// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_CELL_LOCATOR_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_CELL_LOCATOR_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Box_tree_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_coordinates.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

finds the cells of a mesh that points lie in.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Cell_locator_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the mesh in which points are located
  using Location = Location_3<GeomTraits>;             ///< a point of the solid
  using FT = typename GeomTraits::FT;                  ///< the number type
  using Point_3 = typename GeomTraits::Point_3;        ///< the point type

  /// keeps a reference to `mesh`, which is embedded. Complexity: \f$ O(n \log n) \f$.
  explicit Cell_locator_3(const Mesh& mesh) : m_mesh(&mesh), m_cells(boxes(mesh)) {}

  /// returns the mesh.
  const Mesh& mesh() const { return *m_mesh; }

  /*!
  finds the cell of least number that contains `p`, and the barycentric coordinates of `p` there. A coordinate is
  exactly zero if `p` lies on the opposite facet. With an exact number type the coordinates are exact.

  \returns `ERROR_OUTSIDE`, also for coordinates that are not finite

  Complexity: \f$ O(\log n) \f$ in meshes of well shaped cells.
  */
  Status locate(const Point_3& p, Location& result) const {
    if (!internal::has_finite_coordinates(p)) return outside(p); // exact predicates do not take them
    const std::size_t c = m_cells.find(p.bbox(), [&](std::size_t k) { return contains(Cell_index(k), p); });
    if (c == m_mesh->number_of_cells()) return outside(p);
    result = {Cell_index(c), barycentric(Cell_index(c), p)};
    return {};
  }

private:
  static std::vector<Bbox_3> boxes(const Mesh& mesh) {
    std::vector<Bbox_3> result;
    for (Cell_index c : mesh.cells()) {
      Bbox_3 box;
      for (Vertex_index v : mesh.cell(c)) box += mesh.point(v).bbox();
      result.push_back(box);
    }
    return result;
  }

  // The side of p on the facet opposite to vertex i, positive inside.
  Orientation side(Cell_index c, int i, const Point_3& p) const {
    const auto v = m_mesh->vertices(Half_facet{c, i});
    return -typename GeomTraits::Orientation_3()(m_mesh->point(v[0]), m_mesh->point(v[1]), m_mesh->point(v[2]), p);
  }

  bool contains(Cell_index c, const Point_3& p) const {
    for (int i = 0; i < 4; ++i)
      if (side(c, i, p) == NEGATIVE) return false;
    return true;
  }

  std::array<FT, 4> barycentric(Cell_index c, const Point_3& p) const {
    std::array<FT, 4> w;
    FT sum(0);
    for (int i = 0; i < 4; ++i) {
      const auto v = m_mesh->vertices(Half_facet{c, i});
      const FT volume = CGAL::volume(m_mesh->point(v[2]), m_mesh->point(v[1]), m_mesh->point(v[0]), p);
      w[i] = side(c, i, p) == ZERO ? FT(0) : (std::max)(FT(0), volume); // a rounding error may be negative
      sum += w[i];
    }
    for (FT& weight : w) weight /= sum;
    return w;
  }

  static Status outside(const Point_3& p) {
    std::ostringstream text;
    text << "(" << CGAL::to_double(p.x()) << ", " << CGAL::to_double(p.y()) << ", " << CGAL::to_double(p.z()) << ")";
    return {ERROR_OUTSIDE, text.str()};
  }

  const Mesh* m_mesh;
  internal::Box_tree_3 m_cells;
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_CELL_LOCATOR_3_H
