#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Aff_transformation_3.h>

#include <CGAL/Volume_mesh_parameterization/Direct_product_parameterizer_3.h>

#include "solid_test_util.h"

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numeric>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_3 = Kernel::Point_3;
using Vector_3 = Kernel::Vector_3;
using Transformation = CGAL::Aff_transformation_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point_3>;
using Parameterizer = VMP::Direct_product_parameterizer_3<Kernel>;
using Vertices = std::vector<std::size_t>; // new numbers of old vertices

// A block with a hole, longer than wide, and warped so that no two of its edges are equally long: else which of them
// is split first depends on how the block is turned.
Soup uneven_block() {
  const auto uneven = [](const Point_3& p) {
    const double x = p.x(), y = p.y(), z = p.z();
    return Point_3(1.6 * x + 0.05 * std::sin(1.3 * y + 0.7 * z), y + 0.06 * std::sin(1.1 * x + 0.9 * z + 0.3),
                   1.1 * z + 0.05 * std::sin(0.8 * x + 1.2 * y + 0.2));
  };
  return transformed(shaped_block<Point_3>(Shape::JITTERED, 1, 4, 4), uneven);
}

Vertices shuffled_numbers(std::size_t n, Random& random) {
  Vertices numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t i = n; i > 1; --i) std::swap(numbers[i - 1], numbers[random.below(i)]);
  return numbers;
}

// Renumbers vertices, cells and facets, and turns the vertices of each cell evenly.
Soup renumbered(const Soup& soup, const Vertices& vertices, Random& random) {
  Soup result = soup;
  const Vertices cells = shuffled_numbers(soup.cells.size(), random),
                 facets = shuffled_numbers(soup.facets.size(), random);
  for (std::size_t v = 0; v < vertices.size(); ++v) result.points[vertices[v]] = soup.points[v];
  for (std::size_t c = 0; c < cells.size(); ++c) {
    auto& cell = result.cells[cells[c]] = soup.cells[c];
    for (auto& v : cell) v = vertices[v];
    std::rotate(cell.begin(), cell.begin() + random.below(3), cell.begin() + 3);
  }
  for (std::size_t f = 0; f < facets.size(); ++f) {
    auto& facet = result.facets[facets[f]] = soup.facets[f];
    for (auto& v : facet.vertices) v = vertices[v];
  }
  return result;
}

// Compares the results on a block with those on its copy, point p of which is `map`(p), renumbered.
class Comparison {
public:
  // curve_tolerance: how far curves may differ, relative to the edge of a cube of the block
  Comparison(const Parameterizer& a, const Parameterizer& b, const Transformation& map,
             const Vertices& vertices, double curve_tolerance)
      : m_a(a),
        m_b(b),
        m_map(map),
        m_vertices(vertices),
        m_curve_tolerance(curve_tolerance),
        m_scale(std::cbrt(CGAL::to_double(determinant()))) {}

  void run() const {
    compare_counts();
    compare_splits();
    compare_functions();
    compare_domains();
    compare_curves();
  }

private:
  void compare_counts() const {
    assert(m_a.mesh().number_of_vertices() == m_b.mesh().number_of_vertices());
    assert(m_a.mesh().number_of_cells() == m_b.mesh().number_of_cells());
    assert(m_a.handlebody_certificate().genus() == m_b.handlebody_certificate().genus());
    assert(m_a.product_structure() && m_b.product_structure());
    const auto &p = m_a.partition().patches, &q = m_b.partition().patches;
    assert(p.size() == q.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
      assert(p[i].label == q[i].label && p[i].number_of_facets == q[i].number_of_facets);
      assert(p[i].euler_number == q[i].euler_number &&
             p[i].number_of_border_loops == q[i].number_of_border_loops);
      assert(p[i].number_of_components == q[i].number_of_components);
      assert(std::abs(p[i].area * m_scale * m_scale - q[i].area) < 1e-10 * q[i].area);
    }
  }

  // The same simplices were split in the same order.
  void compare_splits() const {
    const VMP::Preparation &p = m_a.preparation(), &q = m_b.preparation();
    assert(p.boundary_edges == q.boundary_edges && p.interior_edges == q.interior_edges &&
           p.facets == q.facets);
    for (std::size_t v = m_vertices.size(); v < m_a.mesh().number_of_vertices(); ++v) {
      const Point_3 image = m_map.transform(m_a.mesh().point(VMP::Vertex_index(v)));
      assert(CGAL::squared_distance(image, m_b.mesh().point(VMP::Vertex_index(v))) <
             1e-24 * m_scale * m_scale);
    }
    std::cout << m_a.mesh().number_of_vertices() - m_vertices.size() << " splits, " << std::flush;
  }

  void compare_functions() const {
    double largest = 0;
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
      const VMP::Vertex_index w(m_vertices[v]);
      const double f = (*m_a.harmonic_function())(VMP::Vertex_index(v)), g = (*m_b.harmonic_function())(w);
      largest = std::max(largest, std::abs(f - g));
    }
    std::cout << "f differs by " << largest << std::flush;
    assert(largest < 1e-12);
  }

  // Which end of the row of holes is the left one is chance: the base may be turned by 180 degrees.
  void compare_domains() const {
    const auto &a = m_a.floor_map()->domain(), &b = m_b.floor_map()->domain();
    assert(a.number_of_holes() == b.number_of_holes());
    for (std::size_t r = 0; r < a.number_of_rims(); ++r) assert(a.wall_label(r) == b.wall_label(r));
    const double gap = std::min(largest_gap(false), largest_gap(true));
    std::cout << ", domains and images by " << gap << std::flush;
    assert(gap < m_curve_tolerance);
  }

  double largest_gap(bool turned) const {
    const auto &a = m_a.floor_map()->domain(), &b = m_b.floor_map()->domain();
    const VMP::Rectangle_2& box = b.outer();
    double largest = std::abs(a.height() * m_scale - b.height());
    const auto compare = [&](double x, double y, double u, double v) {
      if (turned) u = box.xmin + box.xmax - u, v = box.ymin + box.ymax - v;
      largest = std::max({largest, std::abs(x * m_scale - u), std::abs(y * m_scale - v)});
    };
    for (std::size_t r = 0; r < a.number_of_rims(); ++r)
      for (int k = 0; k < 4; ++k) {
        const auto p = a.rim(r).corners()[k], q = b.rim(r).corners()[turned ? (k + 2) % 4 : k];
        compare(p[0], p[1], q[0], q[1]);
      }
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
      const Point_3 &p = m_a.vertex_images()[v], &q = m_b.vertex_images()[m_vertices[v]];
      compare(p.x(), p.y(), q.x(), q.y());
      largest = std::max(largest, std::abs(p.z() * m_scale - q.z()));
    }
    return largest / m_scale;
  }

  // Curves that start at the same points of the floor end at the same points of the ceiling.
  void compare_curves() const {
    const std::map<std::array<std::size_t, 3>, VMP::Facet_index> facets = facets_by_vertices(m_b);
    double largest = 0;
    for (VMP::Facet_index f : floor_facets(m_a.mesh())) {
      const auto v = m_a.mesh().vertices(f);
      if (std::any_of(v.begin(), v.end(), [&](auto w) { return w >= m_vertices.size(); }))
        continue; // of a split
      const auto found = facets.find(sorted({m_vertices[v[0]], m_vertices[v[1]], m_vertices[v[2]]}));
      assert(found != facets.end());
      const auto w = m_b.mesh().vertices(found->second);
      const std::array<double, 3> weights = {0.2, 0.3, 0.5};
      std::array<double, 3> other_weights;
      for (int i = 0; i < 3; ++i)
        other_weights[std::find(w.begin(), w.end(), VMP::Vertex_index(m_vertices[v[i]])) - w.begin()] =
            weights[i];
      const Point_3 p = end_of_curve(m_a, {f, weights}),
                    q = end_of_curve(m_b, {found->second, other_weights});
      largest = std::max(largest, std::sqrt(CGAL::squared_distance(m_map.transform(p), q)) / m_scale);
    }
    std::cout << ", ends of curves by " << largest << std::endl;
    assert(largest < m_curve_tolerance);
  }

  static Point_3 end_of_curve(const Parameterizer& p, const VMP::Base_point_3<Kernel>& start) {
    const Parameterizer::Curves& curves = p.product_map()->curves();
    VMP::Base_point_3<Kernel> end;
    double elapsed;
    const VMP::Status status = curves.trace_to_base(curves.locate(start), VMP::UP, end, elapsed);
    assert(status.ok());
    return curves.locate(end).point(p.mesh());
  }

  static std::array<std::size_t, 3> sorted(std::array<std::size_t, 3> v) {
    std::sort(v.begin(), v.end());
    return v;
  }
  static std::map<std::array<std::size_t, 3>, VMP::Facet_index> facets_by_vertices(const Parameterizer& p) {
    std::map<std::array<std::size_t, 3>, VMP::Facet_index> result;
    for (VMP::Facet_index f : p.mesh().boundary_facets()) {
      const auto v = p.mesh().vertices(f);
      result[sorted({v[0], v[1], v[2]})] = f;
    }
    return result;
  }

  double determinant() const {
    return CGAL::determinant(m_map.transform(Vector_3(1, 0, 0)), m_map.transform(Vector_3(0, 1, 0)),
                             m_map.transform(Vector_3(0, 0, 1)));
  }

  const Parameterizer &m_a, &m_b;
  Transformation m_map;
  Vertices m_vertices;
  double m_curve_tolerance, m_scale;
};

void run(Parameterizer& parameterizer, const Soup& soup) {
  const VMP::Status status = parameterizer.run(soup);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  assert(status.ok());
}

// About three axes by angles that no symmetry of the block knows.
Transformation rotation() {
  const double a = std::sqrt(2.), b = std::sqrt(3.), c = std::sqrt(5.);
  const Transformation x(1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a));
  const Transformation y(std::cos(b), 0, std::sin(b), 0, 1, 0, -std::sin(b), 0, std::cos(b));
  const Transformation z(std::cos(c), -std::sin(c), 0, std::sin(c), std::cos(c), 0, 0, 0, 1);
  return x * y * z;
}

void compare(const char* what, const Parameterizer& original, const Soup& soup, const Transformation& map,
             const Vertices& vertices, double curve_tolerance = 1e-12) {
  Parameterizer other;
  run(other, soup);
  std::cout << what << ": ";
  Comparison(original, other, map, vertices, curve_tolerance).run();
}

void compare_orders(const char* what, const Parameterizer& original, const Soup& block, Random& random,
                    double curve_tolerance) {
  for (int k = 0; k < 3; ++k) {
    const Vertices vertices = shuffled_numbers(block.points.size(), random);
    compare(what, original, renumbered(block, vertices, random), Transformation(CGAL::IDENTITY), vertices,
            curve_tolerance);
  }
}

void compare_movements(const Parameterizer& original, const Soup& block) {
  Vertices same(block.points.size());
  std::iota(same.begin(), same.end(), 0);
  const auto moved = [&](const Transformation& map) {
    return transformed(block, [&](const Point_3& p) { return map.transform(p); });
  };
  for (double scale : {1e-6, 1e6}) {
    const Transformation scaling(CGAL::SCALING, scale);
    compare("scale", original, moved(scaling), scaling, same);
  }
  const Transformation motion = Transformation(CGAL::TRANSLATION, Vector_3(3.1, -20.7, 11.3)) * rotation();
  compare("motion", original, moved(motion), motion, same);
}

int main() {
  Random random(8);
  const Soup uneven = uneven_block();
  Parameterizer of_uneven;
  run(of_uneven, uneven);
  // A flux that is not uniform is smoothed cell after cell, so that curves depend on the order of the cells, by less than the
  // edge of a cell.
  compare_orders("order", of_uneven, uneven, random, 0.25);
  compare_movements(of_uneven, uneven);

  // full of ties: equally long edges, equal potentials, equally short paths, facets without flux
  for (int holes : {1, 2}) {
    const Soup grid = shaped_block<Point_3>(Shape::PLAIN, holes, 3, 4);
    Parameterizer of_grid;
    run(of_grid, grid);
    compare_orders("order of a grid", of_grid, grid, random, 1e-12);
  }
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
