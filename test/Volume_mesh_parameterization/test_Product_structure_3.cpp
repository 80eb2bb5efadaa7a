#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Structure = VMP::Product_structure_3<Kernel>;

// Each cell has an entry and an exit; the exit of one is the entry of the other; signs of the boundary are those of
// the labels.
void check_signs(const Mesh& mesh, const Structure& structure) {
  for (VMP::Cell_index c : mesh.cells()) {
    assert(structure.order()[structure.position(c)] == c);
    const auto& signs = structure.signs(c);
    assert(std::count(signs.begin(), signs.end(), 1) > 0 && std::count(signs.begin(), signs.end(), -1) > 0);
    for (int i = 0; i < 4; ++i) {
      const VMP::Half_facet other = mesh.opposite({c, i});
      const int label = mesh.label(c, i);
      if (other.cell.is_valid()) {
        assert(signs[i] == -structure.signs(other.cell)[other.index]);
        assert((signs[i] > 0) == (structure.position(other.cell) < structure.position(c)));
      } else
        assert(signs[i] == (label == VMP::FLOOR ? 1 : label == VMP::CEILING ? -1 : 0));
    }
  }
}

void test_block(Shape shape, int holes, int per_unit, int layers, unsigned seed = 1) {
  const Swept_solid<Kernel> solid(shaped_block<Point>(shape, holes, per_unit, layers, seed));
  assert(solid.structure.order().size() == solid.mesh.number_of_cells());
  const VMP::Status status = VMP::verify_product(solid.mesh, solid.structure.order());
  assert(status.ok());
  check_signs(solid.mesh, solid.structure);
}

// Any priority will do where the partition is legal and prepared, even one that runs against the curves.
void test_priorities() {
  const Swept_solid<Kernel> solid(shaped_block<Point>(Shape::JITTERED, 1, 2, 2));
  const std::vector<double>& potential = solid.potential.values();
  std::vector<double> reversed(potential), constant(potential.size(), 0);
  for (double& p : reversed) p = -p;
  for (const auto& priority : {potential, reversed, constant}) {
    Structure structure;
    VMP::Status status = VMP::sweep(solid.mesh, priority, structure);
    if (status.ok()) status = VMP::verify_product(solid.mesh, structure.order());
    assert(status.ok() || status.code() == VMP::ERROR_SWEEP_STOPPED);
    if (status.ok()) check_signs(solid.mesh, structure);
    std::cout << "priority: " << status.message() << std::endl;
  }
}

// Glues a tetrahedron onto a wall facet without vertices on the rims: three of its facets are on the wall.
Soup with_ear(const Soup& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  const auto is_inside_wall = [&](VMP::Facet_index f) {
    const auto v = mesh.vertices(f);
    return std::all_of(v.begin(), v.end(), [&](VMP::Vertex_index w) {
      const Point& p = mesh.point(w);
      return p.x() == 0 && p.y() > 0 && p.y() < 3 && p.z() > 0 && p.z() < 1;
    });
  };
  const auto facets = mesh.boundary_facets();
  const auto base = std::find_if(facets.begin(), facets.end(), is_inside_wall);
  assert(base != facets.end());
  Soup result = VMP::make_soup(mesh);
  const std::array<std::size_t, 3> v = result.facets[*base].vertices;
  const Point centre = CGAL::centroid(soup.points[v[0]], soup.points[v[1]], soup.points[v[2]]);
  const std::size_t apex = result.points.size();
  result.points.push_back(centre - Kernel::Vector_3(0.1, 0, 0));
  result.cells.push_back({v[0], v[1], v[2], apex});
  result.facets.erase(result.facets.begin() + *base);
  for (int i = 0; i < 3; ++i) result.facets.push_back({{v[i], v[(i + 1) % 3], apex}, VMP::FIRST_WALL});
  return result;
}

// Without preparation no front can pass the ear; with it, all is well.
void test_stopped() {
  const Soup soup = with_ear(Block_with_holes<Point>(0, 2, 3).soup());
  Mesh mesh;
  VMP::Status status = mesh.assign(soup);
  if (status.ok()) status = VMP::check_tetrahedral_mesh(mesh);
  VMP::Dual_potential_3<Mesh> potential(mesh);
  if (status.ok()) status = potential.solve();
  assert(status.ok());
  Structure structure;
  status = VMP::sweep(mesh, potential.values(), structure);
  std::cout << status.message() << std::endl;
  assert(status.code() == VMP::ERROR_SWEEP_STOPPED && structure.order().empty());
  assert(status.detail().find("tetrahedra are left, among them ") != std::string::npos);
  assert(std::atoi(status.detail().c_str()) >= 1);

  const Swept_solid<Kernel> prepared(soup);
  assert(VMP::verify_product(prepared.mesh, prepared.structure.order()).ok());
}

// A single tetrahedron with three facets on the wall: nothing can be swept, and the count is known.
void test_count() {
  Soup soup;
  soup.points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)};
  soup.cells = {{0, 1, 2, 3}};
  soup.facets = {{{0, 1, 2}, 1}, {{0, 1, 3}, 3}, {{0, 2, 3}, 3}, {{1, 2, 3}, 3}};
  Mesh mesh;
  VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  Structure structure;
  status = VMP::sweep(mesh, std::vector<double>{0.}, structure);
  assert(status.code() == VMP::ERROR_SWEEP_STOPPED &&
         status.detail() == "1 tetrahedra are left, among them 0");
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) {
    for (Shape shape : {Shape::PLAIN, Shape::JITTERED, Shape::BENT, Shape::TWISTED})
      test_block(shape, holes, 3, 3);
    for (int per_unit = 1; per_unit <= 2; ++per_unit)
      for (int layers = 1; layers <= 4; ++layers) test_block(Shape::PLAIN, holes, per_unit, layers);
    for (unsigned seed = 2; seed < 6; ++seed) test_block(Shape::JITTERED, holes, 2, 2, seed);
  }
  test_priorities();
  test_stopped();
  test_count();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
