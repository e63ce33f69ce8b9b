//! The kernel alone: a section of a wing through points, its length and curvature, two sections that
//! become a surface, its area, and triangles of it.
//!
//! `cargo run --example wing_section`

#![expect(clippy::print_stdout, reason = "an example says what it found")]

use std::error::Error;

use virote_kernel::{
    Ends, Interpolator, NurbsCurve, Parametrization, SkinBuilder, Surface, Tolerance, glam::DVec3,
    tessellate,
};

/// The upper side of a symmetric section with four digits, 12 % thick.
fn height(x: f64) -> f64 {
    0.6 * (0.2969 * x.sqrt() - x * (0.126 + x * (0.3516 - x * (0.2843 - 0.1036 * x))))
}

fn section(chord: f64, y: f64) -> Result<NurbsCurve, Box<dyn Error>> {
    let stations = (0..=20).map(|i| f64::from(i * i) / 400.0);
    let points: Vec<DVec3> =
        stations.map(|x| chord * DVec3::new(x, 0.0, height(x)) + y * DVec3::Y).collect();
    let parameters = Parametrization::Centripetal.parameters(&points)?;
    Ok(Interpolator::new(&parameters, 3, Ends::NotAKnot)?.curve(&points)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let (root, tip) = (section(2.0, 0.0)?, section(1.0, 6.0)?);
    println!("the root's upper side is {:.6} long", root.length(root.domain()));

    let wing = SkinBuilder::new(vec![root, tip], Tolerance::DEFAULT).build()?;
    println!("area {:.6}", Surface::from(wing.clone()).area()?.0);

    let mesh = tessellate(&wing, 1e-3, 1_000_000)?;
    println!("{} triangles within a thousandth, area {:.6}", mesh.triangles().len(), mesh.area());
    Ok(())
}
