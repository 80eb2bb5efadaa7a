/*!
\ingroup PkgVolumeMeshParameterizationConcepts
\cgalConcept

The concept `VolumeParameterizationTraits_3` gathers the number type, the geometric objects and the predicates of the
algorithms of this package. Every \cgal kernel is a model.

Predicates are default constructible function objects. They must be exact: all topological decisions rest on them. With an
exact `FT` the points of curves and the images of points under the maps are exact too.

\cgalHasModelsBegin
\cgalHasModelsBare{Any \cgal kernel with exact predicates}
\cgalHasModelsEnd
*/
class VolumeParameterizationTraits_3
{
public:

/// \name Types
/// @{

/*!
The number type, a model of `FieldNumberType` that is constructible from `double`.
*/
typedef unspecified_type FT;

/*!
The point type of the plane, as in a \cgal kernel; constructible from two coordinates of type `FT` or `double`.
*/
typedef unspecified_type Point_2;

/*!
The segment type of the plane, as in a \cgal kernel.
*/
typedef unspecified_type Segment_2;

/*!
The point type of space, as in a \cgal kernel; constructible from three coordinates of type `FT` or `double`.
*/
typedef unspecified_type Point_3;

/*!
A function object with
`CGAL::Orientation operator()(const Point_2& p, const Point_2& q, const Point_2& r) const`,
the exact sign of twice the area of the triangle.
*/
typedef unspecified_type Orientation_2;

/*!
A function object with
`CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const`,
the exact sign of six times the volume of the tetrahedron.
*/
typedef unspecified_type Orientation_3;

/*!
A function object with
`CGAL::Comparison_result operator()(const Segment_2& s, const Segment_2& t) const`,
the exact comparison of slopes. `Boundary_map_3` needs it.
*/
typedef unspecified_type Compare_slope_2;

/*!
The segment type of space, as in a \cgal kernel. `verify_map()` needs it, and so `make_piecewise_linear()`; they need the
following types too.
*/
typedef unspecified_type Segment_3;

/*!
The triangle type of space, as in a \cgal kernel.
*/
typedef unspecified_type Triangle_3;

/*!
A function object with
`bool operator()(const Triangle_3& s, const Triangle_3& t) const` and
`bool operator()(const Triangle_3& s, const Segment_3& t) const`,
the exact answer to whether the two have a point in common.
*/
typedef unspecified_type Do_intersect_3;

/*!
A function object with
`CGAL::Orientation operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s) const`,
for coplanar points of which `p`, `q` and `r` are not collinear: `CGAL::POSITIVE` exactly if `r` and `s` are on the same side of
the line through `p` and `q`.
*/
typedef unspecified_type Coplanar_orientation_3;

/// @}
};
