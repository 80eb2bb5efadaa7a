#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/check_surface.h>
#include <CGAL/Volume_mesh_parameterization/remesh_thin_triangles.h>

#include "io_test_util.h"
#include "surface_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
template <typename Kernel>
using Surface = VMP::Triangle_soup_3<typename Kernel::Point_3>;

const double length = 10, height = 1;

// A plate with n intervals on two opposite sides. Its top and bottom, with labels 2 and 1, are fans of needles.
template <typename Kernel>
Surface<Kernel> plate_of_needles(std::size_t n) {
  Surface<Kernel> s;
  for (double z : {0., height})
    for (double x : {0., length})
      for (std::size_t k = 0; k <= n; ++k) s.points.emplace_back(x, length * double(k) / double(n), z);
  const auto vertex = [&](std::size_t z, std::size_t x, std::size_t k) { return (2 * z + x) * (n + 1) + k; };
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c, int label) {
    s.triangles.push_back({a, b, c});
    s.labels.push_back(label);
  };
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t z : {0, 1}) {
      add(vertex(z, 0, 0), vertex(z, 1, k), vertex(z, 1, k + 1), int(z) + 1);
      add(vertex(z, 1, n), vertex(z, 0, k + 1), vertex(z, 0, k), int(z) + 1);
      add(vertex(0, z, k), vertex(0, z, k + 1), vertex(1, z, k + 1), 3);
      add(vertex(0, z, k), vertex(1, z, k + 1), vertex(1, z, k), 3);
    }
  for (std::size_t k : {std::size_t(0), n}) {
    add(vertex(0, 0, k), vertex(0, 1, k), vertex(1, 1, k), 3);
    add(vertex(0, 0, k), vertex(1, 1, k), vertex(1, 0, k), 3);
  }
  expect(VMP::check_surface(s), VMP::OK);
  return s;
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

template <typename Point>
double area(const VMP::Triangle_soup_3<Point>& s, int label) {
  double sum = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (s.labels.empty() || s.labels[t] == label) {
      const auto& v = s.triangles[t];
      const auto p = [&](int i) { return VMP::internal::approximate(s.points[v[i]]); };
      sum += std::sqrt(CGAL::squared_area(p(0), p(1), p(2)));
    }
  return sum;
}

template <typename Kernel>
void test_plate(std::size_t n) {
  const auto needles = plate_of_needles<Kernel>(n);
  auto surface = needles;
  assert(VMP::share_of_thin_triangles(needles) > .8);
  expect(VMP::remesh_thin_triangles(surface), VMP::OK);
  std::cout << needles.triangles.size() << " triangles become " << surface.triangles.size() << ", thin "
            << VMP::share_of_thin_triangles(surface) << std::endl;
  assert(VMP::share_of_thin_triangles(surface) < .01);
  assert(std::equal(needles.points.begin(), needles.points.end(), surface.points.begin()));
  auto copy = surface;
  expect(VMP::check_surface(copy), VMP::OK);
  assert(copy.triangles == surface.triangles && VMP::genus(surface) == 0);
  const double volume = VMP::internal::sixfold_volume<double>(surface) / 6;
  assert(std::abs(volume - length * length * height) < 1e-9);
  for (int label : {1, 2}) assert(std::abs(area(surface, label) - length * length) < 1e-9);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t v : surface.triangles[t])
      assert(surface.labels[t] == 3 || surface.points[v].z() == (surface.labels[t] == 1 ? 0 : height));
}

// Each strip of the plate is a part of its own: the borders between labels stay.
void test_borders_stay() {
  auto surface = plate_of_needles<Inexact>(60);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) surface.labels[t] = int(t % 7);
  const auto before = surface;
  expect(VMP::remesh_thin_triangles(surface), VMP::OK);
  for (int label = 0; label < 7; ++label) assert(std::abs(area(surface, label) - area(before, label)) < 1e-9);
}

void test_no_labels() {
  auto surface = plate_of_needles<Inexact>(60);
  surface.labels.clear();
  expect(VMP::remesh_thin_triangles(surface), VMP::OK);
  assert(surface.labels.empty() && VMP::share_of_thin_triangles(surface) < .01);
}

// What is well shaped is not touched.
void test_good_surface() {
  auto surface = block_surface<Inexact::Point_3>(2, 2, 2);
  const auto before = surface;
  expect(VMP::remesh_thin_triangles(surface), VMP::OK);
  assert(surface.triangles == before.triangles && surface.points == before.points);
}

int main() {
  for (std::size_t n : {60, 300}) test_plate<Inexact>(n);
  test_plate<Exact>(60);
  test_borders_stay();
  test_no_labels();
  test_good_surface();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}

#else

int main() {
  auto surface = plate_of_needles<Inexact>(60);
  expect(VMP::remesh_thin_triangles(surface), VMP::ERROR_MISSING_LIBRARY);
  std::cout << "done, without TetGen" << std::endl;
  return EXIT_SUCCESS;
}

#endif
