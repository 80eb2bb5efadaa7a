#ifndef VOLUME_MESH_PARAMETERIZATION_PARTITION_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_PARTITION_TEST_UTIL_H

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include "io_test_util.h"

#include <CGAL/Kernel_traits.h>

template <typename Point>
using Mesh_of_points =
    CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3<typename CGAL::Kernel_traits<Point>::Kernel>;

template <typename Point>
Mesh_of_points<Point> mesh_of(const CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point>& soup) {
  Mesh_of_points<Point> mesh;
  expect(mesh.assign(soup), CGAL::Volume_mesh_parameterization::OK);
  return mesh;
}

// Without the labels that test solids have.
template <typename Point>
Mesh_of_points<Point> unlabelled(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> soup) {
  soup.facets.clear();
  return mesh_of(soup);
}

inline CGAL::Volume_mesh_parameterization::Partition_options
along(const CGAL::Volume_mesh_parameterization::Sweep_direction_3& direction) {
  CGAL::Volume_mesh_parameterization::Partition_options options;
  options.directions = {direction};
  return options;
}

// All cells are positive and the labels legal.
template <typename Mesh>
CGAL::Volume_mesh_parameterization::Boundary_partition_3 validate(const Mesh& mesh) {
  namespace VMP = CGAL::Volume_mesh_parameterization;
  expect(VMP::check_tetrahedral_mesh(mesh), VMP::OK);
  VMP::Boundary_partition_3 partition;
  VMP::Handlebody_certificate certificate;
  expect(VMP::validate_solid(mesh, partition, certificate), VMP::OK);
  return partition;
}

#endif // VOLUME_MESH_PARAMETERIZATION_PARTITION_TEST_UTIL_H
