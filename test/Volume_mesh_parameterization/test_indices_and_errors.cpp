#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>

#include <cassert>
#include <cstdlib>
#include <iostream>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace VMP = CGAL::Volume_mesh_parameterization;

// Each code has a sentence of its own.
void test_messages() {
  std::set<std::string> messages;
  for (int code = VMP::OK; code <= VMP::ERROR_CANCELLED; ++code) {
    const std::string message = VMP::get_error_message(VMP::Error_code(code));
    assert(!message.empty() && messages.insert(message).second);
  }
  std::cout << messages.size() << " messages" << std::endl;
}

void test_status() {
  const VMP::Status good;
  assert(good.ok() && good.code() == VMP::OK && good.message() == VMP::get_error_message(VMP::OK));
  const VMP::Status bad(VMP::ERROR_FLAT_TETRAHEDRON, "tetrahedron 7");
  assert(!bad.ok() && bad.code() == VMP::ERROR_FLAT_TETRAHEDRON && bad.detail() == "tetrahedron 7");
  assert(bad.message() == std::string(VMP::get_error_message(VMP::ERROR_FLAT_TETRAHEDRON)) + ": tetrahedron 7");
}

// A cell is not taken for a vertex, nor a number for either; each looks up arrays.
void test_indices() {
  static_assert(!std::is_convertible<int, VMP::Cell_index>::value);
  static_assert(!std::is_same<VMP::Cell_index, VMP::Vertex_index>::value);
  VMP::Cell_index c;
  assert(!c.is_valid());
  c = VMP::Cell_index(1);
  assert(c.is_valid() && (++c, c == VMP::Cell_index(2)));
  const std::vector<int> values = {5, 6, 7};
  assert(values[c] == 7);
}

int main() {
  test_messages();
  test_status();
  test_indices();
  return EXIT_SUCCESS;
}
