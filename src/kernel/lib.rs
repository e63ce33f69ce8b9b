//! Geometry: exact NURBS, and functions with exact derivatives. Knows nothing of scripts, spans or files; equal input gives equal bits.
//!
//! Reading order: [`tolerance`], then [`KnotVector`], [`NurbsCurve`], [`NurbsSurface`], [`Mesh`].
#![doc = include_str!("README.md")]

mod bernstein;
mod bezier;
mod bounds;
pub mod ceiling;
mod compatible;
mod construction_report;
mod curve;
mod deviation_reference;
mod digits;
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
mod removal;
mod scale;
mod side_by_side;
mod skin;
mod surface;
mod sweep;
mod table;
pub mod tolerance;
mod valley;
pub mod work;

/// The library of points and vectors that all signatures here speak in.
pub use glam;

pub use bounds::Bounds;
pub use construction_report::{ConstructionReport, ReportEntry};
pub use curve::{
    AnalyticCurve, CircleForm, ClosestPoint, ConicKind, Continuity, Curve, CurveEvaluator,
    CurveFunction, CurveIntersection, CurvePointKind, EvaluationPlace, LocalGeometry, NurbsCurve,
    Offset, ParametricCurve, join, make_compatible,
};
pub use deviation_reference::{Deviation, DeviationReference};
pub use error::{
    ConstructionError, CountError, DegreeError, DomainError, FitError, FormError, GeomError,
    InputError, IntersectionError, JointError, KnotError, LocalError, MeasureError, WeightError,
};
pub use failure::FunctionFailure;
pub use fit::{
    Approximator, Ends, FirstPass, Interpolator, LineFit, Lines, Parametrization, approximate,
    approximate_within, check_parameters, columns_within, lagrange, surface_within,
};
pub use frame::Frame;
pub use gordon::{CurveAdjustment, Gordon, Network, NetworkError, gordon};
pub use grid::Grid;
pub use interval::Interval;
pub use jet::Jet;
pub use joint_tolerance::JointTolerance;
pub use jump::JumpError;
pub use knots::{KnotClass, KnotVector, Side};
pub use mesh::{
    FaceFault, Group, Mesh, MeshCheck, MeshDistance, MeshError, TessellationOptions, Topology,
    distance_to_polyline, facing_inward, grid_mesh, grid_mesh_any, planar_mesh, polygon_mesh,
    split_polygon, tessellate, tessellate_all, tessellate_any, tessellate_curve,
    tessellate_curve_any, tessellate_finely,
};
pub use numeric::symmetric_eigen::principal_axes;
pub use skin::{
    AlignedSection, Along, CompatibleSections, SectionParameters, Skin, aligned, at_constant_speed,
    corners_of_ring, with_seam_at_corner,
};
pub use surface::{
    AnalyticForm, AnalyticSurface, Axis, AxisContact, Blend, CrossFields, CurveSurfaceIntersection,
    Direction, Edge, FocalPoint, GridSamples, LevelSet, MassProperties, NurbsSurface,
    ParametricPlaces, ParametricSurface, PictureError, Principal, QuadricKind, ShellError, Surface,
    SurfaceClosestPoint, SurfaceContinuity, SurfaceDefects, SurfaceEvaluator, SurfaceFunction,
    SurfaceOffset, SurfacePointKind, SurfaceShape, Twists, area_mass, facing_unlike, join_patches,
    make_surfaces_compatible, volume_mass,
};
pub use sweep::{
    Axes, Columns, FrameRule, Frames, Motion, PathLeg, PlacedAxes, Sweep, SweepResolution, legs,
    mitred, overreaches, swept, translated,
};
pub use table::{Column, NamedColumn, Table};
pub use tolerance::Tolerance;
