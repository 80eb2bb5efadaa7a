#ifndef HANDLEBODY_THREADS_H
#define HANDLEBODY_THREADS_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <string>
#include <thread>

// Bounds the number of threads as long as it lives. Without TBB there is but one.
class Thread_limit {
public:
  static constexpr std::size_t most = 1024;

#ifdef CGAL_LINKED_WITH_TBB
  explicit Thread_limit(std::size_t number)
      : m_control(tbb::global_control::max_allowed_parallelism, number) {}

  static std::size_t default_number() {
    return std::min(std::max<std::size_t>(std::thread::hardware_concurrency(), 1), most);
  }
  static std::string refusal(const std::string&) { return {}; }

private:
  tbb::global_control m_control;
#else
  explicit Thread_limit(std::size_t) {}

  static std::size_t default_number() { return 1; }
  static std::string refusal(const std::string& number) {
    return number == "1" ? "" : "this program was built without TBB: it has one thread";
  }
#endif
};

#endif // HANDLEBODY_THREADS_H
