#include "Result_folder.h"
#include "commands.h"
#include "load_result.h"
#include "types.h"

#include <CGAL/Volume_mesh_parameterization/IO/MEDIT.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_product.h>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using VMP::Status;

namespace {

// Says what holds of each file, or what does not.
class Verdicts {
public:
  explicit Verdicts(bool quiet) : m_quiet(quiet) {}

  bool operator()(const std::string& file, const Status& status, const std::string& what_holds) {
    if (!status.ok()) {
      std::cerr << file << ": " << status.message() << std::endl;
      const bool unreadable = status.code() == VMP::ERROR_CANNOT_READ_FILE || status.code() == VMP::ERROR_WRONG_FORMAT;
      m_exit_code = unreadable ? INPUT_REFUSED : NOT_CERTIFIED;
    } else if (!m_quiet)
      std::cout << file << ": " << what_holds << std::endl;
    return status.ok();
  }
  int exit_code() const { return m_exit_code; }

private:
  bool m_quiet;
  int m_exit_code = EVERYTHING_CERTIFIED;
};

Status verify_solid(const Result_folder& folder, const char* file, Mesh& mesh, std::string& what_holds) {
  VMP::Boundary_partition_3 partition;
  const Status status = load_solid(folder, file, mesh, partition);
  what_holds = std::to_string(mesh.number_of_cells()) + " tetrahedra, a handlebody of genus " +
               std::to_string(partition.genus) + " with a legal partition";
  return status;
}

Status verify_order(const Result_folder& folder, const char* file, const Mesh& mesh) {
  std::vector<VMP::Cell_index> order;
  const Status status = read_order(folder.file(file), order);
  return status.ok() ? VMP::verify_product(mesh, order) : status;
}

Status verify_hexahedra(const Result_folder& folder, std::string& what_holds) {
  VMP::Hexahedron_soup_3<Point_3> hexahedra;
  const Status status = VMP::IO::read_MEDIT(folder.file(Result_folder::hexahedra), hexahedra);
  if (!status.ok()) return status;
  const VMP::Hexahedra_report report = VMP::verify_hexahedra(hexahedra);
  std::ostringstream text;
  text << hexahedra.hexahedra.size() << " hexahedra, none inverted, " << report.irregular_edges
       << " irregular interior edges, scaled Jacobian at least " << report.minimum_scaled_jacobian << ", in the mean "
       << report.mean_scaled_jacobian;
  what_holds = text.str();
  return report.status;
}

// Whether the mesh, at least, could be used.
bool verify_product(const Result_folder& folder, const char* solid, const char* order, Mesh& mesh, Verdicts& verdict) {
  std::string what_holds;
  const Status status = verify_solid(folder, solid, mesh, what_holds);
  if (!verdict(solid, status, what_holds)) return false;
  verdict(order, verify_order(folder, order, mesh), "a product certificate: the solid is its floor times an interval");
  return true;
}

} // namespace

int verify(const std::string& path, bool quiet) {
  const Result_folder folder(path);
  Verdicts verdict(quiet);
  Mesh mesh, domain;
  const bool has_hexahedra_only = folder.has(Result_folder::hexahedra) && !folder.has(Result_folder::object);
  if (!has_hexahedra_only && !verify_product(folder, Result_folder::object, Result_folder::order, mesh, verdict))
    return verdict.exit_code();
  if (folder.has(Result_folder::domain))
    verify_product(folder, Result_folder::domain, Result_folder::domain_order, domain, verdict);
  std::vector<Point_3> images;
  if (folder.has(Result_folder::parameter))
    verdict(Result_folder::parameter, load_images(folder, mesh, images), "a piecewise linear bijection");
  if (folder.has(Result_folder::hexahedra)) {
    std::string what_holds;
    const Status status = verify_hexahedra(folder, what_holds);
    verdict(Result_folder::hexahedra, status, what_holds);
  }
  return verdict.exit_code();
}
