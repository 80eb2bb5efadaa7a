// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_POINT_BETWEEN_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_POINT_BETWEEN_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Kernel/global_functions_3.h>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// The point at this part of the way from p to q; midpoints are rounded least.
template <typename Point>
Point point_between(const Point& p, const Point& q, double part) {
  if (part == .5) return CGAL::midpoint(p, q);
  return p + typename Kernel_traits<Point>::Kernel::FT(part) * (q - p);
}

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_POINT_BETWEEN_H
