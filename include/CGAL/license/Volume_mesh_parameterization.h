// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

// #include <CGAL/license/Volume_mesh_parameterization.h> comes first in each header of the package. These are the
// switches of the generated files of CGAL/license, for a package that lives outside of CGAL's tree.

#ifndef CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H
#define CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_COMMERCIAL_LICENSE

#if CGAL_VOLUME_MESH_PARAMETERIZATION_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE
#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("Your commercial license for CGAL does not cover this release "
                    "of the Volume Mesh Parameterization package.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "Your commercial license for CGAL does not cover this release of the Volume Mesh Parameterization package."
#endif
#endif

#else

#if defined(CGAL_LICENSE_WARNING)
CGAL_pragma_warning("\nMACRO CGAL_VOLUME_MESH_PARAMETERIZATION_COMMERCIAL_LICENSE not defined."
                    "\nYou use the Volume Mesh Parameterization package under the terms of the GPLv3+.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "MACRO CGAL_VOLUME_MESH_PARAMETERIZATION_COMMERCIAL_LICENSE not defined: you use the package under the GPLv3+."
#endif

#endif

#endif // CGAL_LICENSE_VOLUME_MESH_PARAMETERIZATION_H
