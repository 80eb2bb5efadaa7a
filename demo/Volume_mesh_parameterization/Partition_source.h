#ifndef HANDLEBODY_PARTITION_SOURCE_H
#define HANDLEBODY_PARTITION_SOURCE_H

#include "load_input.h"

#include <cstddef>
#include <optional>
#include <vector>

// The labelled solids of an input: that with the labels of the file, or one for each partition worth trying, the best first.
class Partition_source {
public:
  Partition_source(const Input_options& options, Stage_clock& clock) : m_options(options), m_clock(clock) {}

  // Reads and checks the file, labels the boundary unless it is labelled, and tetrahedralizes a surface.
  VMP::Status first(Input& input);
  // Labels the same input in another way; returns `ERROR_NO_PARTITION` if there is no further one.
  VMP::Status next(Input& input);

private:
  using Search = VMP::Partition_search_3<Kernel>;

  VMP::Status open_surface(Input& input);
  VMP::Status open_tetrahedra(Input& input);
  VMP::Status search();
  VMP::Status label(std::size_t candidate, Input& input) const;
  bool is_like_one_tried(const VMP::Partition_candidate_3& candidate) const;

  const Input_options& m_options;
  Stage_clock& m_clock;
  VMP::Triangle_soup_3<Point_3> m_surface; // if the input is one whose triangles the mesher keeps
  Mesh m_solid;
  std::optional<Search> m_search;
  int m_searches = 0;
  std::size_t m_next = 0; // candidate of the search
  std::vector<VMP::Partition_candidate_3> m_tried;
};

#endif // HANDLEBODY_PARTITION_SOURCE_H
