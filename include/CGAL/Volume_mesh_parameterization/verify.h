// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/verify_product.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_VERIFY_H
