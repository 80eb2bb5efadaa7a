/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `TetrahedralMesh_3` describes a tetrahedral mesh by numbers: vertices and cells are numbered from 0 without
gaps, and cells name their vertices. It is what the algorithms of this package take as input. They copy the mesh once
into a `CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3`, so that the functions below need not be fast.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Tetrahedron_soup_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Triangulation_cells_3}
\cgalHasModelsEnd
*/
class TetrahedralMesh_3
{
public:

/// \name Types
/// @{

/*!
The point type, that of a model of `VolumeParameterizationTraits_3`.
*/
typedef unspecified_type Point_3;

/// @}

/// \name Operations
/// @{

/*!
returns the number of vertices.
*/
std::size_t number_of_vertices() const;

/*!
returns the number of tetrahedra.
*/
std::size_t number_of_cells() const;

/*!
returns the position of vertex `vertex`.
*/
Point_3 point(std::size_t vertex) const;

/*!
returns the vertices of cell `cell`, in an order in which `CGAL::orientation()` of their points is positive: `operator[]` of the
result takes 0, 1, 2, 3 and returns a number convertible to `std::size_t`.
*/
unspecified_type cell(std::size_t cell) const;

/*!
returns triangles of the boundary with their labels, as a range of `CGAL::Volume_mesh_parameterization::Labelled_facet`; none need be
labelled, and the order is of no importance.
*/
unspecified_type labelled_facets() const;

/*!
returns the cell behind the facet of cell `cell` opposite to its vertex `i`, or a number that is no cell if that facet is on the
boundary. This operation is optional: a mesh that knows its neighbors saves the time to find them.
*/
std::size_t neighbor(std::size_t cell, int i) const;

/// @}
};
