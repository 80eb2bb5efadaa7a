// Maps a tetrahedral mesh of the user's own type: all it needs are the type and the functions of the concept TetrahedralMesh_3.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// A twisted bar of cubes, each cut into six tetrahedra. Nothing is stored, all is computed from numbers.
class Twisted_bar {
public:
  // 1. Say what a point is.
  using Point_3 = Kernel::Point_3;

  // 2. Number vertices and cells from 0.
  std::size_t number_of_vertices() const { return points * points * (height + 1); }
  std::size_t number_of_cells() const { return 6 * width * width * height; }

  // 3. Give the position of a vertex.
  Point_3 point(std::size_t vertex) const {
    const double x = double(vertex % points), y = double(vertex / points % points),
                 z = double(vertex / (points * points));
    const double c = std::cos(z / 5), s = std::sin(z / 5);
    return Point_3(c * x - s * y, s * x + c * y, z);
  }

  // 4. Give the vertices of a cell, positively oriented: the path from a corner of its cube to the opposite one along the
  // axes in one of their six orders.
  std::array<std::size_t, 4> cell(std::size_t c) const {
    constexpr std::size_t along[] = {1, points, points * points};
    const std::size_t cube = c / 6, first = c % 3, second = (first + 1 + c / 3 % 2) % 3;
    const std::size_t corner =
        cube % width + points * (cube / width % width + points * (cube / (width * width)));
    std::array<std::size_t, 4> v = {corner, corner + along[first], corner + along[first] + along[second],
                       corner + along[0] + along[1] + along[2]};
    if (c / 3 % 2 == 1) std::swap(v[2], v[3]); // an odd permutation
    return v;
  }

  // 5. Give the labels of the boundary; there are none.
  std::vector<VMP::Labelled_facet> labelled_facets() const { return {}; }

private:
  static constexpr std::size_t width = 3, height = 8, points = width + 1; // in cubes; along a side
};

int fail(const VMP::Status& status) {
  std::cerr << status.message() << std::endl;
  return EXIT_FAILURE;
}

int main() {
  // 6. Copy the mesh, and let the partition be found: a mesh with labels could go to parameterize() at once.
  const Twisted_bar bar;
  VMP::Compact_tetrahedral_mesh_3<Kernel> mesh;
  VMP::Status status = mesh.assign(bar);
  if (status.ok()) status = VMP::partition_boundary(mesh);
  if (!status.ok()) return fail(status);

  // 7. Parameterize. Vertices keep their numbers.
  VMP::Direct_product_parameterizer_3<Kernel> result;
  status = VMP::parameterize(mesh, result);
  if (!status.ok()) return fail(status);
  const std::size_t last = bar.number_of_vertices() - 1;
  std::cout << bar.number_of_cells() << " cells; vertex " << last << " at " << bar.point(last)
            << " has the parameters " << result.vertex_images()[last] << std::endl;
  return EXIT_SUCCESS;
}
