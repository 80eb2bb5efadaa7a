#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/internal/Trilinear_jacobian.h>

#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;
template <typename K>
using Hexahedron = std::array<typename K::Point_3, 8>;

constexpr int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

template <typename K>
Hexahedron<K> cube() {
  Hexahedron<K> result;
  for (int i = 0; i < 8; ++i) result[i] = typename K::Point_3(corners[i][0], corners[i][1], corners[i][2]);
  return result;
}

template <typename K>
bool is_positive(const Hexahedron<K>& h) {
  return VMP::internal::has_positive_jacobian(h);
}

// The determinant at a point of the cube, from the derivatives of the trilinear map.
double jacobian(const Hexahedron<Kernel>& h, const std::array<double, 3>& at) {
  Kernel::Vector_3 derivatives[3];
  for (int axis = 0; axis < 3; ++axis) {
    Kernel::Vector_3 sum(0, 0, 0);
    for (int i = 0; i < 8; ++i) {
      double weight = corners[i][axis] == 1 ? 1 : -1;
      for (int k = 0; k < 3; ++k)
        if (k != axis) weight *= corners[i][k] == 1 ? at[k] : 1 - at[k];
      sum = sum + weight * (h[i] - CGAL::ORIGIN);
    }
    derivatives[axis] = sum;
  }
  return CGAL::determinant(derivatives[0], derivatives[1], derivatives[2]);
}

double least_jacobian(const Hexahedron<Kernel>& h, int steps) {
  double least = jacobian(h, {0, 0, 0});
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k)
        least = (std::min)(least, jacobian(h, {double(i) / steps, double(j) / steps, double(k) / steps}));
  return least;
}

// Random cubes: the verdict agrees with samples. Some are inverted although all corners and the centre are positive.
void test_samples() {
  CGAL::Random random(11);
  int positive = 0, inverted = 0, hidden = 0;
  for (int n = 0; n < 3000; ++n) {
    Hexahedron<Kernel> h = cube<Kernel>();
    const double size = random.get_double(0.2, 0.8);
    for (auto& p : h)
      p = p + Kernel::Vector_3(random.get_double(-size, size), random.get_double(-size, size),
                               random.get_double(-size, size));
    const double least = least_jacobian(h, 16);
    (is_positive<Kernel>(h) ? positive : inverted)++;
    if (is_positive<Kernel>(h)) assert(least > 0);
    if (!is_positive<Kernel>(h)) assert(least < 0.02); // what is between samples
    hidden += !is_positive<Kernel>(h) && least_jacobian(h, 1) > 0 && jacobian(h, {.5, .5, .5}) > 0;
  }
  std::cout << positive << " positive, " << inverted << " inverted, " << hidden << " of them inside only\n";
  assert(positive > 500 && inverted > 500 && hidden > 0);
}

// The vertex at (1, 1, 1) is at (t, t, t): its corner is flat for t = 2 / 3.
template <typename K>
bool is_positive_with_vertex_at(double t) {
  Hexahedron<K> h = cube<K>();
  h[6] = typename K::Point_3(t, t, t);
  return is_positive<K>(h);
}

template <typename K>
void test_limits() {
  assert(is_positive_with_vertex_at<K>(1) && is_positive_with_vertex_at<K>(0.75));
  assert(!is_positive_with_vertex_at<K>(0.66));
  const double below = 2. / 3, above = std::nextafter(below, 1.); // closer than intervals can tell
  assert(!is_positive_with_vertex_at<K>(below) && is_positive_with_vertex_at<K>(above));
  Hexahedron<K> h = cube<K>();
  std::swap(h[0], h[6]);
  assert(!is_positive<K>(h));
  h = cube<K>();
  h[6] = h[5]; // flat
  assert(!is_positive<K>(h));
}

int main() {
  test_samples();
  test_limits<Kernel>();
  test_limits<Exact_kernel>();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
