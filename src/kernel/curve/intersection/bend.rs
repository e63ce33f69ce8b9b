//! A curve's pieces as polynomials: what its velocity and its bending are proportional to.
//!
//! With the numerator A and the denominator w of a piece, C' is V/w² with V = A'w − Aw', and
//! C' × C'' is V × V'/w⁴. Signs and zeros of these need no division. Everything is taken about the
//! middle of the curve's box, so that rounding is that of its size and not of its place.

use glam::{DVec3, DVec4};

use crate::{
    Bounds, Interval,
    bernstein::{derivative, largest, product},
    bezier,
    curve::NurbsCurve,
    tolerance::{LAST_BIT, SIGN_RELATIVE},
};

/// Bernstein coefficients of one piece, by its local parameter.
#[derive(Debug)]
pub(in crate::curve) struct BernsteinPiece {
    pub(in crate::curve) interval: Interval,
    /// The denominator w; a single 1 where the curve is polynomial.
    pub(in crate::curve) weight: Vec<f64>,
    /// V, a positive multiple of the velocity.
    pub(in crate::curve) velocity: Vec<DVec3>,
    /// Coordinates whose rounding the velocity carries.
    size: f64,
}

/// A polynomial with the size of coefficients that rounding may leave.
#[derive(Debug)]
pub(in crate::curve) struct RoundedPolynomial {
    pub(in crate::curve) coefficients: Vec<f64>,
    pub(in crate::curve) rounding: f64,
}

impl NurbsCurve {
    /// The pieces between its knots.
    pub(in crate::curve) fn pieces(&self) -> Vec<BernsteinPiece> {
        let bounds = Bounds::of(self.points());
        let middle = bounds.map_or(DVec3::ZERO, Bounds::center);
        let size = bounds.map_or(0.0, Bounds::diagonal);
        let rounding = bounds.map_or(0.0, Bounds::magnitude) * LAST_BIT / SIGN_RELATIVE;
        let piece = |span: usize| {
            let points = bezier::piece(self.knots(), self.control_points(), span);
            BernsteinPiece::new(
                self.knots().span_interval(span),
                &points,
                middle,
                size.max(rounding),
                self,
            )
        };
        self.knots().spans().map(piece).collect()
    }
}

impl BernsteinPiece {
    fn new(
        interval: Interval,
        points: &[DVec4],
        middle: DVec3,
        size: f64,
        curve: &NurbsCurve,
    ) -> Self {
        let numerator: Vec<DVec3> =
            points.iter().map(|point| point.truncate() - middle * point.w).collect();
        let slope = derivative(&numerator);
        let degree = (points.len() - 1) as f64;
        if !curve.is_rational() {
            let weight = points[0].w;
            let velocity = slope.iter().map(|&slope| slope / weight).collect();
            return Self { interval, weight: vec![1.0], velocity, size: degree * size };
        }
        let weight: Vec<f64> = points.iter().map(|point| point.w).collect();
        let times = |vector: DVec3, factor: f64| vector * factor;
        let (grown, shrunk) =
            (product(&slope, &weight, times), product(&numerator, &derivative(&weight), times));
        let velocity = grown.iter().zip(&shrunk).map(|(&a, &b)| a - b).collect();
        let scale = largest(&weight);
        Self { interval, weight, velocity, size: degree * size * scale * scale }
    }

    /// How fast the curve goes along a direction.
    pub(in crate::curve) fn along(&self, direction: DVec3) -> RoundedPolynomial {
        let coefficients = self.velocity.iter().map(|slope| slope.dot(direction)).collect();
        RoundedPolynomial {
            coefficients,
            rounding: SIGN_RELATIVE * self.fastest() * direction.length(),
        }
    }

    /// V × V', along the binormal.
    pub(in crate::curve) fn bend(&self) -> Vec<DVec3> {
        product(&self.velocity, &derivative(&self.velocity), DVec3::cross)
    }

    /// What rounding may leave of the bend.
    pub(in crate::curve) fn bend_rounding(&self) -> f64 {
        let change = derivative(&self.velocity);
        let degree = self.velocity.len() as f64;
        SIGN_RELATIVE * self.fastest() * (longest(&change) + degree * self.size)
    }

    /// The signed bend about a normal.
    pub(in crate::curve) fn bend_about(&self, normal: DVec3) -> RoundedPolynomial {
        let coefficients = self.bend().iter().map(|bend| bend.dot(normal)).collect();
        RoundedPolynomial { coefficients, rounding: self.bend_rounding() }
    }

    /// A positive multiple of the slope of the curvature, signed about a normal where there is
    /// one.
    ///
    /// The signed curvature is b·w²/|V|³ with b = (V × V')·n; its slope has the sign of
    /// (b'w + 2bw')|V|² − 3bw V·V'. Without a normal the same holds for the square of |V × V'|.
    pub(in crate::curve) fn curvature_slope(&self, normal: Option<DVec3>) -> RoundedPolynomial {
        let bend = self.bend();
        // b and b', or |B|² and half of its derivative.
        let (b, change) = match normal {
            Some(normal) => {
                let b: Vec<f64> = bend.iter().map(|bend| bend.dot(normal)).collect();
                let change = derivative(&b);
                (b, change)
            }
            None => {
                let change = derivative(&bend);
                (product(&bend, &bend, DVec3::dot), product(&bend, &change, DVec3::dot))
            }
        };
        let times = |a: f64, b: f64| a * b;
        let acceleration = derivative(&self.velocity);
        let speed = product(&self.velocity, &self.velocity, DVec3::dot);
        let slowing = product(&self.velocity, &acceleration, DVec3::dot);
        let mut rise = product(&change, &self.weight, times);
        let of_weight = product(&b, &derivative(&self.weight), times);
        add(&mut rise, &of_weight, 2.0);
        let mut slope = product(&rise, &speed, times);
        let fall = product(&product(&b, &self.weight, times), &slowing, times);
        add(&mut slope, &fall, -3.0);
        let scale = (largest(&change) * largest(&self.weight) + 2.0 * largest(&of_weight))
            * largest(&speed)
            + 3.0 * largest(&fall);
        // The bend's own rounding, which grows with its square.
        let carried = match normal {
            Some(_) => self.bend_rounding(),
            None => 2.0 * longest(&bend) * self.bend_rounding(),
        };
        let degree = b.len() as f64;
        let carried = degree * carried * largest(&self.weight) * largest(&speed);
        let rounding = SIGN_RELATIVE * scale + carried;
        RoundedPolynomial { coefficients: slope, rounding }
    }

    fn fastest(&self) -> f64 {
        longest(&self.velocity).max(LAST_BIT * self.size)
    }
}

/// Adds a multiple of a polynomial that may be of another degree.
pub(in crate::curve) fn add(sum: &mut Vec<f64>, summand: &[f64], factor: f64) {
    let one = |n: usize| vec![1.0; n + 1];
    let (p, q) = (sum.len() - 1, summand.len() - 1);
    let times = |a: f64, b: f64| a * b;
    let raised = product(summand, &one(p.saturating_sub(q)), times);
    if p < q {
        *sum = product(sum, &one(q - p), times);
    }
    sum.iter_mut().zip(raised).for_each(|(sum, summand)| *sum += factor * summand);
}

/// The largest length among vector coefficients.
pub(in crate::curve) fn longest(coefficients: &[DVec3]) -> f64 {
    coefficients.iter().fold(0.0, |most, vector| most.max(vector.length()))
}
