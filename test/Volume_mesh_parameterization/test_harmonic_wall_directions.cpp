#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Floor_map_2.h>
#include <CGAL/Volume_mesh_parameterization/internal/harmonic_wall_directions.h>

#include "test_util.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Point_3 = Kernel::Point_3;

Mesh make_mesh(int holes, int m, int layers) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Point_3>(holes, m, layers).soup());
  assert(status.ok());
  return mesh;
}

// The base is 1 x 3.
double arc(const Point_3& p) {
  if (p.y() == 0) return p.x();
  if (p.x() == 1) return 1 + p.y();
  return p.y() == 3 ? 5 - p.x() : 8 - p.y();
}

// Each level of the wall is turned against that below; `along` maps its length to itself.
template <typename Along>
std::vector<VMP::internal::Double_kernel::Point_3> picture_of(const Mesh& mesh, double twist,
                                                              const Along& along) {
  std::vector<VMP::internal::Double_kernel::Point_3> picture;
  for (const Point_3& p : mesh.points()) {
    const double a = along(arc(p)) + twist * p.z(), s = a - 8 * std::floor(a / 8);
    if (s <= 1)
      picture.emplace_back(s, 0, p.z());
    else if (s <= 4)
      picture.emplace_back(1, s - 1, p.z());
    else if (s <= 5)
      picture.emplace_back(5 - s, 3, p.z());
    else
      picture.emplace_back(0, 8 - s, p.z());
  }
  return picture;
}

// The angles of the straight wall come back, whatever the twist, even and uneven.
void test_twist() {
  const Mesh mesh = make_mesh(0, 4, 6);
  const VMP::internal::Labelled_surface surface(mesh);
  VMP::internal::Prism_wall wall;
  wall.label = VMP::FIRST_WALL;
  wall.corners = {{{0, 0}, {1, 0}, {1, 3}, {0, 3}}};
  const auto identity = [](double a) { return a; };
  for (double twist : {0., 1., -3., 9.})
    for (double evenness : {0., .5, 1.}) {
      const auto directions = VMP::internal::harmonic_wall_directions(
          surface, {wall}, picture_of(mesh, twist, identity), evenness);
      for (VMP::Facet_index f : mesh.boundary_facets())
        for (VMP::Vertex_index v : mesh.vertices(f)) {
          if (mesh.label(f) != VMP::FIRST_WALL) continue;
          const auto expected = wall.direction(mesh.point(v).x(), mesh.point(v).y());
          assert(CGAL::squared_distance(directions[v], expected) < 1e-4);
        }
    }
}

// Walls without vertices of their own: chords are bisected, and the boundary is mapped one to one.
void test_thin_walls(int holes) {
  const Mesh mesh = make_mesh(holes, 2, 1);
  VMP::Floor_map_2<Kernel> floor_map;
  assert(floor_map.build(mesh).ok());
  std::map<std::pair<double, double>, Kernel::Point_2> below;
  for (std::size_t v = 0; v < floor_map.number_of_vertices(); ++v)
    if (floor_map.mesh_vertex(v).is_valid()) {
      const Point_3& p = mesh.point(floor_map.mesh_vertex(v));
      below[{p.x(), p.y()}] = floor_map.image(v);
    }
  std::vector<Point_3> images;
  for (const Point_3& p : mesh.points()) {
    const Kernel::Point_2& q = below.at({p.x(), p.y()});
    images.emplace_back(q.x(), q.y(), p.z() * floor_map.domain().height());
  }
  VMP::Boundary_images_3<Kernel> boundary;
  const VMP::Status status = floor_map.map_boundary(mesh, images, boundary);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok() && boundary.energy < 4 + 1e-6 && !boundary.bisected_edges.empty());
}

int main() {
  test_twist();
  for (int holes : {1, 2}) test_thin_walls(holes);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
