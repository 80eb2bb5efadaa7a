#undef NDEBUG
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>
#include <CGAL/Volume_mesh_parameterization/Product_map_3.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_map.h>

#include "solid_test_util.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace VMP = CGAL::Volume_mesh_parameterization;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

const double height = 1.5;

template <typename Kernel>
VMP::Location_3<Kernel> random_location(const VMP::Compact_tetrahedral_mesh_3<Kernel>& mesh, Random& random) {
  return {VMP::Cell_index(random.below(mesh.number_of_cells())),
          random.weights<typename Kernel::FT, 4>(1 + unsigned(random.below(15)))};
}

// A block is a product by itself: its f is the height, the curves of its flux are vertical. So its map is known but
// for the map of its floor.
class Block_test {
  using Point_2 = Inexact::Point_2;
  using Point_3 = Inexact::Point_3;
  using Parameterizer = VMP::Direct_product_parameterizer_3<Inexact>;

public:
  Block_test(int holes, int per_unit, int layers) : m_holes(holes) {
    const Block_with_holes<Point_3> block(holes, per_unit, layers, height);
    const VMP::Status status =
        m_parameterizer.run(block.soup(), VMP::parameters::curve_type(VMP::FLUX_CURVES));
    assert(status.ok());
    assert(domain().is_valid() && domain().number_of_holes() == std::size_t(holes));
  }

  void test_harmonic_function() const {
    for (VMP::Vertex_index v : mesh().vertices())
      assert(std::abs((*m_parameterizer.harmonic_function())(v)-mesh().point(v).z() / height) < 1e-10);
  }

  void test_images() {
    for (VMP::Vertex_index v : mesh().vertices())
      assert(is_close(m_parameterizer.vertex_images()[v], expected_image(mesh().point(v))));
    for (int k = 0; k < 1000; ++k) {
      const auto location = random_location(mesh(), m_random);
      Point_3 image(CGAL::ORIGIN);
      const VMP::Status status = map().image(location, image);
      assert(status.ok() && is_close(image, expected_image(location.point(mesh()))));
    }
    const VMP::Map_report report = VMP::verify_map(mesh(), m_parameterizer.vertex_images());
    std::cout << m_holes << " holes: " << report.status.message() << ", " << report.flipped << " flipped"
              << std::endl;
    assert(report.is_bijective() && report.is_polycube_map());
  }

  void test_preimages() {
    const VMP::Rectangle_2& box = domain().outer();
    std::size_t outside = 0;
    for (int k = 0; k < 2000; ++k) {
      const Point_3 q(m_random.in(box.xmin, box.xmax), m_random.in(box.ymin, box.ymax),
                      m_random.in(0, domain().height()));
      test_preimage(q);
      outside += domain().bounded_side(q) == CGAL::ON_UNBOUNDED_SIDE;
    }
    assert((m_holes > 0) == (outside > 0)); // some were in holes
    for (std::size_t rim = 0; rim < domain().number_of_rims(); ++rim)
      for (const auto& [x, y] : domain().rim(rim).corners())
        for (double w : {0., 0.3, 1.}) test_preimage({x, y, w * domain().height()});
    const double x = (box.xmin + (m_holes > 0 ? domain().hole(0).xmin : box.xmax)) / 2,
                 y = box.ymin + 0.1 * box.height();
    for (const Point_3& q : {Point_3(box.xmin - 1, y, 0.1), Point_3(x, box.ymax + 1e-9, 0.1),
                             Point_3(x, y, -1e-9), Point_3(x, y, domain().height() * 1.01)}) {
      VMP::Location_3<Inexact> location;
      assert(map().preimage(q, location).code() == VMP::ERROR_OUTSIDE);
    }
    std::vector<Point_3> points;
    assert(map().column({box.xmin - 1, y}, {0, 1}, points).code() == VMP::ERROR_OUTSIDE && points.empty());
  }

  // Boxes up to the floor map: columns are vertical, and layers are level and equally spaced.
  void test_hexahedra() const {
    const auto column = [&](const Point_2& q, const std::vector<double>& levels,
                            std::vector<Point_3>& points) {
      const VMP::Status status = map().column(q, levels, points);
      const std::size_t layers = levels.size() - 1;
      for (std::size_t k = 0; k <= layers; ++k) {
        const Point_3 &p = points[points.size() - 1 - k], &base = points[points.size() - 1 - layers];
        assert(is_close(p, Point_3(base.x(), base.y(), height * levels[layers - k])));
      }
      return status;
    };
    VMP::Hexahedron_soup_3<Point_3> hexahedra;
    const VMP::Status status =
        VMP::hexahedral_mesh(domain(), VMP::prism_grid_of_size(domain(), 500), column, hexahedra);
    assert(status.ok());
    const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
    std::cout << hexahedra.hexahedra.size() << " hexahedra, scaled Jacobian at least "
              << report.minimum_scaled_jacobian << std::endl;
    assert(report.is_valid() && report.inverted == 0 && report.irregular_edges == 0 &&
           report.genus == m_holes);
  }

  // The image of a curve stands on its foot, from the floor to the ceiling.
  void test_curve_over() const {
    const VMP::Rectangle_2& box = domain().outer();
    const Point_2 foot(box.xmin + 0.01 * box.width(), box.ymin + 0.01 * box.height());
    VMP::Integral_curve_3<Inexact> curve;
    assert(map().curve_over(foot, curve).ok());
    Point_3 image(CGAL::ORIGIN);
    for (const auto& segment : curve.segments()) {
      assert(map().image(segment.end, image).ok());
      assert(is_close(image, Point_3(foot.x(), foot.y(), image.z())));
    }
    assert(std::abs(image.z() - domain().height()) < 1e-12);
  }

  // Curves of a field that is zero everywhere do not arrive, and the map says so.
  void test_lost() const {
    const struct {
      std::array<double, 4> rates(VMP::Cell_index) const { return {0, 0, 0, 0}; }
      std::array<std::int8_t, 4> signs(VMP::Cell_index) const { return {0, 0, 0, 0}; }
    } no_flux;
    const VMP::Curve_field_3<Inexact> field(mesh(), no_flux, *m_parameterizer.harmonic_function());
    const VMP::Integral_curves_3<Inexact> curves(mesh(), field);
    const VMP::Product_map_3<Inexact> map(curves, *m_parameterizer.floor_map());
    const VMP::Rectangle_2& box = domain().outer();
    VMP::Location_3<Inexact> location{VMP::Cell_index(0), {0.25, 0.25, 0.25, 0.25}};
    Point_3 image(CGAL::ORIGIN);
    std::vector<Point_3> points;
    assert(map.image(location, image).code() == VMP::ERROR_CURVE_LOST);
    assert(map.preimage({box.xmin, box.ymin, 0}, location).code() == VMP::ERROR_CURVE_LOST);
    assert(map.column({box.xmin, box.ymin}, {0, 1}, points).code() == VMP::ERROR_CURVE_LOST &&
           points.empty());
    assert(map.vertex_images(points).code() == VMP::ERROR_CURVE_LOST && points.empty());
  }

private:
  const Parameterizer::Mesh& mesh() const { return m_parameterizer.mesh(); }
  const Parameterizer::Product_map& map() const { return *m_parameterizer.product_map(); }
  const VMP::Prism_3<Inexact>& domain() const { return m_parameterizer.floor_map()->domain(); }

  static bool is_close(const Point_3& p, const Point_3& q) { return CGAL::squared_distance(p, q) < 1e-20; }

  // the floor map of the vertical projection, at the same share of the height
  Point_3 expected_image(const Point_3& p) const {
    const Point_2 uv = m_parameterizer.floor_map()->image(projection(p));
    return {uv.x(), uv.y(), p.z() / height * domain().height()};
  }

  VMP::Base_point_3<Inexact> projection(const Point_3& p) const {
    VMP::Base_point_3<Inexact> best;
    double greatest = -1;
    for (VMP::Facet_index f : floor_facets(mesh())) {
      const auto v = mesh().vertices(f);
      std::array<double, 3> weights;
      for (int i = 0; i < 3; ++i)
        weights[i] = area(p, mesh().point(v[(i + 1) % 3]), mesh().point(v[(i + 2) % 3])) /
                     area(mesh().point(v[0]), mesh().point(v[1]), mesh().point(v[2]));
      const double least = *std::min_element(weights.begin(), weights.end());
      if (least <= greatest) continue;
      greatest = least;
      best = {f, weights};
    }
    assert(greatest > -1e-12);
    for (double& weight : best.barycentric) weight = std::max(weight, 0.);
    return best;
  }
  static double area(const Point_3& p, const Point_3& q, const Point_3& r) {
    return CGAL::area(Point_2(p.x(), p.y()), Point_2(q.x(), q.y()), Point_2(r.x(), r.y()));
  }

  void test_preimage(const Point_3& q) const {
    VMP::Location_3<Inexact> location;
    Point_3 back(CGAL::ORIGIN);
    VMP::Status status = map().preimage(q, location);
    if (domain().bounded_side(q) == CGAL::ON_UNBOUNDED_SIDE) {
      assert(status.code() == VMP::ERROR_OUTSIDE);
      return;
    }
    if (status.ok()) status = map().image(location, back);
    assert(status.ok() && is_close(back, q));
  }

  int m_holes;
  Parameterizer m_parameterizer;
  Random m_random{3};
};

// Certified curves on a solid that is no obvious product.
void test_certified(Shape shape, int holes) {
  VMP::Direct_product_parameterizer_3<Inexact> parameterizer;
  VMP::Status status = parameterizer.run(shaped_block<Inexact::Point_3>(shape, holes, 3, 3));
  assert(status.ok());
  const auto& map = *parameterizer.product_map();
  const auto& domain = map.floor_map().domain();
  const VMP::Rectangle_2& box = domain.outer();
  Random random(4);
  double largest = 0;
  for (int k = 0; k < 2000; ++k) {
    const Inexact::Point_3 q(random.in(box.xmin, box.xmax), random.in(box.ymin, box.ymax),
                             random.in(0, domain.height()));
    VMP::Location_3<Inexact> location;
    Inexact::Point_3 back(CGAL::ORIGIN);
    status = map.preimage(q, location);
    assert(status.ok() == (domain.bounded_side(q) != CGAL::ON_UNBOUNDED_SIDE));
    if (!status.ok()) continue;
    status = map.image(location, back);
    assert(status.ok());
    largest = std::max(largest, std::sqrt(CGAL::squared_distance(q, back)));
  }
  std::cout << "shape " << int(shape) << ", " << holes << " holes: image of preimage within " << largest
            << std::endl;
  assert(largest < 1e-10);
}

template <typename Tag, typename Map, typename Locations>
std::vector<Inexact::Point_3> images(const Map& map, const Locations& locations) {
  std::vector<Inexact::Point_3> result, vertices;
  VMP::Status status = map.template images<Tag>(locations, result);
  if (status.ok()) status = map.template vertex_images<Tag>(vertices);
  assert(status.ok());
  result.insert(result.end(), vertices.begin(), vertices.end());
  return result;
}

// Batches are traced in an order of their own and by several threads; each point has the image that it has alone.
void test_batches() {
  VMP::Direct_product_parameterizer_3<Inexact> parameterizer;
  const VMP::Status built = parameterizer.run(shaped_block<Inexact::Point_3>(Shape::BENT, 1, 4, 3));
  assert(built.ok());
  const auto& map = *parameterizer.product_map();
  const auto& mesh = parameterizer.mesh();
  Random random(8);
  std::vector<VMP::Location_3<Inexact>> locations;
  for (int k = 0; k < 3000; ++k) locations.push_back(random_location(mesh, random));
  const std::vector<Inexact::Point_3> all = images<CGAL::Sequential_tag>(map, locations);
  for (std::size_t k = 0; k < locations.size(); ++k) {
    Inexact::Point_3 image(CGAL::ORIGIN);
    const VMP::Status status = map.image(locations[k], image);
    assert(status.ok() && image == all[k]); // to the bit
  }
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    assert(images<CGAL::Parallel_tag>(map, locations) == all);
  }
#endif
  const auto cell_of = [&](std::size_t i) { return locations[i].cell; };
  const auto& field = map.curves().field();
  std::vector<std::uint32_t> order = VMP::internal::order_by_feet(mesh, field, locations.size(), cell_of);
  VMP::internal::Feet_of_cells<std::decay_t<decltype(mesh)>, std::decay_t<decltype(field)>> foot_of(mesh, field);
  for (VMP::Cell_index c : mesh.cells()) assert(mesh.label(foot_of(c)) == VMP::FLOOR);
  for (std::size_t k = 1; k < order.size(); ++k)
    assert(foot_of(cell_of(order[k - 1])) <= foot_of(cell_of(order[k])));
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < locations.size(); ++k) assert(order[k] == k);
}

// With exact numbers both directions are inverse to the bit.
void test_exact() {
  VMP::Direct_product_parameterizer_3<Exact> parameterizer;
  VMP::Status status = parameterizer.run(Block_with_holes<Exact::Point_3>(1, 1, 1).soup());
  assert(status.ok());
  const auto& map = *parameterizer.product_map();
  Random random(6);
  for (int k = 0; k < 20; ++k) {
    const auto location = random_location(parameterizer.mesh(), random);
    VMP::Location_3<Exact> back;
    Exact::Point_3 image;
    status = map.image(location, image);
    if (status.ok()) status = map.preimage(image, back);
    assert(status.ok() && back.point(parameterizer.mesh()) == location.point(parameterizer.mesh()));
  }
}

int main() {
  for (int holes = 0; holes <= 2; ++holes) {
    Block_test test(holes, 4, 3); // four edges on each side of a rim: the floor map finds its corners
    test.test_harmonic_function();
    test.test_images();
    test.test_preimages();
    test.test_hexahedra();
    test.test_curve_over();
    test.test_lost();
  }
  for (int holes = 0; holes <= 2; ++holes)
    for (Shape shape : {Shape::JITTERED, Shape::BENT, Shape::TWISTED}) test_certified(shape, holes);
  test_batches();
  test_exact();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
