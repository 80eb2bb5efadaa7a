#ifndef VOLUME_MESH_PARAMETERIZATION_HEXAHEDRA_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_HEXAHEDRA_TEST_UTIL_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>

#include <cassert>
#include <cstddef>
#include <vector>

using Hexahedra_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Hexahedra = CGAL::Volume_mesh_parameterization::Hexahedron_soup_3<Hexahedra_kernel::Point_3>;

// The unit cubes of a prism, labelled like its sides.
inline Hexahedra cubes_of(const CGAL::Volume_mesh_parameterization::Prism_3<Hexahedra_kernel>& prism) {
  const auto column = [&](const Hexahedra_kernel::Point_2& p, const std::vector<double>& levels, auto& points) {
    for (double level : levels) points.emplace_back(p.x(), p.y(), level * prism.height());
    return CGAL::Volume_mesh_parameterization::Status();
  };
  Hexahedra cubes;
  const auto grid = CGAL::Volume_mesh_parameterization::prism_grid(prism, 1);
  const auto status = CGAL::Volume_mesh_parameterization::hexahedral_mesh(prism, grid, column, cubes);
  assert(status.ok());
  return cubes;
}

inline Hexahedra cube_of_cubes(int n) { return cubes_of({{0, 0, double(n), double(n)}, {}, double(n)}); }

// Eight cubes around a hole.
inline Hexahedra ring_of_cubes() { return cubes_of({{0, 0, 3, 3}, {{1, 1, 2, 2}}, 1}); }

#endif // VOLUME_MESH_PARAMETERIZATION_HEXAHEDRA_TEST_UTIL_H
