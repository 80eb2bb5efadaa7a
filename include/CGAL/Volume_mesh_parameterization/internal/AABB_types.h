// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AABB_TYPES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AABB_TYPES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// AABB_traits and its primitives were renamed in CGAL 6.
template <typename Kernel>
struct AABB_types {
  using Triangles = std::vector<typename Kernel::Triangle_3>;
  using Segments = std::vector<typename Kernel::Segment_3>;
#if CGAL_VERSION_NR >= 1060000000
  using Triangle_primitive = AABB_triangle_primitive_3<Kernel, typename Triangles::const_iterator>;
  using Segment_primitive = AABB_segment_primitive_3<Kernel, typename Segments::const_iterator>;
  template <typename Primitive>
  using Tree = AABB_tree<AABB_traits_3<Kernel, Primitive>>;
#else
  using Triangle_primitive = AABB_triangle_primitive<Kernel, typename Triangles::const_iterator>;
  using Segment_primitive = AABB_segment_primitive<Kernel, typename Segments::const_iterator>;
  template <typename Primitive>
  using Tree = AABB_tree<AABB_traits<Kernel, Primitive>>;
#endif
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_AABB_TYPES_H
