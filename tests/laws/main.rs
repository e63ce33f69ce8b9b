//! The laws of the geometry kernel: what must hold for every curve and every surface, whatever
//! its numbers. Expected values are closed forms, the laws themselves, or worked examples of the
//! literature; never what the kernel said before.

#![expect(clippy::unwrap_used, reason = "a test that cannot build its example fails")]

mod analytic;
mod basis;
mod beside_edges;
mod beside_waves;
mod bodies;
mod breakers;
mod certificate;
mod coincident;
mod construct;
mod constructors;
mod coons;
mod crossing;
mod crossing_turned;
mod curve;
mod edit;
mod edit_surface;
mod evaluator;
mod exact_cut;
mod face;
mod face_touching;
mod face_turned;
mod far;
mod far_parameters;
mod fit;
mod gordon;
mod hostile;
mod jet;
mod joints;
mod knots;
mod level;
mod local;
mod measure;
mod mesh;
mod mesh_boolean;
mod mesh_check;
mod mesh_coincident;
mod nearest;
#[path = "../support/networks.rs"]
mod networks;
mod offset_surface;
mod parametric;
mod pinched;
mod places;
mod planar;
mod poles;
mod primitive;
mod quadric;
mod real_networks;
mod region;
mod region_many;
mod region_touch;
mod seams;
mod shape;
mod shared_edges;
mod sizes;
mod skin;
mod solid;
mod solid_cut;
mod solid_rims;
mod some;
mod strips;
mod surface;
mod sweep;
mod tangents;
mod tensor;
mod tessellation;
mod trajectory;
mod triangles;
mod varied;
mod varied_walls;
mod whole;
mod worked;
