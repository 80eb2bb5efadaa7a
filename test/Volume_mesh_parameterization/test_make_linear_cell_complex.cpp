#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>

#include <CGAL/Volume_mesh_parameterization/make_linear_cell_complex.h>

#include "hexahedra_test_util.h"
#include "io_test_util.h"

#include <cassert>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Complex =
    CGAL::Linear_cell_complex_for_combinatorial_map<3, 3,
                                                    CGAL::Linear_cell_complex_traits<3, Hexahedra_kernel>>;
using Dart = decltype(std::declval<Complex&>().make_combinatorial_hexahedron());

template <unsigned int dimension>
std::size_t count(Complex& complex) {
  return complex.one_dart_per_cell<dimension>().size();
}

std::size_t number_of_boundary_facets(Complex& complex) {
  std::size_t n = 0;
  for (auto d = complex.darts().begin(); d != complex.darts().end(); ++d) n += complex.is_free<3>(d);
  assert(n % 4 == 0);
  return n / 4;
}

// The cells of 27 cubes in a cube, and of 8 around a hole.
void test_counts() {
  Complex complex;
  expect(VMP::make_linear_cell_complex(cube_of_cubes(3), complex), VMP::OK);
  assert(complex.is_valid());
  assert(complex.number_of_darts() == 27 * 24 && count<3>(complex) == 27);
  assert(count<0>(complex) == 64 && complex.number_of_vertex_attributes() == 64);
  assert(count<1>(complex) == 3 * 3 * 16 && count<2>(complex) == 3 * 4 * 9);
  assert(number_of_boundary_facets(complex) == 6 * 9);

  Complex ring;
  expect(VMP::make_linear_cell_complex(ring_of_cubes(), ring), VMP::OK);
  assert(ring.is_valid() && count<3>(ring) == 8 && count<0>(ring) == 32);
  assert(number_of_boundary_facets(ring) == 8 + 8 + 12 + 4);
  assert(long(count<0>(ring)) - long(count<1>(ring)) + long(count<2>(ring)) - 8 == 0);
}

// Darts that are sewn have the ends of one edge, and every inner facet is sewn.
void test_sewing() {
  Complex complex;
  expect(VMP::make_linear_cell_complex(ring_of_cubes(), complex), VMP::OK);
  const auto source = [&](Dart d) { return complex.point(d); };
  for (auto d = complex.darts().begin(); d != complex.darts().end(); ++d) {
    if (complex.is_free<3>(d)) continue;
    const Dart opposite = complex.beta<3>(d);
    assert(source(opposite) == source(complex.beta<1>(d)) && source(complex.beta<1>(opposite)) == source(d));
  }
}

// Each dart is where the documentation says, and its facet is counterclockwise seen from outside.
void test_darts() {
  const Hexahedra soup = ring_of_cubes();
  Complex complex;
  std::vector<Dart> darts;
  expect(VMP::make_linear_cell_complex(soup, complex, std::back_inserter(darts)), VMP::OK);
  assert(darts.size() == soup.hexahedra.size());
  for (std::size_t h = 0; h < darts.size(); ++h) {
    const auto vertex = [&](std::size_t i) { return soup.points[soup.hexahedra[h][i]]; };
    Dart d = darts[h];
    for (std::size_t i : {0u, 4u, 7u, 3u}) {
      assert(complex.point(d) == vertex(i));
      d = complex.beta<1>(d);
    }
    assert(d == darts[h]);
    assert(CGAL::orientation(vertex(0), vertex(4), vertex(7), vertex(1)) == CGAL::NEGATIVE);
    Dart bottom = complex.beta(d, 0, 2);
    for (std::size_t i : {0u, 3u, 2u, 1u}) {
      assert(complex.point(bottom) == vertex(i));
      bottom = complex.beta<1>(bottom);
    }
  }
}

// However the vertices of the hexahedra are turned, the same complex results.
void test_turned_hexahedra() {
  Hexahedra soup = cube_of_cubes(2);
  constexpr std::size_t turned[8] = {3, 0, 1, 2, 7, 4, 5, 6}, tipped[8] = {1, 5, 6, 2, 0, 4, 7, 3};
  for (std::size_t h = 0; h < soup.hexahedra.size(); ++h)
    for (std::size_t k = 0; k < h; ++k) {
      const auto old = soup.hexahedra[h];
      for (std::size_t i = 0; i < 8; ++i) soup.hexahedra[h][i] = old[k % 2 == 0 ? turned[i] : tipped[i]];
    }
  Complex complex;
  expect(VMP::make_linear_cell_complex(soup, complex), VMP::OK);
  assert(complex.is_valid() && count<0>(complex) == 27 && count<2>(complex) == 36);
  assert(number_of_boundary_facets(complex) == 24);
}

void test_refused(const Hexahedra& soup, VMP::Error_code code, const std::string& culprit) {
  Complex complex;
  expect(VMP::make_linear_cell_complex(cube_of_cubes(1), complex), VMP::OK);
  expect(VMP::make_linear_cell_complex(soup, complex), code, culprit);
  assert(complex.number_of_darts() == 24);
}

void test_refusals() {
  test_refused(Hexahedra(), VMP::ERROR_EMPTY_MESH, "no hexahedra");
  Hexahedra soup = cube_of_cubes(2);
  soup.hexahedra[3][5] = 27;
  test_refused(soup, VMP::ERROR_INDEX_OUT_OF_RANGE, "hexahedron 3");
  soup = cube_of_cubes(2);
  soup.points[7] = Hexahedra::Point_3(0, 0, std::numeric_limits<double>::infinity());
  test_refused(soup, VMP::ERROR_COORDINATE_NOT_FINITE, "vertex 7");

  soup = cube_of_cubes(2);
  for (std::size_t i = 0; i < 4; ++i) std::swap(soup.hexahedra[0][i], soup.hexahedra[0][i + 4]); // inside out
  test_refused(soup, VMP::ERROR_NON_MANIFOLD, "hexahedra 0 and");
  soup = cube_of_cubes(2);
  std::swap(soup.hexahedra[1][0], soup.hexahedra[1][3]); // a facet with two edges crossed
  std::swap(soup.hexahedra[1][4], soup.hexahedra[1][7]);
  test_refused(soup, VMP::ERROR_NON_MANIFOLD, "opposite sides");
  soup = cube_of_cubes(2);
  const auto h = soup.hexahedra[0], g = soup.hexahedra[7]; // a hexahedron between a facet of h and one of g
  soup.hexahedra.push_back({h[4], h[5], h[6], h[7], g[4], g[5], g[6], g[7]});
  test_refused(soup, VMP::ERROR_NON_MANIFOLD, "a third one");
  soup = cube_of_cubes(2);
  soup.hexahedra = {soup.hexahedra[0], soup.hexahedra[7]}; // they share a vertex
  test_refused(soup, VMP::ERROR_NON_MANIFOLD, "no closed surface");
}

int main() {
  test_counts();
  test_sewing();
  test_darts();
  test_turned_hexahedra();
  test_refusals();
  return EXIT_SUCCESS;
}
