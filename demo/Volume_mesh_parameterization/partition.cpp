#include "Stage_clock.h"
#include "commands.h"
#include "load_input.h"
#include "picks.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/Partition_search_3.h>
#include <CGAL/Volume_mesh_parameterization/tetrahedralize.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

using VMP::Status;
using Surface = VMP::Triangle_soup_3<Point_3>;
using Search = VMP::Partition_search_3<Kernel>;

namespace {

// One run of `handlebody partition`: reads, searches, lists what was found, and writes one of it.
class Partition_run {
public:
  explicit Partition_run(const Partition_command& options) : m_options(options), m_clock(options.quiet) {}

  Status run() {
    Status status = check_output();
    if (status.ok()) status = load();
    if (!status.ok()) return status;
    m_clock.start("partition");
    Search search(m_solid, search_options());
    status = search.run(Clock_visitor(m_clock));
    m_clock.finish();
    if (!status.ok()) return status;
    if (!m_options.quiet) list(search);
    if (m_options.chosen >= search.candidates().size())
      return {VMP::ERROR_NO_PARTITION, "there are only " + std::to_string(search.candidates().size()) + " candidates"};
    status = label(search);
    return status.ok() ? VMP::IO::write_MEDIT(m_options.output, m_solid) : status;
  }

private:
  Status check_output() const {
    std::error_code error;
    return std::filesystem::equivalent(m_options.input.file, m_options.output, error)
               ? Status(VMP::ERROR_CANNOT_WRITE_FILE, m_options.output + ": it is the input")
               : Status();
  }

  // A surface is filled as coarsely as it allows, to try partitions on.
  Status load() {
    m_clock.start("read and check");
    if (!is_surface_file(m_options.input.file)) {
      const Status status = read_tetrahedra(m_options.input.file, m_solid);
      return status.ok() && !m_options.picks.empty() ? apply_picks(m_options.picks, m_solid) : status;
    }
    Status status = read_surface(m_options.input.file, m_surface);
    if (status.ok()) status = apply_picks(m_options.picks, m_surface);
    if (status.ok()) cut_thin_triangles(m_options.input, m_surface);
    if (status.ok()) m_clock.start("tetrahedralize");
    return status.ok() ? VMP::tetrahedralize(m_surface, m_solid) : status;
  }

  VMP::Partition_options search_options() const {
    VMP::Partition_options options = partition_options(m_options.input);
    options.given_labels = m_options.picks.empty() ? m_options.given_labels : VMP::KEEP_LABELS;
    options.number_of_candidates = std::max(m_options.number_of_candidates, m_options.chosen + 1);
    return options;
  }

  Status label(const Search& search) {
    if (!is_surface_file(m_options.input.file)) return search.label(m_options.chosen, m_solid);
    search.label(m_options.chosen, m_surface);
    return VMP::tetrahedralize(m_surface, m_solid, m_options.input.number_of_tetrahedra);
  }

  static void list(const Search& search) {
    std::printf("%zu legal of %zu tried\n", search.candidates().size(), search.number_of_trials());
    std::printf("%2s %-8s %-22s %6s %7s %6s %5s %6s %5s %5s  %s\n", "#", "by", "direction", "floor", "ceiling", "walls", "rims",
                "zigzag", "gap", "cost", "smallest wall");
    for (std::size_t i = 0; i < search.candidates().size(); ++i) {
      const VMP::Partition_candidate_3& c = search.candidates()[i];
      const VMP::Partition_quality& q = c.quality;
      const auto& d = c.direction;
      std::printf("%2zu %-8s %6.3f,%6.3f,%6.3f   %5.1f%% %6.1f%% %5.1f%% %5.2f %6.3f %5.3f %5.2f  %.2f%%\n", i,
                  VMP::method_name(c.method), d.x(), d.y(), d.z(), 100 * q.floor_share, 100 * q.ceiling_share,
                  100 * q.wall_share, q.rim_length, q.zigzag, q.wall_gap, c.cost, 100 * q.smallest_wall * q.wall_share);
    }
    std::fflush(stdout);
  }

  const Partition_command& m_options;
  Stage_clock m_clock;
  Surface m_surface; // if the input is one
  Mesh m_solid;
};

} // namespace

int partition(const Partition_command& options) {
  const Status status = Partition_run(options).run();
  if (status.ok()) return EVERYTHING_CERTIFIED;
  const bool is_refusal = status.code() != VMP::ERROR_CANCELLED && status.code() != VMP::ERROR_CANNOT_SPLIT;
  return say(options.input.file, status, is_refusal ? INPUT_REFUSED : NOT_CERTIFIED);
}
