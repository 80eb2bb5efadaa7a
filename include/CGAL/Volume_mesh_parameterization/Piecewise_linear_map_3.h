// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PIECEWISE_LINEAR_MAP_3_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PIECEWISE_LINEAR_MAP_3_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Boundary_images_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/Untangling_report.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refined_places.h>
#include <CGAL/Volume_mesh_parameterization/internal/Untangler.h>
#include <CGAL/Volume_mesh_parameterization/parameters.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMap

is a piecewise linear bijection from a solid to a domain: linear on each tetrahedron of a refined mesh, none of which is
flipped or flat, the boundary exactly on that of the domain. `make_piecewise_linear()` computes it.

The refined mesh has a sweep order too: bisecting an edge keeps an order legal.

\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
*/
template <typename GeomTraits>
class Piecewise_linear_map_3 {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>; ///< the type of the refined solid
  using Point_3 = typename GeomTraits::Point_3;        ///< the point type

  /*!
  computes the map.

  The boundary is mapped as given; if it may slide, vertices inside of the walls and of the ceiling move in their planes where
  tetrahedra resist. The interior starts from the better of two maps, the harmonic one and that along curves, and is untangled
  cluster by cluster with the energy of V. Garanzha et al., *Foldover-free maps in 50 lines of code*, 2021. Where tetrahedra
  resist, a ball around them is mapped anew, cell by cell from its boundary inwards, if its image is star-shaped; else their
  edges are bisected. Then what is badly distorted is relaxed.

  \param mesh a solid with a product structure
  \param order the order in which its cells are swept
  \param boundary a map of its boundary that is one to one
  \param curve_images the images of the vertices along curves
  \param visitor has the functions of `Default_parameterization_visitor`

  \returns `ERROR_MAP_NOT_BIJECTIVE` with the number of tetrahedra that resisted and one of them, `ERROR_CANNOT_SPLIT`,
  `ERROR_CANCELLED`; then only `report()` is of use

  Complexity: a sparse system for the harmonic map; then near linear in the number of flipped tetrahedra. What makes no
  progress is given up.
  */
  template <typename Visitor>
  Status build(const Mesh& mesh, const std::vector<Cell_index>& order,
               const Boundary_images_3<GeomTraits>& boundary, const std::vector<Point_3>& curve_images,
               Visitor& visitor) {
    *this = Piecewise_linear_map_3();
    internal::Interior_mapper<GeomTraits> mapper(mesh, order);
    Status status = map_boundary(boundary, mapper);
    if (status.ok()) start(curve_images, mapper);
    if (status.ok() && boundary.may_slide) mapper.release_boundary();
    internal::Untangler<GeomTraits, Visitor> untangler(mapper, visitor, m_report);
    if (status.ok()) status = untangler.run();
    if (status.ok()) status = untangler.polish();
    return status.ok() ? take(mapper) : status;
  }

  /// \name Results
  /// @{

  /// returns whether there is a map: then it is bijective.
  bool is_valid() const { return !m_images.empty(); }
  /// returns the refined mesh. Its first vertices are those of the mesh that it was made of, the others barycentres of
  /// simplices that were split: the last ones of `Compact_tetrahedral_mesh_3::split_simplices()`.
  const Mesh& mesh() const { return m_mesh; }
  /// returns the cells of `mesh()` in the order of a sweep.
  const std::vector<Cell_index>& order() const { return m_order; }
  /// returns the images of the vertices of `mesh()`.
  const std::vector<Point_3>& images() const { return m_images; }
  /// returns what it took, even if there is no map.
  const Untangling_report& report() const { return m_report; }

  /// returns the place of each vertex of `mesh()` in the mesh that it was made of, `original`.
  /// \pre `is_valid()`
  std::vector<Location_3<GeomTraits>> locations(const Mesh& original) const {
    const internal::Refined_places<GeomTraits> places(original, m_mesh);
    std::vector<Location_3<GeomTraits>> result;
    for (Vertex_index v : m_mesh.vertices()) result.push_back(places.location(v));
    return result;
  }

  /// returns the cell of the mesh that it was made of, `original`, which each cell of `mesh()` is a part of.
  /// \pre `is_valid()`
  std::vector<Cell_index> origins(const Mesh& original) const {
    const internal::Refined_places<GeomTraits> places(original, m_mesh);
    std::vector<Cell_index> result;
    for (Cell_index c : m_mesh.cells()) result.push_back(places.origin(m_mesh.cell(c)));
    return result;
  }

  /// @}

private:
  using Position = typename internal::Interior_mapper<GeomTraits>::Position;

  static Position position(const Point_3& p) {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  static Status map_boundary(const Boundary_images_3<GeomTraits>& boundary,
                             internal::Interior_mapper<GeomTraits>& mapper) {
    Status status;
    for (const auto& [v, w] : boundary.bisected_edges)
      if (status.ok()) status = mapper.bisect(v, w);
    for (std::size_t v = 0; status.ok() && v < boundary.images.size(); ++v)
      if (!mapper.is_inside(v)) mapper.set_image(v, position(boundary.images[v]));
    return status;
  }

  // With fewer flipped tetrahedra; along curves if the harmonic map cannot be computed.
  void start(const std::vector<Point_3>& curve_images, internal::Interior_mapper<GeomTraits>& mapper) {
    for (std::size_t v = 0; v < curve_images.size(); ++v)
      if (mapper.is_inside(v)) mapper.set_image(v, position(curve_images[v]));
    const std::size_t flipped_along_curves = mapper.find_flipped().size();
    const std::vector<Position> along_curves = mapper.images();
    m_report.starts_along_curves =
        !mapper.start_harmonically() || flipped_along_curves < mapper.find_flipped().size();
    for (std::size_t v = 0; m_report.starts_along_curves && v < along_curves.size(); ++v)
      mapper.set_image(v, along_curves[v]);
  }

  // By exact signs of the numbers as they are.
  Status take(internal::Interior_mapper<GeomTraits>& mapper) {
    std::vector<Point_3> images;
    for (const Position& p : mapper.images()) images.emplace_back(p[0], p[1], p[2]);
    Status status = std::move(mapper).write_to(m_mesh, m_order);
    if (status.ok()) status = verify_map(m_mesh, images).status;
    if (status.ok()) m_images = std::move(images);
    return status;
  }

  Mesh m_mesh;
  std::vector<Cell_index> m_order;
  std::vector<Point_3> m_images;
  Untangling_report m_report;
};

namespace internal {

template <typename Parameterizer, typename GeomTraits, typename Visitor>
Status untangle(const Parameterizer& solid, const Boundary_images_3<GeomTraits>& boundary, Visitor& visitor,
                Piecewise_linear_map_3<GeomTraits>& result) {
  return run_stage(visitor, "untangle", [&] {
    return result.build(solid.mesh(), solid.product_structure()->order(), boundary, solid.vertex_images(), visitor);
  });
}

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationMap

computes a piecewise linear bijection from a solid that has been parameterized to its domain. The floor map of `solid` may be
improved on the way, and the planes of a prism with it, so that both maps have the same domain and the same floor.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
\tparam Parameterizer an instance of `Direct_product_parameterizer_3`
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam NamedParameters a sequence of named parameters
\param solid has been parameterized with success
\param result receives the map
\param np an optional sequence of named parameters: `visitor` of `parameterize()`

\returns `ERROR_BOUNDARY_MAP` if the boundary could not be mapped one to one: then `solid` is as before; the errors of
`Piecewise_linear_map_3::build()`
*/
template <typename ConcurrencyTag = Sequential_tag, typename Parameterizer, typename GeomTraits,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Status make_piecewise_linear(Parameterizer& solid, Piecewise_linear_map_3<GeomTraits>& result,
                             const NamedParameters& np = CGAL::parameters::default_values()) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  auto visitor =
      choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_parameterization_visitor());
  Boundary_images_3<GeomTraits> boundary;
  Status status = internal::run_stage(visitor, "map the boundary",
                                      [&] { return solid.template map_boundary<ConcurrencyTag>(boundary); });
  return status.ok() ? internal::untangle(solid, boundary, visitor, result) : status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PIECEWISE_LINEAR_MAP_3_H
