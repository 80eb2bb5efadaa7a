#ifndef HANDLEBODY_MPI_PETSC_CALL_H
#define HANDLEBODY_MPI_PETSC_CALL_H

#include <petscsys.h>

#include <stdexcept>
#include <string>

// Turns the error codes of PETSc into exceptions; PETSc itself prints what went wrong where.
inline void petsc_call(PetscErrorCode error) {
  if (error != 0) throw std::runtime_error("PETSc error " + std::to_string(error));
}

#endif // HANDLEBODY_MPI_PETSC_CALL_H
