#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/partition_boundary.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Triangle_soup_3<Point>;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Direction = VMP::Sweep_direction_3;

const double pi = std::acos(-1.);

// Around the z-axis, with radii 1 and 0.4.
template <typename P>
VMP::Triangle_soup_3<P> make_torus(std::size_t n, std::size_t m) {
  VMP::Triangle_soup_3<P> soup;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const double u = 2 * pi * i / n, v = 2 * pi * (j + .3) / m, r = 1 + .4 * std::cos(v);
      soup.points.push_back(P(r * std::cos(u), r * std::sin(u), .4 * std::sin(v)));
      const std::size_t a = i * m + j, b = (i + 1) % n * m + j, c = i * m + (j + 1) % m,
                        d = (i + 1) % n * m + (j + 1) % m;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

Mesh make_mesh(const VMP::Tetrahedron_soup_3<Point>& soup) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

// Halfway from a cube of edge 3 to the ball in it.
Mesh make_ball() {
  auto soup = Block_with_holes<Point>(0, 4, 12, 3).soup();
  for (Point& p : soup.points) {
    const Kernel::Vector_3 d(3 * (p.x() - .5), p.y() - 1.5, p.z() - 1.5);
    const double largest = std::max({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())});
    const double length = std::sqrt(d.squared_length());
    p = CGAL::ORIGIN + (length > 0 ? (1 + largest / length) / 2 : 1) * d;
  }
  return make_mesh(soup);
}

template <typename Surface>
VMP::Boundary_partition_3 summarize(const Surface& surface) {
  const auto approximate = VMP::internal::approximate_surface(surface);
  assert(approximate.adjacency.status().ok());
  assert(VMP::internal::validate_labels(surface).ok());
  return VMP::internal::summarize(approximate.adjacency, VMP::internal::boundary_labels(surface),
                                  approximate.areas);
}

double area(const VMP::Boundary_partition_3& partition, int label) { return partition.find(label)->area; }

// By symmetry floor and ceiling have the same area; each wall has about a fifth of its side.
template <typename P>
void test_torus() {
  auto soup = make_torus<P>(48, 24);
  const std::size_t number_of_points = soup.points.size();
  const auto original = soup.points;
  VMP::Partition_options options;
  options.wall_width = .2;
  const VMP::Status status = VMP::partition_boundary(soup, Direction(0, 0, 5), options);
  assert(status.ok());
  assert(soup.points.size() > number_of_points && soup.labels.size() == soup.triangles.size());
  assert(std::equal(original.begin(), original.end(), soup.points.begin()));
  const auto partition = summarize(soup);
  assert(partition.genus == 1);
  const double total = 4 * pi * pi * .4;
  assert(std::abs(area(partition, VMP::FLOOR) - .4 * total) < .03 * total);
  assert(std::abs(area(partition, VMP::CEILING) - area(partition, VMP::FLOOR)) < .03 * total);
  assert(area(partition, VMP::FIRST_WALL) > .1 * total && area(partition, VMP::FIRST_WALL + 1) > .04 * total);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (std::size_t v : soup.triangles[t]) {
      const double z = CGAL::to_double(soup.points[v].z());
      if (soup.labels[t] == VMP::FLOOR) assert(z < 0);
      if (soup.labels[t] == VMP::CEILING) assert(z > 0);
    }
}

void test_wall_width() {
  double last = 0;
  for (double width : {.05, .1, .2, .4}) {
    Soup soup = make_torus<Point>(48, 24);
    VMP::Partition_options options;
    options.wall_width = width;
    const VMP::Status status = VMP::partition_boundary(soup, Direction(0, 0, 1), options);
    assert(status.ok());
    const double now = area(summarize(soup), VMP::FIRST_WALL);
    assert(now > last);
    last = now;
  }
}

// On the block the creases give the labels: those of the generator, up to the numbers of the walls.
void test_block(int holes) {
  const Mesh original = make_mesh(Block_with_holes<Point>(holes, 2, 2).soup());
  Mesh mesh = original;
  for (VMP::Facet_index f : mesh.boundary_facets()) mesh.set_label(f, 0);
  VMP::Partition_options options;
  options.may_refine = false;
  const VMP::Status status = VMP::partition_boundary(mesh, Direction(.05, 0, 1), options);
  assert(status.ok());
  assert(mesh.number_of_cells() == original.number_of_cells());
  std::map<int, int> renumbered;
  for (VMP::Facet_index f : mesh.boundary_facets())
    assert(renumbered.emplace(original.label(f), mesh.label(f)).first->second == mesh.label(f));
  assert(renumbered.size() == std::size_t(holes + 3));
  assert(renumbered[VMP::FLOOR] == VMP::FLOOR && renumbered[VMP::CEILING] == VMP::CEILING);
  assert(renumbered[VMP::FIRST_WALL] == VMP::FIRST_WALL);
}

void test_orientation(const Mesh& mesh) {
  for (VMP::Cell_index c : mesh.cells()) {
    const auto& v = mesh.cell(c);
    assert(CGAL::orientation(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])) ==
           CGAL::POSITIVE);
  }
}

void test_tetrahedra() {
  Mesh mesh = make_ball();
  test_orientation(mesh);
  const std::size_t number_of_cells = mesh.number_of_cells();
  VMP::Partition_options options;
  options.wall_width = .2;
  const VMP::Status status = VMP::partition_boundary(mesh, Direction(1, 1, 1), options);
  assert(status.ok());
  assert(mesh.number_of_cells() > number_of_cells);
  const auto partition = summarize(mesh);
  assert(partition.genus == 0);
  assert(area(partition, VMP::FIRST_WALL) > 5 && area(partition, VMP::FIRST_WALL) < 15);
  test_orientation(mesh);
}

// Every partition of the search is legal by counts; it ends, and the same search gives the same partitions.
void test_search() {
  const Soup soup = make_torus<Point>(24, 12);
  const auto directions = VMP::propose_directions(soup);
  assert(directions.size() >= 10);
  VMP::Boundary_partition_search_3<Soup> search(soup, directions), again(soup, directions);
  Soup result, same;
  int number_of_partitions = 0;
  VMP::Status status;
  while ((status = search.next(result)).ok()) {
    summarize(result);
    assert(again.next(same).ok());
    assert(same.points == result.points && same.labels == result.labels &&
           again.direction() == search.direction());
    ++number_of_partitions;
  }
  assert(status.code() == VMP::ERROR_NO_PARTITION);
  assert(number_of_partitions > 0 && number_of_partitions <= int(directions.size()));
  Soup automatic = soup;
  Direction direction;
  status = VMP::partition_boundary(automatic, VMP::Partition_options(), &direction);
  assert(status.ok() && std::find(directions.begin(), directions.end(), direction) != directions.end());
}

// A plate is seen best from above; the sides of a block are bases or walls from each axis.
void test_directions() {
  const auto approximate =
      VMP::internal::approximate_surface(make_mesh(Block_with_holes<Point>(1, 2, 2).soup()));
  for (const Direction& axis : {Direction(1, 0, 0), Direction(0, 1, 0), Direction(0, 0, 1)})
    assert(VMP::internal::score(approximate, axis).slant < 1e-12);
  Mesh plate = make_mesh(Block_with_holes<Point>(0, 2, 1, .01).soup());
  assert(VMP::propose_directions(plate).front() == Direction(0, 0, 1));
}

void test_refusals() {
  Soup soup = make_torus<Point>(12, 8);
  const Soup original = soup;
  assert(VMP::partition_boundary(soup, Direction(0, 0, 0)).code() == VMP::ERROR_WRONG_PARAMETER);
  assert(VMP::partition_boundary(soup, Direction(0, 0, NAN)).code() == VMP::ERROR_WRONG_PARAMETER);
  VMP::Partition_options options;
  options.may_refine = false;
  assert(VMP::partition_boundary(soup, Direction(0, 0, 1), options).code() == VMP::ERROR_NO_PARTITION);
  assert(soup.points == original.points && soup.triangles == original.triangles && soup.labels.empty());
  soup.triangles.pop_back();
  assert(VMP::partition_boundary(soup, Direction(0, 0, 1)).code() == VMP::ERROR_OPEN_SURFACE);
  soup.triangles.push_back(soup.triangles.back());
  assert(VMP::partition_boundary(soup, Direction(0, 0, 1)).code() != VMP::OK);
  soup = original;
  soup.triangles.push_back(soup.triangles.back());
  assert(VMP::partition_boundary(soup, Direction(0, 0, 1)).code() == VMP::ERROR_NON_MANIFOLD);
  assert(VMP::partition_boundary(soup).code() == VMP::ERROR_NON_MANIFOLD);
  soup = original;
  for (const Point& p : original.points) soup.points.push_back(p + Kernel::Vector_3(5, 0, 0));
  for (auto triangle : original.triangles) {
    for (std::size_t& v : triangle) v += original.points.size();
    soup.triangles.push_back(triangle);
  }
  assert(VMP::partition_boundary(soup).code() == VMP::ERROR_SEVERAL_COMPONENTS);
  soup = Soup();
  assert(VMP::partition_boundary(soup).code() == VMP::ERROR_EMPTY_MESH);
}

int main() {
  test_torus<Point>();
  test_torus<Exact_kernel::Point_3>();
  test_wall_width();
  for (int holes = 0; holes <= 4; ++holes) test_block(holes);
  test_tetrahedra();
  test_search();
  test_directions();
  test_refusals();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
