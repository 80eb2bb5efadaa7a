#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Cell_locator_3.h>

#include "solid_test_util.h"

#include <cassert>
#include <cstdlib>
#include <limits>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <typename Kernel>
class Locator_test {
  using FT = typename Kernel::FT;
  using Point_3 = typename Kernel::Point_3;
  using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

public:
  Locator_test(Shape shape, bool is_exact)
      : m_mesh(assigned(shape)), m_locator(m_mesh), m_is_exact(is_exact) {
    for (const Point_3& p : m_mesh.points()) m_x.push_back(p.x());
  }

  // In vertices, on edges and facets, inside.
  void test_inside(int points) {
    for (int k = 0; k < points; ++k) {
      const VMP::Location_3<Kernel> p{VMP::Cell_index(m_random.below(m_mesh.number_of_cells())),
                                      m_random.template weights<FT, 4>(1 + unsigned(m_random.below(15)))};
      test(p.point(m_mesh));
    }
    for (VMP::Vertex_index v : m_mesh.vertices()) test(m_mesh.point(v));
  }

  void test_around(int points) {
    for (int k = 0; k < points; ++k)
      test(Point_3(m_random.in(-1, 4), m_random.in(-1, 4), m_random.in(-0.5, 1.5)));
    if (m_is_exact) return; // exact points cannot be made of these
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (double wrong : {nan, inf, -inf}) {
      VMP::Location_3<Kernel> at;
      assert(m_locator.locate(Point_3(0.5, 0.5, wrong), at).code() == VMP::ERROR_OUTSIDE);
    }
  }

private:
  static Mesh assigned(Shape shape) {
    Mesh mesh;
    const VMP::Status status = mesh.assign(shaped_block<Point_3>(shape, 1, 2, 2));
    assert(status.ok());
    return mesh;
  }

  // The sign of the volume between p and the facet opposite to vertex i.
  CGAL::Orientation side(VMP::Cell_index c, int i, const Point_3& p) const {
    auto v = m_mesh.cell(c);
    const auto at = [&](int k) -> const Point_3& { return k == i ? p : m_mesh.point(v[k]); };
    return CGAL::orientation(at(0), at(1), at(2), at(3));
  }

  std::size_t first_cell_with(const Point_3& p) const {
    for (VMP::Cell_index c : m_mesh.cells())
      if (side(c, 0, p) != CGAL::NEGATIVE && side(c, 1, p) != CGAL::NEGATIVE &&
          side(c, 2, p) != CGAL::NEGATIVE && side(c, 3, p) != CGAL::NEGATIVE)
        return c;
    return m_mesh.number_of_cells();
  }

  void test(const Point_3& p) const {
    VMP::Location_3<Kernel> at;
    const VMP::Status status = m_locator.locate(p, at);
    const std::size_t expected = first_cell_with(p);
    assert(status.code() == (expected == m_mesh.number_of_cells() ? VMP::ERROR_OUTSIDE : VMP::OK));
    if (!status.ok()) return;
    assert(at.cell == expected);
    for (int i = 0; i < 4; ++i)
      assert(at.barycentric[i] >= 0 && (side(at.cell, i, p) != CGAL::ZERO || at.barycentric[i] == 0));
    const Point_3 q = at.point(m_mesh);
    assert(m_is_exact ? p == q : CGAL::squared_distance(p, q) < 1e-28);
    const FT x = at.value(m_mesh, m_x);
    assert(m_is_exact ? p.x() == x : CGAL::abs(p.x() - x) < 1e-14);
  }

  Mesh m_mesh;
  VMP::Cell_locator_3<Kernel> m_locator;
  std::vector<FT> m_x; // a linear function at the vertices
  bool m_is_exact;
  Random m_random{3};
};

template <typename Kernel>
void test(int points, bool is_exact) {
  for (Shape shape : {Shape::PLAIN, Shape::JITTERED}) {
    Locator_test<Kernel> locator_test(shape, is_exact);
    locator_test.test_inside(points);
    locator_test.test_around(points);
  }
}

int main() {
  test<Inexact>(3000, false);
  test<Exact>(200, true);
  return EXIT_SUCCESS;
}
