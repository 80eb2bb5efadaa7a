/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `ParameterDomain_3` describes the solid that a handlebody is mapped to, as the direct product of its floor and
the unit interval: a point of the solid is given by a point of the floor and by the share of the way to the ceiling.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Prism_3}
\cgalHasModels{CGAL::Volume_mesh_parameterization::Polycube_3}
\cgalHasModelsEnd
*/
class ParameterDomain_3
{
public:

/// \name Types
/// @{

/*!
A model of `VolumeParameterizationTraits_3`.
*/
typedef unspecified_type Geom_traits;

/*!
A number type, `Geom_traits::FT`.
*/
typedef unspecified_type FT;

/*!
The point type of the domain, `Geom_traits::Point_3`.
*/
typedef unspecified_type Point_3;

/*!
A point of the floor, default constructible and assignable.
*/
typedef unspecified_type Floor_point;

/// @}

/// \name Operations
/// @{

/*!
returns whether the domain is a product that can be evaluated.
*/
bool is_valid() const;

/*!
computes the point at the share `w`, from 0 to 1, of the way from `foot` to the ceiling.
*/
CGAL::Volume_mesh_parameterization::Status point(const Floor_point& foot, const FT& w, Point_3& result) const;

/*!
is the inverse of `point()`.
\returns `ERROR_OUTSIDE` if `p` is not in the domain. A domain whose floor map finds out whether a foot is in the floor may
leave that to it.
*/
CGAL::Volume_mesh_parameterization::Status locate(const Point_3& p, Floor_point& foot, FT& w) const;

/// @}
};
