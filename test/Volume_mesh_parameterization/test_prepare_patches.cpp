#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>

#include "test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>
#include <set>

namespace VMP = CGAL::Volume_mesh_parameterization;

// The faces of a patch by brute force, as sets of sorted vertex lists.
template <typename Mesh>
std::set<std::vector<std::size_t>> faces_of(const Mesh& mesh, int label) {
  std::set<std::vector<std::size_t>> faces;
  for (const VMP::Labelled_facet& f : mesh.labelled_facets()) {
    if (std::min(f.label, int(VMP::FIRST_WALL)) != label) continue;
    for (unsigned subset = 1; subset < 8; ++subset) {
      std::vector<std::size_t> face;
      for (int i = 0; i < 3; ++i)
        if (subset >> i & 1) face.push_back(f.vertices[i]);
      std::sort(face.begin(), face.end());
      faces.insert(face);
    }
  }
  return faces;
}

template <typename Mesh>
bool meets_patch_in_one_face(const Mesh& mesh, VMP::Cell_index c, const std::set<std::vector<std::size_t>>& faces) {
  std::vector<std::size_t> common;
  for (VMP::Vertex_index v : mesh.cell(c))
    if (faces.count({v})) common.push_back(v);
  std::sort(common.begin(), common.end());
  return common.empty() || faces.count(common) != 0;
}

template <typename Mesh>
typename Mesh::FT volume(const Mesh& mesh) {
  typename Mesh::FT sum(0);
  for (VMP::Cell_index c : mesh.cells())
    sum += CGAL::volume(mesh.point(mesh.vertex(c, 0)), mesh.point(mesh.vertex(c, 1)), mesh.point(mesh.vertex(c, 2)),
                        mesh.point(mesh.vertex(c, 3)));
  return sum;
}

template <typename Kernel>
void test(int holes, int per_unit, int layers) {
  using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
  const Block_with_holes<typename Kernel::Point_3> block(holes, per_unit, layers);
  Mesh mesh;
  VMP::Status status = mesh.assign(block.soup());
  assert(status.ok());
  const auto volume_before = volume(mesh);
  VMP::Preparation counts;
  status = VMP::prepare_patches(mesh, counts);
  assert(status.ok());

  for (int label : {VMP::FLOOR, VMP::CEILING, VMP::FIRST_WALL}) {
    const auto faces = faces_of(mesh, label);
    for (VMP::Cell_index c : mesh.cells()) assert(meets_patch_in_one_face(mesh, c, faces));
  }
  for (VMP::Cell_index c : mesh.cells())
    assert(CGAL::orientation(mesh.point(mesh.vertex(c, 0)), mesh.point(mesh.vertex(c, 1)), mesh.point(mesh.vertex(c, 2)),
                             mesh.point(mesh.vertex(c, 3))) == CGAL::POSITIVE);
  assert(CGAL::abs(CGAL::to_double(volume(mesh) - volume_before)) < 1e-12);
  for (const VMP::Labelled_facet& f : mesh.labelled_facets())
    for (std::size_t v : f.vertices) {
      const auto& p = mesh.point(v);
      assert(f.label != VMP::FLOOR || p.z() == 0);
      assert(f.label != VMP::CEILING || p.z() == 1);
    }

  VMP::Preparation again;
  status = VMP::prepare_patches(mesh, again);
  assert(status.ok());
  assert(again.boundary_edges + again.interior_edges + again.facets == 0);
  std::cout << holes << " holes: " << counts.boundary_edges << " boundary edges, " << counts.interior_edges
            << " interior edges, " << counts.facets << " facets -> " << mesh.number_of_cells() << " cells\n";
}

// Three consecutive doubles leave no room for the centre of a cell between them.
void test_refusal() {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const double next = std::nextafter(1., 2.);
  VMP::Tetrahedron_soup_3<Kernel::Point_3> soup;
  soup.points = {{1, 1, 1}, {next, 1, 1}, {1, next, 1}, {1, 1, next}};
  soup.cells = {{0, 1, 2, 3}};
  soup.facets = {{{1, 2, 3}, VMP::FLOOR}, {{0, 2, 3}, VMP::CEILING}, {{0, 1, 3}, 3}, {{0, 1, 2}, 3}};
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  VMP::Preparation counts;
  status = VMP::prepare_patches(mesh, counts);
  assert(status.code() == VMP::ERROR_CANNOT_SPLIT);
  assert(mesh.number_of_cells() == 1);
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) {
    test<CGAL::Exact_predicates_inexact_constructions_kernel>(holes, 1, 1);
    test<CGAL::Exact_predicates_inexact_constructions_kernel>(holes, 2, 3);
  }
  test<CGAL::Exact_predicates_exact_constructions_kernel>(1, 1, 1);
  test_refusal();
  return EXIT_SUCCESS;
}
