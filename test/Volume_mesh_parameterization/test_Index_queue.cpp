#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/internal/Index_queue.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <random>
#include <set>

using CGAL::Volume_mesh_parameterization::internal::Index_queue;

// Random pushes, some of what is there already, and pops, compared with an ordered set.
void test_against_set(std::size_t n) {
  Index_queue queue(n);
  std::set<std::uint32_t> expected;
  std::mt19937 random(7);
  assert(queue.empty());
  const auto pop = [&] {
    assert(!queue.empty() && queue.pop() == *expected.begin());
    expected.erase(expected.begin());
  };
  for (int k = 0; k < 20000 && n > 0; ++k) {
    const bool is_growing = k / 1000 % 2 == 0;
    if (!expected.empty() && random() % 3 == (is_growing ? 0 : random() % 2)) pop();
    const std::uint32_t i(random() % n);
    queue.push(i);
    expected.insert(i);
  }
  while (!expected.empty()) pop();
  assert(queue.empty());
}

void test_all(std::size_t n) {
  Index_queue queue(n);
  for (std::size_t i = n; i-- > 0;) queue.push(std::uint32_t(i));
  for (std::size_t i = 0; i < n; ++i) assert(queue.pop() == i);
  assert(queue.empty());
}

int main() {
  for (std::size_t n : {0, 1, 2, 63, 64, 65, 4095, 4096, 4097, 262143, 262144, 262145, 1000000}) {
    test_against_set(n);
    test_all(n);
  }
  std::cout << "done" << std::endl;
  return EXIT_SUCCESS;
}
