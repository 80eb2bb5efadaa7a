#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Prism_3.h>

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Prism = VMP::Prism_3<Kernel>;

const VMP::Rectangle_2 outer = {0, 0, 7, 3}, left_hole = {1, 1, 2, 2}, right_hole = {4, 0.5, 6, 2.5};

void test_validity() {
  assert(!Prism().is_valid() && Prism().number_of_holes() == 0 && Prism().base_area() == 0);
  assert(Prism().bounded_side(Point_3(1, 0, 0)) == CGAL::ON_UNBOUNDED_SIDE);
  assert(Prism(outer, {}, 1).is_valid());
  assert(Prism(outer, {left_hole, right_hole}, 1).is_valid());
  assert(Prism(outer, {right_hole, left_hole}, 1).is_valid());
  assert(!Prism(outer, {left_hole}, 0).is_valid());
  assert(!Prism(left_hole, {outer}, 1).is_valid());
  assert(!Prism(outer, {{1, 0, 2, 2}}, 1).is_valid());
  assert(!Prism(outer, {{1, 1, 7, 2}}, 1).is_valid());
  assert(!Prism(outer, {{1, 1, 1, 2}}, 1).is_valid());
}

// Holes may lie anywhere, but they may not even touch.
void test_arrangements() {
  const std::vector<VMP::Rectangle_2> pinwheel = {
      {1, 1, 4, 2}, {5, 1, 6, 4}, {3, 5, 6, 6}, {1, 3, 2, 6}, {3, 3, 4, 4}};
  const VMP::Rectangle_2 square = {0, 0, 7, 7};
  assert(Prism(square, pinwheel, 1).is_valid());
  const auto with = [&](const VMP::Rectangle_2& hole) {
    std::vector<VMP::Rectangle_2> holes = pinwheel;
    holes.push_back(hole);
    return Prism(square, holes, 1).is_valid();
  };
  assert(with({4.5, 2, 4.75, 4}));
  assert(!with({4.5, 2, 5, 4}));           // touches a side
  assert(!with({4, 4, 4.5, 4.5}));         // touches a corner
  assert(!with({2.5, 2.5, 4.5, 4.5}));     // contains another one
  assert(!with({3.25, 3.25, 3.75, 3.75})); // is contained
  assert(!with({0.5, 0.5, 6.5, 1.5}));
  assert(square.meets(pinwheel[0]) && !pinwheel[0].meets(pinwheel[1]));
}

void test_sides() {
  Prism prism(outer, {left_hole, right_hole}, 2);
  prism.set_wall_label(2, 9);
  assert(prism.base_area() == 21 - 1 - 4);
  for (std::size_t rim = 0; rim < prism.number_of_rims(); ++rim)
    for (const auto& [x, y] : prism.rim(rim).corners()) assert(prism.bounded_side(Point_2(x, y)) == CGAL::ON_BOUNDARY);
  assert(prism.bounded_side(Point_2(3, 1)) == CGAL::ON_BOUNDED_SIDE);
  assert(prism.bounded_side(Point_2(5, 1)) == CGAL::ON_UNBOUNDED_SIDE);
  assert(prism.bounded_side(Point_2(8, 1)) == CGAL::ON_UNBOUNDED_SIDE);
  assert(prism.rim_at(Point_2(7, 1)) == 0 && prism.rim_at(Point_2(2, 1.5)) == 1 &&
         prism.rim_at(Point_2(3, 1)) == 3);
  assert(prism.label(Point_3(3, 1, 0)) == VMP::FLOOR && prism.label(Point_3(7, 1, 0)) == VMP::FLOOR);
  assert(prism.label(Point_3(3, 1, 2)) == VMP::CEILING && prism.label(Point_3(3, 1, 1)) == VMP::INTERIOR);
  assert(prism.label(Point_3(7, 1, 1)) == VMP::FIRST_WALL &&
         prism.label(Point_3(1, 1.5, 1)) == VMP::FIRST_WALL + 1);
  assert(prism.label(Point_3(4, 1, 1)) == 9 && prism.label(Point_3(5, 1, 0)) == VMP::INTERIOR);
  assert(prism.bounded_side(Point_3(3, 1, 3)) == CGAL::ON_UNBOUNDED_SIDE);
  assert(prism.bounded_side(Point_3(3, 1, 1)) == CGAL::ON_BOUNDED_SIDE);
}

int main() {
  test_validity();
  test_arrangements();
  test_sides();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
