#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/internal/Ball_refiller.h>
#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "test_util.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Mapper = VMP::internal::Interior_mapper<Kernel>;
using Position = Mapper::Position;

const Position middle(.5, .5, .5);

struct Block {
  // length x 1 x 1
  explicit Block(int per_unit, int length = 1) {
    VMP::Preparation counts;
    VMP::Status status =
        mesh.assign(Block_with_holes<Kernel::Point_3>({0, 0, length, 1}, {}, per_unit, per_unit).soup());
    if (status.ok()) status = VMP::prepare_patches(mesh, counts);
    assert(status.ok());
    VMP::Dual_potential_3<Mesh> dual(mesh);
    status = dual.solve();
    VMP::Product_structure_3<Kernel> structure;
    if (status.ok()) status = VMP::sweep(mesh, dual.values(), structure);
    assert(status.ok());
    order = structure.order();
  }

  // The boundary where `image` takes it, vertices inside anywhere in a cube twice as big.
  template <typename Image>
  Mapper scrambled(const Image& image, std::mt19937& random) const {
    std::uniform_real_distribution<double> coordinate(-.5, 1.5);
    Mapper mapper(mesh, order);
    for (VMP::Vertex_index v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      const Position anywhere(coordinate(random), coordinate(random), coordinate(random));
      mapper.set_image(v, mapper.is_inside(v) ? anywhere : image(Position(p.x(), p.y(), p.z())));
    }
    return mapper;
  }

  Mesh mesh;
  std::vector<VMP::Cell_index> order;
};

bool refill(Mapper& mapper, std::size_t most_added = 1000) {
  const std::vector<VMP::Cell_index> flipped = mapper.find_flipped();
  VMP::internal::Star_shaped_ball<Kernel> ball(mapper);
  return ball.grow_around(flipped, mapper.neighborhood(flipped, 1), mapper.mesh().number_of_cells()) &&
         VMP::internal::Ball_refiller<Kernel>(mapper, ball, most_added).run();
}

// Whatever is inside of a star-shaped surface, all cells are positive afterwards, the surface as before, the order legal. Returns
// by how many vertices the mesh has grown.
template <typename Image>
std::size_t test_star(const Block& block, const Image& image, unsigned seed) {
  std::mt19937 random(seed);
  Mapper mapper = block.scrambled(image, random);
  assert(mapper.find_flipped().size() > 1);
  assert(refill(mapper));
  assert(mapper.find_flipped().empty());
  for (VMP::Vertex_index v : block.mesh.vertices()) {
    const auto& p = block.mesh.point(v);
    if (!mapper.is_inside(v)) assert(mapper.images()[v] == image(Position(p.x(), p.y(), p.z())));
  }
  Mesh refined;
  std::vector<VMP::Cell_index> order;
  VMP::Status status = std::move(mapper).write_to(refined, order);
  if (status.ok()) status = VMP::verify_product(refined, order);
  assert(status.ok());
  return refined.number_of_vertices() - block.mesh.number_of_vertices();
}

void test_cube() {
  const Block small(2), block(4);
  const auto as_it_is = [](const Position& p) { return p; };
  for (unsigned seed = 0; seed < 4; ++seed) {
    test_star(small, as_it_is, seed);
    test_star(block, as_it_is, seed);
  }
}

// The more the radii differ, the more cells fit nowhere: their edges and facets are split.
struct Spikes {
  Position operator()(const Position& p) const {
    const double wave = std::sin(40 * p[0] + seed) * std::sin(50 * p[1]) * std::sin(60 * p[2]);
    return middle + (least + (1 - least) * std::abs(wave)) * (p - middle);
  }
  double least;
  unsigned seed;
};

void test_spikes() {
  const Block block(3);
  std::size_t split = 0;
  for (double least : {.7, .4, .2})
    for (unsigned seed = 0; seed < 4; ++seed) split += test_star(block, Spikes{least, seed}, seed);
  assert(split > 0);
}

// If splits are needed but not allowed, all is as before.
void test_giving_up() {
  const Block block(3);
  std::size_t given_up = 0;
  for (unsigned seed = 0; seed < 4; ++seed)
    for (std::size_t most_added : {0, 6}) {
      std::mt19937 random(seed);
      Mapper mapper = block.scrambled(Spikes{.2, seed}, random);
      const std::vector<Position> before = mapper.images();
      if (refill(mapper, most_added)) continue;
      ++given_up;
      assert(mapper.images() == before && mapper.mesh().number_of_cells() == block.mesh.number_of_cells());
    }
  assert(given_up > 0);
}

// A ring that is almost closed is seen whole from nowhere; a few flipped cells in it are refilled all the same.
void test_ring() {
  const Block block(2, 6);
  const auto bent = [](const Position& p) -> Position {
    const double angle = p[0], radius = 2 + p[1];
    return {radius * std::sin(angle), radius * std::cos(angle), p[2]};
  };
  std::mt19937 random(1);
  Mapper mapper = block.scrambled(bent, random);
  const std::vector<Position> before = mapper.images();
  assert(!refill(mapper) && mapper.images() == before);

  for (VMP::Vertex_index v : block.mesh.vertices()) {
    const auto& p = block.mesh.point(v);
    mapper.set_image(v, bent(Position(p.x(), p.y(), p.z())));
  }
  assert(mapper.find_flipped().empty());
  std::size_t inside = 0;
  while (!mapper.is_inside(inside)) ++inside;
  mapper.set_image(inside, mapper.images()[inside] + Position(.5, .5, .5));
  assert(!mapper.find_flipped().empty());
  assert(refill(mapper));
  assert(mapper.find_flipped().empty());
}

// The analytic centre of a tetrahedron is its barycentre; a direction leads away from it, but not out.
void test_analytic_centre() {
  const std::array<Position, 4> t{Position(0, 0, 0), Position(3, 0, 0), Position(1, 2, 0), Position(0, 1, 5)};
  std::vector<VMP::internal::Half_space<3>> half_spaces;
  for (int i = 0; i < 4; ++i) half_spaces.push_back(VMP::internal::half_space_inside(t, i));
  const Position barycentre = (t[0] + t[1] + t[2] + t[3]) / 4;
  Position x = barycentre * .1 + t[1] * .9;
  VMP::internal::climb_barrier<3>(half_spaces, Position::Zero(), 50, x);
  assert((x - barycentre).norm() < 1e-9);
  VMP::internal::climb_barrier<3>(half_spaces, Position(100, 0, 0), 50, x);
  assert(x[0] > 2.5);
  for (const auto& h : half_spaces) assert(h.height(x) > 0);
}

int main() {
  test_analytic_centre();
  test_cube();
  test_spikes();
  test_giving_up();
  test_ring();
  std::cout << "test_Ball_refiller: ok" << std::endl;
  return EXIT_SUCCESS;
}
