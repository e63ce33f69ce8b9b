//! Where a surface bends more tightly than an offset can follow.

use glam::DVec3;

use crate::{
    Direction, GeomError, Surface,
    ceiling::{BEND_CLIMB_STEPS, OFFSET_PLACES},
};

/// Places of a span, along each direction, at which the bend is measured.
const N_PLACES: usize = 4;

/// Spans of a direction that a function counts as, which has no knots.
const FUNCTION_SPANS: usize = 8;

/// A place where the surface bends around a centre that the offset passes.
///
/// Inward beyond its radius a cylinder has turned inside out:
///
/// ```
/// use virote_kernel::{Frame, NurbsSurface, Surface};
///
/// let cylinder = Surface::from(NurbsSurface::cone(Frame::XY, [2.0, 2.0], 1.0)?);
/// assert!(cylinder.offset(-1.0, 1e-6)?.turn.is_none());
/// let turn = cylinder.offset(-3.0, 1e-6)?.turn;
/// assert!(turn.is_some_and(|turn| (turn.radius - 2.0).abs() < 1e-9));
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FocalPoint {
    /// The parameters.
    pub at: [f64; 2],
    /// The radius of curvature there, no longer than the distance.
    pub radius: f64,
}

/// The place where the bend towards the offset is tightest, if the distance is beyond its radius.
///
/// Sampled on a grid, and narrowed down from the tightest sample.
pub(super) fn tightest(surface: &Surface, distance: f64) -> Result<Option<FocalPoint>, GeomError> {
    let [us, vs] = Direction::BOTH.map(|along| places(surface, along));
    let mut best: Option<(f64, [f64; 2])> = None;
    for &u in &us {
        for &v in &vs {
            let bend = bend(surface, distance, u, v)?;
            if bend.is_some_and(|bend| best.is_none_or(|(most, _)| most < bend)) {
                best = bend.map(|bend| (bend, [u, v]));
            }
        }
    }
    let Some((mut most, mut at)) = best else { return Ok(None) };

    // Walk uphill with shrinking steps.
    let (domain_u, domain_v) = (surface.domain_u(), surface.domain_v());
    let mut steps = [domain_u.length() / us.len() as f64, domain_v.length() / vs.len() as f64];
    for _ in 0..BEND_CLIMB_STEPS {
        let mut next = None;
        for (du, dv) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
            let u = (at[0] + du * steps[0]).clamp(domain_u.start(), domain_u.end());
            let v = (at[1] + dv * steps[1]).clamp(domain_v.start(), domain_v.end());
            if let Some(bend) = bend(surface, distance, u, v)?
                && most < bend
            {
                most = bend;
                next = Some([u, v]);
            }
        }
        match next {
            Some(place) => at = place,
            None => steps = steps.map(|step| 0.5 * step),
        }
    }
    Ok((1.0 <= most).then(|| FocalPoint { at, radius: distance.abs() / most }))
}

fn places(surface: &Surface, along: Direction) -> Vec<f64> {
    let spans = match surface {
        Surface::Nurbs(surface) => {
            let knots = surface.knots(along);
            knots.spans().map(|span| knots.span_interval(span)).collect()
        }
        Surface::Parametric(_) => {
            let steps = surface.domain(along).steps(FUNCTION_SPANS);
            let between = |pair: &[f64]| crate::Interval::new(pair[0], pair[1]).ok();
            steps.windows(2).filter_map(between).collect::<Vec<_>>()
        }
    };
    let n = if OFFSET_PLACES < spans.len() * N_PLACES { 1 } else { N_PLACES };
    let inner = |i: usize| (i as f64 + 0.5) / n as f64;
    spans.iter().flat_map(|span| (0..n).map(move |i| span.at(inner(i)))).collect()
}

/// The distance times the larger curvature towards it; none where there is no normal.
///
/// The principal curvatures are the roots of (EG − F²)k² − (EN + GL − 2FM)k + LN − M².
fn bend(surface: &Surface, distance: f64, u: f64, v: f64) -> Result<Option<f64>, GeomError> {
    let d = surface.derivatives_at(u, v, 2)?;
    let (su, sv) = (d.get(1, 0), d.get(0, 1));
    let product = su.cross(sv);
    let area = product.length();
    let normal: DVec3 = product / area;
    let (e, f, g) = (su.dot(su), su.dot(sv), sv.dot(sv));
    let (l, m, n) = (d.get(2, 0).dot(normal), d.get(1, 1).dot(normal), d.get(0, 2).dot(normal));
    let mean = (e * n + g * l - 2.0 * f * m) / (2.0 * area * area);
    let gaussian = (l * n - m * m) / (area * area);
    let root = (mean * mean - gaussian).max(0.0).sqrt();
    let most = (distance * (mean + root)).max(distance * (mean - root));
    Ok(most.is_finite().then_some(most))
}
