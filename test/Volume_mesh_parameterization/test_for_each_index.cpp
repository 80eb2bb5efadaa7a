#undef NDEBUG
#include <CGAL/Volume_mesh_parameterization/internal/for_each_index.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace VMP = CGAL::Volume_mesh_parameterization;
using VMP::internal::Concurrency_for;
using VMP::internal::for_each_index;
using VMP::internal::try_all;
using VMP::internal::try_each_in_order;
using VMP::internal::try_each_index;

// Blocks are in order, and have each index once; there is no empty block.
void test_blocks() {
  for (std::size_t n : {0, 1, 6, 7, 8, 14, 1000})
    for (std::size_t size : {1, 7, 2000}) {
      const VMP::internal::Index_blocks blocks(n, size);
      std::size_t next = 0;
      for (std::size_t b = 0; b < blocks.size(); ++b) {
        assert(!blocks[b].empty());
        for (std::size_t i : blocks[b]) {
          assert(i == next++);
          assert(blocks.block_of(i) == b);
        }
      }
      assert(next == n);
    }
}

// Each index is met once, whatever the block.
template <typename Tag>
void test_loop() {
  for (std::size_t n : {0, 1, 2, 63, 64, 65, 10000})
    for (std::size_t block : {1, 7, 64, 20000}) {
      std::vector<int> calls(n, 0);
      for_each_index<Tag>(
          n, [&](std::size_t i) { ++calls[i]; }, block);
      assert(calls == std::vector<int>(n, 1));
    }
}

// Of many failures the first one is told, and everything before it is done.
template <typename Tag>
void test_failures() {
  constexpr std::size_t n = 5000;
  for (std::size_t first : {0, 1, 63, 64, 1234, 4999, 5000}) {
    std::vector<int> calls(n, 0);
    const VMP::Status status = try_each_index<Tag>(n, [&](std::size_t i) {
      ++calls[i];
      return i < first || i % 3 != first % 3
                 ? VMP::Status()
                 : VMP::Status(VMP::ERROR_CURVE_LOST, "vertex " + std::to_string(i));
    });
    assert(status.ok() == (first == n));
    if (first < n)
      assert(status.code() == VMP::ERROR_CURVE_LOST && status.detail() == "vertex " + std::to_string(first));
    for (std::size_t i = 0; i < first; ++i) assert(calls[i] == 1);
  }
}

// In another order the least failure is told, too, though it may not be met first.
template <typename Tag>
void test_order() {
  std::vector<std::size_t> order(5000);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k * 4999 % order.size(); // a permutation, and far from sorted
  for (std::size_t first : {0, 17, 4999, 5000}) {
    std::vector<int> calls(order.size(), 0);
    const VMP::Status status = try_each_in_order<Tag>(order, [&](std::size_t i) {
      ++calls[i];
      return i < first ? VMP::Status() : VMP::Status(VMP::ERROR_CURVE_LOST, std::to_string(i));
    });
    assert(status.ok() == (first == order.size()) && (status.ok() || status.detail() == std::to_string(first)));
    for (std::size_t i = 0; i < first; ++i) assert(calls[i] == 1);
  }
}

// All functions are called, or those before the first one that fails; its failure is told.
template <typename Tag>
void test_functions() {
  for (int first : {0, 1, 2, 3}) {
    std::vector<int> calls(3, 0);
    const auto function = [&](int i) {
      return [&calls, i, first] {
        ++calls[i];
        return i < first ? VMP::Status() : VMP::Status(VMP::ERROR_CURVE_LOST, std::to_string(i));
      };
    };
    const VMP::Status status = try_all<Tag>(function(0), function(1), function(2));
    assert(status.ok() == (first == 3) && (status.ok() || status.detail() == std::to_string(first)));
    for (int i = 0; i < first; ++i) assert(calls[i] == 1);
  }
}

template <typename Tag>
std::vector<double> results() {
  std::vector<double> x(3000);
  for_each_index<Tag>(x.size(),
                      [&](std::size_t i) { x[i] = std::sin(double(i)) / (1 + std::sqrt(double(i))); });
  return x;
}

template <typename Tag>
void test() {
  test_loop<Tag>();
  test_functions<Tag>();
  test_failures<Tag>();
  test_order<Tag>();
  assert(results<Tag>() == results<CGAL::Sequential_tag>());
}

int main() {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  static_assert(std::is_same<Concurrency_for<CGAL::Parallel_tag, double>, CGAL::Parallel_tag>::value, "");
  static_assert(std::is_same<Concurrency_for<CGAL::Parallel_tag, Exact>, CGAL::Sequential_tag>::value, "");
  test_blocks();
  test<CGAL::Sequential_tag>();
  test<CGAL::Parallel_if_available_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    test<CGAL::Parallel_tag>();
  }
  std::cout << "done with TBB" << std::endl;
#else
  std::cout << "done without TBB" << std::endl;
#endif
  return EXIT_SUCCESS;
}
