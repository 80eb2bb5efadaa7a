// The main job for Python: arrays of numpy in, arrays of numpy out.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Volume_mesh_parameterization/Parameterization_search_3.h>
#include <CGAL/Volume_mesh_parameterization/check_tetrahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/hexahedral_mesh.h>
#include <CGAL/Volume_mesh_parameterization/optimize_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/parameterize.h>
#include <CGAL/Volume_mesh_parameterization/pillow_hexahedra.h>
#include <CGAL/Volume_mesh_parameterization/verify_hexahedra.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace py = pybind11;
namespace VMP = CGAL::Volume_mesh_parameterization;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Kernel::Point_2;
using Point_3 = Kernel::Point_3;
using Mesh = VMP::Compact_tetrahedral_mesh_3<Kernel>;
using Tag = CGAL::Parallel_if_available_tag;
using Reals = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<std::int64_t, py::array::c_style>; // no forcecast: 1.5 is no vertex
using Direction = std::array<double, 3>;

// A failed stage as a C++ exception, which becomes one of Python.
struct Failure : std::runtime_error {
  explicit Failure(const VMP::Status& status) : std::runtime_error(status.message()), code(status.code()) {}
  VMP::Error_code code;
};

void require(const VMP::Status& status) {
  if (PyErr_Occurred()) throw py::error_already_set(); // the visitor stopped
  if (!status.ok()) throw Failure(status);
}

// Lets Ctrl-C stop the computation.
struct Interruptible_visitor {
  bool start_stage(const char*) { return PyErr_CheckSignals() == 0; }
  bool advance(std::size_t, std::size_t) { return PyErr_CheckSignals() == 0; }
};

// Lists the rows of an array of shape (n, columns).
template <std::size_t columns, typename Array>
auto rows(const Array& array, const char* name) {
  using T = std::conditional_t<std::is_same<Array, Reals>::value, double, std::size_t>;
  if (array.ndim() != 2 || array.shape(1) != py::ssize_t(columns))
    throw py::value_error(std::string(name) + " must have the shape (n, " + std::to_string(columns) + ")");
  std::vector<std::array<T, columns>> result(std::size_t(array.shape(0)));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < columns; ++j) result[i][j] = T(array.at(i, j));
  return result;
}

int label_of(std::int64_t number) {
  const int label = int(number);
  if (label != number) throw py::value_error("the label " + std::to_string(number) + " is too large");
  return label;
}

std::vector<Point_3> points_of(const Reals& array) {
  std::vector<Point_3> points;
  for (const auto& p : rows<3>(array, "points")) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

// Makes an array of shape (number of rows, columns); `row` takes a number and returns what has an operator[].
template <typename T, typename Row>
py::array_t<T> table(std::size_t number_of_rows, int columns, const Row& row) {
  py::array_t<T> result({py::ssize_t(number_of_rows), py::ssize_t(columns)});
  auto entry = result.template mutable_unchecked<2>();
  for (std::size_t i = 0; i < number_of_rows; ++i) {
    const auto& r = row(i);
    for (int j = 0; j < columns; ++j) entry(i, j) = T(r[j]);
  }
  return result;
}

template <typename Values>
py::array_t<std::int64_t> list(const Values& values) {
  py::array_t<std::int64_t> result(py::ssize_t(values.size()));
  auto entry = result.mutable_unchecked<1>();
  for (std::size_t i = 0; i < values.size(); ++i) entry(i) = std::int64_t(values[i]);
  return result;
}

py::array_t<double> table_of(const std::vector<Point_3>& points) {
  return table<double>(points.size(), 3, [&](std::size_t i) { return points[i]; });
}

// Labelled triangles or quadrilaterals as two arrays.
template <int corners, typename Facets>
py::tuple facets_and_labels(const Facets& facets) {
  std::vector<int> labels;
  for (const auto& f : facets) labels.push_back(f.label);
  return py::make_tuple(
      table<std::int64_t>(facets.size(), corners, [&](std::size_t i) { return facets[i].vertices; }),
      list(labels));
}

// A mesh whose cells are swept in an order, and the images of its vertices.
py::dict mesh_and_map(const Mesh& mesh, const std::vector<VMP::Cell_index>& order,
                      const std::vector<Point_3>& images) {
  py::dict result;
  result["points"] = table_of(mesh.points());
  result["cells"] =
      table<std::int64_t>(mesh.number_of_cells(), 4, [&](std::size_t c) { return mesh.cell(c); });
  const py::tuple facets = facets_and_labels<3>(VMP::make_soup(mesh).facets);
  result["triangles"] = facets[0];
  result["labels"] = facets[1];
  result["order"] = list(order);
  result["uvw"] = table_of(images);
  return result;
}

class Parameterization {
public:
  Parameterization(const Reals& points, const Integers& cells, const Integers& triangles,
                   const Integers& labels) {
    VMP::Tetrahedron_soup_3<Point_3> soup;
    soup.points = points_of(points);
    soup.cells = rows<4>(cells, "cells");
    for (const auto& vertices : rows<3>(triangles, "triangles")) soup.facets.push_back({vertices, 0});
    if (labels.ndim() != 1 || labels.size() != py::ssize_t(soup.facets.size()))
      throw py::value_error("there must be one label for each triangle");
    for (std::size_t i = 0; i < soup.facets.size(); ++i) soup.facets[i].label = label_of(labels.at(i));
    VMP::orient_cells(soup);
    Mesh mesh;
    require(mesh.assign(soup));
    require(VMP::check_tetrahedral_mesh(mesh));
    auto partitions = soup.facets.empty() ? VMP::Partition_sequence_3<Kernel>(std::move(mesh))
                                          : VMP::Partition_sequence_3<Kernel>::of_labels(std::move(mesh));
    require(m_search.run<Tag>(partitions, CGAL::parameters::visitor(Interruptible_visitor())));
  }

  Parameterization(const Reals& points, const Integers& triangles, std::size_t number_of_cells,
                   const std::optional<Direction>& direction) {
    VMP::Triangle_soup_3<Point_3> surface;
    surface.points = points_of(points);
    surface.triangles = rows<3>(triangles, "triangles");
    const auto np = VMP::parameters::combine(CGAL::parameters::visitor(Interruptible_visitor()),
                                             VMP::parameters::number_of_cells(number_of_cells));
    if (direction) {
      const Kernel::Vector_3 d((*direction)[0], (*direction)[1], (*direction)[2]);
      require(VMP::parameterize_surface<Tag>(
          surface, m_search, VMP::parameters::combine(np, VMP::parameters::sweep_direction(d))));
    } else {
      require(VMP::parameterize_surface<Tag>(surface, m_search, np));
    }
  }

  int genus() const { return solid().partition().genus; }

  py::dict mesh() const {
    return mesh_and_map(solid().mesh(), solid().product_structure()->order(), solid().vertex_images());
  }

  py::object piecewise_linear() const {
    const VMP::Piecewise_linear_map_3<Kernel>& map = m_search.linear_map();
    if (!map.is_valid()) return py::none();
    return mesh_and_map(map.mesh(), map.order(), map.images());
  }

  std::string why_not_piecewise_linear() const {
    return m_search.linear_status().ok() ? std::string() : m_search.linear_status().message();
  }

  py::dict hexahedra(std::size_t number, bool has_pillow) const {
    const VMP::Prism_3<Kernel>& prism = solid().floor_map()->domain();
    const auto column = [this](const Point_2& foot, const std::vector<double>& levels,
                               std::vector<Point_3>& points) {
      return solid().product_map()->column(foot, levels, points);
    };
    VMP::Hexahedron_soup_3<Point_3> mesh;
    require(
        VMP::hexahedral_mesh<Tag>(prism, VMP::prism_grid_of_size(prism, number, has_pillow), column, mesh));
    VMP::Hexahedra_optimization options;
    options.slides_over_smooth_rims = has_pillow;
    if (has_pillow) require(VMP::pillow_hexahedra(mesh));
    require(VMP::optimize_hexahedra<Tag>(solid().mesh(), mesh, options));
    require(VMP::verify_hexahedra(mesh).status);
    py::dict result;
    result["points"] = table_of(mesh.points);
    result["cells"] =
        table<std::int64_t>(mesh.hexahedra.size(), 8, [&](std::size_t i) { return mesh.hexahedra[i]; });
    const py::tuple facets = facets_and_labels<4>(mesh.facets);
    result["quadrilaterals"] = facets[0];
    result["labels"] = facets[1];
    return result;
  }

private:
  const VMP::Direct_product_parameterizer_3<Kernel>& solid() const { return *m_search.parameterizer(); }

  VMP::Parameterization_search_3<Kernel> m_search;
};

// Failures become exceptions of class Error, with the code as an attribute.
void register_failures(py::module_& module) {
  // never destroyed: the interpreter ends first
  static const py::object& error = *new py::object(py::exception<Failure>(module, "Error", PyExc_ValueError));
  py::register_exception_translator([](std::exception_ptr pointer) {
    try {
      if (pointer) std::rethrow_exception(pointer);
    } catch (const Failure& failure) {
      const py::object instance = error(failure.what());
      instance.attr("code") = int(failure.code);
      PyErr_SetObject(error.ptr(), instance.ptr());
    }
  });
}

} // namespace

PYBIND11_MODULE(volume_mesh_parameterization, module) {
  using namespace py::literals;
  module.doc() = "Maps solids with holes one to one onto blocks with holes.";
  register_failures(module);
  py::class_<Parameterization>(module, "Parameterization", "A solid that is mapped onto a prism.")
      .def_property_readonly("genus", &Parameterization::genus, "the number of holes")
      .def("mesh", &Parameterization::mesh,
           "returns the tetrahedra with their certificate and map: a dictionary of the arrays points (n, 3), "
           "cells (m, 4), "
           "triangles (k, 3) of the boundary and their labels (k), order (m), in which the cells are swept, "
           "and uvw (n, 3), "
           "the image of each point. The first points are those that were given.")
      .def("piecewise_linear", &Parameterization::piecewise_linear,
           "returns a dictionary as mesh() does, of a map that is linear on each cell and one to one; its "
           "cells may be "
           "finer. None if there is no such map: see why_not_piecewise_linear().")
      .def("why_not_piecewise_linear", &Parameterization::why_not_piecewise_linear,
           "returns why piecewise_linear() has returned None; else an empty string.")
      .def("hexahedra", &Parameterization::hexahedra, "number"_a, "pillow"_a = false,
           "returns about `number` hexahedra, with a layer of them along the boundary if `pillow`: a "
           "dictionary of the arrays "
           "points (n, 3), cells (m, 8), quadrilaterals (k, 4) of the boundary and their labels (k). Raises "
           "Error if some "
           "would be inverted.");
  module.def(
      "parameterize",
      [](const Reals& points, const Integers& cells, const Integers& triangles, const Integers& labels) {
        return std::make_unique<Parameterization>(points, cells, triangles, labels);
      },
      "points"_a, "cells"_a, "triangles"_a = Integers(std::vector<py::ssize_t>{0, 3}),
      "labels"_a = Integers(0),
      "maps tetrahedra: points (n, 3), cells (m, 4), triangles (k, 3) of the boundary with their labels (k): "
      "1 floor, 2 "
      "ceiling, 3 + i wall i. Without triangles, the partition is found. Raises Error.");
  module.def(
      "parameterize_surface",
      [](const Reals& points, const Integers& triangles, std::size_t number_of_cells,
         const std::optional<Direction>& direction) {
        return std::make_unique<Parameterization>(points, triangles, number_of_cells, direction);
      },
      "points"_a, "triangles"_a, "number_of_cells"_a = 30000, "direction"_a = py::none(),
      "maps the inside of a closed surface: points (n, 3), triangles (m, 3). It is filled with about so many "
      "tetrahedra. "
      "The floor lies opposite to `direction`, a vector; by default a direction is found. Raises Error.");
}
