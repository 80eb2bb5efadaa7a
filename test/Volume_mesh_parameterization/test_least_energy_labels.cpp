#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/internal/least_energy_labels.h>

#include "surface_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Triangle_soup_3<Point>;
using Vector = VMP::internal::Approximate_surface::Vector_3;
using Labels = std::vector<int>;

Labels label(const Soup& soup, const Vector& direction = Vector(0, 0, 1)) {
  const auto surface = VMP::internal::approximate_surface(soup);
  assert(surface.adjacency.status().ok());
  const Vector unit = direction / std::sqrt(direction.squared_length());
  return least_energy_labels(surface, VMP::internal::costs_by_direction(surface, unit));
}

// Those of the generator, without the numbers of the walls.
Labels expected_labels(const Soup& soup) {
  Labels labels = soup.labels;
  for (int& l : labels) l = std::min(l, int(VMP::FIRST_WALL));
  return labels;
}

bool is_above(const Soup& soup, std::size_t t, double z) {
  for (std::size_t v : soup.triangles[t])
    if (soup.points[v].z() < z) return false;
  return true;
}

void test_block(int holes) {
  const Soup soup = block_surface<Point>(holes, 2, 2);
  for (const Vector& tilt : {Vector(0, 0, 1), Vector(.3, 0, 1), Vector(-.1, .3, 1)})
    assert(label(soup, tilt) == expected_labels(soup));
  Labels turned_over = expected_labels(soup);
  for (int& l : turned_over)
    if (l < VMP::FIRST_WALL) l = VMP::FLOOR + VMP::CEILING - l;
  assert(label(soup, Vector(0, 0, -1)) == turned_over);
}

// Thin walls are not given up for shorter rims.
void test_thin_plate() {
  const Soup block = block_surface<Point>(2, 4, 1);
  const Soup plate = transformed(block, [](const Point& p) { return Point(p.x(), p.y(), p.z() / 200); });
  assert(label(plate) == expected_labels(block));
}

// The upper quarter of the sides recedes by `inset`: a bevel of 45 degrees belongs to the ceiling, a steep one to the wall.
void test_bevel(double inset, int label_of_bevel) {
  const Soup block = block_surface<Point>(0, 4, 4);
  const Soup soup = transformed(block, [&](const Point& p) {
    if (p.z() < 1) return p;
    return Point(.5 + (1 - 2 * inset) * (p.x() - .5), 1.5 + (1 - 2 * inset / 3) * (p.y() - 1.5), 1);
  });
  Labels expected = expected_labels(block);
  for (std::size_t t = 0; t < expected.size(); ++t)
    if (is_above(soup, t, .75) && expected[t] == VMP::FIRST_WALL) expected[t] = label_of_bevel;
  assert(label(soup) == expected);
}

// A rough top stays in one piece, though some of its facets are nearer to a wall.
void test_rough_top() {
  std::mt19937 random(1);
  const Soup block = block_surface<Point>(1, 4, 2);
  const Soup soup = transformed(block, [&](const Point& p) {
    return p.z() < 1 ? p : Point(p.x(), p.y(), 1 + .42 * random() / random.max());
  });
  bool is_steep = false;
  const auto surface = VMP::internal::approximate_surface(soup);
  for (VMP::Facet_index f : surface.adjacency.facets())
    is_steep |= block.labels[f] == VMP::CEILING && surface.area_vector(f).z() < .48 * surface.areas[f];
  assert(is_steep && label(soup) == expected_labels(block));
}

// Halfway from a cube to the ball in it: no creases, but one floor, one ceiling and one wall between them.
Soup make_ball() {
  return transformed(block_surface<Point>(0, 6, 18), [](const Point& p) {
    const Kernel::Vector_3 d(2 * p.x() - 1, (2 * p.y() - 3) / 3, 2 * p.z() - 1);
    const double largest = std::max({std::abs(d.x()), std::abs(d.y()), std::abs(d.z())});
    return CGAL::ORIGIN + (1 + largest / std::sqrt(d.squared_length())) / 2 * d;
  });
}

void test_ball() {
  const Soup ball = make_ball();
  const Labels labels = label(ball);
  const auto surface = VMP::internal::approximate_surface(ball);
  const VMP::internal::Facet_components parts(
      surface.adjacency, [&](VMP::Facet_index f, VMP::Facet_index g) { return labels[f] == labels[g]; });
  assert(parts.size() == 3);
  for (VMP::Facet_index f : surface.adjacency.facets())
    if (std::abs(surface.area_vector(f).z()) > .95 * surface.areas[f])
      assert(labels[f] == (surface.area_vector(f).z() < 0 ? VMP::FLOOR : VMP::CEILING));
}

// The same surface has the same labels, in any unit of length.
void test_invariance() {
  const Soup ball = make_ball();
  const Labels labels = label(ball);
  assert(label(ball) == labels);
  for (double scale : {std::ldexp(1, -200), 1024.})
    assert(label(transformed(
               ball, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); })) == labels);
}

// Labels that cost very much elsewhere are taken where they are asked for, and only there.
void test_picked_facets() {
  const Soup block = block_surface<Point>(1, 4, 4);
  const auto surface = VMP::internal::approximate_surface(block);
  auto costs = VMP::internal::costs_by_direction(surface, Vector(0, 0, 1));
  Labels expected = expected_labels(block);
  for (std::size_t t = 0; t < expected.size(); ++t)
    if (is_above(block, t, .75) && expected[t] == VMP::FIRST_WALL) {
      costs[t] = {1e6, 0, 1e6};
      expected[t] = VMP::CEILING;
    }
  assert(least_energy_labels(surface, costs) == expected);
}

// A vertex of a side on another one: two facets have no area, and no normal.
void test_degenerate_facets() {
  const Soup block = block_surface<Point>(0, 2, 2);
  const Soup soup =
      transformed(block, [](const Point& p) { return p == Point(0, .5, .5) ? Point(0, 1, .5) : p; });
  const auto surface = VMP::internal::approximate_surface(soup);
  const Labels labels = label(soup), expected = expected_labels(block);
  int number_of_degenerate_facets = 0;
  for (VMP::Facet_index f : surface.adjacency.facets())
    if (surface.areas[f] > 0)
      assert(labels[f] == expected[f]);
    else
      ++number_of_degenerate_facets;
  assert(number_of_degenerate_facets == 2);
}

// The energy is no number: the search for its minimum must end all the same.
void test_surface_without_area() {
  for (double scale : {0., 1e200}) {
    const Soup soup = transformed(block_surface<Point>(0, 1, 1),
                                  [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); });
    assert(label(soup) == Labels(soup.triangles.size(), VMP::FIRST_WALL));
  }
}

int main() {
  for (int holes = 0; holes <= 4; ++holes) test_block(holes);
  test_thin_plate();
  test_bevel(.25, VMP::CEILING);
  test_bevel(.1, VMP::FIRST_WALL);
  test_rough_top();
  test_ball();
  test_invariance();
  test_picked_facets();
  test_degenerate_facets();
  test_surface_without_area();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
