// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_LABEL_POLYCUBE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_LABEL_POLYCUBE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_partition_3.h>
#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/internal/Axis_aligned_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Facet_adjacency.h>
#include <CGAL/Volume_mesh_parameterization/internal/boundary_triangles.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

namespace internal {

// The faces of a polycube: the largest connected sets of facets in one plane.
template <typename GeomTraits>
class Polycube_faces {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Triangle = typename Axis_aligned_surface<GeomTraits>::Triangle;

  // `triangles` are the boundary facets.
  Polycube_faces(const Facet_adjacency& surface, const std::vector<Triangle>& triangles)
      : m_normals(normals(triangles)),
        m_face(surface, [&](Facet_index f, Facet_index g) { return m_normals[f] == m_normals[g]; }) {}

  std::size_t size() const { return m_face.size(); }
  std::size_t operator[](Facet_index f) const { return m_face[f]; }
  const Axis_normal& normal(Facet_index f) const { return m_normals[f]; }

private:
  static std::vector<Axis_normal> normals(const std::vector<Triangle>& triangles) {
    std::vector<Axis_normal> result;
    for (const Triangle& t : triangles) result.push_back(Axis_aligned_surface<GeomTraits>::normal(t));
    return result;
  }

  std::vector<Axis_normal> m_normals; // of the facets
  Facet_components m_face;
};

// Labels the boundary by the labels of faces; those without are walls, numbered by component.
template <typename GeomTraits>
void write_face_labels(const Facet_adjacency& surface, const Polycube_faces<GeomTraits>& faces,
                       const std::vector<int>& label_of, Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const Facet_components patches(
      surface, [&](Facet_index f, Facet_index g) { return label_of[faces[f]] == label_of[faces[g]]; });
  std::vector<int> wall(patches.size(), INTERIOR);
  int next = FIRST_WALL;
  for (Facet_index f : surface.facets()) {
    int& number = wall[patches[f]];
    if (label_of[faces[f]] == INTERIOR && number == INTERIOR) number = next++;
    mesh.set_label(f, label_of[faces[f]] == INTERIOR ? number : label_of[faces[f]]);
  }
}

// Calls label_faces(faces, triangles, labels) to choose floor and ceiling, and writes the labels.
template <typename GeomTraits, typename LabelFaces>
Status label_faces(Compact_tetrahedral_mesh_3<GeomTraits>& mesh, const LabelFaces& choose) {
  std::vector<typename Polycube_faces<GeomTraits>::Triangle> triangles;
  Status status = boundary_triangles<GeomTraits>(mesh, mesh.points(), ERROR_NOT_A_POLYCUBE, triangles);
  if (!status.ok()) return status;
  const Facet_adjacency surface = boundary_adjacency(mesh);
  if (!surface.status().ok()) return surface.status();
  const Polycube_faces<GeomTraits> faces(surface, triangles);
  std::vector<int> labels(faces.size(), INTERIOR);
  status = choose(faces, triangles, labels);
  if (status.ok()) write_face_labels(surface, faces, labels, mesh);
  return status;
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels the boundary of a polycube: every face with a facet that has the label `FLOOR` becomes floor as a whole, likewise for
`CEILING`, and the others are walls, numbered by component. A face is a largest connected set of coplanar facets.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a polycube, of whose facets at least one is labelled `FLOOR` and one `CEILING`; other labels do not matter. If
the result is not legal, it is left there

\returns `ERROR_NOT_A_POLYCUBE` if a boundary facet is orthogonal to no axis; `ERROR_WRONG_PARAMETER` if a face has facets
of floor and of ceiling; the errors of `validate_partition()`

Complexity: \f$ O(n \log n) \f$.
*/
template <typename GeomTraits>
Status label_polycube(Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  const auto choose = [&](const auto& faces, const auto&, std::vector<int>& labels) -> Status {
    for (Facet_index f : mesh.boundary_facets()) {
      const int wish = mesh.label(f);
      int& label = labels[faces[f]];
      if (wish != FLOOR && wish != CEILING) continue;
      if (label != INTERIOR && label != wish)
        return {ERROR_WRONG_PARAMETER,
                "the face of facet " + std::to_string(f) + " is picked as floor and as ceiling"};
      label = wish;
    }
    return {};
  };
  Boundary_partition_3 summary;
  const Status status = internal::label_faces(mesh, choose);
  return status.ok() ? validate_partition(mesh, summary) : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels the boundary of a polycube: its lowest faces along an axis become floor, its highest ones ceiling, the others walls.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a polycube
\param axis 0, 1 or 2 for x, y or z
\param up whether coordinates grow from the floor to the ceiling

\returns `ERROR_NOT_A_POLYCUBE` if a boundary facet is orthogonal to no axis; the errors of `validate_solid()`

Complexity: \f$ O(n \log n) \f$.
*/
template <typename GeomTraits>
Status label_polycube(Compact_tetrahedral_mesh_3<GeomTraits>& mesh, int axis, bool up = true) {
  const auto choose = [&](const auto& faces, const auto& triangles, std::vector<int>& labels) {
    const auto is_level = [&](Facet_index f) { return faces.normal(f).axis == axis; };
    std::vector<typename GeomTraits::FT> heights;
    for (Facet_index f : mesh.boundary_facets())
      if (is_level(f)) heights.push_back(triangles[f][0][axis]);
    const auto ends = std::minmax_element(heights.begin(), heights.end());
    for (Facet_index f : mesh.boundary_facets()) {
      if (!is_level(f)) continue;
      if (triangles[f][0][axis] == *ends.first) labels[faces[f]] = up ? FLOOR : CEILING;
      if (triangles[f][0][axis] == *ends.second) labels[faces[f]] = up ? CEILING : FLOOR;
    }
    return Status();
  };
  Boundary_partition_3 summary;
  Handlebody_certificate certificate;
  const Status status = internal::label_faces(mesh, choose);
  return status.ok() ? validate_solid(mesh, summary, certificate) : status;
}

/*!
\ingroup PkgVolumeMeshParameterizationPartition

labels the boundary of a polycube as the function above, upwards along the first of the axes z, y and x along which this is
legal.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\returns also `ERROR_NO_PARTITION`
*/
template <typename GeomTraits>
Status label_polycube_by_height(Compact_tetrahedral_mesh_3<GeomTraits>& mesh) {
  Status status;
  for (int axis : {2, 1, 0}) {
    status = label_polycube(mesh, axis);
    if (status.ok() || status.code() == ERROR_NOT_A_POLYCUBE) return status;
  }
  return {ERROR_NO_PARTITION,
          "from the lowest to the highest faces along any axis; along x: " + status.message()};
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_LABEL_POLYCUBE_H
