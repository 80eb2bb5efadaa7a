// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_H

#include <CGAL/license/Volume_mesh_parameterization.h>

/**
 * \file CGAL/volume_mesh_parameterization.h
 * Convenience header file that includes the whole package except `IO/`.
 */

#include <CGAL/Volume_mesh_parameterization/Averaged_gradient_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Base_point_3.h>
#include <CGAL/Volume_mesh_parameterization/Boundary_images_3.h>
#include <CGAL/Volume_mesh_parameterization/Boundary_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Cell_locator_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_3.h>
#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_options.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Hexahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_search_3.h>
#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/Partition_sequence_3.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_inverse_3.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Polycube_3.h>
#include <CGAL/Volume_mesh_parameterization/Polygon_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/Sweep_guide_3.h>
#include <CGAL/Volume_mesh_parameterization/Tetrahedron_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulation_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/Untangling_report.h>
#include <CGAL/Volume_mesh_parameterization/Weighted_statistics.h>
#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/critical_points.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/image_of_boundary.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/irregular_edges.h>
#include <CGAL/Volume_mesh_parameterization/label_polycube.h>
#include <CGAL/Volume_mesh_parameterization/make_linear_cell_complex.h>
#include <CGAL/Volume_mesh_parameterization/make_triangle_soup.h>
#include <CGAL/Volume_mesh_parameterization/measure_distortion.h>
#include <CGAL/Volume_mesh_parameterization/measure_floor_distortion.h>
#include <CGAL/Volume_mesh_parameterization/measure_hexahedral_fit.h>
#include <CGAL/Volume_mesh_parameterization/measure_map_distance.h>
#include <CGAL/Volume_mesh_parameterization/measure_partition.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>
#include <CGAL/Volume_mesh_parameterization/pillow_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>
#include <CGAL/Volume_mesh_parameterization/propose_directions.h>
#include <CGAL/Volume_mesh_parameterization/remesh_thin_triangles.h>
#include <CGAL/Volume_mesh_parameterization/sort_spatially.h>
#include <CGAL/Volume_mesh_parameterization/sweep_with_repairs.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize_polycube.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>
#include <CGAL/Volume_mesh_parameterization/verify.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_H
