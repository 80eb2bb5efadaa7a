#undef NDEBUG
#undef CGAL_LINKED_WITH_TBB // even where TBB is found
#include "test_for_each_index.cpp"
