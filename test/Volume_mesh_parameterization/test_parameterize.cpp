#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/parameterize.h>

#include "io_test_util.h"
#include "surface_test_util.h"

#include <CGAL/Surface_mesh.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Surface = VMP::Triangle_soup_3<Point>;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;

constexpr double rounding = 1e-7; // of the linear systems

Soup block(int holes) { return Block_with_holes<Point>(holes, 1, 1).soup(); }

// Bases go to bases and walls to walls; input vertices keep their numbers.
void test_images(const Soup& soup, const Parameterizer& result) {
  assert(result.vertex_images().size() == result.mesh().number_of_vertices());
  assert(std::equal(soup.points.begin(), soup.points.end(), result.mesh().points().begin()));
  const VMP::Prism_3<Kernel>& prism = result.floor_map()->domain();
  assert(prism.number_of_holes() == std::size_t(result.partition().genus));
  for (const VMP::Labelled_facet& f : result.mesh().labelled_facets())
    for (std::size_t v : f.vertices) {
      const Point& image = result.vertex_images()[v];
      if (f.label == VMP::FLOOR) assert(image.z() == 0);
      if (f.label == VMP::CEILING) assert(std::abs(image.z() - prism.height()) < rounding);
      assert(image.x() > prism.outer().xmin - rounding && image.x() < prism.outer().xmax + rounding);
    }
}

void test_blocks() {
  for (int holes = 0; holes <= 4; ++holes) {
    Parameterizer result;
    expect(VMP::parameterize(block(holes), result), VMP::OK);
    assert(result.partition().genus == holes);
    assert(result.product_structure()->order().size() == result.mesh().number_of_cells());
    test_images(block(holes), result);
  }
}

// Walls become bases and bases walls.
Soup turned_labels(int holes) {
  Soup soup = block(holes);
  for (VMP::Labelled_facet& f : soup.facets)
    if (f.label <= 4) f.label = 5 - f.label;
  return soup;
}

// All patches of a solid torus are annuli, so it can be swept from the hole outwards as well.
void test_sideways() {
  Parameterizer result;
  expect(VMP::parameterize(turned_labels(1), result), VMP::OK);
  test_images(turned_labels(1), result);
}

void expect_refusal(const Soup& soup, VMP::Error_code code) {
  Parameterizer result;
  expect(VMP::parameterize(soup, result), code);
  assert(!result.harmonic_function() && !result.product_map() && result.vertex_images().empty());
}

void test_wrong_labels() {
  Soup soup = block(1);
  soup.facets.pop_back();
  expect_refusal(soup, VMP::ERROR_UNLABELLED_FACET);

  soup = block(1);
  soup.facets.front().label = 17;
  expect_refusal(soup, VMP::ERROR_NUMBER_OF_PATCHES);

  soup = block(1);
  const auto& cell = soup.cells.front();
  soup.facets.push_back({{cell[0], cell[1], cell[2]}, VMP::FLOOR});
  soup.facets.push_back({{cell[1], cell[2], cell[3]}, VMP::FLOOR});
  soup.facets.push_back({{cell[0], cell[2], cell[3]}, VMP::FLOOR});
  soup.facets.push_back({{cell[0], cell[1], cell[3]}, VMP::FLOOR});
  expect_refusal(soup, VMP::ERROR_LABEL_NOT_ON_BOUNDARY);

  expect_refusal(turned_labels(2), VMP::ERROR_WALLS_MEET);

  expect_refusal(Soup(), VMP::ERROR_EMPTY_MESH);
}

// Lets a number of stages pass.
struct Impatient_visitor {
  int* stages;
  int patience;
  bool start_stage(const char*) { return (*stages)++ < patience; }
  bool advance(std::size_t, std::size_t) { return true; }
};

void test_visitor() {
  int number_of_stages = 0;
  Parameterizer all;
  expect(VMP::parameterize(block(1), all, CGAL::parameters::visitor(Impatient_visitor{&number_of_stages, 1000})), VMP::OK);
  assert(number_of_stages > 5);
  for (int patience = 0; patience < number_of_stages; ++patience) {
    int stages = 0;
    Parameterizer result;
    expect(VMP::parameterize(block(1), result, CGAL::parameters::visitor(Impatient_visitor{&stages, patience})),
           VMP::ERROR_CANCELLED);
    assert(stages == patience + 1 && result.vertex_images().empty());
    assert(patience > 0 || result.mesh().number_of_cells() == 0);
  }
}

// In a block that is bent by a fourth of a circle, curves near the axis are shorter.
Soup bent_block() {
  return transformed(Block_with_holes<Point>(0, 1, 4).soup(), [](const Point& p) {
    const double angle = p.z() * CGAL_PI / 2;
    return Point((p.x() + 1) * std::cos(angle), p.y(), (p.x() + 1) * std::sin(angle));
  });
}

double length(const Parameterizer& result, const VMP::Integral_curve_3<Kernel>& curve) {
  double sum = 0;
  for (const auto& s : curve.segments())
    sum += std::sqrt(CGAL::squared_distance(s.begin.point(result.mesh()), s.end.point(result.mesh())));
  return sum;
}

template <typename Check>
void for_each_curve(VMP::Level_function level, const Check& check) {
  Parameterizer result;
  expect(VMP::parameterize(bent_block(), result, VMP::parameters::level_function(level)), VMP::OK);
  for (VMP::Facet_index f : result.mesh().boundary_facets())
    if (result.mesh().label(f) == VMP::FLOOR) {
      VMP::Integral_curve_3<Kernel> curve;
      expect(result.product_map()->curves().trace_curve({f, {1. / 3, 1. / 3, 1. / 3}}, curve), VMP::OK);
      check(result, curve);
    }
}

void test_level_function() {
  for_each_curve(VMP::ARC_LENGTH_LEVEL, [](const Parameterizer& result, const auto& curve) {
    assert(std::abs(curve.total_level() - length(result, curve)) < rounding);
  });
  for_each_curve(VMP::HARMONIC_LEVEL, [](const Parameterizer& result, const auto& curve) {
    bool follows = true;
    for (const auto& s : curve.segments()) follows &= result.curve_field()->follows_harmonic_level(s.begin.cell);
    assert(!follows || std::abs(curve.total_level() - 1) < rounding);
    assert(curve.total_level() > 0 && length(result, curve) > 1);
  });
}

CGAL::Surface_mesh<Point> surface_mesh(const Surface& soup) {
  using Graph = CGAL::Surface_mesh<Point>;
  Graph mesh;
  for (const Point& p : soup.points) mesh.add_vertex(p);
  for (const auto& t : soup.triangles)
    mesh.add_face(Graph::Vertex_index(t[0]), Graph::Vertex_index(t[1]), Graph::Vertex_index(t[2]));
  return mesh;
}

#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN

void test_surfaces() {
  using VMP::parameters::combine;
  Surface surface = block_surface<Point>(2, 1, 1);
  Parameterizer automatic;
  expect(VMP::parameterize_surface(surface_mesh(surface), automatic, VMP::parameters::number_of_cells(500)), VMP::OK);
  assert(automatic.partition().genus == 2);

  for (auto& t : surface.triangles) std::swap(t[0], t[1]); // inside out
  Parameterizer downwards;
  const Kernel::Vector_3 down(0, 0, -2);
  const auto np = combine(VMP::parameters::sweep_direction(down), VMP::parameters::number_of_cells(0));
  expect(VMP::parameterize_surface(surface, downwards, np), VMP::OK);
  for (const VMP::Labelled_facet& f : downwards.mesh().labelled_facets())
    for (std::size_t v : f.vertices) assert(f.label != VMP::FLOOR || downwards.mesh().point(v).z() == 1);

  const Kernel::Vector_3 sideways(1, 0, 0); // only loops help
  expect(VMP::parameterize_surface(surface, downwards, VMP::parameters::sweep_direction(sideways)), VMP::OK);
}

// Stops within a stage.
struct Visitor_of_partition {
  bool start_stage(const char*) { return true; }
  bool advance(std::size_t, std::size_t) { return false; }
};

void test_refused_surfaces() {
  using VMP::parameters::sweep_direction;
  Parameterizer result;
  Surface surface = block_surface<Point>(1, 1, 1);
  expect(VMP::parameterize_surface(surface, result, sweep_direction(Kernel::Vector_3(0, 0, 0))), VMP::ERROR_WRONG_PARAMETER);
  for (int patience : {0, 1}) {
    int stages = 0;
    expect(VMP::parameterize_surface(surface, result, CGAL::parameters::visitor(Impatient_visitor{&stages, patience})),
           VMP::ERROR_CANCELLED);
  }
  expect(VMP::parameterize_surface(surface, result, CGAL::parameters::visitor(Visitor_of_partition())),
         VMP::ERROR_CANCELLED, "while partitioning");
  surface.triangles.pop_back();
  surface.labels.clear();
  expect(VMP::parameterize_surface(surface, result), VMP::ERROR_OPEN_SURFACE);
  CGAL::Surface_mesh<Point> quadrilateral;
  CGAL::Surface_mesh<Point>::Vertex_index v[4];
  for (int i = 0; i < 4; ++i) v[i] = quadrilateral.add_vertex(Point(i == 1 || i == 2, i > 1, 0));
  quadrilateral.add_face(v[0], v[1], v[2], v[3]);
  expect(VMP::parameterize_surface(quadrilateral, result), VMP::ERROR_NOT_TRIANGULATED);
  assert(result.mesh().number_of_cells() == 0);
}

#else

void test_surfaces() {
  Parameterizer result;
  expect(VMP::parameterize_surface(surface_mesh(block_surface<Point>(1, 1, 1)), result), VMP::ERROR_MISSING_LIBRARY, "TetGen");
}
void test_refused_surfaces() {}

#endif

// A solid without labels gets some first, by loops if need be.
void test_partitioned_solid() {
  Soup soup = block(1);
  soup.facets.clear();
  Mesh mesh;
  expect(mesh.assign(soup), VMP::OK);
  for (const VMP::Sweep_direction_3& d : {VMP::Sweep_direction_3(0, 0, 3), VMP::Sweep_direction_3(1, 2, 0)}) {
    Mesh labelled = mesh;
    VMP::Partition_options options;
    options.directions = {d};
    expect(VMP::partition_boundary(labelled, options), VMP::OK);
    Parameterizer result;
    expect(VMP::parameterize(labelled, result), VMP::OK);
    assert(result.partition().genus == 1);
  }
}

int main() {
  test_blocks();
  test_sideways();
  test_wrong_labels();
  test_visitor();
  test_level_function();
  test_surfaces();
  test_refused_surfaces();
  test_partitioned_solid();
  return EXIT_SUCCESS;
}
