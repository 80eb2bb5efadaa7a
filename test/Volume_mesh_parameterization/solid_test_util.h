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

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

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

// Turns cells to be positive.
template <typename Point>
void orient_positively(CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point>& soup) {
  for (auto& c : soup.cells)
    if (CGAL::orientation(soup.points[c[0]], soup.points[c[1]], soup.points[c[2]], soup.points[c[3]]) ==
        CGAL::NEGATIVE)
      std::swap(c[0], c[1]);
}

// Nearly a ball of radius 1: nine tenths of the way to it from a cube, cut into m times 3 m times 3 m cubes. A whole ball
// has flat cells where the cube has its edges.
template <typename Point>
CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> ball(int m) {
  return transformed(Block_with_holes<Point>(0, m, 3 * m).soup(), [](const Point& p) {
    const double x = 2 * CGAL::to_double(p.x()) - 1, y = 2 * CGAL::to_double(p.y()) / 3 - 1,
                 z = 2 * CGAL::to_double(p.z()) - 1;
    const double largest = std::max({std::abs(x), std::abs(y), std::abs(z)}), length = std::hypot(x, y, z);
    const double scale = length > 0 ? .1 + .9 * largest / length : 1;
    return Point(scale * x, scale * y, scale * z);
  });
}

// Where a tube has its centre, and two vectors from there to its surface.
struct Tube_section {
  CGAL::Simple_cartesian<double>::Point_3 center;
  CGAL::Simple_cartesian<double>::Vector_3 right, up;
};

// A disk with some rings of so many sides around a vertex 0, as triangles with increasing vertices.
inline std::vector<std::array<std::size_t, 3>> disk_triangles(int sides, int rings) {
  std::vector<std::array<std::size_t, 3>> triangles;
  const auto vertex = [&](int ring, int side) {
    return std::size_t(ring == 0 ? 0 : 1 + (ring - 1) * sides + side % sides);
  };
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < sides; ++k) {
      triangles.push_back({vertex(r - 1, k), vertex(r, k), vertex(r, k + 1)});
      if (r > 1) triangles.push_back({vertex(r - 1, k), vertex(r - 1, k + 1), vertex(r, k + 1)});
    }
  for (auto& t : triangles) std::sort(t.begin(), t.end());
  return triangles;
}

// A closed tube: section(t) for 0 <= t < 2 pi tells where it runs. Its sections are disks, the cells between two of them
// prisms.
template <typename Point, typename Section>
CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> closed_tube(int sections, int sides, int rings,
                                                                          const Section& section) {
  CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> soup;
  const int n = 1 + rings * sides; // vertices of a section
  for (int s = 0; s < sections; ++s) {
    const Tube_section at = section(2 * CGAL_PI * s / sections);
    for (int v = 0; v < n; ++v) {
      const int side = (v + sides - 1) % sides, ring = (v + sides - 1) / sides;
      const double radius = double(ring) / rings, angle = 2 * CGAL_PI * side / sides;
      const auto p = at.center + radius * (std::cos(angle) * at.right + std::sin(angle) * at.up);
      soup.points.emplace_back(p.x(), p.y(), p.z());
    }
  }
  for (int s = 0; s < sections; ++s)
    for (const auto& [u, v, w] : disk_triangles(sides, rings)) {
      const std::size_t a = std::size_t(n) * s, b = std::size_t(n) * ((s + 1) % sections);
      soup.cells.push_back({a + u, a + v, a + w, b + w});
      soup.cells.push_back({a + u, a + v, b + v, b + w});
      soup.cells.push_back({a + u, b + u, b + v, b + w});
    }
  orient_positively(soup);
  return soup;
}

// Around the z-axis, with radii 1 and 0.4. Its sections turn once on the way round: hardly any rim can follow its edges.
template <typename Point>
CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> solid_torus(int sections, int sides,
                                                                          int rings) {
  return closed_tube<Point>(sections, sides, rings, [](double t) {
    const CGAL::Simple_cartesian<double>::Vector_3 outward(std::cos(t), std::sin(t), 0), upward(0, 0, 1);
    return Tube_section{CGAL::ORIGIN + outward, .4 * (std::cos(t) * outward + std::sin(t) * upward),
                        .4 * (std::cos(t) * upward - std::sin(t) * outward)};
  });
}

// A tube along a trefoil, which lies on a torus.
template <typename Point>
CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3<Point> trefoil_tube(int sections) {
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  const double torus_radius = 3, knot_radius = 1.2, tube_radius = .5;
  const auto on_torus = [&](double t, double radius) {
    const double distance = torus_radius + radius * std::cos(3 * t);
    return Vector(distance * std::cos(2 * t), distance * std::sin(2 * t), radius * std::sin(3 * t));
  };
  return closed_tube<Point>(sections, 6, 1, [&](double t) {
    const double small = 1e-4;
    const Vector center = on_torus(t, knot_radius), normal = on_torus(t, knot_radius + 1) - center;
    const Vector along = on_torus(t + small, knot_radius) - on_torus(t - small, knot_radius);
    const Vector side = CGAL::cross_product(along, normal) / std::sqrt(along.squared_length());
    return Tube_section{CGAL::ORIGIN + center, tube_radius * normal, tube_radius * side};
  });
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

// Fields given cell by cell as rates: they may lose their curves.
using Rates = std::vector<std::array<double, 4>>;

struct Given_flux {
  Rates values;
  const std::array<double, 4>& rates(CGAL::Volume_mesh_parameterization::Cell_index c) const { return values[c]; }
  std::array<std::int8_t, 4> signs(CGAL::Volume_mesh_parameterization::Cell_index c) const {
    std::array<std::int8_t, 4> result;
    for (int i = 0; i < 4; ++i) result[i] = std::int8_t((values[c][i] > 0) - (values[c][i] < 0));
    return result;
  }
};

// The rates of a field that turns around an edge inside of a plain block in the cells that share it.
template <typename Kernel>
Rates whirl(const Swept_solid<Kernel>& solid, CGAL::Volume_mesh_parameterization::Cell_index& some_cell) {
  using Point_3 = typename Kernel::Point_3;
  CGAL::Volume_mesh_parameterization::Vertex_index a, b;
  for (CGAL::Volume_mesh_parameterization::Vertex_index v : solid.mesh.vertices()) {
    if (solid.mesh.point(v) == Point_3(0.5, 1.5, 0.5)) a = v;
    if (solid.mesh.point(v) == Point_3(0.5, 1, 0.5)) b = v;
  }
  assert(a.is_valid() && b.is_valid());
  Rates rates(solid.mesh.number_of_cells());
  for (CGAL::Volume_mesh_parameterization::Cell_index c : solid.mesh.cells()) {
    const int i = solid.mesh.index(c, a), j = solid.mesh.index(c, b);
    if (i < 0 || j < 0) continue;
    int p = 0;
    while (p == i || p == j) ++p;
    int q = 6 - i - j - p;
    const auto point = [&](int k) { return solid.mesh.point(solid.mesh.vertex(c, k)); };
    if (CGAL::orientation(point(i), point(j), point(p), point(q)) == CGAL::NEGATIVE) std::swap(p, q);
    rates[c][p] = -1;
    rates[c][q] = 1;
    some_cell = c;
  }
  return rates;
}

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
