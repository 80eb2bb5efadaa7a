// Copyright (c) 2026  The Volume_mesh_parameterization authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_VOLUME_MESH_PARAMETERIZATION_SWEEP_WITH_REPAIRS_H
#define CGAL_VOLUME_MESH_PARAMETERIZATION_SWEEP_WITH_REPAIRS_H

#include <CGAL/license/Volume_mesh_parameterization.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Refinable_order.h>
#include <CGAL/Volume_mesh_parameterization/internal/Sweep.h>
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>
#include <CGAL/Volume_mesh_parameterization/internal/geometric_order.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Volume_mesh_parameterization {

/*!
\ingroup PkgVolumeMeshParameterizationStructure

tells what it took to finish a sweep.
*/
struct Sweep_report {
  std::size_t left_at_first = 0;   ///< cells that the first sweep from the floor did not reach
  bool from_ceiling = false;       ///< the sweep was finished from the ceiling alone
  std::size_t restarts = 0;        ///< sweeps from both ends with learned priorities
  std::size_t refinements = 0;     ///< rounds in which the cells that were left were refined
  std::size_t bisected_edges = 0;  ///< edges that these rounds bisected
};

namespace internal {

template <typename ConcurrencyTag, typename GeomTraits, typename Guide>
class Sweep_repair {
public:
  using Mesh = Compact_tetrahedral_mesh_3<GeomTraits>;

  Sweep_repair(Mesh& mesh, const Guide& guide, Sweep_report& report)
      : m_mesh(mesh), m_make_guide(guide), m_report(report) {}

  Status run(std::vector<Cell_index>& order) {
    const std::size_t cells_at_first = m_mesh.number_of_cells();
    Sweep_guide_3 guide;
    Status status = make_guide(guide);
    if (!status.ok()) return status;
    order = from_floor({}, guide);
    m_report.left_at_first = m_mesh.number_of_cells() - order.size();
    if (is_complete(order) || from_ceiling(guide, order) || restart(guide.potential, order)) return {};
    while (m_report.refinements < most_refinements && m_mesh.number_of_cells() < most_growth * cells_at_first) {
      status = refine(order);
      if (status.ok()) status = make_guide(guide);
      if (!status.ok()) return status;
      order = from_floor(order, guide);
      if (is_complete(order)) return {};
    }
    return {ERROR_SWEEP_STOPPED, "after " + std::to_string(m_report.refinements) +
                                     " refinements the number of tetrahedra left is " +
                                     std::to_string(m_mesh.number_of_cells() - order.size()) + ", among them " +
                                     std::to_string(first_left(order))};
  }

private:
  using Tag = Concurrency_for<ConcurrencyTag, typename GeomTraits::FT>;

  // Bounds on the work.
  static constexpr std::size_t most_restarts = 60, most_refinements = 20, most_growth = 4;
  // By how much a cell that was left behind is preferred from then on; the potential runs from 0 to 1.
  static constexpr double lesson = 0.002;

  // Potentials that differ by the rounding of a solver count as equal, and geometry decides. What needs no fields is made at the
  // same time as these.
  Status make_guide(Sweep_guide_3& guide) {
    std::vector<std::uint32_t> ranks;
    const Status status = try_all<Tag>([&] { return m_make_guide(m_mesh, guide); },
                                       [&] {
                                         ranks = geometric_ranks(m_mesh);
                                         m_edges = Edge_numbering(m_mesh, Tag());
                                         return Status();
                                       });
    if (!status.ok()) return status;
    for (double& p : guide.potential) p = std::round(p / rounding_share) * rounding_share;
    guide.ranks = std::move(ranks);
    return {};
  }

  bool is_complete(const std::vector<Cell_index>& order) const { return order.size() == m_mesh.number_of_cells(); }

  std::vector<char> swept_cells(const std::vector<Cell_index>& order) const {
    std::vector<char> is_swept(m_mesh.number_of_cells(), 0);
    for (Cell_index c : order) is_swept[c] = 1;
    return is_swept;
  }

  Cell_index first_left(const std::vector<Cell_index>& order) const {
    const std::vector<char> is_swept = swept_cells(order);
    return Cell_index(std::find(is_swept.begin(), is_swept.end(), 0) - is_swept.begin());
  }

  std::vector<Cell_index> from_floor(const std::vector<Cell_index>& beginning, const Sweep_guide_3& guide) const {
    Sweep<GeomTraits> sweep(m_mesh, m_edges, FLOOR);
    for (Cell_index c : beginning) sweep.sweep(c);
    sweep.template run<Tag>(guide);
    return sweep.order();
  }

  bool from_ceiling(const Sweep_guide_3& guide, std::vector<Cell_index>& order) {
    Sweep<GeomTraits> sweep(m_mesh, m_edges, CEILING);
    sweep.template run<Tag>(guide);
    m_report.from_ceiling = sweep.is_complete();
    if (m_report.from_ceiling) order.assign(sweep.order().rbegin(), sweep.order().rend());
    return m_report.from_ceiling;
  }

  // Sweeps from the floor, then what is left from the ceiling, along the potential alone: the first time as it is, then
  // with what was learned. Cells that were left get an earlier turn, and so do their swept neighbours, half as much.
  // `order` keeps the longest order from the floor.
  bool restart(Sweep_guide_3 guide, std::vector<Cell_index>& order) {
    while (m_report.restarts < most_restarts) {
      ++m_report.restarts;
      Sweep<GeomTraits> up(m_mesh, m_edges, FLOOR), down(m_mesh, m_edges, CEILING);
      up.template run<Tag>(guide);
      for (Cell_index c : up.order()) down.exclude(c);
      down.template run<Tag>(guide);
      if (up.order().size() + down.order().size() == m_mesh.number_of_cells()) {
        order = up.order();
        order.insert(order.end(), down.order().rbegin(), down.order().rend());
        return true;
      }
      if (up.order().size() > order.size()) order = up.order();
      learn(up, guide.potential);
    }
    return false;
  }

  void learn(const Sweep<GeomTraits>& sweep, std::vector<double>& potential) const {
    for (Cell_index c : m_mesh.cells()) {
      if (sweep.is_swept(c)) continue;
      potential[c] -= lesson;
      for (int i = 0; i < 4; ++i) {
        const Cell_index neighbor = m_mesh.neighbor(c, i);
        if (neighbor.is_valid() && sweep.is_swept(neighbor)) potential[neighbor] -= lesson / 2;
      }
    }
  }

  // Bisects all edges of the cells that are left, the longest first.
  Status refine(std::vector<Cell_index>& order) {
    ++m_report.refinements;
    Refinable_order<GeomTraits> refinable(m_mesh, order);
    for (const auto& edge : edges_of_cells_left(order)) {
      const Status status = refinable.insert_barycentre({edge[0], edge[1]});
      if (!status.ok() && status.code() != ERROR_CANNOT_SPLIT) return status;
      m_report.bisected_edges += status.ok();
    }
    return std::move(refinable).write_to(m_mesh, order);
  }

  std::vector<Edge_numbering::Ends> edges_of_cells_left(const std::vector<Cell_index>& order) const {
    const std::vector<char> is_swept = swept_cells(order);
    std::vector<Edge_index> edges;
    for (Cell_index c : m_mesh.cells())
      if (!is_swept[c])
        for (Edge_index e : m_edges.edges(c)) edges.push_back(e);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<Edge_numbering::Ends> result;
    for (Edge_index e : edges) result.push_back(m_edges.ends(e));
    sort_longest_first(result, [this](Vertex_index v) { return approximate(m_mesh.point(v)); });
    return result;
  }

  Mesh& m_mesh;
  const Guide& m_make_guide;
  Sweep_report& m_report;
  Edge_numbering m_edges; // of the mesh as the guide knows it
};

} // namespace internal

/*!
\ingroup PkgVolumeMeshParameterizationStructure

sweeps the cells of `mesh` from the floor to the ceiling, whatever it takes within fixed bounds: from the floor; if that
stops, from the ceiling; then from both ends along the potential alone, with learned priorities; then by bisecting the
edges of the cells that are left and going on, which keeps what is swept.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`; the result does not depend on it
\tparam GeomTraits a model of `VolumeParameterizationTraits_3`
\tparam Guide the type of `guide`

\param mesh a mesh with a legal partition, prepared by `prepare_patches()`; refined only if needed
\param guide a function object `Status guide(const Mesh& mesh, Sweep_guide_3& result)`; it is called again after each
refinement
\param[out] structure the result; unchanged on failure
\param[out] report what it took
\returns `ERROR_SWEEP_STOPPED` with the number of cells that are left and one of them, or the failure of `guide`

Complexity: \f$ O(n \log n) \f$ without repairs; at most 62 times that, and 20 refinements.
*/
template <typename ConcurrencyTag = Sequential_tag, typename GeomTraits, typename Guide>
Status sweep_with_repairs(Compact_tetrahedral_mesh_3<GeomTraits>& mesh, const Guide& guide,
                          Product_structure_3<GeomTraits>& structure, Sweep_report& report) {
  std::vector<Cell_index> order;
  report = Sweep_report();
  const Status status = internal::Sweep_repair<ConcurrencyTag, GeomTraits, Guide>(mesh, guide, report).run(order);
  if (status.ok()) structure = {mesh, std::move(order)};
  return status;
}

} // namespace Volume_mesh_parameterization
} // namespace CGAL

#endif // CGAL_VOLUME_MESH_PARAMETERIZATION_SWEEP_WITH_REPAIRS_H
