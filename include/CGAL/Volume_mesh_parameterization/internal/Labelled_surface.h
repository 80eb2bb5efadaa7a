// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LABELLED_SURFACE_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LABELLED_SURFACE_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Triangle_soup_3.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>
#include <CGAL/Volume_mesh_parameterization/internal/Approximate_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_surface.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/point_between.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {
namespace internal {

// A new vertex at this part of the way from v to w.
struct Edge_split {
  std::uint32_t v, w;
  double part;
};

/*
The boundary of a solid in doubles, with labels, cut finer along edges so that rims run where they should. Its first
vertices are those of the solid, the interior ones being in no triangle; then come those of the splits, in their order.
The splits can be repeated in the solid or in the surface that it was made of.
*/
class Labelled_surface {
public:
  using Id = Refined_surface::Id;

  Labelled_surface() = default;

  template <typename GeomTraits>
  explicit Labelled_surface(const Compact_tetrahedral_mesh_3<GeomTraits>& solid) {
    for (const auto& p : solid.points()) surface.add_vertex(approximate(p));
    for (Facet_index f : solid.boundary_facets()) {
      const auto v = solid.vertices(f);
      surface.add_triangle({v[0], v[1], v[2]}, f, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
      labels.push_back(solid.label(f));
    }
    surface.link();
  }

  Id split(Id v, Id w, double part) {
    splits.push_back({v, w, part});
    const Id h = surface.half_edge(v, w);
    for (Id side : {h, surface.opposite(h)}) labels.push_back(label(side)); // of the added triangles
    return surface.split(h, surface.source(h) == v ? part : 1 - part);
  }

  Id bisect(Id v, Id w) { return split(v, w, .5); }

  void split_chords() {
    for (const auto& [v, w] : surface.chords()) bisect(v, w);
  }

  // The label on the left of a half-edge.
  int label(Id half_edge) const { return labels[half_edge / 3]; }
  bool is_rim(Id half_edge) const { return label(half_edge) != label(surface.opposite(half_edge)); }

  std::size_t number_of_given_vertices() const { return surface.number_of_vertices() - splits.size(); }

  Approximate_surface approximate_surface() const {
    std::vector<Facet_adjacency::Triangle> triangles;
    triangles.reserve(surface.number_of_triangles());
    for (const Refined_surface::Triangle& t : surface.triangles())
      triangles.push_back({Vertex_index(t[0]), Vertex_index(t[1]), Vertex_index(t[2])});
    return {Facet_adjacency(surface.number_of_vertices(), std::move(triangles)), surface.points()};
  }

  // The vertices of the solid to which all vertices can be moved along split edges: a map that is homotopic to the identity
  // and maps simplices to simplices.
  std::vector<Vertex_index> origins() const {
    std::vector<Vertex_index> result;
    for (std::size_t v = 0; v < number_of_given_vertices(); ++v) result.emplace_back(v);
    for (const Edge_split& s : splits) result.push_back(Vertex_index(result[s.v]));
    return result;
  }

  // Repeats the splits in the surface that the solid was made of, which lacks the vertices that were added inside.
  template <typename Point>
  void write_to(Triangle_soup_3<Point>& soup) const {
    const std::size_t n = number_of_given_vertices(), number_inside = n - soup.points.size();
    const auto in_soup = [&](Id v) { return v < n ? v : v - number_inside; };
    for (const Edge_split& s : splits)
      soup.points.push_back(point_between(soup.points[in_soup(s.v)], soup.points[in_soup(s.w)], s.part));
    soup.triangles.clear();
    for (const Refined_surface::Triangle& t : surface.triangles())
      soup.triangles.push_back({in_soup(t[0]), in_soup(t[1]), in_soup(t[2])});
    soup.labels = labels;
  }

  // Repeats the splits in the solid.
  template <typename GeomTraits>
  Status write_to(Compact_tetrahedral_mesh_3<GeomTraits>& solid) const {
    Splittable_mesh<GeomTraits> splittable(solid);
    Status status;
    for (std::size_t k = 0; k < splits.size() && status.ok(); ++k)
      status = splittable.split_edge(Vertex_index(splits[k].v), Vertex_index(splits[k].w), splits[k].part);
    if (status.ok()) status = std::move(splittable).write_to(solid);
    if (status.ok()) write_labels(solid);
    return status;
  }

  Refined_surface surface;
  std::vector<int> labels; // of triangles
  std::vector<Edge_split> splits;

private:
  // Boundary facets of a mesh are numbered in the order of their sorted vertices.
  template <typename GeomTraits>
  void write_labels(Compact_tetrahedral_mesh_3<GeomTraits>& solid) const {
    std::vector<std::pair<Refined_surface::Triangle, int>> labelled;
    for (std::size_t t = 0; t < labels.size(); ++t) {
      labelled.emplace_back(surface.triangles()[t], labels[t]);
      std::sort(labelled.back().first.begin(), labelled.back().first.end());
    }
    std::sort(labelled.begin(), labelled.end());
    for (Facet_index f : solid.boundary_facets()) solid.set_label(f, labelled[f].second);
  }
};

} // namespace internal
} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_INTERNAL_LABELLED_SURFACE_H
