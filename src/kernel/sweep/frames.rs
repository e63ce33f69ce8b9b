//! Frames that travel along a path: x along its tangent, z carried along by a rule.

use glam::{DQuat, DVec3};

use crate::{
    GeomError, InputError, LocalError, NurbsCurve, Side,
    ceiling::FRAME_DOUBLINGS,
    frame::{across, norm, unit},
    tolerance::{FRAME_JUMP, PLACE_RELATIVE, TURN_ACCURACY, VANISHING_RELATIVE},
};

/// A rule for the directions across a path.
///
/// The binormal of a circle counter-clockwise in the xy plane is z; what does not turn about the path
/// keeps the direction that it is given:
///
/// ```
/// use virote_kernel::{Frame, FrameRule, Frames, NurbsCurve, glam::DVec3};
///
/// let path = NurbsCurve::arc(Frame::XY, 2.0, 0.0, 1.0)?;
/// let z = |rule, up| Frames::new(&path, rule, up, false)?.at(0.5).map(|axes| axes.z);
/// assert!(z(FrameRule::Frenet, DVec3::X)?.distance(DVec3::Z) < 1e-12);
/// assert!(z(FrameRule::RotationMinimizing, DVec3::NEG_Z)?.distance(DVec3::NEG_Z) < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FrameRule {
    /// z is as near to a given direction as it can be everywhere.
    Fixed,
    /// z is the path's binormal.
    Frenet,
    /// z does not turn about the path.
    RotationMinimizing,
}

/// x, y and z at a place of the path.
///
/// ```
/// use virote_kernel::{FrameRule, Frames, NurbsCurve, glam::DVec3};
///
/// let path = NurbsCurve::line(DVec3::ZERO, DVec3::X * 5.0)?;
/// let axes = Frames::new(&path, FrameRule::Fixed, DVec3::Z, false)?.at(0.5)?;
/// assert_eq!([axes.x, axes.y, axes.z], [DVec3::X, DVec3::Y, DVec3::Z]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Along the path.
    pub x: DVec3,
    /// z × x.
    pub y: DVec3,
    /// Across the path.
    pub z: DVec3,
}

impl Axes {
    fn new(x: DVec3, z: DVec3) -> Self {
        Self { x, y: z.cross(x), z }
    }

    /// Turned about x.
    fn turned(self, angle: f64) -> Self {
        if angle.abs() <= 0.0 {
            return self;
        }
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        Self::new(self.x, self.z * cosine - self.y * sine)
    }
}

/// Tangents of a straight path differ by less than this.
const STRAIGHT: f64 = TURN_ACCURACY;

/// Steps of a span between two looks at the accuracy.
const FIRST_STEPS: usize = 16;

/// Halvings of a step after which what still turns around in it does so at once.
const FLIP_HALVINGS: usize = 20;

/// Frames at many places of a path, from which those between follow.
///
/// ```
/// use virote_kernel::{Frame, FrameRule, Frames, NurbsCurve, glam::DVec3};
///
/// // A plane ring comes back with the axes that it began with: nothing is left to close.
/// let ring = NurbsCurve::arc(Frame::XY, 2.0, 0.0, std::f64::consts::TAU)?;
/// let frames = Frames::new(&ring, FrameRule::RotationMinimizing, DVec3::Z, true)?;
/// assert!(frames.closing().abs() < 1e-9 && frames.flips().is_empty());
/// assert!(frames.last().x.distance(DVec3::Y) < 1e-12);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Frames {
    path: NurbsCurve,
    rule: FrameRule,
    up: DVec3,
    places: Vec<FramePlace>,
    /// The angle that closes the frames of a closed path, spread over its length.
    closing: f64,
    /// Between which parameters the frame turns at once.
    flips: Vec<[f64; 2]>,
    /// How the section is slid along the path towards a corner at the start and at the end.
    mitres: [Option<PathCorner>; 2],
    /// Whether the path comes back to its start in the direction in which it left.
    is_closed: bool,
}

/// A corner at an end of the path.
#[derive(Clone, Copy, Debug)]
struct PathCorner {
    point: DVec3,
    /// How far what lies beside the path by one, along y and along z, is from the plane that halves
    /// the corner, along the path.
    slopes: [f64; 2],
    /// Where the section stands upright again, as a distance from the corner.
    length: f64,
    /// Whether the path is straight up to there.
    is_straight: bool,
}

#[derive(Clone, Copy, Debug)]
struct FramePlace {
    t: f64,
    point: DVec3,
    axes: Axes,
    /// Length of the path up to here, as a fraction.
    length: f64,
}

impl Frames {
    /// The frames along a path; z starts as near to `up` as it can.
    ///
    /// Rotation minimizing frames by double reflection, with steps halved until the last frame
    /// turns by less than [`TURN_ACCURACY`]: Wang, Jüttler, Zheng & Liu, *Computation of rotation
    /// minimizing frames*, ACM TOG 27 (2008). Where the path comes back to its start with the same tangent, the angle that the
    /// frame misses itself by is spread over the length.
    ///
    /// # Errors
    /// [`InputError::ParallelAxes`] where the path runs along `up` and the rule needs it,
    /// [`LocalError::Straight`] for a Frenet frame where nothing bends,
    /// [`LocalError::VanishingTangent`].
    pub fn new(
        path: &NurbsCurve,
        rule: FrameRule,
        up: DVec3,
        is_closed: bool,
    ) -> Result<Self, GeomError> {
        let mut frames = Self {
            path: path.clone(),
            rule,
            up,
            places: Vec::new(),
            closing: 0.0,
            flips: Vec::new(),
            mitres: [None; 2],
            is_closed,
        };
        let mut n_steps = FIRST_STEPS;
        frames.walk(n_steps)?;
        if rule == FrameRule::RotationMinimizing {
            for _ in 0..FRAME_DOUBLINGS {
                let before = frames.last();
                n_steps *= 2;
                frames.walk(n_steps)?;
                if norm(before.z - frames.last().z) <= TURN_ACCURACY {
                    break;
                }
            }
        }
        if is_closed && rule == FrameRule::RotationMinimizing {
            let (first, last) = (frames.places[0].axes, frames.last());
            frames.closing = libm::atan2(last.y.dot(first.z), last.z.dot(first.z));
        }
        Ok(frames)
    }

    /// The angle that was spread over the length so that a closed path ends as it began.
    #[must_use]
    pub fn closing(&self) -> f64 {
        self.closing
    }

    /// Whether the path comes back to its start in the direction in which it left.
    pub(super) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// Parameters between which the frame turns at once: around, where the path goes over from one way of bending to the
    /// other, or by less, at a knot.
    #[must_use]
    pub fn flips(&self) -> &[[f64; 2]] {
        &self.flips
    }

    /// The frames of a path that has a corner at its start (0) or end (1): there the section lies
    /// in the plane of this normal. A straight path keeps its prism; a bent one is sheared over
    /// `reach` from the corner.
    #[must_use]
    pub fn with_corner(mut self, end: usize, normal: DVec3, reach: f64) -> Self {
        let (axes, point) = match end {
            0 => (self.places[0].axes, self.path.start()),
            _ => (self.last(), self.path.end()),
        };
        let chord = self.path.start().distance(self.path.end());
        let is_straight = self.places.iter().all(|place| norm(place.axes.x - axes.x) <= STRAIGHT);
        let length = if is_straight { chord } else { reach.min(chord) };
        let along = axes.x.dot(normal);
        let slopes = [axes.y.dot(normal) / along, axes.z.dot(normal) / along];
        self.mitres[end] = Some(PathCorner { point, slopes, length, is_straight });
        self
    }

    /// By how much what reaches so far from the path is shortened by the corners at both ends,
    /// over the length that there is for it: above 1 the surface crosses itself there.
    #[must_use]
    pub fn overreach(&self, reach: f64) -> f64 {
        let slopes = |end: usize| self.mitres[end].map_or([0.0; 2], |mitre| mitre.slopes);
        let [start, end] = [slopes(0), slopes(1)];
        let length = self.mitres.iter().flatten().map(|mitre| mitre.length);
        let slide = reach * libm::hypot(end[0] - start[0], end[1] - start[1]);
        slide / length.fold(f64::INFINITY, f64::min)
    }

    /// How far along the path, at a place of it, what lies at `offset` from it is slid to corners.
    pub(super) fn slide(&self, point: DVec3, axes: Axes, offset: DVec3) -> f64 {
        let slide = |mitre: &PathCorner| {
            let part = (point.distance(mitre.point) / mitre.length).min(1.0);
            let rest = 1.0 - part;
            let share = if mitre.is_straight { rest } else { rest * rest * (1.0 + 2.0 * part) };
            let [by_y, by_z] = mitre.slopes;
            -share * (by_y * offset.dot(axes.y) + by_z * offset.dot(axes.z))
        };
        self.mitres.iter().flatten().map(slide).sum()
    }

    /// Parameters where a bent path's section stands upright again, roughly, and on both sides of what
    /// the frame does at once.
    pub(super) fn breaks(&self) -> Vec<f64> {
        let bent = self.mitres.iter().flatten().filter(|mitre| !mitre.is_straight);
        let crossing = |mitre: &PathCorner| {
            let is_near = |place: &FramePlace| place.point.distance(mitre.point) <= mitre.length;
            let change = |pair: &&[FramePlace]| is_near(&pair[0]) != is_near(&pair[1]);
            self.places.windows(2).find(change).map(|pair| pair[1].t)
        };
        let flips = self.flips.iter().flatten().copied();
        let inner = flips.filter(|&t| {
            let domain = self.path.domain();
            domain.start() < t && t < domain.end()
        });
        bent.filter_map(crossing).chain(inner).collect()
    }

    /// The axes at the end of the path.
    #[must_use]
    pub fn last(&self) -> Axes {
        self.places[self.places.len() - 1].axes
    }

    fn tangent(&self, t: f64) -> Result<DVec3, GeomError> {
        self.path.tangent_at(t, Side::Right)
    }

    fn walk(&mut self, n_steps: usize) -> Result<(), GeomError> {
        self.places.clear();
        self.flips.clear();
        let knots = self.path.knots();
        let mut parameters: Vec<f64> = knots
            .spans()
            .flat_map(|span| {
                let mut steps = knots.span_interval(span).steps(n_steps);
                steps.pop();
                steps
            })
            .collect();
        parameters.push(self.path.domain().end());
        for t in parameters {
            let (point, x) = (self.path.point_at(t), self.tangent(t)?);
            let place = match self.places.last().copied() {
                None => FramePlace { t, point, axes: self.first(t, x)?, length: 0.0 },
                Some(before) => {
                    let length = before.length + point.distance(before.point);
                    let axes = self.next(before, t, point, x)?;
                    let place = FramePlace { t, point, axes, length };
                    // At a knot of low continuity the frame may come in otherwise than it goes on.
                    let arriving = FramePlace { axes: self.arriving(before, place)?, ..place };
                    let jumps = FRAME_JUMP < norm(arriving.axes.z - axes.z);
                    let flip = self.flip(before, arriving)?;
                    self.flips.extend(flip.map(|flip| self.cell(flip)));
                    self.flips.extend(jumps.then(|| self.cell([t, t])));
                    place
                }
            };
            self.places.push(place);
        }
        let total = self.places.last().map_or(1.0, |place| place.length);
        self.places.iter_mut().for_each(|place| place.length /= total);
        Ok(())
    }

    /// The axes with which the path comes to a place.
    fn arriving(&self, before: FramePlace, place: FramePlace) -> Result<Axes, GeomError> {
        if self.rule != FrameRule::Frenet {
            return Ok(place.axes);
        }
        let x = self.path.tangent_at(place.t, Side::Left)?;
        let z = self.binormal(place.t, Side::Left).or_else(|| across(before.axes.z, x));
        Ok(z.and_then(|z| across(z, x)).map_or(place.axes, |z| Axes::new(x, z)))
    }

    /// A short interval about what the frame does at once, wide enough for knots.
    fn cell(&self, [start, end]: [f64; 2]) -> [f64; 2] {
        let domain = self.path.domain();
        let margin = (end - start).max(PLACE_RELATIVE * domain.length());
        [(start - margin).max(domain.start()), (end + margin).min(domain.end())]
    }

    /// Between which parameters the frame turns around at once between two places, rather than fast: halves are
    /// asked as long as it turns by more than a right angle over one of them.
    fn flip(
        &self,
        mut before: FramePlace,
        mut after: FramePlace,
    ) -> Result<Option<[f64; 2]>, GeomError> {
        if self.rule == FrameRule::RotationMinimizing {
            return Ok(None);
        }
        let is_turned = |a: FramePlace, b: FramePlace| a.axes.z.dot(b.axes.z) < 0.0;
        for _ in 0..FLIP_HALVINGS {
            if !is_turned(before, after) {
                return Ok(None);
            }
            let t = f64::midpoint(before.t, after.t);
            let point = self.path.point_at(t);
            let axes = self.next(before, t, point, self.tangent(t)?)?;
            let middle = FramePlace { t, point, axes, length: before.length };
            *(if is_turned(before, middle) { &mut after } else { &mut before }) = middle;
        }
        Ok(Some([before.t, after.t]))
    }

    fn first(&self, t: f64, x: DVec3) -> Result<Axes, GeomError> {
        match self.rule {
            FrameRule::Frenet => {
                // At a straight start, the first binormal that there is.
                let domain = self.path.domain();
                let steps = domain.steps(256);
                let found = steps.into_iter().find_map(|t| self.binormal(t, Side::Right));
                let z = self.binormal(t, Side::Right).or(found);
                let z = z.ok_or(GeomError::Local(LocalError::Straight {
                    what: "frenet frame",
                    parameter: t,
                }))?;
                let z = across(z, x).ok_or(GeomError::Local(LocalError::Straight {
                    what: "frenet frame",
                    parameter: t,
                }))?;
                Ok(Axes::new(x, z))
            }
            _ => self.upright(x),
        }
    }

    fn upright(&self, x: DVec3) -> Result<Axes, GeomError> {
        let z = across(self.up, x).ok_or(GeomError::Input(InputError::ParallelAxes {
            first: "the path",
            second: "the direction up",
        }))?;
        Ok(Axes::new(x, z))
    }

    fn binormal(&self, t: f64, side: Side) -> Option<DVec3> {
        let derivatives = self.path.derivatives_beside(t, side, 2);
        let cross = derivatives[1].cross(derivatives[2]);
        let size = derivatives[1].length() * derivatives[2].length();
        if norm(cross) <= VANISHING_RELATIVE.sqrt() * size { None } else { unit(cross) }
    }

    fn next(&self, before: FramePlace, t: f64, point: DVec3, x: DVec3) -> Result<Axes, GeomError> {
        let z = match self.rule {
            FrameRule::Fixed => return self.upright(x),
            FrameRule::Frenet => self.binormal(t, Side::Right).or_else(|| across(before.axes.z, x)),
            FrameRule::RotationMinimizing => reflected_twice(before, point, x),
        };
        let z = z.and_then(|z| across(z, x));
        Ok(Axes::new(x, z.ok_or(GeomError::Local(LocalError::VanishingTangent { parameter: t }))?))
    }

    /// The frame at a parameter.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at(&self, t: f64) -> Result<Axes, GeomError> {
        let next = self.places.partition_point(|place| place.t <= t).max(1);
        let before = self.places[next - 1];
        let point = self.path.point_at(t);
        let axes = self.next(before, t, point, self.tangent(t)?)?;
        let ahead = self.places.get(next).map_or(before.length, |place| place.length);
        let width = self.places.get(next).map_or(1.0, |place| place.t - before.t);
        let along = before.length + (ahead - before.length) * ((t - before.t) / width);
        Ok(axes.turned(-self.closing * along))
    }
}

/// The z that two reflections carry on: the first takes the point before to the next one, the
/// second its tangent to the next one's.
fn reflected_twice(before: FramePlace, point: DVec3, x: DVec3) -> Option<DVec3> {
    let step = point - before.point;
    let Some(axis) = unit(step) else { return across(before.axes.z, x) };
    let reflect = |v: DVec3, axis: DVec3| v - axis * (2.0 * v.dot(axis));
    let (z, tangent) = (reflect(before.axes.z, axis), reflect(before.axes.x, axis));
    match unit(x - tangent) {
        Some(second) if VANISHING_RELATIVE < norm(x - tangent) => Some(reflect(z, second)),
        _ => Some(z),
    }
}

/// The axes carried over a corner by the smallest turn.
pub(super) fn over_corner(axes: Axes, x: DVec3) -> Axes {
    let z = DQuat::from_rotation_arc(axes.x, x).mul_vec3(axes.z);
    Axes::new(x, across(z, x).unwrap_or(z))
}
