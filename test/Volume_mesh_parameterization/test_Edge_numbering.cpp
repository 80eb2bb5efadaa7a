#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Edge_numbering.h>
#include <CGAL/Volume_mesh_parameterization/internal/Vertex_stars.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <set>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using VMP::internal::Edge_numbering;
using VMP::internal::Edge_stars;
using VMP::internal::Vertex_stars;

void test_edges_of_cells(const Mesh& mesh, const Edge_numbering& edges) {
  std::set<Edge_numbering::Ends> expected;
  for (VMP::Cell_index c : mesh.cells())
    for (int k = 0; k < 6; ++k) {
      const VMP::Vertex_index v = mesh.vertex(c, Mesh::edge_vertices[k][0]),
                              w = mesh.vertex(c, Mesh::edge_vertices[k][1]);
      const Edge_numbering::Ends& ends = edges.ends(edges.edge(c, k));
      assert(ends[0] == std::min(v, w) && ends[1] == std::max(v, w));
      assert(edges.find(v, w) == edges.edge(c, k) && edges.find(w, v) == edges.edge(c, k));
      expected.insert(ends);
    }
  assert(expected.size() == edges.number_of_edges());
  auto in_order = expected.begin();
  for (VMP::Edge_index e : edges.edges()) assert(edges.ends(e) == *in_order++);
}

void test_find_misses(const Mesh& mesh, const Edge_numbering& edges) {
  std::size_t found = 0;
  for (VMP::Vertex_index v : mesh.vertices())
    for (VMP::Vertex_index w : mesh.vertices()) found += edges.find(v, w).is_valid();
  assert(found == 2 * edges.number_of_edges());
}

template <typename Star, typename Incident>
void test_star(const Mesh& mesh, const Star& star, const Incident& is_incident) {
  assert(std::is_sorted(star.begin(), star.end()));
  for (VMP::Cell_index c : mesh.cells())
    assert(is_incident(c) == std::binary_search(star.begin(), star.end(), c));
}

// Numbers are given in blocks of vertices, maybe by several threads.
void test_blocks() {
  Mesh mesh;
  const VMP::Status status =
      mesh.assign<CGAL::Parallel_if_available_tag>(Block_with_holes<Kernel::Point_3>(1, 13, 13).soup());
  assert(status.ok() && mesh.number_of_vertices() > 2 * 8192);
  Edge_numbering edges(mesh, CGAL::Parallel_if_available_tag());
  test_edges_of_cells(mesh, edges);
  const Edge_numbering::Ends last = edges.ends(VMP::Edge_index(edges.number_of_edges() - 1));
  edges.forget_cells();
  assert(edges.number_of_cells() == 0 && edges.find(last[0], last[1]) + 1 == edges.number_of_edges());
}

int main() {
  test_blocks();
  Mesh mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Kernel::Point_3>(1, 2, 2).soup());
  assert(status.ok());
  const Edge_numbering edges(mesh);
  test_edges_of_cells(mesh, edges);
  test_find_misses(mesh, edges);
  const Edge_stars edge_stars(edges);
  for (VMP::Edge_index e : edges.edges())
    test_star(mesh, edge_stars.cells(e), [&](VMP::Cell_index c) {
      return mesh.index(c, edges.ends(e)[0]) >= 0 && mesh.index(c, edges.ends(e)[1]) >= 0;
    });
  const Vertex_stars vertex_stars(mesh);
  for (VMP::Vertex_index v : mesh.vertices())
    test_star(mesh, vertex_stars.cells(v), [&](VMP::Cell_index c) { return mesh.index(c, v) >= 0; });
  const Edge_numbering none{Mesh()};
  assert(none.number_of_edges() == 0 && Edge_numbering().number_of_edges() == 0);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
