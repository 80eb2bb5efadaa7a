#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>

#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Solid = Swept_solid<Inexact>;
using Field = VMP::Curve_field_3<Inexact>;

const Shape all_shapes[] = {Shape::PLAIN, Shape::JITTERED, Shape::BENT, Shape::TWISTED};

// In degrees, also for tiny angles.
double angle_to_vertical(const Field::Vector_3& v) {
  return std::atan2(std::hypot(v.x(), v.y()), v.z()) * 180 / CGAL_PI;
}

double largest_angle_to_vertical(const Solid& solid, const Field& field) {
  double largest = 0;
  for (VMP::Cell_index c : solid.mesh.cells())
    largest = std::max(largest, angle_to_vertical(field.vector(solid.mesh, c)));
  return largest;
}

// Signs are those of the structure, on walls exactly zero; the rates sum up to at most `tolerance` times the largest.
template <typename Kernel>
void test_rates(const Swept_solid<Kernel>& solid, const VMP::Curve_field_3<Kernel>& field, double tolerance) {
  using FT = typename Kernel::FT;
  for (VMP::Cell_index c : solid.mesh.cells()) {
    const auto& rates = field.rates(c);
    FT sum(0), largest(0);
    for (int i = 0; i < 4; ++i) {
      const int sign = solid.structure.signs(c)[i];
      assert(field.sign(c, i) == sign && int(CGAL::sign(rates[i])) == sign);
      assert((sign == 0) == (solid.mesh.label(c, i) >= VMP::FIRST_WALL));
      sum += rates[i];
      largest = (std::max)(largest, FT(CGAL::abs(rates[i])));
    }
    assert(CGAL::abs(sum) <= FT(tolerance) * largest);
  }
}

// What the field keeps of the mesh for those who follow curves.
template <typename Kernel>
void test_cells(const Swept_solid<Kernel>& solid, const VMP::Curve_field_3<Kernel>& field) {
  const auto& mesh = solid.mesh;
  static_assert(sizeof(VMP::internal::Curve_cell<double>) == VMP::internal::cache_line, "");
  for (VMP::Cell_index c : mesh.cells()) {
    const auto& cell = field.cell(c);
    assert(field.rates(c)[field.main_entry(c)] > 0);
    std::array<int, 4> signs = {0, 0, 0, 0};
    for (int k = 0; k < cell.entries.size(); ++k) ++signs[cell.entries[k]];
    for (int k = 0; k < cell.exits.size(); ++k) --signs[cell.exits[k]];
    for (int i = 0; i < 4; ++i) {
      assert(signs[i] == field.sign(c, i) && cell.neighbors[i] == mesh.neighbor(c, i));
      if (!cell.neighbors[i].is_valid()) continue;
      assert(cell.slot_behind(i, i) == mesh.opposite({c, i}).index);
      for (int j = 0; j < 4; ++j)
        assert(j == i || mesh.vertex(cell.neighbors[i], cell.slot_behind(i, j)) == mesh.vertex(c, j));
    }
  }
}

template <typename Kernel>
void test_certified(Shape shape, int holes, int per_unit, double tolerance) {
  const Swept_solid<Kernel> solid(shaped_block<typename Kernel::Point_3>(shape, holes, per_unit, per_unit));
  for (VMP::Level_function level : {VMP::HARMONIC_LEVEL, VMP::ARC_LENGTH_LEVEL}) {
    const VMP::Curve_field_3<Kernel> field = solid.certified_field(level);
    test_rates(solid, field, tolerance);
    test_cells(solid, field);
  }
}

void test_vertical(int holes, int per_unit) {
  const Solid solid(shaped_block<Inexact::Point_3>(Shape::PLAIN, holes, per_unit, per_unit));
  const Field flux(solid.mesh, solid.flux, solid.harmonic);
  const double angle_of_flux = largest_angle_to_vertical(solid, flux);
  const double angle = largest_angle_to_vertical(solid, solid.certified_field());
  std::cout << holes << " holes, " << per_unit << " cubes per unit, angles to the vertical: flux "
            << angle_of_flux << ", certified " << angle << " degrees" << std::endl;
  assert(angle_of_flux < 1e-10);
  assert(per_unit < 3 || angle < 5);
  for (VMP::Cell_index c : solid.mesh.cells()) assert(flux.follows_harmonic_level(c));
}

using Curve = VMP::Integral_curve_3<Inexact>;

double length(const Solid& solid, const Curve& curve) {
  double sum = 0;
  for (const auto& s : curve.segments())
    sum += std::sqrt(CGAL::squared_distance(s.begin.point(solid.mesh), s.end.point(solid.mesh)));
  return sum;
}

bool follows_harmonic_level(const Field& field, const Curve& curve) {
  const auto& segments = curve.segments();
  return std::all_of(segments.begin(), segments.end(),
                     [&](const auto& s) { return field.follows_harmonic_level(s.begin.cell); });
}

// Where w follows f, a curve gains 1, the difference of f between the bases. Measured by its length, it gains that.
void test_levels(Shape shape, int holes, bool certified) {
  const Solid solid(shaped_block<Inexact::Point_3>(shape, holes, 3, 3));
  const auto field = [&](VMP::Level_function level) {
    return certified ? solid.certified_field(level) : Field(solid.mesh, solid.flux, solid.harmonic, level);
  };
  const Field harmonic = field(VMP::HARMONIC_LEVEL), arc_length = field(VMP::ARC_LENGTH_LEVEL);
  const VMP::Integral_curves_3<Inexact> by_f(solid.mesh, harmonic), by_length(solid.mesh, arc_length);
  Random random(5);
  std::size_t curves = 0, following = 0;
  for (VMP::Facet_index f : floor_facets(solid.mesh)) {
    const VMP::Base_point_3<Inexact> start{f, random.weights<double, 3>(7)};
    Curve a, b;
    const VMP::Status status = by_f.trace_curve(start, a), same = by_length.trace_curve(start, b);
    assert(status.code() == same.code());
    if (!status.ok()) {
      assert(!certified && status.code() == VMP::ERROR_CURVE_LOST);
      continue;
    }
    ++curves;
    if (follows_harmonic_level(harmonic, a)) {
      ++following;
      assert(std::abs(a.total_level() - 1) < 1e-9);
    } else
      assert(a.total_level() > 0);
    const double l = length(solid, b);
    assert(std::abs(b.total_level() - l) < 1e-12 * l && std::abs(length(solid, a) - l) < 1e-9 * l);
  }
  std::cout << following << " of " << curves << " curves follow f" << std::endl;
  assert(following > 0 && (shape != Shape::PLAIN || following == curves));
}

int main() {
  for (int holes = 0; holes <= 2; ++holes)
    for (Shape shape : all_shapes) {
      test_certified<Inexact>(shape, holes, 3, 4 * std::numeric_limits<double>::epsilon());
      test_levels(shape, holes, true);
      test_levels(shape, holes, false);
    }
  test_certified<Exact>(Shape::PLAIN, 1, 1, 0);
  test_certified<Exact>(Shape::JITTERED, 0, 2, 0);
  test_certified<Exact>(Shape::BENT, 1, 2, 0);
  for (int holes = 0; holes <= 2; ++holes)
    for (int per_unit = 1; per_unit <= 4; ++per_unit) test_vertical(holes, per_unit);
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
