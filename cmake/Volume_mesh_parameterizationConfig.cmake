# Defines, for the source tree and for an installation alike,
#   CGAL::Volume_mesh_parameterization   the headers with what they require: CGAL and Eigen
# and, for each optional library that is found, a target to link in addition:
#   CGAL::TetGen_support    defines CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN; mind TetGen's licence, the AGPL
#   CGAL::CHOLMOD_support   defines CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
#   CGAL::PETSc_support     defines CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC
#   CGAL::TBB_support       CGAL's own
# With CGAL 6.1 or later also
#   CGAL::Constrained_Delaunay_support   defines CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CONSTRAINED_DELAUNAY: surfaces are
#                                        filled without TetGen; programs take minutes to compile

if(TARGET CGAL::Volume_mesh_parameterization)
  return()
endif()

include(CMakeFindDependencyMacro)

# CGAL's version file accepts no other major version than the one asked for: compare by hand.
find_dependency(CGAL)
if(CGAL_VERSION VERSION_LESS 5.5)
  set(Volume_mesh_parameterization_FOUND FALSE)
  set(Volume_mesh_parameterization_NOT_FOUND_MESSAGE "CGAL ${CGAL_VERSION} was found, at least 5.5 is needed")
  return()
endif()
find_dependency(Eigen3 3.4)
include(CGAL_Eigen3_support)

# beside this folder, above lib/cmake/<name> or above lib/<architecture>/cmake/<name>
find_path(Volume_mesh_parameterization_INCLUDE_DIR CGAL/Volume_mesh_parameterization/indices.h
  PATHS "${CMAKE_CURRENT_LIST_DIR}/../include" "${CMAKE_CURRENT_LIST_DIR}/../../../include"
        "${CMAKE_CURRENT_LIST_DIR}/../../../../include"
  NO_DEFAULT_PATH)
mark_as_advanced(Volume_mesh_parameterization_INCLUDE_DIR)

add_library(CGAL::Volume_mesh_parameterization INTERFACE IMPORTED)
set_target_properties(CGAL::Volume_mesh_parameterization PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${Volume_mesh_parameterization_INCLUDE_DIR}"
  INTERFACE_COMPILE_FEATURES cxx_std_17
  INTERFACE_LINK_LIBRARIES "CGAL::CGAL;CGAL::Eigen3_support")

function(cgal_add_optional_support name target definition without)
  if(NOT TARGET ${target})
    if(NOT Volume_mesh_parameterization_FIND_QUIETLY)
      message(STATUS "NOTICE: ${name} was not found: ${without}.")
    endif()
  elseif(NOT TARGET CGAL::${name}_support)
    add_library(CGAL::${name}_support INTERFACE IMPORTED)
    set_target_properties(CGAL::${name}_support PROPERTIES
      INTERFACE_COMPILE_DEFINITIONS ${definition}
      INTERFACE_LINK_LIBRARIES ${target})
  endif()
endfunction()

if(NOT CGAL_VERSION VERSION_LESS 6.1)
  add_library(CGAL::Constrained_Delaunay_support INTERFACE IMPORTED)
  set_target_properties(CGAL::Constrained_Delaunay_support PROPERTIES
    INTERFACE_COMPILE_DEFINITIONS CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CONSTRAINED_DELAUNAY)
endif()

list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_package(TetGen QUIET)
find_package(CHOLMOD QUIET)
find_package(PETSc QUIET)
find_package(TBB QUIET)
include(CGAL_TBB_support)
cgal_add_optional_support(TetGen TetGen::TetGen CGAL_VOLUME_MESH_PARAMETERIZATION_USE_TETGEN
  "triangle surfaces are filled with tetrahedra only with CGAL 6.1 or later, else only tetrahedral meshes are taken")
cgal_add_optional_support(CHOLMOD CHOLMOD::CHOLMOD CGAL_VOLUME_MESH_PARAMETERIZATION_USE_CHOLMOD
  "Eigen solves all linear systems")
cgal_add_optional_support(PETSc PETSc::PETSc CGAL_VOLUME_MESH_PARAMETERIZATION_USE_PETSC
  "there is no algebraic multigrid, and no program for several machines")
cgal_add_optional_support(TBB CGAL::TBB_support "" "all stages run in one thread")
