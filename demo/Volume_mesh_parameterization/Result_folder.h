#ifndef HANDLEBODY_RESULT_FOLDER_H
#define HANDLEBODY_RESULT_FOLDER_H

#include <CGAL/Volume_mesh_parameterization/Error_code.h>
#include <CGAL/Volume_mesh_parameterization/indices.h>

#include <string>
#include <vector>

// The folder with the files of a result. Files of an earlier result are removed first, so that a folder never holds
// parts of two.
class Result_folder {
public:
  explicit Result_folder(std::string path) : m_path(std::move(path)) {}

  std::string file(const char* name) const { return m_path + "/" + name; }
  bool has(const char* name) const;

  // Refuses to remove or overwrite the file `input`.
  CGAL::Volume_mesh_parameterization::Status create(const std::string& input) const;

  CGAL::Volume_mesh_parameterization::Status
  write_order(const char* name, const std::vector<CGAL::Volume_mesh_parameterization::Cell_index>& order) const;
  CGAL::Volume_mesh_parameterization::Status write_text(const char* name, const std::string& text) const;

  static constexpr const char* object = "object.mesh";
  static constexpr const char* order = "order.txt";
  static constexpr const char* domain = "domain.mesh";            // of a given polycube
  static constexpr const char* domain_order = "domain_order.txt"; // its product certificate
  static constexpr const char* parameter = "parameter.mesh";
  static constexpr const char* hexahedra = "hex.mesh";
  static constexpr const char* gmsh_hexahedra = "hex.msh";
  static constexpr const char* abaqus_hexahedra = "hex.inp";
  static constexpr const char* vtu_hexahedra = "hex.vtu";
  static constexpr const char* result = "result.vtu";
  static constexpr const char* curves = "curves.vtp";
  static constexpr const char* report = "report.json";

private:
  std::string m_path;
};

// Reads cells, one a line, as write_order() of a folder writes them.
CGAL::Volume_mesh_parameterization::Status
read_order(const std::string& file, std::vector<CGAL::Volume_mesh_parameterization::Cell_index>& order);

#endif // HANDLEBODY_RESULT_FOLDER_H
