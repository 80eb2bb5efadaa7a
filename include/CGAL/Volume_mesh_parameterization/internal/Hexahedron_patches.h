// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_PATCHES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_PATCHES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Hexahedron_facets.h>
#include <CGAL/Volume_mesh_parameterization/internal/check_hexahedra.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The sides of hexahedra that are labelled, by their label.
using Hexahedron_patches = std::map<int, std::vector<Hexahedron_side>>;

// What solvers are to call the patches: floor, ceiling, wall_0; and all of the mesh.
inline std::string patch_identifier(int label) {
  std::string name = patch_name(label);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}
constexpr const char* solid_identifier = "solid";

// Finds the side that each labelled quadrilateral is; those with the label 0 are left out. Besides the errors of
// check_hexahedra: `ERROR_WRONG_PARAMETER` for a negative label, and `ERROR_LABEL_NOT_ON_BOUNDARY`.
template <typename Point>
Status find_patches(const Hexahedron_soup_3<Point>& soup, Hexahedron_patches& patches) {
  const Status status = check_hexahedra(soup);
  if (!status.ok()) return status;
  std::vector<Hexahedron_side> boundary;
  for_each_facet(sorted_sides(soup.hexahedra), [&](const Hexahedron_side* sides, std::size_t n) {
    if (n == 1) boundary.push_back(*sides);
  });
  std::vector<char> is_labelled(boundary.size(), 0);
  for (std::size_t q = 0; q < soup.facets.size(); ++q) {
    const Labelled_quadrilateral& facet = soup.facets[q];
    if (facet.label == INTERIOR) continue;
    const std::string name = "quadrilateral " + std::to_string(q);
    if (facet.label < 0)
      return {ERROR_WRONG_PARAMETER, name + " has the label " + std::to_string(facet.label)};
    const auto vertices = sorted(facet.vertices);
    const auto side = std::lower_bound(boundary.begin(), boundary.end(), vertices,
                                       [](const auto& s, const auto& v) { return s.sorted_vertices < v; });
    if (side == boundary.end() || side->sorted_vertices != vertices || is_labelled[side - boundary.begin()])
      return {ERROR_LABEL_NOT_ON_BOUNDARY, name};
    is_labelled[side - boundary.begin()] = 1;
    patches[facet.label].push_back(*side);
  }
  return {};
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_HEXAHEDRON_PATCHES_H
