//! Geometry that depends on several variables, to the first order: a curve or surface with the slopes of
//! its control points.
//!
//! A point is linear in the homogeneous control points, and whatever is measured depends on them through
//! points and their derivatives. So the slope of a measure is its gradient by the control points times their
//! slopes; where the measure is an integral, its gradient is the integral of the integrand's, found once for
//! all variables.

mod asked;
mod body;
mod border;
mod closed;
mod curve;
mod flux;
mod inertia;
pub(crate) mod knots;
mod length;
mod listed;
mod made_of;
mod orders;
mod point_map;
mod rows;
pub(crate) mod same_shape;
mod solid;
mod surface;
mod wall;

use std::{ops::Range, sync::Arc};

use glam::{DVec3, DVec4};

use self::{asked::AskedSlopes, listed::ListedSlopes, rows::VariableRows};
use super::{
    CountError, GeomError, Grid, Jet,
    tolerance::{EXACT_RELATIVE, LAST_BIT},
};

pub(crate) use asked::{AllSlopes, SlopeWays};
pub use body::RegionWay;
pub use border::VariedRegion;
pub use closed::stay_closed;
pub use curve::VariedCurve;
pub use flux::SurfaceIntegral;
pub use made_of::PointEntries;
pub use point_map::{PointFactors, PointMap};
pub use same_shape::{factors_of_same_curve, factors_of_same_surface};
pub use solid::VariedSolid;
pub use surface::VariedSurface;
pub use wall::VariedWall;

/// With so many points for each variable, or more, all slopes cost less at once than those of a few places one by one.
const MANY_POINTS: usize = 4;

/// The slopes of homogeneous control points by several variables: listed, or made of each point when it is asked for.
/// Invariant: as many for every variable; those that are listed are finite, and of those that are asked for one that is
/// not makes no derivative: whoever asks refuses it.
///
/// Half the sum of two points, the first of which moves along x with the second of three variables:
///
/// ```
/// use virote_kernel::{PointSlopes, glam::DVec4};
///
/// let slopes = PointSlopes::new(3, 2, vec![(1, vec![DVec4::X, DVec4::ZERO])])?;
/// assert_eq!(slopes.through(&[DVec4::splat(0.5); 2]), [0.0, 0.5, 0.0]);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct PointSlopes {
    n_variables: usize,
    n_points: usize,
    form: SlopeForm,
}

/// How slopes are known.
#[derive(Clone, Debug)]
enum SlopeForm {
    /// All of them.
    Listed(ListedSlopes),
    /// Those of a point when it is asked for.
    Asked(Arc<AskedSlopes>),
}

/// By the same slopes.
impl PartialEq for PointSlopes {
    fn eq(&self, other: &Self) -> bool {
        self.n_variables == other.n_variables && self.by_variable() == other.by_variable()
    }
}

impl PointSlopes {
    /// The slopes of so many points by those of the variables that they depend on, in order.
    ///
    /// # Errors
    /// [`CountError::WrongCount`] for a variable that there is not, [`CountError::TooFewPoints`] unless there is a slope
    /// for each point, `InputError::NotFinite`.
    pub fn new(
        n_variables: usize,
        n_points: usize,
        by_variable: Vec<(usize, Vec<DVec4>)>,
    ) -> Result<Self, GeomError> {
        for (variable, slopes) in &by_variable {
            if n_variables <= *variable {
                let (what, needed, got) = ("variables", variable.saturating_add(1), n_variables);
                return Err(CountError::WrongCount { what, needed, got }.into());
            }
            if slopes.len() != n_points {
                return Err(CountError::TooFewPoints { got: slopes.len(), needed: n_points }.into());
            }
            super::homogeneous::check_finite(slopes)?;
        }
        let form = SlopeForm::Listed(ListedSlopes::new(by_variable));
        Ok(Self { n_variables, n_points, form })
    }

    /// The slopes of so many points by each of some variables, which are made when they are asked for; sums of them may be
    /// beyond numbers, and are no jets then.
    pub(crate) fn asked(
        n_variables: usize,
        n_points: usize,
        variables: Vec<usize>,
        ways: SlopeWays,
    ) -> Self {
        let asked = AskedSlopes::new(n_points, variables, ways);
        Self { n_variables, n_points, form: SlopeForm::Asked(Arc::new(asked)) }
    }

    /// How many variables there are.
    #[must_use]
    pub fn n_variables(&self) -> usize {
        self.n_variables
    }

    /// How many points there are.
    #[must_use]
    pub fn n_points(&self) -> usize {
        self.n_points
    }

    /// The slopes by those variables that the points depend on, each with its index.
    #[must_use]
    pub fn by_variable(&self) -> &[(usize, Vec<DVec4>)] {
        &self.listed().by_variable
    }

    fn listed(&self) -> &ListedSlopes {
        match &self.form {
            SlopeForm::Listed(listed) => listed,
            SlopeForm::Asked(asked) => asked.listed(),
        }
    }

    /// Each variable that moves points with the range of these, and the slopes of all points by it.
    pub(crate) fn moving(&self) -> impl Iterator<Item = (usize, Range<usize>, &[DVec4])> {
        self.listed().moving()
    }

    /// Whether slopes of so many variables that further points are made of cost less one by one, where they are asked for.
    pub(crate) fn are_asked_rather(&self) -> bool {
        Self::are_asked_of(self.n_points, self.moving().count())
    }

    /// The same of so many points that so many variables move.
    pub(crate) fn are_asked_of(n_points: usize, n_variables: usize) -> bool {
        n_points < MANY_POINTS * n_variables
    }

    /// By which variables any of the points may move, in order.
    #[must_use]
    pub fn variables(&self) -> Vec<usize> {
        match &self.form {
            SlopeForm::Listed(listed) => listed.by_variable.iter().map(|own| own.0).collect(),
            SlopeForm::Asked(asked) => asked.variables().to_vec(),
        }
    }

    /// The points that a variable moves, and the slopes of all by it; none if it moves none.
    pub(crate) fn moving_with(&self, variable: usize) -> Option<(Range<usize>, &[DVec4])> {
        self.listed().moving_with(variable)
    }

    /// Whether each variable moves one of the points at most, as far as is known without asking for slopes.
    #[must_use]
    pub fn move_one_each(&self) -> bool {
        match &self.form {
            SlopeForm::Listed(listed) => listed.moving().all(|(_, moving, _)| moving.len() == 1),
            SlopeForm::Asked(_) => self.is_fixed(),
        }
    }

    /// Along which coordinates each point may move; none where weights move, but for the rounding of what stands still.
    #[must_use]
    pub fn moving_coordinates(&self) -> Option<Vec<[bool; 3]>> {
        let SlopeForm::Listed(listed) = &self.form else {
            return Some(vec![[!self.is_fixed(); 3]; self.n_points]);
        };
        let mut are_moving = vec![[false; 3]; self.n_points];
        for (_, moving, slopes) in listed.moving() {
            let own = &slopes[moving.clone()];
            let most = |size: fn(&DVec4) -> f64| own.iter().map(size).fold(0.0, f64::max);
            let weights = most(|slope| slope.w.abs());
            if 0.0 < weights && LAST_BIT.sqrt() * most(|slope| slope.abs().max_element()) < weights
            {
                return None;
            }
            for (are_moving, slope) in are_moving[moving].iter_mut().zip(own) {
                (0..3).for_each(|axis| are_moving[axis] |= 0.0 < slope[axis].abs());
            }
        }
        Some(are_moving)
    }

    /// Whether a point moves as one of others does, but for rounding.
    #[must_use]
    pub fn moves_as(&self, point: usize, other: &Self, other_point: usize) -> bool {
        let of = |slopes: &Self, point: usize| {
            let mut factors = vec![0.0; slopes.n_points];
            factors[point] = 1.0;
            let mut all = vec![DVec3::ZERO; slopes.n_variables];
            slopes.add_sum(&factors, &mut all);
            all
        };
        let [own, others] = [of(self, point), of(other, other_point)];
        let size = own.iter().map(|slope| slope.abs().max_element()).fold(0.0, f64::max);
        let is_near = |(a, b): (&DVec3, &DVec3)| a.distance(*b) <= EXACT_RELATIVE * size;
        own.len() == others.len() && own.iter().zip(&others).all(is_near)
    }

    /// Adds the slopes of a sum of the points, with a factor for each, to those by all variables.
    pub(crate) fn add_sum(&self, factors: &[f64], total: &mut [DVec3]) {
        let listed = match &self.form {
            SlopeForm::Listed(listed) => listed,
            SlopeForm::Asked(asked) => return asked.add_sum(factors, total),
        };
        for (variable, moving, slopes) in listed.moving() {
            let pairs = slopes[moving.clone()].iter().zip(&factors[moving]);
            let own: DVec4 = pairs.map(|(&slope, &factor)| slope * factor).sum();
            total[variable] += own.truncate();
        }
    }

    /// Whether the points depend on no variable.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        match &self.form {
            SlopeForm::Listed(listed) => listed.by_variable.is_empty(),
            SlopeForm::Asked(asked) => asked.is_fixed(),
        }
    }

    /// # Errors
    /// [`CountError::WrongCount`] unless they are those of so many points.
    pub(crate) fn check_points(&self, needed: usize) -> Result<(), GeomError> {
        match self.is_fixed() || self.n_points == needed {
            true => Ok(()),
            false => {
                let got = self.n_points;
                Err(CountError::WrongCount { what: "slopes", needed, got }.into())
            }
        }
    }

    /// The slopes by all variables of something with this gradient by the control points; what it does not tell is zero.
    #[must_use]
    pub fn through(&self, gradient: &[DVec4]) -> Vec<f64> {
        let mut all = vec![0.0; self.n_variables];
        match &self.form {
            SlopeForm::Listed(listed) => {
                for (variable, moving, slopes) in listed.moving() {
                    let from = moving.start;
                    let pairs = slopes[moving].iter().zip(gradient.iter().skip(from));
                    all[variable] = pairs.map(|(s, g)| s.dot(*g)).sum();
                }
            }
            SlopeForm::Asked(asked) => asked.add_through(gradient, &mut all),
        }
        all
    }

    /// The points with some variables moved by steps.
    fn moved(&self, points: &[DVec4], steps: &[(usize, f64)]) -> Vec<DVec4> {
        let mut moved = points.to_vec();
        for (variable, slopes) in self.by_variable() {
            for (_, step) in steps.iter().filter(|(moving, _)| moving == variable) {
                moved.iter_mut().zip(slopes).for_each(|(point, slope)| *point += slope * step);
            }
        }
        moved
    }

    /// Sums of the slopes of points with what acts on them, by each variable that moves one of them: of points that
    /// stand in some ranges, with a row of factors for each point and a sum for each column.
    fn sums(
        &self,
        acting: impl Iterator<Item = Range<usize>> + Clone,
        factors: &Grid<f64>,
    ) -> VariableRows<DVec4> {
        let listed = match &self.form {
            SlopeForm::Listed(listed) => listed,
            SlopeForm::Asked(asked) => return asked.sums(acting, factors),
        };
        let mut found = VariableRows::new(factors.n_columns());
        for (variable, moving, slopes) in listed.moving() {
            let is_any =
                |range: &Range<usize>| range.start.max(moving.start) < range.end.min(moving.end);
            if !acting.clone().any(|range| is_any(&range)) {
                continue;
            }
            let (sums, mut row) = (found.push(variable, DVec4::ZERO), 0);
            for range in acting.clone() {
                let (first, end) = (range.start.max(moving.start), range.end.min(moving.end));
                for (idx, slope) in slopes.iter().enumerate().take(end).skip(first) {
                    let own = factors.row(row + idx - range.start);
                    sums.iter_mut().zip(own).for_each(|(sum, factor)| *sum += slope * factor);
                }
                row += range.len();
            }
        }
        found
    }

    /// A vector of this value and with the slopes `own` by variables, where parameters that vary too add theirs: each
    /// with how the vector grows with it.
    fn vector(
        &self,
        value: DVec3,
        own: impl Iterator<Item = (usize, DVec3)> + Clone,
        parameters: &[(&Jet, DVec3)],
    ) -> Result<[Jet; 3], GeomError> {
        let coordinate = |axis: usize| {
            let mut all = vec![0.0; 1 + self.n_variables];
            all[0] = value[axis];
            own.clone().for_each(|(variable, slope)| all[1 + variable] = slope[axis]);
            for (parameter, growth) in parameters {
                for (sum, slope) in all[1..].iter_mut().zip(parameter.slopes()) {
                    *sum += growth[axis] * slope;
                }
            }
            Jet::of_several(all)
        };
        Ok([coordinate(0)?, coordinate(1)?, coordinate(2)?])
    }
}

/// A point of a curve with its velocity, and what they are made of.
struct CurvePoint {
    /// The homogeneous point.
    value: DVec4,
    /// Its derivative.
    along: DVec4,
    place: DVec3,
    velocity: DVec3,
}

impl CurvePoint {
    /// Of the control points that act there, with the values and derivatives of their basis functions.
    fn new(points: &[DVec4], values: &[f64], slopes: &[f64]) -> Self {
        let (mut value, mut along) = (DVec4::ZERO, DVec4::ZERO);
        for ((&point, &n), &dn) in points.iter().zip(values).zip(slopes) {
            value += point * n;
            along += point * dn;
        }
        let place = value.truncate() / value.w;
        let velocity = (along.truncate() - place * along.w) / value.w;
        Self { value, along, place, velocity }
    }
}

/// The binomial coefficients of a power.
fn binomials(n: usize) -> impl Iterator<Item = f64> {
    let next = move |binomial: &mut f64, i: usize| {
        *binomial *= if i == 0 { 1.0 } else { (n + 1 - i) as f64 / i as f64 };
        Some(*binomial)
    };
    (0..=n).scan(1.0, next)
}
