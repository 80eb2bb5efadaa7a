/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `ParameterDomain_3` describes the solid that a handlebody is mapped to: a base in the plane, a rectangle with
as many rectangular holes as the handlebody has, times the interval from 0 to the height. The base is the floor, its copy
at full height is the ceiling. Each rim of the base, number 0 the outer one and number 1 + k that of hole k, stands below
one wall.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Volume_mesh_parameterization::Prism_3}
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
The point type of the base, `Geom_traits::Point_2`.
*/
typedef unspecified_type Point_2;

/*!
The point type of the domain, `Geom_traits::Point_3`.
*/
typedef unspecified_type Point_3;

/// @}

/// \name Shape
/// @{

/*!
returns whether the rims are disjoint and bound a base with holes, and the height is positive.
*/
bool is_valid() const;

/*!
returns the number of rims of the base, one more than there are holes.
*/
std::size_t number_of_rims() const;

/*!
returns a rim of the base.
*/
CGAL::Volume_mesh_parameterization::Rectangle_2 rim(std::size_t r) const;

/*!
returns the height of the ceiling; the floor is at height 0.
*/
double height() const;

/*!
returns the label of the wall that stands on rim `r`.
*/
int wall_label(std::size_t r) const;

/// @}

/// \name Queries
/// @{

/*!
returns the number of the rim that `p` lies on, or the number of rims if it lies on none.
*/
std::size_t rim_at(const Point_2& p) const;

/*!
returns on which side of the boundary of the base `p` is.
*/
CGAL::Bounded_side bounded_side(const Point_2& p) const;

/*!
returns on which side of the boundary of the domain `p` is.
*/
CGAL::Bounded_side bounded_side(const Point_3& p) const;

/*!
returns the label of the side that `p` lies on, `INTERIOR` if it lies on none.
*/
int label(const Point_3& p) const;

/// @}
};
