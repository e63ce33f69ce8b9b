//! Geometry: exact NURBS, and functions with exact derivatives. Knows nothing of scripts, spans or files; equal input gives equal bits.
//!
#![doc = include_str!("README.md")]
//! # Index
//!
//! By what one looks for. Reading order of the sources: [`tolerance`], then [`KnotVector`], [`NurbsCurve`], [`NurbsSurface`], [`Mesh`].
//!
//! ## Representation
//!
//! - Numbers and places: [`glam`] for points, vectors and maps; [`Interval`], [`Frame`], [`Bounds`], [`Grid`], [`Table`].
//! - Bases: [`KnotVector`], its [`class`](KnotVector::class), its [functions](KnotVector::basis_at) and their
//!   [derivatives](KnotVector::basis_derivatives_at).
//! - Exact: [`NurbsCurve`], [`NurbsSurface`]. Of a function: [`ParametricCurve`] of a [`CurveFunction`], [`ParametricSurface`] of a
//!   [`SurfaceFunction`], whose derivatives a [`Jet`] finds. Either: [`Curve`], [`Surface`].
//! - What is wrong: [`GeomError`] in its families. What counts as equal: [`Tolerance`], [`JointTolerance`].
//! - What a construction did: [`ConstructionReport`]. How long it may take: [`work`]. How large things may be: [`ceiling`].
//!
//! ## Evaluate
//!
//! - Points: [`NurbsCurve::point_at`], [`NurbsSurface::point_at`]; many at once: [`CurveEvaluator`], [`SurfaceEvaluator`],
//!   [`NurbsCurve::sample`], [`NurbsSurface::points_on_grid`], [`GridSamples`].
//! - Derivatives: [`NurbsCurve::derivatives_at`], from one [`Side`] with [`NurbsCurve::derivatives_beside`];
//!   [`NurbsSurface::derivatives_at`], [`NurbsCurve::hodograph`].
//! - Tangent, curvature, torsion, moving frame: [`Curve::local_at`] gives [`LocalGeometry`]; [`Curve::place_kind_at`].
//! - Normal, Gaussian and mean curvature, [`Principal`] directions: [`Surface::shape_at`] gives [`SurfaceShape`]; [`Surface::kind_at`],
//!   [`Surface::first_form_at`], [`Surface::second_form_at`].
//! - The scheme behind it: [`NurbsCurve::de_casteljau`], [`NurbsSurface::de_casteljau`], [`NurbsCurve::basis_at`].
//!
//! ## Edit
//!
//! - Knots and degree: [`NurbsCurve::insert_knots`], [`NurbsCurve::without_knot`], [`NurbsCurve::elevate_degree`], [`NurbsCurve::reduced`];
//!   [`NurbsSurface::insert_knots`], [`NurbsSurface::elevate_degree`].
//! - Pieces: [`NurbsCurve::split`], [`NurbsCurve::trimmed`], [`NurbsCurve::decompose`], [`join`]; [`NurbsSurface::split`],
//!   [`NurbsSurface::trimmed`], [`NurbsSurface::decompose`], [`join_patches`]; [`NurbsCurve::extended`].
//! - Direction and parameter: [`NurbsCurve::reversed`], [`NurbsCurve::reparametrized`], [`NurbsSurface::swapped`].
//! - One basis: [`make_compatible`], [`make_surfaces_compatible`]. Other bases: [`NurbsCurve::power_form`], [`NurbsCurve::to_coons`],
//!   [`NurbsCurve::to_hermite`], [`NurbsCurve::standard_form`].
//! - Maps of space: [`NurbsCurve::transformed`], [`NurbsCurve::projected`], [`NurbsSurface::transformed`].
//!
//! ## Measure
//!
//! - Length and its inverse: [`NurbsCurve::length`], [`NurbsCurve::parameter_at_length`], [`NurbsCurve::division`].
//! - Nearest points: [`NurbsCurve::closest`], [`NurbsSurface::closest`], [`MeshDistance`]; largest distances: [`DeviationReference`].
//! - Area, volume, centroid, inertia: [`Surface::area`], [`area_mass`], [`volume_mass`], [`principal_axes`].
//! - Places of note: [`NurbsCurve::inflections`], [`NurbsCurve::vertices`], [`NurbsCurve::extrema`], [`NurbsCurve::corners`],
//!   [`NurbsCurve::cusps`]; [`Surface::umbilics`], [`Surface::defects`].
//! - How measures go with control points that vary: [`VariedCurve`], [`VariedSurface`] of [`PointSlopes`]; those of points made of others: [`PointMap`], as of the same curve on other knots: [`factors_of_same_curve`], [`factors_of_same_surface`].
//! - Joints: [`Curve::continuity_with`], [`Surface::continuity_with`], [`Curve::continuity`].
//! - What it is: [`NurbsCurve::analytic`], [`NurbsCurve::conic_kind`], [`NurbsSurface::analytic`] with [`NurbsSurface::analytic_chart`], [`NurbsSurface::quadric`],
//!   [`Curve::is_planar`], [`Surface::is_developable`].
//!
//! ## Intersect
//!
//! - Curves: [`NurbsCurve::intersections`], [`NurbsCurve::self_intersections`], with a plane [`NurbsCurve::plane_parameters`].
//! - Curve and surface: [`Surface::piercings`]. Surface and plane: [`Surface::section`]. Surfaces: [`Surface::intersections`].
//! - With the parameters on both surfaces, and proven: [`SurfaceCurve`], its [`SurfaceCurveKind`] and [`CurveEnd`].
//! - Lines of light: [`Surface::isophotes`], [`Surface::zebra`], [`Surface::reflection_lines`].
//! - Meshes: [`Mesh::section`], [`Mesh::outlines`].
//!
//! ## Construct
//!
//! - Curves of points: [`NurbsCurve::bezier`], [`NurbsCurve::line`], [`NurbsCurve::polyline`], [`NurbsCurve::hermite`], [`NurbsCurve::uniform`],
//!   [`NurbsCurve::beta_spline`]. Round ones: [`NurbsCurve::arc`], [`NurbsCurve::arc_through`], [`NurbsCurve::circle`],
//!   [`NurbsCurve::ellipse`], [`NurbsCurve::helix`].
//! - Surfaces of points: [`NurbsSurface::bezier`], [`NurbsSurface::bilinear`]. Round ones: [`NurbsSurface::sphere`], [`NurbsSurface::cone`],
//!   [`NurbsSurface::torus`], [`NurbsSurface::revolved`] about an [`Axis`].
//! - Surfaces of curves: [`NurbsSurface::extruded`], [`NurbsSurface::ruled`], [`NurbsSurface::swung`], [`NurbsSurface::coons`],
//!   [`NurbsSurface::coons_bicubic`].
//! - Skins: [`SkinBuilder`], and what it is made of: [`CompatibleSections`] with a way [`Along`] them give a [`Skin`]; [`aligned`] and
//!   [`at_constant_speed`] bring sections to run beside one another.
//! - Sweeps: [`SweepBuilder`], and what it is made of: [`swept`] with [`Frames`] and a [`Motion`] gives a [`Sweep`];
//!   [`translated`], [`mitred`].
//! - Networks: [`NetworkBuilder`], and what it is made of: [`gordon`] of a [`Network`] gives a [`Gordon`].
//! - Beside others: [`NurbsCurve::offset`], [`Surface::offset`].
//!
//! ## Regions of the plane
//!
//! - [`Region`] within curves, [`Region::even_odd`]; [`Region::union`], [`Region::intersection`], [`Region::difference`].
//! - [`Region::offset`] with its [`CornerStyle`], [`Region::filleted`]; [`Region::mass`], [`Region::side_of`] with its [`RegionSide`], its [`RegionStrip`]s.
//! - What is refused: [`RegionError`].
//!
//! ## Parts of surfaces
//!
//! - [`Face`]: [`Face::whole`], [`Face::within`] loops of parameters, [`Face::bounded`] by loops in space, its [parts](FacePart);
//!   [`Face::split`] by [`Cutter`]s, [`Face::part_at`], [`Face::beside_plane`]; [`Face::edges`], [`Face::part_edges`] by [`FaceEdge`]s, as files have them by [`FaceChart::along`] an [`EdgePath`], [`Face::clipped`] curves;
//!   [`Face::mass`], [`Face::enclosed_mass`], [`Face::bounds`], [`Face::closest`] with its [`FaceClosestPoint`], [`Face::side_of`], [`Face::side_of_parameters`], the [`AreaStrip`]s of either.
//! - What is refused: [`FaceError`].
//!
//! ## Solids
//!
//! - [`Solid`] of faces that close, [`Solid::capped`] by plane faces, of a region [`Solid::extruded`] or [`Solid::revolved`];
//!   [`Solid::cut`] by a plane, [`Solid::section`];
//!   [`Solid::faces`], [`Solid::shells`], [`Solid::bodies`] with their voids ([`SolidBody`]); [`Solid::topology`], a [`SolidTopology`] of [`SolidEdge`]s;
//!   [`Solid::contents`] (its [`SolidContents`]), [`Solid::volume_mass`], [`Solid::area_mass`], [`Solid::mesh`], [`Solid::closest`] with its [`SolidClosestPoint`], [`Solid::side_of`], [`Solid::piercings`] with its [`CurveSolidIntersection`].
//! - What is refused: [`SolidError`].
//!
//! ## Approximate
//!
//! - Through points: [`Interpolator`] at parameters by [`Parametrization`], with [`Ends`]; [`lagrange`].
//! - Near points: [`Approximator`], [`approximate`], [`approximate_within`] a tolerance.
//! - Grids of points: [`FirstPass`] with a [`LineFit`], [`columns_within`], [`surface_within`]; where these move [`GridLines`].
//! - Of rates: [`find_trajectory`] gives a [`Trajectory`], [`NurbsCurve::of_trajectory`]; of rates in branches [`find_branched_trajectory`].
//! - Of functions: [`ParametricCurve::to_nurbs`], [`ParametricSurface::to_nurbs`], [`Curve::nurbs_within`].
//!
//! ## Mesh
//!
//! - Triangles within a tolerance: [`tessellate`], [`tessellate_finely`], [`tessellate_all`], of either kind [`tessellate_any`], with faces
//!   [`tessellate_together`]; on a grid
//!   [`grid_mesh`]; polylines [`tessellate_curve`].
//! - Of polygons: [`polygon_mesh`], [`planar_mesh`], [`Mesh::new`].
//! - Whether it closes: [`Mesh::check`] gives [`MeshCheck`], [`Topology`]; [`Mesh::area`], [`Mesh::volume`].

mod arrange;
mod bernstein;
mod bezier;
mod bounds;
mod box_tree;
pub mod ceiling;
mod compatible;
mod construction_report;
mod curve;
mod deviation_reference;
mod digits;
mod disjoint_sets;
mod ended;
mod error;
mod failure;
mod fit;
mod frame;
mod gordon;
mod grid;
mod homogeneous;
mod hull;
mod interval;
pub mod jet;
mod joint;
mod joint_tolerance;
mod jump;
mod knots;
mod lazy;
mod mesh;
mod nearest;
mod numeric;
mod positive;
mod refine;
mod region;
mod removal;
mod scale;
mod side_by_side;
mod skin;
mod solid;
pub mod sorting;
mod surface;
mod sweep;
mod table;
pub mod tolerance;
mod trim;
mod valley;
mod varied;
pub mod work;

/// The library of points and vectors that all signatures here speak in.
pub use glam;

pub use bounds::Bounds;
pub use construction_report::{ConstructionReport, ReportEntry};
pub use curve::{
    AnalyticCurve, CircleForm, ClosestPoint, ConicKind, Continuity, Curve, CurveEvaluator,
    CurveFunction, CurveIntersection, CurvePointKind, EvaluationPlace, LocalGeometry, NurbsCurve,
    Offset, ParametricCurve, TangentArc, TangentEnd, TangentLine, join, make_compatible,
};
pub use deviation_reference::{Deviation, DeviationReference};
pub use error::{
    ConstructionError, CountError, DegreeError, DomainError, FitError, FormError, GeomError,
    InputError, IntersectionError, JointError, KnotError, LocalError, MeasureError, WeightError,
};
pub use failure::FunctionFailure;
pub use fit::{
    Approximator, Ends, FirstPass, GridLines, Interpolator, LineFit, Lines, Parametrization,
    approximate, approximate_within, check_parameters, columns_within, interpolate_varied,
    interpolate_varied_ring, lagrange, surface_within,
};
pub use frame::{Frame, unit};
pub use gordon::{
    CurveAdjustment, Gordon, Network, NetworkBuilder, NetworkError, NetworkInput, PreparedNetwork,
    gordon,
};
pub use grid::Grid;
pub use interval::Interval;
pub use jet::Jet;
pub use joint_tolerance::JointTolerance;
pub use jump::JumpError;
pub use knots::{KnotClass, KnotVector, Side};
pub use mesh::{
    FaceFault, Mesh, MeshCheck, MeshDistance, MeshError, MeshGroup, TessellationOptions, Topology,
    distance_to_polyline, facing_inward, grid_mesh, grid_mesh_any, planar_mesh, polygon_mesh,
    split_polygon, tessellate, tessellate_all, tessellate_any, tessellate_curve,
    tessellate_curve_any, tessellate_finely, tessellation_parameters,
};
pub use numeric::{
    answers::{Answers, Wanted},
    branched_rate::{BranchEnd, BranchedRate},
    constrained_least::ConstrainedLeast,
    enclosure::Enclosure,
    integral::{Integral, find_integral, find_sized_integral},
    integral_error::{IntegralError, IntegralReason},
    least::find_least,
    least_place::find_least_place,
    least_pole::find_pole,
    least_problem::{LeastEnd, LeastProblem},
    least_squares::{LeastSquares, find_least_squares},
    linear::solve_linear,
    root::{find_crossing, find_root, find_roots},
    root_error::RootError,
    root_proof::RootProof,
    sample::Sample,
    slope::{Slope, find_slope},
    symmetric_eigen::principal_axes,
    system_root::find_system_root,
    trajectory::{TrajectoryError, find_branched_trajectory, find_trajectory},
    trajectory_nodes::{Trajectory, TrajectoryNode},
};
pub use region::{CornerStyle, Region, RegionError, RegionSide, RegionStrip};
pub use skin::{
    AlignedSection, Along, CompatibleSections, SectionParameters, SectionSlope, Skin, SkinBuilder,
    SkinError, SkinInput, SkinnedSurface, aligned, at_constant_speed, corners_of_ring,
    with_seam_at_corner,
};
pub use solid::{
    CurveSolidIntersection, EdgeAngles, Solid, SolidBody, SolidClosestPoint, SolidContents,
    SolidEdge, SolidError, SolidStep, SolidTopology,
};
pub use surface::{
    AnalyticChart, AnalyticForm, AnalyticSurface, Axis, AxisContact, Blend, CrossFields,
    CurveSurfaceIntersection, Direction, Edge, FocalPoint, GridSamples, LevelSet, MassProperties,
    NurbsSurface, ParametricPlaces, ParametricSurface, PictureError, Principal, QuadricKind,
    ShellError, SignedVolume, Surface, SurfaceClosestPoint, SurfaceContinuity, SurfaceDefects,
    SurfaceEvaluator, SurfaceFunction, SurfaceOffset, SurfacePointKind, SurfaceShape, Twists,
    area_mass, facing_unlike, join_patches, make_surfaces_compatible, signed_volume, volume_mass,
};
pub use sweep::{
    Axes, Columns, FrameRule, Frames, Motion, PathLeg, PlacedAxes, Sweep, SweepBuilder, SweepError,
    SweepInput, SweepResolution, SweptLeg, SweptSurface, legs, mitred, overreaches, swept,
    translated,
};
pub use table::{Column, NamedColumn, Table};
pub use tolerance::Tolerance;
pub use trim::{
    AreaStrip, CurveEnd, Cutter, EdgePath, Face, FaceChart, FaceClosestPoint, FaceContinuity,
    FaceEdge, FaceError, FacePart, ParameterArc, SurfaceCurve, SurfaceCurveKind, SurfacePiece,
    pieces_facing_unlike, tessellate_together,
};
pub use varied::{
    PointEntries, PointFactors, PointMap, PointSlopes, RegionWay, SurfaceIntegral, VariedCurve,
    VariedRegion, VariedSolid, VariedSurface, VariedWall, factors_of_same_curve,
    factors_of_same_surface, stay_closed,
};
