// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_FLOOR_MAP_2_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_FLOOR_MAP_2_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/Base_point_3.h>
#include <CGAL/Volume_mesh_parameterization/Floor_map_options.h>
#include <CGAL/Volume_mesh_parameterization/Prism_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Bucket_grid_2.h>
#include <CGAL/Volume_mesh_parameterization/internal/Floor_map_builder.h>
#include <CGAL/Volume_mesh_parameterization/internal/Incidence_lists.h>
#include <CGAL/Volume_mesh_parameterization/internal/Prism_boundary_mapper.h>
#include <CGAL/Volume_mesh_parameterization/internal/triangle_weights_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is a piecewise linear one-to-one map from the floor of a solid to the base of a prism, a rectangle with as many
rectangular holes as the floor has holes, which may lie anywhere.

The floor is cut by lines that part the holes, each from side to side of a cell, and each cell around its hole into four
trapezoids (one piece without holes). Each piece is embedded by the theorem of Tutte and Floater with mean value weights
(where rounding spoils that, with weights adapted to the stretch), then the whole is relaxed: the distortion is least for
sides that may slide, planes of sides included. Sides of holes that are nearly in one plane share it. The triangulation is
that of the floor with some edges bisected. It is checked by exact signs: each triangle is positively oriented and the border runs
monotonically along the sides, so the map is one to one. The floor is seen from inside: together with w upwards the map
preserves orientation. With an exact number type `image()` and `preimage()` are inverse to the bit.

\cgalModels{VolumeFloorMap_3}

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Floor_map_2 {
public:
  using Geom_traits = GeomTraits;                      ///< a model of `VolumeParameterizationTraits_3`
  using FT = typename GeomTraits::FT;                  ///< the number type
  using Point_2 = typename GeomTraits::Point_2;        ///< the point type of the plane
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the type of the solid
  using Domain = Prism_3<GeomTraits>;                  ///< a model of `ParameterDomain_3`
  using Triangle = std::array<std::uint32_t, 3>;       ///< three vertex numbers

  /// \name Construction
  /// @{

  /// \param options what the domain is to be like
  explicit Floor_map_2(const Floor_map_options& options = Floor_map_options()) : m_options(options) {}

  /// maps the floor of `mesh`, whose partition is valid. Near linear, but for a sparse factorization in the plane.
  /// The outer rim is the longest one; each rim of the domain carries the label of the wall that meets it. By default the
  /// area of the base is about that of the floor, the height of the prism the volume of `mesh` over the mean area of
  /// floor and ceiling.
  /// \returns `ERROR_NUMBER_OF_PATCHES` (no floor), `ERROR_NON_MANIFOLD`, `ERROR_PATCH_NOT_A_SURFACE`,
  /// `ERROR_PATCH_NOT_CONNECTED` or `ERROR_PATCH_TOPOLOGY` if the floor is no disk with holes, `ERROR_CANNOT_SOLVE`,
  /// `ERROR_FLOOR_MAP` if triangles are flipped, `ERROR_WRONG_PARAMETER` if the options ask for sizes that are negative, no
  /// numbers or no integers, or too small for holes with integer planes
  Status build(const Mesh& mesh) {
    *this = Floor_map_2(m_options);
    internal::Floor_map_builder<GeomTraits> builder(mesh, m_options);
    const Status status = builder.build();
    if (!status.ok()) return status;
    m_surface = std::move(builder.floor.surface);
    m_mesh_vertices = std::move(builder.mesh_vertices);
    for (const auto& p : builder.floor.images) m_images.push_back(Point_2(p.x(), p.y()));
    set_domain(builder);
    index_parts(mesh.number_of_boundary_facets());
    index_images();
    return {};
  }

  /*!
  extends the floor map to the whole boundary of `mesh`, for which `build()` has succeeded, by construction: the creases of
  the walls run along harmonic angles to the corners of the ceiling, the same way around as in `images`, the ceiling is cut
  and embedded like the floor, then each rectangle of the walls; at last the whole surface is relaxed, with vertices that
  slide and planes of the domain that move, unless the options fix them. If it is much distorted, other corners are tried.
  The floor map and the domain become those of the result.

  \param mesh the solid
  \param images those of all its vertices under the map along curves; only where the boundary is cut depends on them
  \param boundary receives the result
  \returns `ERROR_BOUNDARY_MAP` or `ERROR_CANNOT_SOLVE`; then nothing is changed

  Complexity: near linear, but for sparse factorizations in the plane.
  */
  Status map_boundary(const Mesh& mesh, const std::vector<typename GeomTraits::Point_3>& images,
                      Boundary_images_3<GeomTraits>& boundary) {
    std::vector<internal::Double_kernel::Point_3> picture;
    for (const auto& p : images) picture.push_back(internal::approximate(p));
    internal::Prism_boundary_mapper<Floor_map_2> mapper;
    const Status status = mapper.run({mesh, *this, m_options, std::move(picture)});
    if (!status.ok()) return status;
    mapper.best().write_to(boundary);
    for (std::size_t v = 0; v < m_images.size(); ++v) {
      const auto& p = mapper.best().floor_image(v);
      m_images[v] = Point_2(p.x(), p.y());
    }
    m_domain = mapper.best().domain();
    index_images();
    return {};
  }

  /// @}
  /// \name Access
  /// @{

  /// returns the prism.
  const Domain& domain() const { return m_domain; }

  /// returns the number of vertices of the floor, those of its refinement included.
  std::size_t number_of_vertices() const { return m_images.size(); }
  /// returns the number of triangles of the floor, those of its refinement included.
  std::size_t number_of_triangles() const { return m_surface.number_of_triangles(); }
  /// returns the vertices of triangle `t` of the refined floor, counterclockwise in the plane.
  const Triangle& triangle(std::size_t t) const { return m_surface.triangles()[t]; }
  /// returns the facet of the mesh that triangle `t` is a part of.
  Facet_index parent(std::size_t t) const { return m_surface.parent(t); }
  /// returns corner `i` of triangle `t` as a point of the floor.
  Base_point_3<GeomTraits> corner(std::size_t t, int i) const {
    const auto& w = m_surface.weights(t)[i];
    return {parent(t), {FT(w[0]), FT(w[1]), FT(w[2])}};
  }
  /// returns the image of vertex `v` of the refined floor.
  const Point_2& image(std::size_t v) const { return m_images[v]; }
  /// returns the ends of the edge of the refined floor that vertex `v` has bisected, if it is no vertex of the mesh.
  const std::array<std::uint32_t, 2>& bisected_edge(std::size_t v) const { return m_surface.split_edge(v); }
  /// returns the vertex of the mesh that vertex `v` of the refined floor is; invalid if it is the midpoint of an edge.
  Vertex_index mesh_vertex(std::size_t v) const {
    return v < m_mesh_vertices.size() ? m_mesh_vertices[v] : Vertex_index();
  }

  /// @}
  /// \name Evaluation
  /// @{

  /// returns the image of the point of `floor_facet` with the given weights. Points on the rims of the floor, with a
  /// weight of exactly 0, come to lie on sides of the domain exactly. In time proportional to the parts of the facet.
  /// \pre `floor_facet` is on the floor, the weights are not negative and sum up to one
  Point_2 image(Facet_index floor_facet, const std::array<FT, 3>& barycentric) const {
    const Chart chart(barycentric);
    const Point_2 p = chart.point(barycentric);
    const auto parts = m_parts[floor_facet];
    const auto corners = [&](std::uint32_t t) { return chart_corners(t, chart); };
    auto part = std::find_if(parts.begin(), parts.end(),
                             [&](auto t) { return internal::contains<GeomTraits>(corners(t), p); });
    if (part == parts.end()) part = parts.begin(); // a weight is negative: extend the map
    const Triangle& t = triangle(*part);
    return combine(internal::weights_in<GeomTraits>(corners(*part), p),
                   {m_images[t[0]], m_images[t[1]], m_images[t[2]]});
  }
  /// returns the image of a point of the floor.
  Point_2 image(const Base_point_3<GeomTraits>& p) const { return image(p.facet, p.barycentric); }

  /// finds the point of the floor with image `p` in about constant time. If `p` is on a side of the domain, then
  /// the weight of the vertex off the rim is exactly 0.
  /// \returns `ERROR_OUTSIDE` if `p` is outside of the domain or in a hole
  Status preimage(const Point_2& p, Base_point_3<GeomTraits>& result) const {
    const Bounded_side side = m_domain.bounded_side(p);
    if (side == ON_BOUNDARY && border_preimage(p, result)) return {};
    const auto is_in = [&](std::uint32_t t) { return internal::contains<GeomTraits>(image_corners(t), p); };
    const std::uint32_t t = side == ON_BOUNDED_SIDE ? m_grid.find(p, is_in) : internal::Refined_surface::none;
    if (t == internal::Refined_surface::none)
      return {ERROR_OUTSIDE, "(" + std::to_string(CGAL::to_double(p.x())) + ", " +
                                 std::to_string(CGAL::to_double(p.y())) + ")"};
    result = combine_corners(t, internal::weights_in<GeomTraits>(image_corners(t), p));
    return {};
  }
  /// @}

private:
  using Corners = std::array<Point_2, 3>;
  using Weights = std::array<FT, 3>;

  // A facet as a triangle of the plane: two of the three weights, without the greatest. A weight of 0 is kept.
  struct Chart {
    int x, y;

    explicit Chart(const Weights& w) {
      const int greatest = int(std::max_element(w.begin(), w.end()) - w.begin());
      x = (greatest + 1) % 3;
      y = (greatest + 2) % 3;
    }
    template <typename Number>
    Point_2 point(const std::array<Number, 3>& w) const {
      return Point_2(w[x], w[y]);
    }
  };

  // An edge of the border, on the line where coordinate `axis` is `plane`.
  struct Border_edge {
    int axis;
    double plane, low, high; // ends in the other coordinate
    std::uint32_t half_edge;
  };

  Corners image_corners(std::uint32_t t) const {
    const Triangle& v = triangle(t);
    return {m_images[v[0]], m_images[v[1]], m_images[v[2]]};
  }

  Corners chart_corners(std::uint32_t t, const Chart& chart) const {
    const auto& w = m_surface.weights(t);
    return {chart.point(w[0]), chart.point(w[1]), chart.point(w[2])};
  }

  // Starts from the nearest corner: a coordinate that all corners of non-zero weight share is kept.
  static Point_2 combine(const Weights& w, const Corners& c) {
    const int n = int(std::max_element(w.begin(), w.end()) - w.begin()), i = (n + 1) % 3, j = (n + 2) % 3;
    return Point_2(c[n].x() + (w[i] * (c[i].x() - c[n].x()) + w[j] * (c[j].x() - c[n].x())),
                   c[n].y() + (w[i] * (c[i].y() - c[n].y()) + w[j] * (c[j].y() - c[n].y())));
  }

  Base_point_3<GeomTraits> combine_corners(std::uint32_t t, const Weights& w) const {
    Base_point_3<GeomTraits> result{parent(t), {FT(0), FT(0), FT(0)}};
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) result.barycentric[k] += w[i] * FT(m_surface.weights(t)[i][k]);
    return result;
  }

  // p lies on a side of the domain, so on an edge of the border, unless it is not a number.
  bool border_preimage(const Point_2& p, Base_point_3<GeomTraits>& result) const {
    const auto is_after = [](const auto& key, const Border_edge& e) {
      return key < std::make_tuple(e.axis, FT(e.plane), FT(e.low));
    };
    for (int axis = 0; axis < 2; ++axis) {
      const FT& along = p[1 - axis];
      auto e =
          std::upper_bound(m_border.begin(), m_border.end(), std::make_tuple(axis, p[axis], along), is_after);
      if (e == m_border.begin()) continue;
      --e;
      if (e->axis != axis || p[axis] != e->plane || !(along <= e->high)) continue;
      const std::uint32_t h = e->half_edge;
      const bool forward = m_images[m_surface.source(h)][1 - axis] == e->low;
      const FT share = (along - e->low) / (FT(e->high) - e->low);
      Weights w = {FT(0), FT(0), FT(0)};
      w[(forward ? h : m_surface.next(h)) % 3] = 1 - share;
      w[(forward ? m_surface.next(h) : h) % 3] = share;
      result = combine_corners(h / 3, w);
      return true;
    }
    return false;
  }

  void set_domain(const internal::Floor_map_builder<GeomTraits>& builder) {
    const std::vector<Rectangle_2>& r = builder.floor.rectangles;
    m_domain = Domain(r[0], std::vector<Rectangle_2>(r.begin() + 1, r.end()), builder.height);
    for (std::size_t rim = 0; rim < r.size(); ++rim) m_domain.set_wall_label(rim, builder.wall_labels[rim]);
  }

  void index_parts(std::size_t number_of_facets) {
    const auto parent_of = [this](std::uint32_t t) { return std::array<Facet_index, 1>{parent(t)}; };
    m_parts = internal::Incidence_lists<Facet_index, std::uint32_t>(number_of_facets, number_of_triangles(),
                                                                    parent_of);
  }

  void index_images() {
    const Rectangle_2& box = m_domain.outer();
    m_grid = internal::Bucket_grid_2(box.xmin, box.ymin, box.xmax, box.ymax, m_surface.triangles(), m_images);
    index_border();
  }

  void index_border() {
    m_border.clear();
    for (std::uint32_t h = 0; h < m_surface.number_of_half_edges(); ++h) {
      if (!m_surface.is_border(h)) continue;
      const Point_2 &p = m_images[m_surface.source(h)], &q = m_images[m_surface.target(h)];
      const int axis = p.x() == q.x() ? 0 : 1;
      const double a = CGAL::to_double(p[1 - axis]), b = CGAL::to_double(q[1 - axis]);
      m_border.push_back({axis, CGAL::to_double(p[axis]), std::min(a, b), std::max(a, b), h});
    }
    std::sort(m_border.begin(), m_border.end(), [](const Border_edge& e, const Border_edge& f) {
      return std::tie(e.axis, e.plane, e.low) < std::tie(f.axis, f.plane, f.low);
    });
  }

  Floor_map_options m_options;
  Domain m_domain;
  internal::Refined_surface m_surface;
  std::vector<Vertex_index> m_mesh_vertices; // of the first vertices of the refined floor
  std::vector<Point_2> m_images;
  internal::Incidence_lists<Facet_index, std::uint32_t> m_parts; // of each facet of the mesh
  internal::Bucket_grid_2 m_grid;
  std::vector<Border_edge> m_border; // sorted by axis, plane and lower end
};

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_FLOOR_MAP_2_H
