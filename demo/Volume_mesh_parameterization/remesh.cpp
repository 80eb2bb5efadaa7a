#include "Result_folder.h"
#include "Stage_clock.h"
#include "commands.h"
#include "hexahedra.h"
#include "load_result.h"
#include "report.h"
#include "result_files.h"

#include <vector>

using VMP::Status;

namespace {

// One run of `handlebody hexahedra`: checks a result from scratch, and makes hexahedra by its piecewise linear map.
class Remeshing {
public:
  explicit Remeshing(const Remesh_command& options)
      : m_options(options), m_source(options.folder), m_folder(options.output), m_clock(options.quiet) {}

  int run() {
    const Status writable = m_folder.create(m_source.file(Result_folder::object));
    if (!writable.ok()) return say(m_options.output, writable, INPUT_REFUSED);
    m_report["input"] = {{"folder", m_options.folder}};
    m_report["threads"] = m_options.threads;
    Status status = load();
    if (!status.ok()) return finish(status, INPUT_REFUSED);
    VMP::Hexahedron_soup_3<Point_3> hexahedra;
    m_clock.start("hexahedra");
    status = make_hexahedra(m_options.hexahedra, m_solid, m_prism, m_images, m_report, hexahedra);
    if (!status.ok()) return finish(status, NOT_CERTIFIED);
    status = write_hexahedra_files(m_folder, hexahedra, m_options.hexahedra.formats);
    return finish(status, status.ok() ? EVERYTHING_CERTIFIED : INPUT_REFUSED);
  }

private:
  Status load() {
    if (!m_source.has(Result_folder::object)) return {VMP::ERROR_CANNOT_READ_FILE, "it has no object.mesh"};
    if (!m_source.has(Result_folder::parameter))
      return {VMP::ERROR_CANNOT_READ_FILE, "it has no parameter.mesh: no piecewise linear map was found"};
    m_clock.start("check");
    VMP::Boundary_partition_3 partition;
    Status status = load_solid(m_source, Result_folder::object, m_solid, partition);
    if (status.ok()) status = load_images(m_source, m_solid, m_images);
    return status.ok() ? find_prism(m_solid, m_images, m_prism) : status;
  }

  int finish(const Status& status, int exit_code) {
    return end_report(m_options.folder, status, exit_code, m_clock, m_report, m_folder);
  }

  const Remesh_command& m_options;
  Result_folder m_source, m_folder;
  Stage_clock m_clock;
  Mesh m_solid;
  std::vector<Point_3> m_images; // of the vertices of the solid
  VMP::Prism_3<Kernel> m_prism;
  Json m_report;
};

} // namespace

int remesh(const Remesh_command& options) {
  const Thread_limit limit(options.threads);
  return Remeshing(options).run();
}
