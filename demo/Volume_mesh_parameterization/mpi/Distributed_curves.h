#ifndef HANDLEBODY_MPI_DISTRIBUTED_CURVES_H
#define HANDLEBODY_MPI_DISTRIBUTED_CURVES_H

#include "Distributed_mesh.h"

#include <CGAL/Volume_mesh_parameterization/Integral_curve_3.h>

#include <petscdmswarm.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <unordered_map>
#include <vector>

// The curves of a certified field, from the floor to the ceiling of a distributed mesh. Each process follows them through
// its own cells; at a ghost they go on in the process that owns it, to which PETSc's DMSwarm moves them as particles.
class Distributed_curves {
public:
  using Field = VMP::Curve_field_3<Kernel>;
  using Location = VMP::Location_3<Kernel>;

  struct Curve {
    Location at; // its cell has the number that it has in the process that follows the curve
    double level;
    std::uint32_t seed, cells; // the place of its start among all, the number of cells that it has passed
    std::int32_t arrival;      // the facet of the ceiling, -1 on the way
  };

  // What tracing took, in all processes together.
  struct Costs {
    long long rounds = 0, crossings = 0; // a crossing leads from a cell of one process to one of another
    long long moves = 0;                 // those, and the ways from and to the first process
    double messages = 0, bytes_sent = 0, seconds = 0;
  };

  // `field` is that of the whole mesh in the first process, and empty in the others.
  Distributed_curves(const Distributed_mesh& mesh, const Field& field)
      : m_originals(mesh.original_cells()), m_owners(mesh.owners_of_cells()), m_cells(m_owners.size()) {
    connect_with_originals();
    receive_cells(field);
    send_owners();
    create_swarm();
  }
  ~Distributed_curves() {
    DMDestroy(&m_swarm);
    PetscSFDestroy(&m_connection);
  }
  Distributed_curves(const Distributed_curves&) = delete;
  Distributed_curves& operator=(const Distributed_curves&) = delete;

  // returns where the curves arrive, in the order of `starts`, in the first process. There, both have cells of the whole
  // mesh; in the others both are empty.
  std::vector<Curve> trace(const std::vector<Location>& starts) {
    const double start = MPI_Wtime(), messages = petsc_isend_ct, bytes = petsc_isend_len;
    long long leaving = sow(starts);
    do {
      petsc_call(DMSwarmMigrate(m_swarm, PETSC_TRUE));
      ++m_costs.rounds;
      m_costs.moves += leaving;
      leaving = advance();
    } while (leaving > 0);
    m_costs.crossings = sum(m_costs.crossings, MPI_LONG_LONG);
    m_costs.messages = sum(petsc_isend_ct - messages, MPI_DOUBLE);
    m_costs.bytes_sent = sum(petsc_isend_len - bytes, MPI_DOUBLE);
    m_costs.seconds = MPI_Wtime() - start;
    return harvest();
  }

  const Costs& costs() const { return m_costs; }

private:
  using Cell = VMP::internal::Curve_cell<double>;
  static_assert(std::is_trivially_copyable_v<Curve> && std::is_trivially_copyable_v<Cell>,
                "they are sent as bytes");

  // The particles of this process, as arrays of PETSc.
  class Particles {
  public:
    explicit Particles(DM swarm) : m_swarm(swarm) {
      petsc_call(DMSwarmGetLocalSize(swarm, &m_size));
      petsc_call(DMSwarmGetField(swarm, "curve", nullptr, nullptr, reinterpret_cast<void**>(&curves)));
      petsc_call(
          DMSwarmGetField(swarm, DMSwarmField_rank, nullptr, nullptr, reinterpret_cast<void**>(&ranks)));
    }
    ~Particles() {
      DMSwarmRestoreField(m_swarm, "curve", nullptr, nullptr, reinterpret_cast<void**>(&curves));
      DMSwarmRestoreField(m_swarm, DMSwarmField_rank, nullptr, nullptr, reinterpret_cast<void**>(&ranks));
    }
    Particles(const Particles&) = delete;
    Particles& operator=(const Particles&) = delete;

    PetscInt size() const { return m_size; }

    Curve* curves = nullptr;
    PetscInt* ranks = nullptr; // of the processes where they are to be next

  private:
    DM m_swarm;
    PetscInt m_size = 0;
  };

  template <typename Number>
  static Number sum(Number x, MPI_Datatype type) {
    MPI_Allreduce(MPI_IN_PLACE, &x, 1, type, MPI_SUM, PETSC_COMM_WORLD);
    return x;
  }

  // Each cell that a process knows has its original in the first process.
  void connect_with_originals() {
    std::vector<PetscSFNode> originals;
    for (PetscInt c : m_originals) originals.push_back({0, c});
    long long number_of_own = 0;
    for (const PetscSFNode& owner : m_owners) number_of_own += owner.rank == m_rank;
    m_number_of_originals = PetscInt(sum(number_of_own, MPI_LONG_LONG));
    petsc_call(PetscSFCreate(PETSC_COMM_WORLD, &m_connection));
    petsc_call(PetscSFSetGraph(m_connection, m_rank == 0 ? m_number_of_originals : 0,
                               PetscInt(originals.size()), nullptr, PETSC_OWN_POINTER, originals.data(),
                               PETSC_COPY_VALUES));
  }

  void receive_cells(const Field& field) {
    MPI_Datatype bytes = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(int(sizeof(Cell)), MPI_BYTE, &bytes);
    MPI_Type_commit(&bytes);
    const Cell* originals = m_rank == 0 ? &field.cell(VMP::Cell_index(0)) : nullptr;
    petsc_call(PetscSFBcastBegin(m_connection, bytes, originals, m_cells.data(), MPI_REPLACE));
    petsc_call(PetscSFBcastEnd(m_connection, bytes, originals, m_cells.data(), MPI_REPLACE));
    MPI_Type_free(&bytes);
    number_neighbors();
  }

  void send_owners() {
    m_owners_of_originals.resize(m_rank == 0 ? m_number_of_originals : 0);
    PetscSFNode* originals = m_owners_of_originals.data();
    petsc_call(PetscSFReduceBegin(m_connection, MPIU_2INT, m_owners.data(), originals, MPI_REPLACE));
    petsc_call(PetscSFReduceEnd(m_connection, MPIU_2INT, m_owners.data(), originals, MPI_REPLACE));
  }

  // Neighbors come with the numbers of the whole mesh. Those of ghosts are not needed, and may be unknown here.
  void number_neighbors() {
    std::unordered_map<PetscInt, std::size_t> places;
    for (std::size_t c = 0; c < m_originals.size(); ++c) places[m_originals[c]] = c;
    for (std::size_t c = 0; c < m_cells.size(); ++c)
      for (VMP::Cell_index& n : m_cells[c].neighbors)
        if (m_owners[c].rank == m_rank && n.is_valid()) n = VMP::Cell_index(places.at(PetscInt(n)));
  }

  void create_swarm() {
    petsc_call(DMCreate(PETSC_COMM_WORLD, &m_swarm));
    petsc_call(DMSetType(m_swarm, DMSWARM));
    petsc_call(DMSwarmSetType(m_swarm, DMSWARM_BASIC));
    petsc_call(DMSwarmInitializeFieldRegister(m_swarm));
    petsc_call(DMSwarmRegisterUserStructField(m_swarm, "curve", sizeof(Curve)));
    petsc_call(DMSwarmFinalizeFieldRegister(m_swarm));
  }

  // All curves begin as particles of the first process. Returns how many are to migrate.
  long long sow(const std::vector<Location>& starts) {
    petsc_call(DMSwarmSetLocalSizes(m_swarm, PetscInt(starts.size()), 0));
    const Particles particles(m_swarm);
    for (std::size_t k = 0; k < starts.size(); ++k) {
      const PetscSFNode& owner = m_owners_of_originals[starts[k].cell];
      const Location start{VMP::Cell_index(owner.index), starts[k].barycentric};
      particles.curves[k] = {start, 0, std::uint32_t(k), 0, -1};
      particles.ranks[k] = owner.rank;
    }
    return count_leaving(particles);
  }

  // Follows the curves that are here; returns how many are to migrate.
  long long advance() {
    const Particles particles(m_swarm);
    for (PetscInt k = 0; k < particles.size(); ++k)
      if (particles.curves[k].arrival < 0) particles.ranks[k] = follow(particles.curves[k]);
    return count_leaving(particles);
  }

  // In all processes.
  long long count_leaving(const Particles& particles) const {
    const auto here = std::count(particles.ranks, particles.ranks + particles.size(), m_rank);
    return sum(static_cast<long long>(particles.size() - here), MPI_LONG_LONG);
  }

  // As Integral_curves_3 does. In a certified field every cell has an exit, no curve passes a cell twice, and exits on the
  // boundary are on the ceiling. Returns where the particle is to be next: if it has arrived, in the first process.
  PetscInt follow(Curve& curve) {
    Curve here = curve;
    PetscInt next = m_rank;
    while (here.arrival < 0 && next == m_rank) {
      const Cell& cell = m_cells[here.at.cell];
      const auto fetch = [&](VMP::Cell_index c) { VMP::internal::prefetch(&m_cells[c]); };
      const auto [exit, time] = cell.exit_of(here.at.barycentric, VMP::UP, fetch);
      auto end = cell.moved(here.at.barycentric, VMP::UP * time);
      end[exit] = 0;
      here.level += time;
      ++here.cells;
      next = cell.neighbors[exit].is_valid() ? enter_neighbor(cell, exit, end, here.at)
                                             : arrive(exit, end, here);
    }
    curve = here;
    return next;
  }

  PetscInt enter_neighbor(const Cell& cell, int exit, const std::array<double, 4>& end, Location& at) {
    cell.enter_neighbor(exit, end, at.barycentric);
    const PetscSFNode& owner = m_owners[cell.neighbors[exit]];
    at.cell = VMP::Cell_index(owner.index);
    m_costs.crossings += owner.rank != m_rank;
    return owner.rank;
  }

  PetscInt arrive(int exit, const std::array<double, 4>& end, Curve& curve) const {
    curve.at = {VMP::Cell_index(m_originals[curve.at.cell]), end};
    curve.arrival = exit;
    return 0;
  }

  std::vector<Curve> harvest() const {
    const Particles particles(m_swarm);
    std::vector<Curve> result(particles.curves, particles.curves + particles.size());
    std::sort(result.begin(), result.end(), [](const Curve& a, const Curve& b) { return a.seed < b.seed; });
    return result;
  }

  PetscInt m_rank = Distributed_mesh::rank();
  std::vector<PetscInt> m_originals; // the numbers of the cells in the whole mesh
  std::vector<PetscSFNode> m_owners; // the process that owns each cell, and its number there
  std::vector<Cell> m_cells;         // those of ghosts are not used
  PetscSF m_connection = nullptr;    // of the cells with their originals
  PetscInt m_number_of_originals = 0;
  std::vector<PetscSFNode> m_owners_of_originals; // in the first process
  DM m_swarm = nullptr;
  Costs m_costs;
};

#endif // HANDLEBODY_MPI_DISTRIBUTED_CURVES_H
