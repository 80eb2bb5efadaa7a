// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_PREPARE_PATCHES_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_PREPARE_PATCHES_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Splittable_mesh.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationMesh

counts the simplices that `prepare_patches()` split.
*/
struct Preparation {
  std::size_t boundary_edges = 0; ///< edges of the boundary between two places of another patch
  std::size_t interior_edges = 0; ///< edges through the solid that join a patch to itself, or floor and ceiling
  std::size_t facets = 0;         ///< facets through the solid with all vertices in one patch
};

namespace internal {

// Which of floor, ceiling and walls each vertex and each boundary edge belongs to, as bits.
template <typename GeomTraits>
class Patch_memberships {
public:
  enum : unsigned { ON_FLOOR = 1, ON_CEILING = 2, ON_WALLS = 4 };
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;

  explicit Patch_memberships(const Mesh& mesh) : m_vertices(mesh.number_of_vertices(), 0) {
    for (Facet_index f : mesh.boundary_facets()) {
      const auto v = mesh.vertices(f);
      const unsigned bit = membership(mesh.label(f));
      for (int i = 0; i < 3; ++i) {
        m_vertices[v[i]] |= bit;
        m_edges.push_back({key(v[i], v[(i + 1) % 3]), bit});
      }
    }
    unite_equal_edges();
  }

  static unsigned membership(int label) {
    return label == FLOOR ? ON_FLOOR : label == CEILING ? ON_CEILING : label >= FIRST_WALL ? ON_WALLS : 0u;
  }

  unsigned of(Vertex_index v) const { return m_vertices[v]; }

  // 0 for an edge in the interior
  unsigned of(Vertex_index a, Vertex_index b) const {
    const std::uint64_t k = key(a, b);
    const auto found = std::lower_bound(m_edges.begin(), m_edges.end(), Edge{k, 0u});
    return found != m_edges.end() && found->first == k ? found->second : 0u;
  }

private:
  using Edge = std::pair<std::uint64_t, unsigned>;

  static std::uint64_t key(Vertex_index a, Vertex_index b) {
    return (std::uint64_t(std::min<std::uint32_t>(a, b)) << 32) | std::max<std::uint32_t>(a, b);
  }

  void unite_equal_edges() {
    std::sort(m_edges.begin(), m_edges.end());
    std::size_t n = 0;
    for (const Edge& e : m_edges)
      if (n > 0 && m_edges[n - 1].first == e.first)
        m_edges[n - 1].second |= e.second;
      else
        m_edges[n++] = e;
    m_edges.resize(n);
  }

  std::vector<unsigned> m_vertices;
  std::vector<Edge> m_edges; // sorted
};

template <typename ConcurrencyTag, typename GeomTraits>
class Patch_preparation {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;
  using Simplex = std::vector<Vertex_index>;

  explicit Patch_preparation(Mesh& mesh) : m_mesh(mesh) {}

  Status run(Preparation& counts) {
    Status status = split_all(&Patch_preparation::boundary_edges, counts.boundary_edges);
    if (status.ok()) status = split_all(&Patch_preparation::interior_edges, counts.interior_edges);
    if (status.ok()) status = split_all(&Patch_preparation::facets, counts.facets);
    return status;
  }

private:
  using Memberships = Patch_memberships<GeomTraits>;

  // A split of one simplex of the list leaves the others in the mesh.
  Status split_all(std::vector<Simplex> (Patch_preparation::*find)(const Memberships&) const, std::size_t& count) {
    std::vector<Simplex> simplices = (this->*find)(Memberships(m_mesh));
    count = simplices.size();
    if (simplices.empty()) return {};
    // better shapes, and an order that does not depend on how the vertices are numbered
    sort_longest_first(simplices, [this](Vertex_index v) { return approximate(m_mesh.point(v)); });
    Splittable_mesh<GeomTraits> splittable(m_mesh);
    for (const Simplex& s : simplices) {
      const Status status = splittable.insert_barycentre(s);
      if (!status.ok()) return status;
    }
    return std::move(splittable).template write_to<ConcurrencyTag>(m_mesh);
  }

  template <typename Predicate>
  std::vector<Simplex> edges(Predicate is_wanted) const {
    const Index_blocks blocks(m_mesh.number_of_cells(), 1 << 16);
    std::vector<std::vector<Simplex>> found(blocks.size());
    const auto search = [&](std::size_t block) {
      for (std::size_t c : blocks[block])
        for (const auto& e : Mesh::edge_vertices) {
          const Vertex_index a = m_mesh.cell(c)[e[0]], b = m_mesh.cell(c)[e[1]];
          if (is_wanted(a, b)) found[block].push_back({std::min(a, b), std::max(a, b)});
        }
    };
    for_each_index<ConcurrencyTag>(found.size(), search, 1);
    std::vector<Simplex> result;
    for (const std::vector<Simplex>& part : found) result.insert(result.end(), part.begin(), part.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<Simplex> boundary_edges(const Memberships& patches) const {
    return edges([&](Vertex_index a, Vertex_index b) {
      const unsigned common = patches.of(a) & patches.of(b);
      if (common == 0) return false; // spares most searches
      const unsigned edge = patches.of(a, b);
      return edge != 0 && (common & ~edge) != 0;
    });
  }

  std::vector<Simplex> interior_edges(const Memberships& patches) const {
    const unsigned bases = Memberships::ON_FLOOR | Memberships::ON_CEILING;
    return edges([&](Vertex_index a, Vertex_index b) {
      const unsigned common = patches.of(a) & patches.of(b), either = patches.of(a) | patches.of(b);
      return (common != 0 || (either & bases) == bases) && patches.of(a, b) == 0;
    });
  }

  std::vector<Simplex> facets(const Memberships& patches) const {
    std::vector<Simplex> result;
    for (Facet_index f : m_mesh.facets()) {
      const auto v = m_mesh.vertices(f);
      const unsigned common = patches.of(v[0]) & patches.of(v[1]) & patches.of(v[2]);
      if ((common & ~Memberships::membership(m_mesh.label(f))) != 0) result.push_back({v[0], v[1], v[2]});
    }
    return result;
  }

  Mesh& m_mesh;
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationMesh

refines `mesh` until every cell meets each of floor, ceiling and the union of the walls in nothing or in exactly one
face: a vertex, an edge or a facet.

That is what the sweep needs: a cell with three facets on walls could never be swept, and a cell that touches a patch
without having a facet in it makes pockets. An edge or a facet whose vertices all lie in one patch without the simplex itself
lying there gets its barycentre inserted, edges first, and so do interior edges that join floor and ceiling. Then a
cell with all four vertices in one patch does not exist: its facets would all lie in that patch, and the cell would be
the whole mesh. Labels are kept; points of the boundary are only added, on its edges and facets.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`

\param mesh a mesh whose partition `validate_partition()` accepts
\param[out] counts how many simplices were split
\returns `ERROR_CANNOT_SPLIT` if a barycentre rounds to a place where a cell would not be positive; then `mesh` may be refined
in part

Complexity: \f$ O(n \log n) \f$.
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits>
Status prepare_patches(Compact_tetrahedral_mesh_3<GeomTraits>& mesh, Preparation& counts) {
  return internal::Patch_preparation<ConcurrencyTag, GeomTraits>(mesh).run(counts);
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_PREPARE_PATCHES_H
