#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/handlebody_certificate.h>

#include "test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Kernel::Point_3>;

Mesh make_mesh(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

// A word is reduced, and the class of a loop in homology is how often each generator occurs.
std::vector<int> homology(const VMP::Handlebody_certificate& certificate,
                          const std::vector<VMP::Vertex_index>& loop) {
  std::vector<int> result(certificate.genus(), 0);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const VMP::Vertex_index v = loop[i], w = loop[(i + 1) % loop.size()];
    int last = 0;
    for (int letter : certificate.word(certificate.edges().find(v, w))) {
      assert(letter != 0 && letter != -last && std::abs(letter) <= certificate.genus());
      result[std::abs(letter) - 1] += (letter > 0) == (v < w) ? 1 : -1;
      last = letter;
    }
  }
  return result;
}

void test_block(int holes) {
  const Mesh mesh = make_mesh(Block_with_holes<Kernel::Point_3>(holes, 2, 3).soup());
  VMP::Handlebody_certificate certificate;
  const VMP::Status status = VMP::certify_handlebody(mesh, certificate);
  assert(status.ok());
  assert(certificate.genus() == holes);
  assert(holes > 0 ? certificate.longest_word() > 0 : certificate.longest_word() == 0);
  for (VMP::Facet_index f : mesh.facets()) {
    const auto v = mesh.vertices(f);
    for (int n : homology(certificate, {v[0], v[1], v[2]})) assert(n == 0);
  }
}

// In the solid torus a loop around the hole is a generator.
void test_loop_around_hole() {
  const Mesh mesh = make_mesh(Block_with_holes<Kernel::Point_3>(1, 1, 1).soup());
  VMP::Handlebody_certificate certificate;
  const VMP::Status status = VMP::certify_handlebody(mesh, certificate);
  assert(status.ok());
  std::vector<VMP::Vertex_index> loop;
  for (const auto& corner : {std::array<int, 2>{1, 1}, {2, 1}, {2, 2}, {1, 2}})
    for (VMP::Vertex_index v : mesh.vertices())
      if (mesh.point(v) == Kernel::Point_3(corner[0], corner[1], 0)) loop.push_back(v);
  assert(loop.size() == 4);
  assert(std::abs(homology(certificate, loop)[0]) == 1);
}

VMP::Error_code code_of(const Soup& soup) {
  VMP::Handlebody_certificate certificate;
  return VMP::certify_handlebody(make_mesh(soup), certificate).code();
}

void test_cavity() {
  Soup soup = Block_with_holes<Kernel::Point_3>(0, 3, 3).soup();
  const auto is_in_cavity = [&](const std::array<std::size_t, 4>& cell) {
    const Kernel::Point_3 c = CGAL::centroid(soup.points[cell[0]], soup.points[cell[1]], soup.points[cell[2]],
                                             soup.points[cell[3]]);
    return 3 * c.x() > 1 && 3 * c.x() < 2 && 3 * c.y() > 4 && 3 * c.y() < 5 && 3 * c.z() > 1 && 3 * c.z() < 2;
  };
  soup.facets.clear();
  assert(code_of(soup) == VMP::OK);
  soup.cells.erase(std::remove_if(soup.cells.begin(), soup.cells.end(), is_in_cavity), soup.cells.end());
  assert(code_of(soup) == VMP::ERROR_NOT_A_HANDLEBODY);
}

void test_two_components() {
  const Soup one = Block_with_holes<Kernel::Point_3>(1, 1, 1).soup();
  Soup two = one;
  for (const auto& p : one.points) two.points.push_back(p + Kernel::Vector_3(10, 0, 0));
  for (auto c : one.cells) {
    for (std::size_t& v : c) v += one.points.size();
    two.cells.push_back(c);
  }
  assert(code_of(two) == VMP::ERROR_NOT_A_HANDLEBODY);
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) test_block(holes);
  test_loop_around_hole();
  test_cavity();
  test_two_components();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
