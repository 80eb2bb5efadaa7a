#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/internal/Foldover_free_energy.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Energy = VMP::internal::Foldover_free_energy;
using VMP::internal::Model_shape;
using Position = Eigen::Vector3d;

// A grid of n^3 cubes, each cut into six tetrahedra.
struct Grid {
  explicit Grid(int n) : size(n + 1) {
    for (int x = 0; x <= n; ++x)
      for (int y = 0; y <= n; ++y)
        for (int z = 0; z <= n; ++z) {
          points.push_back(Position(x, y, z));
          const bool is_inside = x > 0 && y > 0 && z > 0 && x < n && y < n && z < n;
          freedoms.push_back(is_inside ? Energy::free : Energy::fixed);
        }
    const int paths[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int x = 0; x < n; ++x)
      for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z)
          for (int k = 0; k < 6; ++k) add_cell({x, y, z}, paths[k], k >= 3);
  }

  void add_cell(std::array<int, 3> site, const int* path, bool is_odd) {
    Energy::Cell cell;
    cell[0] = number(site);
    for (int i = 0; i < 3; ++i) {
      ++site[path[i]];
      cell[i + 1] = number(site);
    }
    if (is_odd) std::swap(cell[2], cell[3]);
    cells.push_back(cell);
  }

  std::uint32_t number(const std::array<int, 3>& s) const {
    return std::uint32_t((s[0] * size + s[1]) * size + s[2]);
  }

  std::size_t count_flipped(const std::vector<Position>& p) const {
    std::size_t n = 0;
    for (const auto& c : cells) {
      Eigen::Matrix3d e;
      for (int k = 0; k < 3; ++k) e.col(k) = p[c[k + 1]] - p[c[0]];
      n += !(e.determinant() > 0);
    }
    return n;
  }

  int size;
  std::vector<Position> points;
  std::vector<Energy::Freedom> freedoms;
  std::vector<Energy::Cell> cells;
};

// At rest each cell has the least energy, 3 + 2 lambda.
void test_rest() {
  const Grid grid(2);
  std::vector<Position> positions = grid.points;
  Energy energy(grid.cells, {}, grid.points, grid.freedoms, positions, Model_shape::AT_REST);
  energy.polish(0);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) assert(std::abs(energy.value(c) - 3.2) < 1e-12);
}

// Sheared by a lot, a grid is as good as at rest if the models are deformed as it is around them, even with a vertex inside far off.
void test_models_as_around() {
  const Grid grid(4);
  std::vector<Position> sheared = grid.points;
  for (Position& p : sheared) p[0] += .6 * p[2];
  std::vector<Position> positions = sheared;
  positions[grid.number({2, 2, 2})] = Position(-1, -1, 9);
  assert(grid.count_flipped(positions) > 0);
  Energy energy(grid.cells, {}, grid.points, grid.freedoms, positions, Model_shape::AS_AROUND);
  assert(energy.untangle(.3, 40));
  energy.polish(100);
  double most = 0, most_at_rest = 0;
  for (std::size_t v = 0; v < positions.size(); ++v) assert((positions[v] - sheared[v]).norm() < .1);
  Energy rigid(grid.cells, {}, grid.points, grid.freedoms, sheared, Model_shape::AT_REST);
  rigid.polish(0);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    most = (std::max)(most, energy.value(c));
    most_at_rest = (std::max)(most_at_rest, rigid.value(c));
  }
  std::cout << "most energy " << most << ", with models at rest " << most_at_rest << std::endl;
  assert(most < 3.3 && most_at_rest > 3.5);
}

// All vertices at one point: no deformation to go by, and no number that is not finite.
void test_collapsed() {
  const Grid grid(3);
  std::vector<Position> positions(grid.points.size(), Position(1, 1, 1));
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (grid.freedoms[v] == Energy::fixed) positions[v][2] = grid.points[v][2];
  for (bool is_point : {false, true}) {
    if (is_point) std::fill(positions.begin(), positions.end(), Position(1, 1, 1));
    Energy energy(grid.cells, {}, grid.points, grid.freedoms, positions, Model_shape::AS_AROUND);
    assert(!energy.untangle(.3, 20));
    for (const Position& p : positions) assert(p.allFinite());
  }
}

// Vertices anywhere inside: the convex boundary has a map without flips, and it is found.
void test_untangle() {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Grid grid(5);
    std::vector<Position> positions = grid.points;
    std::mt19937 random(seed);
    for (std::size_t v = 0; v < positions.size(); ++v)
      if (grid.freedoms[v] == Energy::free)
        for (int k = 0; k < 3; ++k) positions[v][k] = 5. * random() / random.max();
    const std::vector<Position> start = positions;
    assert(grid.count_flipped(positions) > 50);
    Energy energy(grid.cells, {}, grid.points, grid.freedoms, positions, Model_shape::AT_REST);
    assert(energy.untangle(.3, 60));
    assert(grid.count_flipped(positions) == 0);
    for (std::size_t v = 0; v < positions.size(); ++v)
      assert(grid.freedoms[v] == Energy::free || positions[v] == start[v]);
    // nothing else is as good as the grid itself
    energy.polish(100);
    for (std::size_t v = 0; v < positions.size(); ++v) assert((positions[v] - grid.points[v]).norm() < .05);
  }
}

// A vertex that would have to be on both sides of a plane: no map, and an end.
void test_hopeless() {
  const Grid grid(3);
  std::vector<Position> positions = grid.points;
  for (Position& p : positions) p[0] = -p[0];
  Energy energy(grid.cells, {}, grid.points, grid.freedoms, positions, Model_shape::AT_REST);
  assert(!energy.untangle(.3, 20));
  assert(energy.number_of_steps() <= 100);
}

// Two vertices of opposite sides exchanged: some cells cannot be positive, and must not turn over others at the end.
void test_partly_hopeless() {
  const Grid grid(5);
  std::vector<Position> positions = grid.points;
  std::swap(positions[grid.number({0, 1, 2})], positions[grid.number({5, 3, 3})]);
  const std::size_t before = grid.count_flipped(positions);
  Energy energy(grid.cells, {}, grid.points, grid.freedoms, positions, Model_shape::AT_REST);
  assert(!energy.untangle(.3, 60));
  std::cout << before << " flips, then " << grid.count_flipped(positions) << std::endl;
  assert(grid.count_flipped(positions) <= before);
}

// A tetrahedron wants its apex on the other side of its base; a guard on the same base keeps it here.
void test_guard() {
  const std::vector<Position> rest = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.3, .3, -1}, {.3, .3, 1}};
  const Energy::Cell cell{0, 2, 1, 3}, guard{0, 1, 2, 3};
  const std::vector<Energy::Freedom> freedoms = {Energy::fixed, Energy::fixed, Energy::fixed, Energy::free,
                                                 Energy::fixed};
  for (bool is_guarded : {false, true}) {
    std::vector<Position> positions = rest;
    positions[3] = rest[4];
    std::vector<Energy::Cell> guards;
    if (is_guarded) guards.push_back(guard);
    const bool is_untangled =
        Energy({cell}, guards, rest, freedoms, positions, Model_shape::AT_REST).untangle(.3, 40);
    std::cout << "apex at height " << positions[3][2] << std::endl;
    assert(is_untangled != is_guarded && (positions[3][2] > 0) == is_guarded);
  }
}

int main() {
  test_rest();
  test_models_as_around();
  test_collapsed();
  test_untangle();
  test_hopeless();
  test_partly_hopeless();
  test_guard();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
