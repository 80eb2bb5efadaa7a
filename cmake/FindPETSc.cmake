# Finds PETSc (https://petsc.org, BSD-2-Clause) by pkg-config, and MPI, which its headers need.
# Defines the target PETSc::PETSc and the variable PETSc_FOUND.

include(FindPackageHandleStandardArgs)

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(PETSC QUIET PETSc)
endif()
find_package(MPI QUIET COMPONENTS CXX)
find_package_handle_standard_args(PETSc REQUIRED_VARS PETSC_LINK_LIBRARIES MPI_CXX_FOUND VERSION_VAR PETSC_VERSION)

if(PETSc_FOUND AND NOT TARGET PETSc::PETSc)
  add_library(PETSc::PETSc INTERFACE IMPORTED)
  set_target_properties(PETSc::PETSc PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${PETSC_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${PETSC_LINK_LIBRARIES};MPI::MPI_CXX")
endif()
