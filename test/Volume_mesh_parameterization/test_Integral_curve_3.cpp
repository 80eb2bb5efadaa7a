#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>

#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

template <typename Kernel>
class Test {
  using FT = typename Kernel::FT;
  using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
  using Location = VMP::Location_3<Kernel>;
  using Base_point = VMP::Base_point_3<Kernel>;

public:
  Test(Shape shape, int holes, int per_unit, int layers)
      : m_solid(shaped_block<typename Kernel::Point_3>(shape, holes, per_unit, layers)),
        m_mesh(m_solid.mesh),
        m_field(m_solid.certified_field()),
        m_curves(m_mesh, m_field),
        m_floor(floor_facets(m_mesh)) {
    CGAL::Bbox_3 box;
    for (const auto& p : m_mesh.points()) box += p.bbox();
    m_diameter =
        std::hypot(std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin()), box.zmax() - box.zmin());
    for (VMP::Facet_index f : m_mesh.boundary_facets())
      for (VMP::Vertex_index v : m_mesh.vertices(f))
        if (m_mesh.label(f) >= VMP::FIRST_WALL) m_wall.emplace_back(v, m_mesh.label(f));
    std::sort(m_wall.begin(), m_wall.end());
  }

  // Random points inside of facets, on edges and at vertices. Returns the largest distance between a point and where
  // its curve comes back to, relative to the diameter.
  double largest_gap(std::size_t number_of_points) {
    double largest = 0;
    for (std::size_t k = 0; k < number_of_points; ++k) {
      const unsigned mask = k % 2 == 0 ? 7 : 1 + unsigned(m_random.below(7));
      const Base_point start{m_floor[m_random.below(m_floor.size())], m_random.template weights<FT, 3>(mask)};
      largest = std::max(largest, gap(start));
    }
    return largest;
  }

  // Curves of points on walls, rims among them, stay on their wall up to both bases.
  void test_walls() {
    for (VMP::Facet_index f : m_mesh.boundary_facets()) {
      const int wall = m_mesh.label(f);
      if (wall < VMP::FIRST_WALL) continue;
      for (unsigned mask = 1; mask < 8; ++mask) {
        const Location start = m_curves.locate({f, m_random.template weights<FT, 3>(mask)});
        for (VMP::Curve_direction direction : {VMP::DOWN, VMP::UP}) {
          const auto on_segment = [&](const Location& a, const Location& b, const FT&) {
            assert(is_on_wall(a, wall) && is_on_wall(b, wall));
          };
          Location at = start;
          VMP::Half_facet arrival;
          FT elapsed;
          const VMP::Status status = m_curves.trace(at, direction, FT(-1), arrival, elapsed, on_segment);
          assert(status.ok() && is_on_rim(m_curves.base_point(at, arrival), direction));
        }
      }
    }
  }

  void test_vertices() {
    for (VMP::Cell_index c : m_mesh.cells())
      for (int i = 0; i < 4; ++i) {
        Location at{c, {FT(0), FT(0), FT(0), FT(0)}};
        at.barycentric[i] = FT(1);
        Base_point floor, ceiling;
        FT below, above;
        const VMP::Status down = m_curves.trace_to_base(at, VMP::DOWN, floor, below);
        const VMP::Status up = m_curves.trace_to_base(at, VMP::UP, ceiling, above);
        assert(down.ok() && m_mesh.label(floor.facet) == VMP::FLOOR && below >= FT(0));
        assert(up.ok() && m_mesh.label(ceiling.facet) == VMP::CEILING && above >= FT(0));
        assert(below + above > FT(0));
      }
  }

  // The same point at the same level, whether the curve is stored or followed for a time; w grows along it.
  void test_durations() {
    for (int k = 0; k < 100; ++k) {
      const Base_point start{m_floor[m_random.below(m_floor.size())], m_random.template weights<FT, 3>(7)};
      VMP::Integral_curve_3<Kernel> curve;
      VMP::Status status = m_curves.trace_curve(start, curve);
      assert(status.ok());
      FT before(0);
      for (const auto& s : curve.segments()) {
        assert(s.level >= before && s.begin.cell == s.end.cell);
        before = s.level;
      }
      const FT level = FT(m_random.share()) * curve.total_level();
      Location at = m_curves.locate(start);
      VMP::Half_facet arrival;
      FT elapsed;
      status = m_curves.trace(at, VMP::UP, level, arrival, elapsed);
      assert(status.ok() && !arrival.cell.is_valid());
      assert(is_close(at, curve.at(level)) && std::abs(CGAL::to_double(elapsed - level)) < 1e-14);
      assert(is_close(curve.at(curve.total_level()), curve.segments().back().end));
      assert(is_close(curve.at(FT(0)), m_curves.locate(start)));
    }
  }

private:
  double gap(const Base_point& start) {
    Base_point ceiling, end;
    FT up, down;
    VMP::Status status = m_curves.trace_to_base(m_curves.locate(start), VMP::UP, ceiling, up);
    assert(status.ok() && m_mesh.label(ceiling.facet) == VMP::CEILING);
    status = m_curves.trace_to_base(m_curves.locate(ceiling), VMP::DOWN, end, down);
    assert(status.ok() && m_mesh.label(end.facet) == VMP::FLOOR);
    assert(std::abs(CGAL::to_double(up - down)) < 1e-12);
    const FT squared = CGAL::squared_distance(point(start), point(end));
    return squared == FT(0) ? 0 : std::sqrt(CGAL::to_double(squared)) / m_diameter;
  }

  typename Kernel::Point_3 point(const Base_point& p) const { return m_curves.locate(p).point(m_mesh); }

  bool is_close(const Location& a, const Location& b) const {
    const FT squared = CGAL::squared_distance(a.point(m_mesh), b.point(m_mesh));
    return CGAL::to_double(squared) < 1e-26 * m_diameter * m_diameter;
  }

  bool is_wall_vertex(VMP::Vertex_index v, int wall) const {
    return std::binary_search(m_wall.begin(), m_wall.end(), std::make_pair(v, wall));
  }

  // The mesh is prepared: vertices of a cell that are all on walls span a face of the wall.
  bool is_on_wall(const Location& at, int wall) const {
    for (int i = 0; i < 4; ++i)
      if (at.barycentric[i] != FT(0) && !is_wall_vertex(m_mesh.vertex(at.cell, i), wall)) return false;
    return true;
  }

  bool is_on_rim(const Base_point& p, VMP::Curve_direction direction) const {
    const auto zeros = std::count(p.barycentric.begin(), p.barycentric.end(), FT(0));
    return zeros > 0 && m_mesh.label(p.facet) == (direction == VMP::DOWN ? VMP::FLOOR : VMP::CEILING);
  }

  Swept_solid<Kernel> m_solid;
  const Mesh& m_mesh;
  VMP::Curve_field_3<Kernel> m_field;
  VMP::Integral_curves_3<Kernel> m_curves;
  std::vector<VMP::Facet_index> m_floor;
  std::vector<std::pair<VMP::Vertex_index, int>> m_wall; // vertices with the walls they are on
  double m_diameter;
  Random m_random{11};
};

VMP::Status trace_up(const Swept_solid<Inexact>& solid, const Rates& rates, VMP::Cell_index start) {
  const VMP::Curve_field_3<Inexact> field(solid.mesh, Given_flux{rates}, solid.harmonic);
  const VMP::Integral_curves_3<Inexact> curves(solid.mesh, field);
  VMP::Base_point_3<Inexact> end;
  double elapsed;
  return curves.trace_to_base({start, {0.25, 0.25, 0.25, 0.25}}, VMP::UP, end, elapsed);
}

bool is_lost(const VMP::Status& status, const std::string& why) {
  return status.code() == VMP::ERROR_CURVE_LOST && status.detail().find(why) != std::string::npos &&
         status.detail().find("tetrahedron ") == 0;
}

void test_lost() {
  const Swept_solid<Inexact> solid(shaped_block<Inexact::Point_3>(Shape::PLAIN, 0, 2, 2));
  const auto& mesh = solid.mesh;
  Rates rates(mesh.number_of_cells());
  assert(is_lost(trace_up(solid, rates, VMP::Cell_index(3)), "tetrahedron 3 has no facet to leave by"));

  const auto facets = mesh.boundary_facets();
  const auto wall =
      std::find_if(facets.begin(), facets.end(), [&](auto f) { return mesh.label(f) >= VMP::FIRST_WALL; });
  const VMP::Half_facet h = mesh.half_facet(*wall);
  rates[h.cell] = {1, 1, 1, 1};
  rates[h.cell][h.index] = -3;
  assert(is_lost(trace_up(solid, rates, h.cell), "leaves the solid"));

  VMP::Cell_index cell;
  const Rates turning = whirl(solid, cell);
  assert(is_lost(trace_up(solid, turning, cell), "is passed twice"));
}

int main() {
  for (Shape shape : {Shape::PLAIN, Shape::JITTERED, Shape::BENT, Shape::TWISTED})
    for (int holes = 0; holes <= 2; ++holes) {
      Test<Inexact> test(shape, holes, 3, 3);
      const double gap = test.largest_gap(10000);
      std::cout << "shape " << int(shape) << ", " << holes << " holes: back within " << gap
                << " of the diameter" << std::endl;
      assert(gap < 1e-12);
      test.test_walls();
      test.test_vertices();
      test.test_durations();
    }
  for (Shape shape : {Shape::PLAIN, Shape::BENT}) {
    Test<Exact> test(shape, 1, 1, 1);
    assert(test.largest_gap(200) == 0);
    test.test_walls();
    test.test_vertices();
  }
  test_lost();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
