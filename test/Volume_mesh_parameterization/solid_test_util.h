#ifndef VOLUME_MESH_PARAMETERIZATION_SOLID_TEST_UTIL_H
#define VOLUME_MESH_PARAMETERIZATION_SOLID_TEST_UTIL_H

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Curve_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Dual_potential_3.h>
#include <CGAL/Volume_mesh_parameterization/Flux_field_3.h>
#include <CGAL/Volume_mesh_parameterization/Harmonic_function_3.h>
#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_structure_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/prepare_patches.h>

#include "test_util.h"

#include <cassert>
#include <cmath>
#include <iostream>
#include <random>

enum class Shape { PLAIN, JITTERED, BENT, TWISTED };

// A block of height 1 with holes: as it is, or with interior vertices moved by up to 20 % of the edge of a cube, or
// bent by 90 degrees, or twisted by as much.
template <typename Point>
CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point>
shaped_block(Shape shape, int holes, int per_unit, int layers, unsigned seed = 1) {
  const auto soup = Block_with_holes<Point>(holes, per_unit, layers).soup();
  switch (shape) {
  case Shape::PLAIN:
    return soup;
  case Shape::JITTERED:
    return jitter_interior(soup, 0.2 / std::max(per_unit, layers), seed);
  case Shape::BENT:
    return transformed(soup, [](const Point& p) {
      const double angle = CGAL_PI / 2 * CGAL::to_double(p.z()), radius = 1 + CGAL::to_double(p.x());
      return Point(radius * std::cos(angle), CGAL::to_double(p.y()), radius * std::sin(angle));
    });
  case Shape::TWISTED:
    return transformed(soup, [](const Point& p) {
      const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y()), z = CGAL::to_double(p.z());
      const double c = std::cos(CGAL_PI / 2 * z), s = std::sin(CGAL_PI / 2 * z);
      return Point(c * x - s * y, s * x + c * y, 3 * z);
    });
  }
  return soup;
}

// The guide that the parameterizer uses: the dual potential and the signs of the flux.
template <typename Mesh>
CGAL::Volume_mesh_parameterization::Status flux_guide(const Mesh& mesh,
                                                      CGAL::Volume_mesh_parameterization::Sweep_guide_3& guide) {
  using namespace CGAL::Volume_mesh_parameterization;
  Dual_potential_3<Mesh> potential(mesh);
  Flux_field_3<Mesh> flux(mesh);
  Status status = potential.solve();
  if (status.ok()) status = flux.solve();
  if (!status.ok()) return status;
  guide = Sweep_guide_3(potential.values());
  for (const Cell_index c : mesh.cells()) guide.signs.push_back(flux.signs(c));
  return status;
}

// A prepared mesh with its fields and its sweep: what integral curves need. The parts refer to each other.
template <typename Kernel>
struct Swept_solid {
  using Mesh = CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3<Kernel>;
  using Soup = CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<typename Kernel::Point_3>;
  using Curve_field = CGAL::Volume_mesh_parameterization::Curve_field_3<Kernel>;

  Mesh mesh;
  CGAL::Volume_mesh_parameterization::Harmonic_function_3<Mesh> harmonic;
  CGAL::Volume_mesh_parameterization::Flux_field_3<Mesh> flux;
  CGAL::Volume_mesh_parameterization::Dual_potential_3<Mesh> potential;
  CGAL::Volume_mesh_parameterization::Product_structure_3<Kernel> structure;

  explicit Swept_solid(const Soup& soup) : harmonic(mesh), flux(mesh), potential(mesh) {
    using namespace CGAL::Volume_mesh_parameterization;
    Preparation counts;
    require(mesh.assign(soup));
    require(check_tetrahedral_mesh(mesh));
    require(prepare_patches(mesh, counts));
    require(harmonic.solve());
    require(flux.solve());
    require(potential.solve());
    require(sweep(mesh, guide(), structure));
  }
  Swept_solid(const Swept_solid&) = delete;
  Swept_solid& operator=(const Swept_solid&) = delete;

  Curve_field certified_field(CGAL::Volume_mesh_parameterization::Level_function level =
                                  CGAL::Volume_mesh_parameterization::HARMONIC_LEVEL) const {
    return {mesh, structure, flux, harmonic, level};
  }

  CGAL::Volume_mesh_parameterization::Sweep_guide_3 guide() const {
    std::vector<std::array<std::int8_t, 4>> signs;
    for (const auto c : mesh.cells()) signs.push_back(flux.signs(c));
    return {potential.values(), signs};
  }

private:
  static void require(const CGAL::Volume_mesh_parameterization::Status& status) {
    if (!status.ok()) std::cerr << status.message() << std::endl;
    assert(status.ok());
  }
};

// The facets of the floor.
template <typename Mesh>
std::vector<CGAL::Volume_mesh_parameterization::Facet_index> floor_facets(const Mesh& mesh) {
  std::vector<CGAL::Volume_mesh_parameterization::Facet_index> result;
  for (const auto f : mesh.boundary_facets())
    if (mesh.label(f) == CGAL::Volume_mesh_parameterization::FLOOR) result.push_back(f);
  return result;
}

// Random numbers that are the same with every standard library.
class Random {
public:
  explicit Random(unsigned seed) : m_random(seed) {}
  std::size_t below(std::size_t n) { return m_random() % n; }
  double share() { return m_random() / double(std::mt19937::max()); }
  double in(double low, double high) { return low + (high - low) * share(); }

  // n weights with the sum 1; those whose bit is not set in `mask` are zero.
  template <typename FT, std::size_t n>
  std::array<FT, n> weights(unsigned mask) {
    std::array<FT, n> w;
    FT sum(0);
    for (std::size_t i = 0; i < n; ++i) sum += w[i] = FT(mask >> i & 1 ? share() + 1e-3 : 0);
    for (FT& weight : w) weight /= sum;
    return w;
  }

private:
  std::mt19937 m_random;
};

#endif // VOLUME_MESH_PARAMETERIZATION_SOLID_TEST_UTIL_H
