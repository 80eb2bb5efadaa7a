#ifndef HANDLEBODY_CHOSEN_SOLVER_TRAITS_H
#define HANDLEBODY_CHOSEN_SOLVER_TRAITS_H

#include "types.h"

#include <CGAL/Volume_mesh_parameterization/Default_solver_traits_3.h>
#include <CGAL/Volume_mesh_parameterization/Petsc_solver_traits_3.h>

#include <string>
#include <variant>
#include <vector>

// A model of SparseLinearAlgebraWithFactorTraits_d that takes the solver named on the command line: so the library is
// instantiated once, not once for each solver.
class Chosen_solver_traits {
public:
  using NT = double;
  using Matrix = CGAL::Eigen_sparse_symmetric_matrix<double>;
  using Vector = CGAL::Eigen_vector<double>;

  Chosen_solver_traits() {
    if (name() == "ldlt") m_solver.emplace<VMP::Simplicial_solver_traits_3>();
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
    if (name() == "cholmod") m_solver.emplace<VMP::Cholmod_solver_traits_3>();
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC
    if (name() == "petsc") m_solver.emplace<VMP::Petsc_solver_traits_3>();
#endif
  }

  static std::vector<std::string> names() {
    return {"cg", "ldlt",
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
            "cholmod",
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC
            "petsc",
#endif
    };
  }
  static void choose(const std::string& name_of_solver) { name() = name_of_solver; }

  bool linear_solver(const Matrix& matrix, const Vector& right, Vector& solution, NT& denominator) {
    return factor(matrix, denominator) && linear_solver(right, solution);
  }
  bool factor(const Matrix& matrix, NT& denominator) {
    return std::visit([&](auto& solver) { return solver.factor(matrix, denominator); }, m_solver);
  }
  bool linear_solver(const Vector& right, Vector& solution) {
    return std::visit([&](auto& solver) { return solver.linear_solver(right, solution); }, m_solver);
  }

private:
  static std::string& name() {
    static std::string chosen = "cg";
    return chosen;
  }

  std::variant<VMP::Default_solver_traits_3, VMP::Simplicial_solver_traits_3
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
               ,
               VMP::Cholmod_solver_traits_3
#endif
#ifdef CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC
               ,
               VMP::Petsc_solver_traits_3
#endif
               >
      m_solver;
};

#endif // HANDLEBODY_CHOSEN_SOLVER_TRAITS_H
