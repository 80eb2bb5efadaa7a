#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include "test_util.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <set>
#include <string>

namespace VMP = CGAL::Volume_mesh_parameterization;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Soup = VMP::Tetrahedron_soup_3<Point>;
using Order = std::vector<VMP::Cell_index>;

// The rules of the sweep, word for word, on sets of simplices. A simplex is the sorted list of its vertices.
class Definition {
  using Simplex = std::vector<std::uint32_t>;
  using Complex = std::set<Simplex>;

public:
  Definition(const Mesh& mesh, int base) : m_mesh(mesh) {
    for (VMP::Facet_index f : mesh.boundary_facets()) {
      const auto v = mesh.vertices(f);
      const Complex facet = closure({v[0], v[1], v[2]});
      if (mesh.label(f) == base) m_swept.insert(facet.begin(), facet.end());
      if (mesh.label(f) >= VMP::FIRST_WALL) m_wall.insert(facet.begin(), facet.end());
    }
  }

  bool may_sweep(VMP::Cell_index c) const {
    const Complex cell = closure(cell_simplex(c));
    Complex entry, wall;
    int entries = 0, exits = 0;
    for (const Simplex& s : cell)
      if (s.size() == 3) {
        const Complex facet = closure(s);
        if (m_wall.count(s))
          wall.insert(facet.begin(), facet.end());
        else if (m_swept.count(s)) {
          ++entries;
          entry.insert(facet.begin(), facet.end());
        } else
          ++exits;
      }
    if (entries < 1 || entries > 3 || exits == 0) return false;
    return std::all_of(cell.begin(), cell.end(), [&](const Simplex& s) {
      const bool in_sweep = !m_swept.count(s) || entry.count(s);
      const bool on_wall = s.size() > 2 || !m_wall.count(s) || m_swept.count(s) || wall.count(s);
      return s.size() == 4 || (in_sweep && on_wall);
    });
  }

  void sweep(VMP::Cell_index c) {
    for (const Simplex& s : closure(cell_simplex(c))) m_swept.insert(s);
  }

private:
  static Complex closure(Simplex s) {
    std::sort(s.begin(), s.end());
    Complex faces;
    for (unsigned subset = 1; subset < 1u << s.size(); ++subset) {
      Simplex face;
      for (std::size_t i = 0; i < s.size(); ++i)
        if (subset >> i & 1) face.push_back(s[i]);
      faces.insert(face);
    }
    return faces;
  }
  Simplex cell_simplex(VMP::Cell_index c) const {
    const auto& v = m_mesh.cell(c);
    return {v[0], v[1], v[2], v[3]};
  }

  const Mesh& m_mesh;
  Complex m_swept, m_wall;
};

// The first position that breaks a rule, or the number of tetrahedra.
template <typename CellIterator>
long first_breach(const Mesh& mesh, CellIterator first, CellIterator last, int base) {
  Definition definition(mesh, base);
  for (CellIterator c = first; c != last; ++c) {
    if (!definition.may_sweep(*c)) return c - first;
    definition.sweep(*c);
  }
  return last - first;
}

// Sweeps the lowest tetrahedron that may be swept, which finishes on these blocks.
Order find_order(const Mesh& mesh) {
  const auto height = [&](VMP::Cell_index c) {
    double sum = 0;
    for (VMP::Vertex_index v : mesh.cell(c)) sum += mesh.point(v).z();
    return sum;
  };
  Order waiting(mesh.cells().begin(), mesh.cells().end()), order;
  std::sort(waiting.begin(), waiting.end(), [&](auto a, auto b) { return height(a) < height(b); });
  Definition definition(mesh, VMP::FLOOR);
  while (!waiting.empty()) {
    const auto next =
        std::find_if(waiting.begin(), waiting.end(), [&](auto c) { return definition.may_sweep(c); });
    assert(next != waiting.end());
    definition.sweep(*next);
    order.push_back(*next);
    waiting.erase(next);
  }
  return order;
}

Mesh block(int holes, int m, int layers) {
  Mesh mesh;
  const VMP::Status status = mesh.assign(Block_with_holes<Point>(holes, m, layers).soup());
  assert(status.ok());
  return mesh;
}

bool contains(const VMP::Status& status, const std::string& text) {
  return status.detail().find(text) != std::string::npos;
}

const std::string rules[] = {"has no facet to enter by",
                             "outside of its entry facets, in vertex",
                             "outside of its entry facets, in edge",
                             "has no facet to leave by",
                             "reaches the wall from inside, in vertex",
                             "reaches the wall from inside, in edge"};

// Compares the verdict on `order` with that of the definition. Returns which rule is said to be broken, or -1.
int compare_with_definition(const Mesh& mesh, const Order& order) {
  const VMP::Status status = VMP::verify_product(mesh, order);
  assert(VMP::verify_product<CGAL::Parallel_if_available_tag>(mesh, order).message() == status.message());
  const long n = long(order.size()), up = first_breach(mesh, order.begin(), order.end(), VMP::FLOOR);
  const long down = first_breach(mesh, order.rbegin(), order.rend(), VMP::CEILING);
  assert(status.ok() == (up == n && down == n));
  if (status.ok()) return -1;
  assert(status.code() == VMP::ERROR_SWEEP_RULE);
  const long position = up < n ? up : down;
  const VMP::Cell_index cell = up < n ? order[up] : order[n - 1 - down];
  assert(contains(status, std::string("from the ") + (up < n ? "floor" : "ceiling") + ", position " +
                              std::to_string(position) + ", tetrahedron " + std::to_string(cell) + " "));
  const auto rule =
      std::find_if(std::begin(rules), std::end(rules), [&](const auto& r) { return contains(status, r); });
  assert(rule != std::end(rules));
  return int(rule - rules);
}

void test_orders(int holes, int m, int layers) {
  const Mesh mesh = block(holes, m, layers);
  const Order order = find_order(mesh);
  assert(compare_with_definition(mesh, order) == -1);
  Order reversed(order.rbegin(), order.rend());
  assert(compare_with_definition(mesh, reversed) == 0);
}

// All swaps of two entries: some orders stay valid, the others break each of the rules.
void test_swaps(const Mesh& mesh) {
  Order order = find_order(mesh);
  std::size_t valid = 0, broken[std::size(rules)] = {};
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      std::swap(order[i], order[j]);
      const int rule = compare_with_definition(mesh, order);
      ++(rule < 0 ? valid : broken[rule]);
      std::swap(order[i], order[j]);
    }
  std::cout << "swaps: " << valid << " valid";
  for (std::size_t r = 0; r < std::size(rules); ++r)
    std::cout << ", " << broken[r] << " '" << rules[r] << "'";
  std::cout << std::endl;
  assert(valid > 0);
}

// Tetrahedra over the vertices 0, 1, ..., swept as listed; labels[c][i] is the label of the facet opposite to
// vertex i of tetrahedron c.
VMP::Status verify_labels(const std::vector<std::array<int, 4>>& cells,
                          const std::vector<std::array<int, 4>>& labels) {
  Mesh::Cell_vertices vertices;
  std::vector<Mesh::Cell_vertices> all;
  for (const auto& c : cells) {
    std::transform(c.begin(), c.end(), vertices.begin(), [](int v) { return VMP::Vertex_index(v); });
    all.push_back(vertices);
  }
  Mesh mesh;
  const VMP::Status status = mesh.assign(std::vector<Point>(6, CGAL::ORIGIN), all, labels);
  assert(status.ok());
  const Order order(mesh.cells().begin(), mesh.cells().end());
  compare_with_definition(mesh, order);
  return VMP::verify_product(mesh, order);
}

void test_labels() {
  const std::array<int, 4> cell = {0, 1, 2, 3};
  assert(verify_labels({cell}, {{3, 3, 2, 1}}).ok());
  assert(verify_labels({cell}, {{3, 2, 1, 1}}).ok());
  assert(contains(verify_labels({cell}, {{3, 3, 3, 1}}), "has no facet to leave by"));
  assert(contains(verify_labels({cell}, {{1, 1, 1, 1}}), "has no facet to leave by"));
  assert(contains(verify_labels({cell}, {{3, 3, 3, 2}}), "has no facet to enter by"));
  // only the way back is wrong
  assert(contains(verify_labels({cell}, {{3, 3, 0, 1}}),
                  "from the ceiling, position 0, tetrahedron 0 has no facet"));
  // a second tetrahedron brings the edge 2 3 into the floor and onto the wall
  assert(contains(verify_labels({cell, {2, 3, 4, 5}}, {{2, 2, 1, 1}, {2, 2, 2, 1}}),
                  "outside of its entry facets, in edge 2 3"));
  assert(contains(verify_labels({cell, {2, 3, 4, 5}}, {{2, 2, 1, 1}, {2, 2, 2, 3}}),
                  "reaches the wall from inside, in edge 2 3"));
}

void test_permutations() {
  const Mesh mesh = block(0, 1, 1);
  const Order order = find_order(mesh);
  const auto refusal = [&](const Order& bad) {
    const VMP::Status status = VMP::verify_product(mesh, bad);
    assert(status.code() == VMP::ERROR_SWEEP_RULE);
    return status;
  };
  Order bad = order;
  bad.pop_back();
  assert(contains(refusal(bad), "names 17 tetrahedra of 18"));
  assert(!refusal({}).ok());
  bad = order;
  bad[7] = bad[2];
  assert(
      contains(refusal(bad), "position 7, tetrahedron " + std::to_string(bad[2]) + " comes a second time"));
  bad[5] = VMP::Cell_index(18);
  assert(contains(refusal(bad), "position 5, tetrahedron 18 does not exist"));
  bad[5] = VMP::Cell_index();
  assert(contains(refusal(bad), "does not exist"));
}

int main() {
  for (int holes = 0; holes < 3; ++holes)
    for (int m = 1; m < 3; ++m)
      for (int layers = 1; layers < 3; ++layers) test_orders(holes, m, layers);
  test_swaps(block(0, 1, 2));
  test_swaps(block(1, 1, 1));
  test_swaps(block(1, 1, 2));
  test_labels();
  test_permutations();
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
