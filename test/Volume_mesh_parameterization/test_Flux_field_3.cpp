#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>

#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>

#include "test_util.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Field = VMP::Flux_field_3<Mesh>;
using Vector = Field::Vector_3;

template <typename Mesh_ = Mesh, typename Soup_>
Mesh_ mesh_of(const Soup_& soup) {
  Mesh_ mesh;
  const VMP::Status status = mesh.assign(soup);
  assert(status.ok());
  return mesh;
}

template <typename Field_ = Field, typename Mesh_>
Field_ solved(const Mesh_& mesh) {
  Field_ field(mesh);
  const VMP::Status status = field.solve();
  assert(status.ok() && field.residual() < 1e-12);
  return field;
}

template <typename Field_ = Field, typename Mesh_>
Field_ equilibrated(const Mesh_& mesh) {
  VMP::Harmonic_function_3<Mesh_> harmonic(mesh);
  const VMP::Status status = harmonic.solve();
  assert(status.ok());
  Field_ field(mesh);
  field.equilibrate(harmonic);
  assert(field.residual() < 1e-12);
  return field;
}

// a block in which no linear function is the solution
Soup wedge(int holes) {
  return transformed(
      jitter_interior(Block_with_holes<Point>(holes, 3, 4).soup(), 0.05, 3), [](const Point& p) {
        return Point(p.x() + 0.3 * p.z() * p.z(), p.y(), p.z() * (1 + 0.4 * p.x() + 0.1 * p.y() * p.y()));
      });
}

// the number, without rounding
template <std::size_t n>
CGAL::Gmpq exact_sum(const std::array<double, n>& numbers) {
  CGAL::Gmpq sum(0);
  for (double x : numbers) sum += CGAL::Gmpq(x);
  return sum;
}

template <typename Mesh_, typename Field_>
void test_conservation(const Mesh_& mesh, const Field_& field) {
  double largest = 0;
  for (VMP::Facet_index f : mesh.facets()) largest = std::max(largest, std::abs(field.flux(f)));
  for (VMP::Facet_index f : mesh.boundary_facets())
    if (mesh.label(f) >= VMP::FIRST_WALL) assert(field.flux(f) == 0);
  for (VMP::Cell_index c : mesh.cells()) {
    double sum = 0;
    bool enters = false, leaves = false;
    const auto signs = field.signs(c);
    for (int i = 0; i < 4; ++i) {
      const double inflow = field.inflow({c, i});
      sum += inflow;
      assert(signs[i] == (inflow > 0) - (inflow < 0));
      enters |= signs[i] > 0, leaves |= signs[i] < 0;
      if (mesh.neighbor(c, i).is_valid()) assert(field.inflow(mesh.opposite({c, i})) == -inflow);
    }
    assert(std::abs(sum) < 1e-12 * largest);
    assert(exact_sum(field.rates(c)) == 0);
    assert(enters && leaves);
  }
  const double floor = field.total_flux(VMP::FLOOR), ceiling = field.total_flux(VMP::CEILING);
  assert(floor < 0 && std::abs(floor + ceiling) < 1e-12 * ceiling);
  assert(field.total_flux(VMP::FIRST_WALL) == 0);
  assert(field.largest_divergence() < 1e-12);
}

// The flux enters through all of the floor and leaves through all of the ceiling, which conservation does not imply.
void test_bases(const Mesh& mesh, const Field& field) {
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    if (mesh.label(f) == VMP::FLOOR) assert(field.flux(f) < 0);
    if (mesh.label(f) == VMP::CEILING) assert(field.flux(f) > 0);
  }
}

// The rates are those of the barycentric coordinates of a point that moves with the vector of the cell.
void test_rates_and_vectors(const Mesh& mesh, const Field& field) {
  for (VMP::Cell_index c : mesh.cells()) {
    const VMP::internal::Cell_gradients cell(mesh, c);
    const Vector v = field.vector(c);
    for (int i = 0; i < 4; ++i) {
      const double rate = field.rates(c)[i],
                   size = std::sqrt(v.squared_length() * cell.gradients[i].squared_length());
      assert(std::abs(v * cell.gradients[i] - rate) < 1e-12 * size);
      assert(std::abs(field.inflow({c, i}) / (3 * cell.volume) - rate) < 1e-9 * size);
    }
  }
}

void test_block(int holes, Field (*make_field)(const Mesh&)) {
  const double height = 1.7;
  const Mesh mesh = mesh_of(jitter_interior(Block_with_holes<Point>(holes, 4, 5, height).soup(), 0.06, 7));
  const Field field = make_field(mesh);
  test_conservation(mesh, field);
  test_bases(mesh, field);
  test_rates_and_vectors(mesh, field);
  double error = 0;
  for (VMP::Cell_index c : mesh.cells())
    error = std::max(error, std::sqrt((field.vector(c) - Vector(0, 0, 1 / height)).squared_length()));
  std::cout << "block with " << holes << " holes: error " << error << ", residual " << field.residual()
            << ", divergence " << field.largest_divergence() << '\n';
  assert(error < 1e-11);
  const double area = 3 * (2 * holes + 1) - holes;
  assert(std::abs(field.total_flux(VMP::CEILING) * height / area - 1) < 1e-12);
}

// The vertical facets of the cubes are parallel to the field: nothing crosses them, to the bit.
void test_parallel_facets(Field (*make_field)(const Mesh&)) {
  const Mesh mesh = mesh_of(Block_with_holes<Point>(2, 5, 5).soup());
  const Field field = make_field(mesh);
  std::size_t vertical = 0;
  for (VMP::Facet_index f : mesh.facets()) {
    const auto v = mesh.vertices(f);
    const bool is_vertical =
        CGAL::orientation(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]),
                          mesh.point(v[0]) + Kernel::Vector_3(0, 0, 1)) == CGAL::COPLANAR;
    assert((field.flux(f) == 0) == is_vertical);
    vertical += is_vertical;
  }
  assert(vertical > mesh.number_of_boundary_facets());
  test_conservation(mesh, field);
}

void test_invariance(Field (*make_field)(const Mesh&)) {
  const Mesh mesh = mesh_of(wedge(2));
  const Field expected = make_field(mesh);
  test_conservation(mesh, expected);
  test_rates_and_vectors(mesh, expected);
  const auto compare = [&](const Mesh& moved, double scale) {
    const Field field = make_field(moved);
    double error = 0, largest = 0;
    for (VMP::Facet_index f : mesh.facets()) {
      error = std::max(error, std::abs(field.flux(f) / scale - expected.flux(f)));
      largest = std::max(largest, std::abs(expected.flux(f)));
    }
    assert(error < 1e-11 * largest);
  };
  for (double s : {1e-6, 1e6})
    compare(mesh_of(transformed(wedge(2),
                                [s](const Point& p) { return Point(s * p.x(), s * p.y(), s * p.z()); })),
            s);
  compare(mesh_of(transformed(wedge(2),
                              [](const Point& p) { // turned by (3, 4, 5)
                                return Point(7 + (3 * p.x() - 4 * p.y()) / 5, p.z() - 11,
                                             -(4 * p.x() + 3 * p.y()) / 5);
                              })),
          1);
  const Field again = make_field(mesh);
  for (VMP::Cell_index c : mesh.cells()) assert(again.rates(c) == expected.rates(c)); // to the bit
}

void test_solvers_agree() {
  const Mesh mesh = mesh_of(wedge(2));
  const Field expected = solved(mesh);
  test_bases(mesh, expected);
  const auto direct = solved<VMP::Flux_field_3<Mesh, VMP::Simplicial_solver_traits_3>>(mesh);
  for (VMP::Cell_index c : mesh.cells())
    assert((direct.vector(c) - expected.vector(c)).squared_length() < 1e-22);
}

double mean_angle(const Mesh& mesh, const Field& field, const VMP::Harmonic_function_3<Mesh>& harmonic) {
  double sum = 0, volume = 0;
  for (VMP::Cell_index c : mesh.cells()) {
    const Vector v = field.vector(c), g = harmonic.gradient(c);
    const double cosine = v * g / std::sqrt(v.squared_length() * g.squared_length());
    const double weight = VMP::internal::Cell_gradients(mesh, c).volume;
    sum += weight * std::acos(std::min(1., cosine));
    volume += weight;
  }
  return sum / volume;
}

// What flows through the equilibrated flux is the energy of the harmonic function, to which each vertex of the ceiling gives
// its share; that of the other flux is the energy of the best function in a larger space, so it is less. Both flow about
// where the gradient points.
void test_methods_agree() {
  const Mesh mesh = mesh_of(wedge(1));
  VMP::Harmonic_function_3<Mesh> harmonic(mesh);
  const VMP::Status status = harmonic.solve();
  assert(status.ok());
  double energy = 0;
  for (VMP::Cell_index c : mesh.cells())
    energy += VMP::internal::Cell_gradients(mesh, c).volume * harmonic.gradient(c).squared_length();
  const Field local = equilibrated(mesh), global = solved(mesh);
  const double through_local = local.total_flux(VMP::CEILING), through_global = global.total_flux(VMP::CEILING);
  const double local_angle = mean_angle(mesh, local, harmonic), global_angle = mean_angle(mesh, global, harmonic);
  std::cout << "energy " << energy << ", fluxes " << through_local << " and " << through_global << ", angles to the gradient "
            << local_angle << " and " << global_angle << std::endl;
  assert(std::abs(through_local / energy - 1) < 1e-12);
  assert(0.9 * energy < through_global && through_global < energy);
  assert(local_angle < 0.3 && global_angle < 0.3);
}

double energy_of(const Mesh& mesh, const Field& field) {
  double sum = 0;
  for (VMP::Cell_index c : mesh.cells())
    sum += VMP::internal::Cell_gradients(mesh, c).volume * field.vector(c).squared_length();
  return sum;
}

// Relaxed long enough, the conservative flux becomes that of least energy, whatever the blocks; its total through the ceiling
// stays, so what is compared is the direction, with a flux of the same total.
void test_relaxation(std::size_t cells_per_block) {
  using Tag = CGAL::Parallel_if_available_tag;
  const Mesh mesh = mesh_of(wedge(2));
  const Field rough = equilibrated(mesh), best = solved(mesh);
  std::vector<double> fluxes;
  for (VMP::Facet_index f : mesh.facets()) fluxes.push_back(rough.flux(f));
  VMP::internal::Circulation_relaxation<Mesh>(mesh, Tag(), cells_per_block).run<Tag>(2000, fluxes);
  const double ratio = rough.total_flux(VMP::CEILING) / best.total_flux(VMP::CEILING);
  double error = 0, before = 0, largest = 0;
  for (VMP::Facet_index f : mesh.facets()) {
    error = std::max(error, std::abs(fluxes[f] - ratio * best.flux(f)));
    before = std::max(before, std::abs(rough.flux(f) - ratio * best.flux(f)));
    largest = std::max(largest, std::abs(fluxes[f]));
  }
  std::cout << "relaxed: difference " << before / largest << " -> " << error / largest << ", energy " << energy_of(mesh, rough)
            << " -> " << ratio * ratio * energy_of(mesh, best) << std::endl;
  assert(error < 1e-4 * largest && before > 1e-2 * largest);
}

// Blocks may go to several threads: the fluxes are the same to the bit.
void test_threads() {
  const Mesh mesh = mesh_of(wedge(2));
  const Field rough = equilibrated(mesh);
  std::vector<double> fluxes;
  for (VMP::Facet_index f : mesh.facets()) fluxes.push_back(rough.flux(f) + std::sin(double(f)));
  const auto relaxed = [&](auto tag) {
    std::vector<double> result = fluxes;
    VMP::internal::Circulation_relaxation<Mesh>(mesh, tag, 20).template run<decltype(tag)>(3, result);
    return result;
  };
  const std::vector<double> expected = relaxed(CGAL::Sequential_tag());
  assert(expected != fluxes);
  for (int k = 0; k < 20; ++k) assert(relaxed(CGAL::Parallel_if_available_tag()) == expected);
}

// Preparing changes nothing, and works for one time: afterwards equilibrate() does it by itself.
void test_preparation() {
  const Mesh mesh = mesh_of(wedge(1));
  VMP::Harmonic_function_3<Mesh> f(mesh);
  assert(f.solve().ok());
  const Field expected = equilibrated(mesh);
  Field field(mesh);
  field.prepare_to_equilibrate();
  for (int k = 0; k < 2; ++k) {
    field.equilibrate(f);
    for (VMP::Facet_index facet : mesh.facets()) assert(field.flux(facet) == expected.flux(facet));
  }
}

void test_exact_kernel() {
  using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Exact_mesh = VMP::Compact_tetrahedral_mesh_3<Exact_kernel>;
  const auto mesh = mesh_of<Exact_mesh>(Block_with_holes<Exact_kernel::Point_3>(1, 2, 2).soup());
  test_conservation(mesh, solved<VMP::Flux_field_3<Exact_mesh>>(mesh));
  test_conservation(mesh, equilibrated<VMP::Flux_field_3<Exact_mesh>>(mesh));
}

// Rates of any sizes: the sum becomes 0 without rounding, no sign changes, and little else does.
void test_balance_rates() {
  std::mt19937 random(17);
  const auto number = [&] { return std::ldexp(random() / 4294967296., -int(random() % 70)); };
  for (int k = 0; k < 100000; ++k) {
    const std::array<double, 4> rates = {number(), -number(), random() % 2 ? number() : -number(),
                                         random() % 3 ? number() : 0};
    const std::array<double, 4> balanced = VMP::internal::balance_rates(rates);
    assert(exact_sum(balanced) == 0);
    for (int i = 0; i < 4; ++i)
      assert((balanced[i] > 0) == (rates[i] > 0) && (balanced[i] < 0) == (rates[i] < 0));
  }
  const std::array<double, 4> balanced = VMP::internal::balance_rates({0.1, 0.2, 0, -0.3});
  for (int i = 0; i < 4; ++i)
    assert(std::abs(balanced[i] - std::array<double, 4>{0.1, 0.2, 0, -0.3}[i]) < 1e-15);
  assert((VMP::internal::balance_rates({1, 2, 0, 3}) == std::array<double, 4>{0, 0, 0, 0}));
}

struct Failing_solver : VMP::Default_solver_traits_3 {
  bool linear_solver(const Vector&, Vector&) { return false; }
};

VMP::Error_code code_of(const Soup& soup) {
  const Mesh mesh = mesh_of(soup);
  return Field(mesh).solve().code();
}

void test_refusals() {
  const Soup good = Block_with_holes<Point>(0, 1, 2).soup();
  assert(code_of(good) == VMP::OK);
  const Mesh mesh = mesh_of(good);
  assert((VMP::Flux_field_3<Mesh, Failing_solver>(mesh).solve().code() == VMP::ERROR_CANNOT_SOLVE));

  assert(code_of(transformed(good, [](const Point& p) { return Point(p.x(), p.y(), 0); })) ==
         VMP::ERROR_FLAT_TETRAHEDRON);
  for (int base : {VMP::FLOOR, VMP::CEILING}) {
    Soup without = good;
    for (VMP::Labelled_facet& f : without.facets)
      if (f.label == base) f.label = VMP::FIRST_WALL;
    assert(code_of(without) == VMP::ERROR_NUMBER_OF_PATCHES);
  }
  Soup island = good;
  const std::size_t n = island.points.size();
  for (const Point& p : {Point(9, 0, 0), Point(10, 0, 0), Point(9, 1, 0), Point(9, 0, 1)})
    island.points.push_back(p);
  island.cells.push_back({n, n + 1, n + 2, n + 3});
  assert(code_of(island) == VMP::ERROR_SEVERAL_COMPONENTS);
}

int main() {
  for (const auto make_field : {&solved<Field, Mesh>, &equilibrated<Field, Mesh>}) {
    for (int holes : {0, 1, 2}) test_block(holes, make_field);
    test_parallel_facets(make_field);
    test_invariance(make_field);
  }
  test_solvers_agree();
  test_methods_agree();
  for (std::size_t cells_per_block : {1, 20, 1000}) test_relaxation(cells_per_block);
  test_threads();
  test_preparation();
  test_exact_kernel();
  test_balance_rates();
  test_refusals();
  std::cout << "done\n";
  return EXIT_SUCCESS;
}
