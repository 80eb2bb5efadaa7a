// Makes a solid a direct product, computes the chart of all its vertices, and prints as JSON what each stage costs.
// benchmark.py runs it and makes tables.
// usage: benchmark_stages FILE THREADS [SEEDS OUTPUT]
//   FILE    tetrahedra in MEDIT format with a labelled boundary
//   SEEDS   about how many interior vertices to trace once more, alone, for a comparison with other programs
//   OUTPUT  a VTU file to write for these: the prepared mesh with the harmonic function and the seeds

#include "benchmark_util.h"

#include <CGAL/Volume_mesh_parameterization/Direct_product_3.h>
#include <CGAL/Volume_mesh_parameterization/IO/VTU.h>
#include <CGAL/Volume_mesh_parameterization/compute_charts.h>

#include "threads.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using Product = VMP::Direct_product_3<Kernel>;
using Curves = Product::Curves;
using Location = Curves::Location;
using Chart = VMP::Curve_chart_3<Kernel>;
using Tag = CGAL::Parallel_if_available_tag;
using VMP::Status;

// Measures stages, each from its start to that of the next one.
class Stage_meter {
public:
  void start(const char* name) {
    finish();
    m_name = name;
    m_meter = Meter();
  }

  void finish() {
    if (!m_name.empty()) m_stages[m_name] = m_meter.measurement();
    m_name.clear();
  }

  const Json& stages() const { return m_stages; }

private:
  Json m_stages;
  std::string m_name;
  Meter m_meter;
};

// Tells the meter of the stages of the library, which copies its visitors.
struct Metering_visitor {
  bool start_stage(const char* name) {
    meter->start(name);
    return true;
  }
  bool advance(std::size_t, std::size_t) { return true; }

  Stage_meter* meter;
};

std::vector<Location> locations_of_vertices(const Mesh& mesh) {
  std::vector<Location> locations(mesh.number_of_vertices());
  for (VMP::Cell_index c : mesh.cells())
    for (int i = 0; i < 4; ++i) {
      Location& location = locations[mesh.vertex(c, i)];
      location = {c, {0, 0, 0, 0}};
      location.barycentric[i] = 1;
    }
  return locations;
}

// How many curves arrive, upwards and downwards, the cells that they pass, without those that they only touch, and their
// length.
Json measure_curves(const Mesh& mesh, const Curves& curves, const std::vector<Location>& locations) {
  std::size_t arrived = 0, crossings = 0;
  double length = 0;
  for (const Location& location : locations)
    for (VMP::Curve_direction direction : {VMP::DOWN, VMP::UP}) {
      Location at = location;
      VMP::Half_facet arrival;
      double elapsed;
      const auto count = [&](const Location& begin, const Location& end, double time) {
        crossings += time > 0;
        length += std::sqrt(CGAL::squared_distance(begin.point(mesh), end.point(mesh)));
      };
      arrived += curves.trace(at, direction, -1, arrival, elapsed, count).ok();
    }
  return {{"seeds", locations.size()},
          {"share_that_arrives", arrived / (2. * locations.size())},
          {"crossings", crossings},
          {"length", length}};
}

// Seeds are sorted before.
Json trace(const Mesh& mesh, const Curves& curves, const std::vector<Location>& locations) {
  const auto order = VMP::internal::order_by_feet(mesh, curves.field(), locations.size(),
                                                  [&](std::size_t i) { return locations[i].cell; });
  std::vector<Chart> charts(locations.size());
  const auto seed = [&](std::size_t k) { return locations[order[k]]; };
  const auto keep = [&](std::size_t k, const Chart& chart) {
    charts[order[k]] = chart;
    return true;
  };
  Json cost = measure([&] { static_cast<void>(VMP::internal::for_each_chart<Tag>(curves, order.size(), seed, keep)); });
  cost.update(measure_curves(mesh, curves, locations));
  return cost;
}

// FNV-1a, of the order of the sweep and of all charts: equal results have equal ones.
class Fingerprint {
public:
  template <typename T>
  void add(const T& value) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(&value);
    for (std::size_t i = 0; i < sizeof(T); ++i) m_hash = (m_hash ^ bytes[i]) * 1099511628211ull;
  }
  std::uint64_t value() const { return m_hash; }

private:
  std::uint64_t m_hash = 14695981039346656037ull;
};

std::uint64_t fingerprint(const Product& product, const std::vector<Chart>& charts) {
  Fingerprint result;
  for (VMP::Cell_index c : product.product_structure()->order()) result.add(std::size_t(c));
  for (const Chart& chart : charts) {
    result.add(std::size_t(chart.floor.facet));
    for (double x : chart.floor.barycentric) result.add(x);
    result.add(chart.below);
    result.add(chart.above);
  }
  return result.value();
}

// About `number` interior vertices, in the order of the mesh.
std::vector<int> choose_seeds(const Mesh& mesh, std::size_t number) {
  std::vector<int> is_seed(mesh.number_of_vertices(), 1);
  for (VMP::Facet_index f : mesh.boundary_facets())
    for (VMP::Vertex_index v : mesh.vertices(f)) is_seed[v] = 0;
  const std::size_t interior = std::count(is_seed.begin(), is_seed.end(), 1);
  const std::size_t step = std::max<std::size_t>(interior / number, 1);
  std::size_t k = 0;
  for (int& s : is_seed)
    if (s == 1) s = k++ % step == 0;
  return is_seed;
}

Status compare_seeds(const Product& product, const std::vector<Location>& locations, std::size_t number,
                     const char* output, Json& result) {
  const std::vector<int> is_seed = choose_seeds(product.mesh(), number);
  std::vector<Location> seeds;
  for (std::size_t v = 0; v < is_seed.size(); ++v)
    if (is_seed[v] == 1) seeds.push_back(locations[v]);
  result = trace(product.mesh(), product.curves(), seeds);
  VMP::IO::VTU_content content;
  content.with_facets = false;
  content.point_data = {{"f", product.harmonic_function()->values()}, {"is_seed", is_seed}};
  return VMP::IO::write_VTU(output, product.mesh(), content);
}

Status run(int argc, char** argv, Json& result) {
  Soup soup;
  const std::size_t base = CGAL::Memory_sizer().resident_size();
  Status status = read_solid(argv[1], soup);
  if (!status.ok()) return status;

  Product product;
  std::vector<Location> locations;
  std::vector<Chart> charts;
  Stage_meter meter;
  status = product.build<Tag>(soup, CGAL::parameters::visitor(Metering_visitor{&meter}));
  if (!status.ok()) return status;
  meter.start("compute the charts of all vertices");
  locations = locations_of_vertices(product.mesh());
  status = VMP::compute_charts<Tag>(product.curves(), locations, charts);
  meter.finish();

  result = {{"cells", soup.cells.size()},
            {"prepared_cells", product.mesh().number_of_cells()},
            {"base_bytes", base},
            {"fingerprint", std::to_string(fingerprint(product, charts))},
            {"stages", meter.stages()},
            {"curves_of_vertices", trace(product.mesh(), product.curves(), locations)}};
  if (status.ok() && argc > 3)
    status = compare_seeds(product, locations, std::stoul(argv[3]), argv[4], result["curves_of_seeds"]);
  return status;
}

int main(int argc, char** argv) {
  if (argc != 3 && argc != 5) {
    std::cerr << "usage: benchmark_stages FILE THREADS [SEEDS OUTPUT]\n";
    return 2;
  }
  const Thread_limit limit(std::stoul(argv[2]));
  Json result;
  const Status status = run(argc, argv, result);
  if (!status.ok()) std::cerr << status.message() << std::endl;
  std::cout << result.dump(2) << std::endl;
  return status.ok() ? EXIT_SUCCESS : EXIT_FAILURE;
}
