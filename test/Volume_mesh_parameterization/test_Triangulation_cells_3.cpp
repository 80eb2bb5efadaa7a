#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/Compact_tetrahedral_mesh_3.h>
#include <CGAL/Volume_mesh_parameterization/Triangulation_cells_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/validate_partition.h>

#include "io_test_util.h"
#include "test_util.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Regular_triangulation_3.h>

#include <cassert>
#include <cstdlib>
#include <iostream>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;

template <typename P>
Point bare(const P& p) { return {p.x(), p.y(), p.z()}; }

// Each Delaunay cell of the block with one hole lies in one cube; those of the hole are left out.
template <typename Triangulation>
bool is_in_block(const Triangulation& t, typename Triangulation::Cell_handle c) {
  const Point p = CGAL::centroid(bare(t.point(c->vertex(0))), bare(t.point(c->vertex(1))), bare(t.point(c->vertex(2))),
                                 bare(t.point(c->vertex(3))));
  return p.z() < 1 && (p.x() < 1 || p.x() > 2 || p.y() < 1 || p.y() > 2);
}

template <typename Triangulation>
int label(const Triangulation& t, const typename Triangulation::Facet& f) {
  const auto all = [&](const auto& predicate) {
    for (int i = 1; i < 4; ++i)
      if (!predicate(t.point(f.first->vertex((f.second + i) % 4)))) return false;
    return true;
  };
  if (all([](const auto& p) { return p.z() == 0; })) return VMP::FLOOR;
  if (all([](const auto& p) { return p.z() == 1; })) return VMP::CEILING;
  return all([](const auto& p) { return p.x() > 0 && p.x() < 3 && p.y() > 0 && p.y() < 3; }) ? 4 : 3;
}

// The part of a complex that is needed, with the label as the index of a surface patch.
template <typename Triangulation_>
struct Complex {
  using Triangulation = Triangulation_;

  const Triangulation& triangulation() const { return t; }
  bool is_in_complex(typename Triangulation::Cell_handle c) const { return is_in_block(t, c); }
  bool is_in_complex(const typename Triangulation::Facet& f) const {
    return is_in_block(t, f.first) && label(t, f) != VMP::CEILING;
  }
  int surface_patch_index(const typename Triangulation::Facet& f) const { return 10 * label(t, f); }

  Triangulation t;
};

template <typename Triangulation>
Complex<Triangulation> make_complex() {
  Complex<Triangulation> result;
  const Block_with_holes<Point> block(1, 1, 1);
  for (const Point& p : block.soup().points)
    result.t.insert(typename Triangulation::Point(p));
  result.t.insert(typename Triangulation::Point(Point(1, 1, 5))); // in no chosen cell
  return result;
}

template <typename Triangulation>
void test_chosen_cells() {
  const Complex<Triangulation> complex = make_complex<Triangulation>();
  const Triangulation& t = complex.t;
  const auto cells = VMP::make_triangulation_cells(
      t, [&](auto c) { return is_in_block(t, c); }, [&](const auto& f) { return label(t, f); });
  assert(t.number_of_vertices() == 33 && cells.number_of_vertices() == 32);
  for (std::size_t c = 0; c < cells.number_of_cells(); ++c)
    for (int i = 0; i < 4; ++i)
      assert(cells.vertex_handle(cells.cell(c)[i]) == cells.cell_handle(c)->vertex(i));
  auto v = t.finite_vertices_begin();
  for (std::size_t k = 0; k < cells.number_of_vertices(); ++k) {
    while (cells.vertex_handle(k) != typename Triangulation::Vertex_handle(v)) ++v; // in the order of the container
    assert(cells.point(k) == bare(t.point(v)));
  }

  Mesh mesh;
  VMP::Boundary_partition_3 partition;
  expect(mesh.assign(cells), VMP::OK);
  expect(VMP::check_tetrahedral_mesh(mesh), VMP::OK);
  expect(VMP::validate_partition(mesh, partition), VMP::OK);
  assert(partition.genus == 1);
  double volume = 0;
  for (VMP::Cell_index c : mesh.cells())
    volume += CGAL::volume(mesh.point(mesh.vertex(c, 0)), mesh.point(mesh.vertex(c, 1)), mesh.point(mesh.vertex(c, 2)),
                           mesh.point(mesh.vertex(c, 3)));
  assert(CGAL::abs(volume - 8) < 1e-12);
}

void test_complex() {
  const auto complex = make_complex<CGAL::Delaunay_triangulation_3<Kernel>>();
  Mesh mesh;
  expect(mesh.assign(VMP::make_triangulation_cells(complex)), VMP::OK);
  for (const VMP::Labelled_facet& f : mesh.labelled_facets()) assert(f.label == VMP::INTERIOR);

  expect(mesh.assign(VMP::make_triangulation_cells(complex, [](int patch) { return patch / 10; })), VMP::OK);
  VMP::Boundary_partition_3 partition = VMP::summarize_partition(mesh);
  assert(partition.find(VMP::FLOOR) && !partition.find(VMP::CEILING) && partition.find(3) && partition.find(4));
  assert(partition.find(VMP::INTERIOR)->area == partition.find(VMP::FLOOR)->area);
}

void test_nothing_chosen() {
  const CGAL::Delaunay_triangulation_3<Kernel> empty;
  const auto cells = VMP::make_triangulation_cells(empty, [](auto) { return true; }, [](const auto&) { return 0; });
  Mesh mesh;
  expect(mesh.assign(cells), VMP::ERROR_EMPTY_MESH);
}

int main() {
  test_chosen_cells<CGAL::Delaunay_triangulation_3<Kernel>>();
  test_chosen_cells<CGAL::Regular_triangulation_3<Kernel>>();
  test_complex();
  test_nothing_chosen();
  return EXIT_SUCCESS;
}
