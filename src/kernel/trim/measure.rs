//! Integrals over faces: area, and how it is spread.
//!
//! A face's parameters are cut along the knots of its surface. What is left of the border in each
//! rectangle between knots is a strip from the rectangle's start of u to an arc of the border; what is
//! left of that are whole rectangles, or parts of them between two v. All are integrated by the
//! adaptive rule that integrates surfaces. Green's theorem, with what it adds up sorted by rectangles:
//! Gonzalez-Ochoa, McCammon & Peters, *Computing moments of objects enclosed by piecewise polynomial
//! surfaces*, ACM TOG 17 (1998).

use std::{collections::BTreeMap, sync::Arc};

use glam::{DAffine3, DMat3, DVec3};

use super::{Face, lift::affine_map};
use crate::{
    Bounds, Frame, GeomError, Interval, MassProperties, NurbsCurve, NurbsSurface, Region,
    Tolerance,
    surface::{
        Density, IntegralValues, MOMENT_KINDS, MassIntegral, ONE_MOMENT, QuadratureMap,
        QuantityKinds, Surface, far_share, integral, integral_over, moments,
    },
    tolerance::{KNOT_RELATIVE, LAST_BIT, PARAMETER_RELATIVE},
};

/// Where on each arc of a border places are taken that tell where a face is.
const ALONG_BORDERS: [f64; 4] = [0.0, 0.25, 0.5, 0.75];
/// How many times smaller than the box of their surfaces a box of faces is, for integrals to be taken about its own
/// middle.
const SMALL_PART: f64 = 8.0;

/// A part of a face's parameters.
pub(super) enum ParameterPiece<'a> {
    /// Between two u and two v, so many times.
    Rectangle { surface: &'a NurbsSurface, u: Interval, v: Interval, times: f64 },
    /// From a u to a part of an arc.
    Strip { surface: &'a NurbsSurface, arc: &'a NurbsCurve, interval: Interval, from: f64 },
}

/// Where a line of constant second parameter runs over a piece: at which v, from which u, how far, and by what areas are
/// multiplied.
pub(super) struct PieceLine {
    v: f64,
    from: f64,
    width: f64,
    factor: f64,
}

impl ParameterPiece<'_> {
    fn surface(&self) -> &NurbsSurface {
        match *self {
            Self::Rectangle { surface, .. } | Self::Strip { surface, .. } => surface,
        }
    }
}

impl QuadratureMap for ParameterPiece<'_> {
    type Line = PieceLine;

    fn line_at(&self, second: f64) -> PieceLine {
        match *self {
            Self::Rectangle { times, .. } => {
                PieceLine { v: second, from: 0.0, width: 1.0, factor: times }
            }
            Self::Strip { arc, from, .. } => {
                let derivatives = arc.derivatives_at(second, 1);
                let (end, dv) = (derivatives[0], derivatives[1].y);
                let width = end.x - from;
                PieceLine { v: end.y, from, width, factor: width * dv }
            }
        }
    }

    fn at(
        &self,
        first: f64,
        &PieceLine { v, from, width, factor }: &PieceLine,
    ) -> Result<(DVec3, DVec3, f64), GeomError> {
        let surface = self.surface();
        let [domain_u, domain_v] = [surface.domain_u(), surface.domain_v()];
        let u = (from + width * first).clamp(domain_u.start(), domain_u.end());
        let v = v.clamp(domain_v.start(), domain_v.end());
        let [point, along_u, along_v] = surface.tangents_at(u, v);
        Ok((point, along_u.cross(along_v), factor))
    }

    fn even_ways(&self) -> [bool; 2] {
        match *self {
            Self::Rectangle { surface, .. } => surface.even_ways(),
            Self::Strip { surface, .. } => [surface.even_ways()[0], false],
        }
    }

    fn cells(&self) -> [Vec<Interval>; 2] {
        match *self {
            Self::Rectangle { u, v, .. } => [vec![u], vec![v]],
            Self::Strip { interval, .. } => [vec![Interval::UNIT], vec![interval]],
        }
    }
}

/// Part of an arc of the border within one rectangle between knots.
struct BorderPiece {
    arc: usize,
    interval: Interval,
    row: usize,
    column: usize,
    /// v where it begins and where it ends.
    ends: [f64; 2],
}

impl BorderPiece {
    /// Whether it begins and ends at different v.
    fn rises(&self) -> bool {
        0.0 < (self.ends[0] - self.ends[1]).abs()
    }
}

impl Face {
    /// Its area, centroid and inertia, as of a skin of density one.
    ///
    /// # Errors
    /// `MeasureError::NothingThere`, `MeasureError::TooLargeToMeasure`; `GeomError::Ended`.
    pub fn mass(&self) -> Result<MassProperties, GeomError> {
        self.plane_mass().map_or_else(|| Self::mass_of(std::slice::from_ref(self)), Ok)
    }

    /// The same of a face on a plane patch that is even everywhere, by integrals along its border.
    fn plane_mass(&self) -> Option<MassProperties> {
        let map = affine_map(&self.plane.surface)?;
        let [part] = &self.parts[..] else { return None };
        let flat = part.mass();
        let [a, b] = self.plane.scales.map(f64::recip);
        let map = map * DAffine3::from_scale(DVec3::new(a, b, 0.0));
        let DAffine3 { matrix3: by, .. } = map;
        let stretch = by.x_axis.cross(by.y_axis).length();
        // The inertia is the trace of the second moments less these.
        let turned = |m: DMat3, trace: f64| DMat3::from_diagonal(DVec3::splat(trace)) - m;
        let trace = |m: DMat3| m.x_axis.x + m.y_axis.y + m.z_axis.z;
        let spread = turned(flat.inertia, 0.5 * trace(flat.inertia));
        let spread = by * spread * by.transpose() * stretch;
        let amount = flat.amount * stretch;
        let size = part.bounds().diagonal();
        let cancelled = FLUX_BITS * LAST_BIT * size * size / flat.amount;
        let mass = MassProperties {
            amount,
            centroid: map.transform_point3(flat.centroid),
            inertia: turned(spread, trace(spread)),
            relative_error: flat.relative_error.max(cancelled),
        };
        (amount.is_normal() && mass.inertia.is_finite()).then_some(mass)
    }

    /// Its area alone.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn area(&self) -> Result<f64, GeomError> {
        if let Some((_, area)) = self.plane_area() {
            return Ok(area.length());
        }
        Ok(self.integral(ONE_MOMENT, |_, normal| [normal.length()])?.values[0])
    }

    /// Of a face on a plane patch that is even everywhere, a point of its plane and the normal along Su × Sv as long
    /// as its area.
    pub(super) fn plane_area(&self) -> Option<(DVec3, DVec3)> {
        let map = affine_map(&self.plane.surface)?;
        let [a, b] = self.plane.scales;
        let area: f64 = self.parts.iter().map(Region::area).sum();
        let normal = map.matrix3.x_axis.cross(map.matrix3.y_axis);
        let middle = self.plane.surface.bounds().center();
        Some((middle, normal * (area / (a * b))))
    }

    /// The area, centroid and inertia of several together.
    ///
    /// # Errors
    /// Those of [`Self::mass`].
    pub fn mass_of(faces: &[Self]) -> Result<MassProperties, GeomError> {
        let about = amid(faces);
        let mut sum = MassIntegral::default();
        for face in faces {
            let found = face.integral(MOMENT_KINDS, |point, normal| {
                moments(arm(point, about), normal.length())
            })?;
            sum.add(found, 1.0);
        }
        sum.mass(about, [1.0; 3]).ok_or_else(|| sum.without("area"))
    }

    /// The integral over du·dv of quantities that depend on a point and on Su × Sv.
    ///
    /// # Errors
    /// Those of a search that was ended.
    pub(crate) fn integral<const N: usize, D: Into<Density<N>>>(
        &self,
        kinds: QuantityKinds<N>,
        density: impl Fn(DVec3, DVec3) -> D,
    ) -> Result<IntegralValues<N>, GeomError> {
        if self.is_whole() {
            return integral(&Surface::Nurbs(Arc::clone(&self.plane.surface)), kinds, density);
        }
        let arcs = self.closed_arcs()?;
        integral_over(
            &self.parameter_pieces(&arcs)?,
            far_share(&self.plane.surface),
            kinds,
            density,
        )
    }

    /// The pieces between knots of what arcs bound.
    pub(super) fn parameter_pieces<'a>(
        &'a self,
        arcs: &'a [NurbsCurve],
    ) -> Result<Vec<ParameterPiece<'a>>, GeomError> {
        let surface = &*self.plane.surface;
        let lines = [surface.knots_u().breaks(), surface.knots_v().breaks()];
        let mut border = Vec::new();
        for (number, arc) in arcs.iter().enumerate() {
            border.extend(pieces(number, arc, &lines)?);
        }
        let mut parts: Vec<ParameterPiece<'_>> = Vec::new();
        for piece in &border {
            let (arc, from) = (&arcs[piece.arc], lines[0][piece.column]);
            parts.push(ParameterPiece::Strip { surface, arc, interval: piece.interval, from });
        }
        for (u, v, times) in rectangles(&border, &lines) {
            parts.push(ParameterPiece::Rectangle { surface, u, v, times });
        }
        Ok(parts)
    }

    /// The arcs of all loops, as curves of parameters; where one begins a little beside the end of the
    /// one before it, with a leg between.
    pub(super) fn closed_arcs(&self) -> Result<Vec<NurbsCurve>, GeomError> {
        let mut arcs = Vec::new();
        for border in self.parts.iter().flat_map(Region::arcs) {
            let own: Vec<NurbsCurve> =
                border.iter().map(|arc| self.plane.to_parameters(arc)).collect();
            for (i, arc) in own.iter().enumerate() {
                let (end, start) = (arc.end(), own[(i + 1) % own.len()].start());
                arcs.push(arc.clone());
                if end != start {
                    arcs.push(NurbsCurve::line(end, start)?);
                }
            }
        }
        Ok(arcs)
    }
}

/// A point amid faces, about which integrals over them cancel least: the middle of a box around their surfaces, about
/// which flux through quadrics is even; where what the borders enclose is many times smaller, the middle of that.
pub(crate) fn amid(faces: &[Face]) -> DVec3 {
    let whole = |face: &Face| face.plane.surface.bounds();
    let own = |face: &Face| {
        let arcs = face.parts.iter().flat_map(Region::arcs).flatten();
        let places = arcs.flat_map(|arc| ALONG_BORDERS.map(|at| arc.point_at(arc.domain().at(at))));
        let places = places.map(|place| face.plane.point(place));
        let border = if face.is_whole() { None } else { Bounds::of(places) };
        border.unwrap_or_else(|| whole(face))
    };
    let Some(surfaces) = faces.iter().map(whole).reduce(Bounds::union) else { return DVec3::ZERO };
    let borders = faces.iter().map(own).reduce(Bounds::union);
    borders
        .filter(|own| SMALL_PART * own.diagonal() < surfaces.diagonal())
        .unwrap_or(surfaces)
        .center()
}

/// The way to a point, without what rounding leaves of it: the moments of a plane face about a point of its plane
/// are none, and not known badly.
pub(super) fn arm(point: DVec3, about: DVec3) -> DVec3 {
    let size = 16.0 * LAST_BIT * (point.abs() + about.abs());
    let arm = point - about;
    DVec3::select(arm.abs().cmple(size), DVec3::ZERO, arm)
}

/// Last bits of what it is made of by which a flux is taken for rounding.
pub(super) const FLUX_BITS: f64 = 16.0;

/// The flux through a piece of surface that is an arm away; none where that is rounding. And what it is made of,
/// where nothing is told of it so many times as its last bits are not known.
pub(super) fn flux(arm: DVec3, normal: DVec3) -> Density<1> {
    let (flux, made_of) = (arm.dot(normal), arm.length() * normal.length());
    match flux.abs() <= FLUX_BITS * LAST_BIT * made_of {
        true => Density { values: [0.0], parts: [FLUX_BITS * made_of] },
        false => Density { values: [flux], parts: [made_of] },
    }
}

/// The parts of an arc between knots, its own and those of the surface.
fn pieces(
    number: usize,
    arc: &NurbsCurve,
    lines: &[Vec<f64>; 2],
) -> Result<Vec<BorderPiece>, GeomError> {
    let domain = arc.domain();
    let mut cuts = arc.knots().breaks();
    for part in arc.decompose() {
        let hull = Bounds::of(part.points()).unwrap_or(part.bounds());
        for (axis, lines) in lines.iter().enumerate() {
            let plane = if axis == 0 { Frame::YZ } else { Frame::ZX };
            let slack = KNOT_RELATIVE * (lines[lines.len() - 1] - lines[0]);
            let inner = &lines[1..lines.len() - 1];
            let from = inner.partition_point(|&line| line < hull.min[axis]);
            let to = inner.partition_point(|&line| line <= hull.max[axis]);
            for &line in &inner[from..to.max(from)] {
                GeomError::go_on(1)?;
                let origin = if axis == 0 { DVec3::X } else { DVec3::Y } * line;
                let tolerance = Tolerance::DEFAULT.with_distance(slack);
                cuts.extend(part.plane_parameters(plane.at(origin), tolerance));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    let least = PARAMETER_RELATIVE * domain.length();
    let mut ends = vec![domain.start()];
    for cut in cuts {
        if least < cut - ends[ends.len() - 1] && least < domain.end() - cut {
            ends.push(cut);
        }
    }
    ends.push(domain.end());
    let cell = |lines: &[f64], t: f64| {
        lines.partition_point(|&line| line <= t).clamp(1, lines.len() - 1) - 1
    };
    let piece = |pair: &[f64]| {
        let interval = Interval::new(pair[0], pair[1]).ok()?;
        let middle = arc.point_at(interval.at(0.5));
        let (column, row) = (cell(&lines[0], middle.x), cell(&lines[1], middle.y));
        let ends = [arc.point_at(pair[0]).y, arc.point_at(pair[1]).y];
        Some(BorderPiece { arc: number, interval, row, column, ends })
    };
    Ok(ends.windows(2).filter_map(piece).collect())
}

/// The rectangles left of the strips: between which u and v, and how often.
fn rectangles(border: &[BorderPiece], lines: &[Vec<f64>; 2]) -> Vec<(Interval, Interval, f64)> {
    let mut rows: BTreeMap<usize, Vec<&BorderPiece>> = BTreeMap::new();
    for piece in border.iter().filter(|piece| 0 < piece.column && piece.rises()) {
        rows.entry(piece.row).or_default().push(piece);
    }
    let mut found = Vec::new();
    for pieces in rows.into_values() {
        let mut vs: Vec<f64> = pieces.iter().flat_map(|piece| piece.ends).collect();
        vs.sort_by(f64::total_cmp);
        vs.dedup();
        let most = pieces.iter().map(|piece| piece.column).max().unwrap_or(0);
        for column in 0..most {
            // How often pieces further right run up between neighbouring v, less how often down.
            let mut changes: BTreeMap<usize, i32> = BTreeMap::new();
            for piece in pieces.iter().filter(|piece| column < piece.column) {
                let [from, to] = piece.ends.map(|end| vs.partition_point(|&v| v < end));
                *changes.entry(from).or_default() += 1;
                *changes.entry(to).or_default() -= 1;
            }
            let (mut times, mut from) = (0, 0);
            for (place, change) in changes.into_iter().filter(|&(_, change)| change != 0) {
                if times != 0
                    && let Ok(u) = Interval::new(lines[0][column], lines[0][column + 1])
                    && let Ok(v) = Interval::new(vs[from], vs[place])
                {
                    found.push((u, v, f64::from(times)));
                }
                times += change;
                from = place;
            }
        }
    }
    found
}
