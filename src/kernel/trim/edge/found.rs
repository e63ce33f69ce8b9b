//! All that two surfaces, or a surface and a plane, have in common, with the proof.
//!
//! Which curves there are is found by `surface::intersection::level_set`: pairs of parts of both surfaces are halved
//! until boxes tell that they are apart or cones of normals that they cross in one arc at most, so that none is
//! missed, however small; each arc is followed, and no curve may end but at a border or where others end. Here each
//! of these curves is lifted to the parameters of both surfaces and proven, which adds none and leaves none out.

use glam::DVec3;

use super::{
    CurveEnd, SurfaceCurve, SurfaceCurveKind, certificate,
    even::even_parameters,
    lift::{LiftForm, LiftedPiece, lifted, pieces_of},
    piece::{Carrier, CurvePiece},
    place::{FAR, PlaceFinder},
    spline::spline,
};
use crate::{
    Bounds, Frame, GeomError, KnotVector, NurbsCurve, NurbsSurface, Surface, Tolerance,
    tolerance::{EDGE_SHARE, LAST_BIT, NORMAL_AGREEMENT},
};

/// Places along a curve at which it is looked at what the surfaces do there.
const N_LOOKS: usize = 7;

impl SurfaceCurve {
    /// All curves that two surfaces share, within the tolerance, each with the parameters on both.
    ///
    /// Complete as [`Surface::intersections`] is; places in which surfaces touch are no curves and not told.
    ///
    /// # Errors
    /// As [`Surface::intersections`].
    pub fn all(surfaces: [&NurbsSurface; 2], tolerance: Tolerance) -> Result<Vec<Self>, GeomError> {
        let [a, b] = surfaces.map(|surface| Surface::from(surface.clone()));
        let found = a.intersections(&b, tolerance)?;
        let size = surfaces[0].bounds().diagonal().min(surfaces[1].bounds().diagonal());
        let distance = tolerance.distance_for(size);
        found.curves.iter().map(|curve| Self::along(curve, surfaces, distance)).collect()
    }

    /// All curves in which a plane cuts a surface, within the tolerance. The parameters of the second are the
    /// coordinates x and y of the plane.
    ///
    /// # Errors
    /// As [`NurbsSurface::section`].
    pub fn all_in_plane(
        surface: &NurbsSurface,
        plane: Frame,
        tolerance: Tolerance,
    ) -> Result<Vec<Self>, GeomError> {
        let found = surface.section(plane, tolerance)?;
        let distance = tolerance.distance_for(surface.bounds().diagonal());
        let sheet = sheet(plane, surface.bounds())?;
        found.curves.iter().map(|curve| Self::along(curve, [surface, &sheet], distance)).collect()
    }

    /// A curve that two surfaces share, with its parameters on both and the proof.
    ///
    /// The curve stays as it is where it is within an eighth of the tolerance of both surfaces, and is fitted to
    /// the places that they share otherwise.
    ///
    /// # Errors
    /// As [`NurbsCurve::new`].
    pub fn along(
        curve: &NurbsCurve,
        surfaces: [&NurbsSurface; 2],
        tolerance: f64,
    ) -> Result<Self, GeomError> {
        let allowed = EDGE_SHARE * tolerance;
        let forms = [(LiftForm::Kept, allowed), (LiftForm::Refitted, allowed)];
        Self::in_a_form(curve, surfaces, tolerance, &forms)
    }

    /// The same of a curve as it is: where it is farther than the tolerance from a surface nothing is known of its
    /// deviation. Where surfaces cross at a small angle they do so farther away, which the radius tells.
    ///
    /// # Errors
    /// As [`NurbsCurve::new`].
    pub fn of(
        curve: &NurbsCurve,
        surfaces: [&NurbsSurface; 2],
        tolerance: f64,
    ) -> Result<Self, GeomError> {
        if let Some(found) = Self::evenly(curve, surfaces, tolerance) {
            return Ok(found);
        }
        // The nearer its parameters are to it, the nearer it is proven to be.
        let shares = [EDGE_SHARE, 0.5, 1.0];
        let forms = shares.map(|share| (LiftForm::Kept, share * tolerance));
        let mut found = Self::in_a_form(curve, surfaces, tolerance, &forms)?;
        if !found.is_proven && found.deviation <= tolerance {
            found.prove_within(surfaces, tolerance, FAR * tolerance);
        }
        Ok(found)
    }

    /// One that goes evenly along lines of constant parameter, or is in a plane patch, and is proven to be there.
    fn evenly(curve: &NurbsCurve, surfaces: [&NurbsSurface; 2], tolerance: f64) -> Option<Self> {
        let [one, other] = surfaces;
        let on = [even_parameters(curve, one)?, even_parameters(curve, other)?];
        let mut found = Self {
            curve: curve.clone(),
            on,
            deviation: f64::INFINITY,
            radius: None,
            kind: kind_of(curve, surfaces, tolerance),
            is_proven: false,
            between: [CurveEnd::Junction; 2],
        };
        found.prove(surfaces, tolerance);
        found.between = ends_of(&found, surfaces, tolerance);
        (found.is_proven && found.deviation <= EDGE_SHARE * tolerance).then_some(found)
    }

    fn in_a_form(
        curve: &NurbsCurve,
        surfaces: [&NurbsSurface; 2],
        tolerance: f64,
        forms: &[(LiftForm, f64)],
    ) -> Result<Self, GeomError> {
        let finder = PlaceFinder::new(surfaces, curve, tolerance);
        let kind = kind_of(curve, surfaces, tolerance);
        let found = forms.iter().find_map(|&(form, allowed)| {
            let pieces = lifted(&finder, curve, form, allowed)?;
            (!pieces.is_empty()).then_some((pieces, form == LiftForm::Kept))
        });
        let Some((pieces, is_kept)) = found else {
            return Self::unlifted(curve, surfaces, kind);
        };
        let on = |i: usize| {
            let pieces: Vec<_> =
                pieces.iter().map(|piece| (piece.ends, &piece.on[i][..])).collect();
            spline(&pieces)
        };
        let whole = if is_kept { curve.clone() } else { refitted(curve, pieces.clone())? };
        let mut found = Self {
            curve: whole,
            on: [on(0)?, on(1)?],
            deviation: f64::INFINITY,
            radius: None,
            kind,
            is_proven: false,
            between: [CurveEnd::Junction; 2],
        };
        found.between = ends_of(&found, surfaces, tolerance);
        found.prove(surfaces, tolerance);
        Ok(found)
    }

    /// One of which no parameters are found but those of its ends: nothing is known of its deviation.
    fn unlifted(
        curve: &NurbsCurve,
        surfaces: [&NurbsSurface; 2],
        kind: SurfaceCurveKind,
    ) -> Result<Self, GeomError> {
        let domain = curve.domain();
        let on = surfaces.map(|surface| {
            let ends = [curve.start(), curve.end()].map(|end| {
                let [u, v] = surface.closest(end).parameters;
                DVec3::new(u, v, 0.0)
            });
            let knots = [domain.start(), domain.start(), domain.end(), domain.end()];
            NurbsCurve::polynomial(KnotVector::new(1, knots.to_vec())?, &ends)
        });
        let [first, second] = on;
        Ok(Self {
            curve: curve.clone(),
            on: [first?, second?],
            deviation: f64::INFINITY,
            radius: None,
            kind,
            is_proven: false,
            between: [CurveEnd::Junction; 2],
        })
    }

    /// Bounds the deviation anew and tries to prove that the surfaces cross along it, no further than a distance
    /// away.
    pub fn prove(&mut self, surfaces: [&NurbsSurface; 2], distance: f64) {
        self.prove_within(surfaces, distance, distance);
    }

    /// The same, where the surfaces may cross as far away as they may beside a curve within the distance of both.
    fn prove_within(&mut self, surfaces: [&NurbsSurface; 2], distance: f64, reach: f64) {
        let carriers = surfaces.map(Carrier::new);
        let pieces = self.pieces();
        let mut deviation = 0.0_f64;
        for piece in &pieces {
            for (i, carrier) in carriers.iter().enumerate() {
                let length = piece.residual(carrier, i).map_or(f64::INFINITY, |r| r.length());
                deviation = deviation.max(length);
            }
        }
        self.deviation = deviation;
        self.radius = None;
        if self.kind == SurfaceCurveKind::Crossing {
            let mut radius = Some(0.0_f64);
            for piece in pieces {
                let own = certificate::radius(&carriers, piece, reach);
                radius = radius.zip(own).map(|(most, own)| most.max(own));
                if radius.is_none() {
                    break;
                }
            }
            self.radius = radius;
        }
        self.is_proven = match self.kind {
            SurfaceCurveKind::Crossing => self.radius.is_some() && deviation <= distance,
            SurfaceCurveKind::Border => deviation <= distance,
            SurfaceCurveKind::Contact => false,
        };
    }

    /// The curve and its parameters between all their knots.
    pub(super) fn pieces(&self) -> Vec<CurvePiece> {
        let curves = [&self.curve, &self.on[0], &self.on[1]].map(pieces_of);
        let mut breaks: Vec<f64> = curves
            .iter()
            .flatten()
            .flat_map(|(interval, _)| [interval.start(), interval.end()])
            .collect();
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let mut next = [0; 3];
        let mut found = Vec::new();
        for pair in breaks.windows(2) {
            let parts: [Vec<glam::DVec4>; 3] = std::array::from_fn(|i| {
                while curves[i][next[i]].0.end() <= pair[0] && next[i] + 1 < curves[i].len() {
                    next[i] += 1;
                }
                let (interval, points) = &curves[i][next[i]];
                let ends = [pair[0], pair[1]].map(|t| interval.fraction_of(t));
                match ends {
                    [0.0, 1.0] => points.clone(),
                    _ => crate::bernstein::part(points, ends),
                }
            });
            let [curve, first, second] = parts;
            let on = [first, second].map(|points| {
                [points.iter().map(|p| p.x).collect(), points.iter().map(|p| p.y).collect()]
            });
            found.push(CurvePiece { curve, on });
        }
        found
    }
}

/// The spline through common places; of a closed curve the last is the first.
fn refitted(curve: &NurbsCurve, mut pieces: Vec<LiftedPiece>) -> Result<NurbsCurve, GeomError> {
    if curve.start() == curve.end() {
        let start = pieces[0].curve[0];
        if let Some(end) = pieces.last_mut().and_then(|piece| piece.curve.last_mut()) {
            *end = start;
        }
    }
    let pieces: Vec<_> = pieces.iter().map(|piece| (piece.ends, &piece.curve[..])).collect();
    spline(&pieces)
}

/// A part of a plane about all that could be in it, whose parameters are the plane's coordinates.
pub(super) fn sheet(plane: Frame, bounds: Bounds) -> Result<NurbsSurface, GeomError> {
    let center = bounds.center() - plane.origin();
    let reach = bounds.diagonal().max(LAST_BIT * bounds.magnitude());
    let middle = [center.dot(plane.x()), center.dot(plane.y())];
    let knots = |i: usize| {
        let [low, high] = [middle[i] - reach, middle[i] + reach];
        KnotVector::new(1, vec![low, low, high, high])
    };
    let corner = |i: usize, j: usize| {
        let side = |n: usize| if n == 0 { -reach } else { reach };
        plane.point(DVec3::new(middle[0] + side(i), middle[1] + side(j), 0.0))
    };
    NurbsSurface::polynomial(knots(0)?, knots(1)?, &crate::Grid::from_fn(2, 2, corner))
}

/// What surfaces do along a curve, by some of its places.
fn kind_of(curve: &NurbsCurve, surfaces: [&NurbsSurface; 2], tolerance: f64) -> SurfaceCurveKind {
    let steps = curve.domain().steps(N_LOOKS + 1);
    let points: Vec<DVec3> = steps[1..=N_LOOKS].iter().map(|&t| curve.point_at(t)).collect();
    let runs_along_border = surfaces.iter().any(|surface| {
        let closed = [surface.is_closed_u(tolerance), surface.is_closed_v(tolerance)];
        let domains = [surface.domain_u(), surface.domain_v()];
        let sides = [(0, 0), (0, 1), (1, 0), (1, 1)];
        let feet: Vec<[f64; 2]> =
            points.iter().map(|&point| surface.closest(point).parameters).collect();
        sides.iter().filter(|&&(along, _)| !closed[along]).any(|&(along, side)| {
            let end = if side == 0 { domains[along].start() } else { domains[along].end() };
            feet.iter().zip(&points).all(|(foot, point)| {
                let mut on = *foot;
                on[along] = end;
                surface.point_at(on[0], on[1]).distance(*point) <= tolerance
            })
        })
    });
    if runs_along_border {
        return SurfaceCurveKind::Border;
    }
    let touches = |point: &&DVec3| {
        let [a, b] = surfaces.map(|surface| {
            let [u, v] = surface.closest(**point).parameters;
            surface.normal_at(u, v).ok()
        });
        a.zip(b).is_some_and(|(a, b)| a.cross(b).length() <= NORMAL_AGREEMENT.sqrt())
    };
    match 2 * points.iter().filter(touches).count() <= N_LOOKS {
        true => SurfaceCurveKind::Crossing,
        false => SurfaceCurveKind::Contact,
    }
}

/// What the ends of a curve are.
fn ends_of(found: &SurfaceCurve, surfaces: [&NurbsSurface; 2], tolerance: f64) -> [CurveEnd; 2] {
    if found.curve.start().distance(found.curve.end()) <= LAST_BIT * tolerance {
        return [CurveEnd::Closed; 2];
    }
    [0, 1].map(|end| {
        let is_border = surfaces.iter().zip(&found.on).any(|(surface, on)| {
            let at = if end == 0 { on.start() } else { on.end() };
            let point = surface.point_at(at.x, at.y);
            let closed = [surface.is_closed_u(tolerance), surface.is_closed_v(tolerance)];
            let domains = [surface.domain_u(), surface.domain_v()];
            (0..2).filter(|&i| !closed[i]).any(|i| {
                [domains[i].start(), domains[i].end()].into_iter().any(|border| {
                    let mut beside = [at.x, at.y];
                    beside[i] = border;
                    let edges = surface.edges();
                    let edge = &edges[2 * i + usize::from(border > domains[i].start())];
                    tolerance < edge.bounds().diagonal()
                        && surface.point_at(beside[0], beside[1]).distance(point) <= tolerance
                })
            })
        });
        if is_border { CurveEnd::Border } else { CurveEnd::Junction }
    })
}
