/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `VolumeFloorMap_3` describes a one-to-one map from the floor of a solid to the floor of a domain, which together
with the product structures of both gives the map of the solid. Models are movable; for a
`CGAL::Volume_mesh_parameterization::Parameterization_search_3` they can be copied.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Floor_map_2}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Boundary_map_3}
\cgalHasModelsEnd
*/
class VolumeFloorMap_3
{
public:

/// \name Types
/// @{

/*!
A model of `VolumeParameterizationTraits_3`.
*/
typedef unspecified_type Geom_traits;

/*!
A model of `ParameterDomain_3` with the same `Geom_traits`.
*/
typedef unspecified_type Domain;

/// @}

/// \name Operations
/// @{

/*!
prepares the map for the floor of `mesh`, the facets labelled `FLOOR`. The partition of `mesh` is legal.
\returns why there is no such map
*/
CGAL::Volume_mesh_parameterization::Status build(const CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3<Geom_traits>& mesh);

/*!
returns what the floor is mapped to. It lives as long as the map, and is valid once the map is built.
*/
const Domain& domain() const;

/*!
returns the image of `p`, a point of the floor. May be called by several threads at a time.
*/
Domain::Floor_point image(const CGAL::Volume_mesh_parameterization::Base_point_3<Geom_traits>& p) const;

/*!
computes the point of the floor whose image is `foot`. May be called by several threads at a time.
\returns `ERROR_OUTSIDE` if `foot` is not in the floor of the domain
*/
CGAL::Volume_mesh_parameterization::Status preimage(const Domain::Floor_point& foot, CGAL::Volume_mesh_parameterization::Base_point_3<Geom_traits>& p) const;

/*!
extends the map to the whole boundary of `mesh`, for which `build()` has succeeded. `images` are those of the vertices of `mesh`
along curves, as a guide. The floor map may change so that both agree. Only `make_piecewise_linear()` needs this function.
\returns why there is no such map; then nothing is changed
*/
CGAL::Volume_mesh_parameterization::Status map_boundary(const CGAL::Volume_mesh_parameterization::Compact_tetrahedral_mesh_3<Geom_traits>& mesh,
                                                        const std::vector<Geom_traits::Point_3>& images,
                                                        CGAL::Volume_mesh_parameterization::Boundary_images_3<Geom_traits>& boundary);

/// @}
};
