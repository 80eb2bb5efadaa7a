#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_inverse_3.h>
#include <CGAL/Volume_mesh_parameterization/Piecewise_linear_map_3.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "solid_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

void require(const VMP::Status& status) {
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
}

template <typename Kernel>
class Solid {
public:
  using Point_3 = typename Kernel::Point_3;
  using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

  explicit Solid(const VMP::Tetrahedron_soup_3<Point_3>& soup,
                 const VMP::Floor_map_options& options = VMP::Floor_map_options())
      : parameterizer(VMP::Floor_map_2<Kernel>(options)) {
    require(parameterizer.run(soup));
    require(VMP::make_piecewise_linear(parameterizer, map));
  }

  // The map is a bijection onto the prism, the refined mesh the same solid with a legal order and the same labels.
  void test() const {
    assert(map.is_valid());
    const VMP::Map_report report = VMP::verify_map(map.mesh(), map.images());
    assert(report.is_polycube_map());
    require(VMP::verify_product(map.mesh(), map.order()));
    test_boundary();
    test_origins();
    test_inverse();
    test_report();
  }

  // Nothing is flipped any more; where nothing was, nothing had to be bisected.
  void test_report() const {
    const VMP::Untangling_report& report = map.report();
    assert(report.flipped_at_end == 0);
    if (report.flipped_at_start == 0) assert(report.split_simplices == 0);
  }

  // The middle of an image comes from the middle of its cell; columns stand on the floor and end at the ceiling.
  void test_inverse() const {
    VMP::Piecewise_linear_inverse_3<Kernel> inverse;
    require(inverse.build(map));
    for (VMP::Cell_index c : map.mesh().cells()) {
      const auto& v = map.mesh().cell(c);
      const auto at = [&](VMP::Vertex_index w) { return map.images()[w]; };
      VMP::Location_3<Kernel> place;
      require(inverse.preimage(CGAL::centroid(at(v[0]), at(v[1]), at(v[2]), at(v[3])), place));
      assert(place.cell == c);
      for (const auto& weight : place.barycentric) assert(std::abs(CGAL::to_double(weight) - 0.25) < 1e-6);
    }
    const auto& domain = parameterizer.floor_map()->domain();
    const auto corner = domain.outer().corners()[0];
    std::vector<Point_3> column;
    require(inverse.column({corner[0], corner[1]}, domain.height(), {0, 0.5, 1}, column));
    assert(column.size() == 3);
    VMP::Location_3<Kernel> place;
    assert(inverse.preimage(Point_3(0, 0, -1), place).code() == VMP::ERROR_OUTSIDE);
  }

  // Each facet lies in the plane of its label.
  void test_boundary() const {
    const auto& domain = parameterizer.floor_map()->domain();
    assert(domain.is_valid());
    for (VMP::Facet_index f : map.mesh().boundary_facets()) {
      const auto v = map.mesh().vertices(f);
      const int label = map.mesh().label(f);
      if (label == VMP::FLOOR)
        assert(std::all_of(v.begin(), v.end(), [&](auto w) { return map.images()[w].z() == 0; }));
      if (label == VMP::CEILING)
        assert(
            std::all_of(v.begin(), v.end(), [&](auto w) { return map.images()[w].z() == domain.height(); }));
      if (label < VMP::FIRST_WALL) continue;
      const auto at = [&](auto w) {
        return typename Kernel::Point_2(map.images()[w].x(), map.images()[w].y());
      };
      for (VMP::Vertex_index w : v) assert(domain.wall_label(domain.rim_at(at(w))) == label);
    }
  }

  void test_origins() const {
    const auto& original = parameterizer.mesh();
    const auto locations = map.locations(original);
    assert(locations.size() == map.mesh().number_of_vertices());
    for (VMP::Vertex_index v : map.mesh().vertices()) {
      const double distance =
          CGAL::to_double(CGAL::squared_distance(locations[v].point(original), map.mesh().point(v)));
      assert(distance < 1e-24);
    }
    std::vector<double> volumes(original.number_of_cells(), 0);
    const auto origins = map.origins(original);
    const auto volume = [](const auto& mesh, VMP::Cell_index c) {
      const auto& v = mesh.cell(c);
      return CGAL::to_double(
          CGAL::volume(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])));
    };
    for (VMP::Cell_index c : map.mesh().cells()) volumes[origins[c]] += volume(map.mesh(), c);
    for (VMP::Cell_index c : original.cells()) assert(std::abs(volumes[c] - volume(original, c)) < 1e-12);
  }

  Parameterizer parameterizer;
  VMP::Piecewise_linear_map_3<Kernel> map;
};

void test_shapes() {
  for (int holes = 0; holes <= 4; ++holes)
    for (Shape shape : {Shape::PLAIN, Shape::BENT})
      Solid<Inexact>(shaped_block<Inexact::Point_3>(shape, holes, 2, 3)).test();
  Solid<Inexact>(shaped_block<Inexact::Point_3>(Shape::JITTERED, 1, 2, 3)).test();
  Solid<Inexact>(shaped_block<Inexact::Point_3>(Shape::TWISTED, 0, 2, 3)).test();
}

// All planes are where the user wants them.
void test_options() {
  const auto soup = shaped_block<Inexact::Point_3>(Shape::BENT, 1, 2, 3);
  VMP::Floor_map_options options;
  options.integer_planes = true;
  const Solid<Inexact> integer(soup, options);
  integer.test();
  const auto& domain = integer.parameterizer.floor_map()->domain();
  for (std::size_t rim = 0; rim < domain.number_of_rims(); ++rim)
    for (const auto& corner : domain.rim(rim).corners())
      assert(corner[0] == std::round(corner[0]) && corner[1] == std::round(corner[1]));
  assert(domain.height() == std::round(domain.height()));
  options.integer_planes = false;
  options.size = {5, 4, 2};
  const Solid<Inexact> sized(soup, options);
  sized.test();
  assert(sized.parameterizer.floor_map()->domain().outer().width() == 5);
  assert(sized.parameterizer.floor_map()->domain().outer().height() == 4);
  assert(sized.parameterizer.floor_map()->domain().height() == 2);
}

// What curves and the straight map have in common: the floor.
void test_floor() {
  const Solid<Inexact> solid(shaped_block<Inexact::Point_3>(Shape::BENT, 2, 2, 3));
  const auto& mesh = solid.parameterizer.mesh();
  for (VMP::Facet_index f : mesh.boundary_facets()) {
    if (mesh.label(f) != VMP::FLOOR) continue;
    for (VMP::Vertex_index v : mesh.vertices(f)) {
      const auto &p = solid.map.images()[v], &q = solid.parameterizer.vertex_images()[v];
      assert(CGAL::squared_distance(p, q) < 1e-20);
    }
  }
}

struct Impatient_visitor {
  bool start_stage(const char*) { return true; }
  bool advance(std::size_t, std::size_t) { return false; }
};

// An interior that is hopelessly tangled needs work, which may be stopped.
void test_cancelled() {
  VMP::Direct_product_parameterizer_3<Inexact> parameterizer;
  require(parameterizer.run(shaped_block<Inexact::Point_3>(Shape::JITTERED, 1, 4, 4)));
  VMP::Boundary_images_3<Inexact> boundary;
  require(parameterizer.map_boundary(boundary));
  // turned inside out: no bijection, everything is flipped
  for (auto& p : boundary.images) p = Inexact::Point_3(p.x(), p.y(), -p.z());
  VMP::Piecewise_linear_map_3<Inexact> map;
  Impatient_visitor impatient;
  const auto& order = parameterizer.product_structure()->order();
  VMP::Status status =
      map.build(parameterizer.mesh(), order, boundary, parameterizer.vertex_images(), impatient);
  assert(status.code() == VMP::ERROR_CANCELLED && !map.is_valid());
}

void test_refused() {
  VMP::Direct_product_parameterizer_3<Inexact> parameterizer;
  require(parameterizer.run(shaped_block<Inexact::Point_3>(Shape::PLAIN, 0, 1, 2)));
  VMP::Boundary_images_3<Inexact> boundary;
  require(parameterizer.map_boundary(boundary));
  for (auto& p : boundary.images) p = Inexact::Point_3(p.x(), p.y(), -p.z());
  VMP::Piecewise_linear_map_3<Inexact> map;
  VMP::Default_parameterization_visitor visitor;
  const auto& order = parameterizer.product_structure()->order();
  const VMP::Status status =
      map.build(parameterizer.mesh(), order, boundary, parameterizer.vertex_images(), visitor);
  assert(status.code() == VMP::ERROR_MAP_NOT_BIJECTIVE && !map.is_valid());
  assert(map.report().flipped_at_end > 0);
}

int main() {
  test_shapes();
  test_options();
  test_floor();
  Solid<Exact>(shaped_block<Exact::Point_3>(Shape::PLAIN, 1, 1, 2)).test();
  test_cancelled();
  test_refused();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
