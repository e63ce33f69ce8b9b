//! Whether a place beside kinks is one of the least, by the gradients near it.
//!
//! Where the least value is, the hull of the gradients near by holds zero; elsewhere the planes with those gradients promise
//! to be lower. They are learned by asking there: where the function does not fall as promised, a gradient between is one
//! that the hull lacks. So near by is first a hundredth of the unknowns' sizes, then less and less, so that kinks may be
//! bent. Goldstein, *Optimization of Lipschitz continuous functions*, Math. Programming 13 (1977); Mahdavi-Amiri &
//! Yousefpour, *An effective nonsmooth optimization algorithm for locally Lipschitz functions*, J. Optim. Theory Appl. 155
//! (2012); planes within reach as in Schramm & Zowe, *A version of the bundle idea for minimizing a nonsmooth function*,
//! SIAM J. Optim. 2 (1992). A hull that holds zero may be that of a saddle: along what the kinks leave free it is looked
//! beside.

use super::{
    answers::{Answers, Wanted},
    least_beside::free_ways,
    least_model::{CurvatureModel, HoldingCondition, Plane, Terms, magnitude},
    least_search::LeastSearch,
    quadratic_program::{LinearCondition, dot},
};
use crate::{
    ceiling::{
        KINK_HULL_FEW, KINK_HULL_HALVINGS, KINK_HULL_PLANES, KINK_HULL_RETURNS, KINK_HULL_UNKNOWNS,
    },
    tolerance::{
        DIFFERENCE_RELATIVE, KINK_BESIDE_RELATIVE, KINK_DIFFERENCE_RELATIVE, KINK_HULL_BENDS,
        KINK_HULL_DIFFERENCE_RELATIVE, KINK_HULL_REACHES, KINK_HULL_RELATIVE, KINK_ROUNDINGS,
        KINK_SLOPE_RELATIVE, LAST_BIT, LEAST_PROBE_RELATIVE,
    },
};

/// The share of a promised fall from which on that is kept.
const KEPT: f64 = 0.1;

/// What is known of a function and its conditions within reach of a place.
struct Hull {
    reach: f64,
    planes: Vec<Plane>,
    /// The planes of conditions that were broken within reach.
    cuts: Vec<LinearCondition>,
}

/// The gradients on one side of a place, and by how much the plane with the first one is below the value there.
type OneSide = (Vec<Vec<f64>>, f64);

/// What the function is within reach of a place.
enum Nearby {
    /// Nowhere lower: the hull of these gradients holds zero.
    Least(Vec<Plane>),
    /// Lower along a way.
    Lower(Vec<f64>),
    /// Hidden by rounding.
    Hidden,
    /// Lower as far as is known, and not as promised.
    Unknown,
}

/// What a question along a way on which a fall is promised tells.
enum Told {
    Kept,
    Hidden,
    News,
    Nothing,
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    /// Whether a place near by is lower, where the search settled beside kinks; the search goes there.
    pub(super) fn leaves_by_hull(&mut self) -> Result<bool, E> {
        self.asked.reach = KINK_DIFFERENCE_RELATIVE;
        let is_left = self.leaves_hulls();
        self.asked.reach = DIFFERENCE_RELATIVE;
        is_left
    }

    fn leaves_hulls(&mut self) -> Result<bool, E> {
        let has_differences = self.asked.has_differences;
        let side = self.one_side()?;
        if self.is_across(&side.0) {
            self.is_unproven = true;
            return Ok(false);
        }
        let mut planes = Vec::new();
        // Differences tell nothing that is as near as the places they are of.
        let told = |reach: &f64| !has_differences || KINK_BESIDE_RELATIVE < *reach;
        for reach in KINK_HULL_REACHES.into_iter().filter(told) {
            let nearby = self.nearby(&side, reach)?;
            self.is_unproven = matches!(nearby, Nearby::Unknown);
            match nearby {
                Nearby::Lower(way) => return self.leaves_on(&way, reach),
                Nearby::Hidden => return Ok(false),
                Nearby::Least(known) => planes = known,
                Nearby::Unknown => {}
            }
        }
        if self.is_unproven {
            return Ok(false);
        }
        Ok(self.leaves_along_kinks(&planes)? || self.leaves_between_planes(planes)?)
    }

    /// Goes along a way to a place that is lower, as far as it is lower and lower twice as far each time.
    fn leaves_on(&mut self, way: &[f64], reach: f64) -> Result<bool, E> {
        let mut best = self.moved(way, 1.0)?;
        let mut times = 1.0;
        for _ in 0..KINK_HULL_HALVINGS {
            let farther = self.moved(way, 2.0 * times)?;
            if self.merit(&best.1) <= self.merit(&farther.1) {
                break;
            }
            best = farther;
            times *= 2.0;
        }
        let is_lower = self.is_lower(self.merit(&best.1), reach);
        if is_lower {
            self.leave_for(best, times * reach);
        }
        Ok(is_lower)
    }

    fn one_side(&mut self) -> Result<OneSide, E> {
        let (place, values) = (self.place.clone(), self.values.clone());
        self.slopes_beside(&place, &values)
    }

    /// What the function is within reach of the place.
    fn nearby(&mut self, (slopes, below): &OneSide, reach: f64) -> Result<Nearby, E> {
        let first = Plane { gradient: slopes[0].clone(), gap: below.max(0.0) };
        let mut hull = Hull { reach, planes: vec![first], cuts: Vec::new() };
        let n = self.place.len();
        let relative = if self.asked.has_differences {
            KINK_HULL_DIFFERENCE_RELATIVE
        } else {
            KINK_HULL_RELATIVE
        };
        let is_many = KINK_HULL_UNKNOWNS[usize::from(self.asked.has_differences)] < n;
        for _ in 0..if is_many { KINK_HULL_FEW } else { KINK_HULL_PLANES * (n + 2) } {
            let steep = hull.steepest();
            if steep <= 0.0 {
                return Ok(Nearby::Least(hull.planes));
            }
            let Some((way, fall)) = self.hull_step(slopes, &hull) else {
                return Ok(Nearby::Unknown);
            };
            if fall <= (relative * steep * reach).max(self.little()) {
                return Ok(Nearby::Least(hull.planes));
            }
            let bits = KINK_ROUNDINGS * LAST_BIT * self.merit(&self.values).abs();
            if fall <= bits + self.rounding(&hull.planes) {
                return Ok(Nearby::Hidden);
            }
            match self.ask_along(&way, fall, &mut hull)? {
                Told::News => {}
                Told::Kept => return Ok(Nearby::Lower(way)),
                Told::Hidden => return Ok(Nearby::Hidden),
                Told::Nothing => return Ok(Nearby::Unknown),
            }
        }
        Ok(Nearby::Unknown)
    }

    /// The step within reach behind which the planes promise the greatest fall, and that fall; none where rounding lets what
    /// is known contradict itself.
    fn hull_step(&self, slopes: &[Vec<f64>], hull: &Hull) -> Option<(Vec<f64>, f64)> {
        let reach = hull.reach;
        let limits = self.limits(&self.place);
        let limits: Vec<[f64; 2]> =
            limits.into_iter().map(|[low, high]| [low.max(-reach), high.min(reach)]).collect();
        let terms = Terms {
            gradients: slopes,
            values: &self.weighted(&self.values),
            limits: &limits,
            n_equations: self.problem.n_equations,
        };
        let model = CurvatureModel::new(self.place.len());
        let mut best: Option<(Vec<f64>, f64)> = None;
        for bend in KINK_HULL_BENDS {
            let share = bend * hull.steepest() / reach;
            let step = model.step_below(&terms, &hull.planes, &hull.cuts, share);
            let Some((mut way, mut fall)) = step else { continue };
            let room = terms.room(&way).min(reach / magnitude(&way)).min(hull.room(&way));
            if room.is_finite() {
                let longer: Vec<f64> = way.iter().map(|part| part * room.max(1.0)).collect();
                let fall_there = hull.fall(&longer);
                if fall < fall_there {
                    (way, fall) = (longer, fall_there);
                }
            }
            let is_at_edge = 0.99 * reach < magnitude(&way);
            if best.as_ref().is_none_or(|(_, most)| *most < fall) {
                best = Some((way, fall));
            }
            if is_at_edge {
                break;
            }
        }
        best
    }

    /// Asks behind a way whether a fall is kept, and if not on the way where it is not for something that the hull lacks.
    fn ask_along(&mut self, way: &[f64], fall: f64, hull: &mut Hull) -> Result<Told, E> {
        let here = self.merit(&self.values);
        let (mut low, mut high, mut top) = (0.0, 1.0, f64::INFINITY);
        let (mut share, mut n_same) = (1.0, 0);
        for _ in 0..KINK_HULL_HALVINGS {
            let (place, values) = self.moved(way, share)?;
            let rise = self.merit(&values) - here;
            n_same += usize::from(rise.abs() <= 0.0);
            if 1 < n_same {
                return Ok(Told::Hidden);
            }
            let missed = rise + KEPT * fall * share;
            if 1.0 <= share && missed < 0.0 {
                return Ok(Told::Kept);
            }
            if missed.is_finite() && self.learn_at((place, values), (way, fall), hull)? {
                return Ok(Told::News);
            }
            if share < 1.0 && missed < top {
                low = share;
            } else {
                (high, top) = (share, missed);
            }
            share = 0.5 * (low + high);
        }
        Ok(Told::Nothing)
    }

    /// Takes up the planes of a place on a way on which a fall is promised; whether they promise less of it.
    fn learn_at(
        &mut self,
        (place, values): (Vec<f64>, Vec<f64>),
        (way, fall): (&[f64], f64),
        hull: &mut Hull,
    ) -> Result<bool, E> {
        let (mut slopes, below) = self.slopes_beside(&place, &values)?;
        if self.is_across(&slopes) {
            return Ok(false);
        }
        let taken = self.way_between(&self.place, &place);
        let weighted = self.weighted(&values);
        let n_cuts = hull.cuts.len();
        for idx in self.problem.n_equations..self.penalties.len() {
            let value = weighted[idx + 1];
            if KEPT * KEPT * fall < -value * self.penalties[idx] {
                let normal = std::mem::take(&mut slopes[idx + 1]);
                let constant = (value - dot(&normal, &taken)).max(0.0);
                if constant + dot(&normal, way) < 0.0 {
                    hull.cuts.push(LinearCondition { normal, constant, is_equation: false });
                }
            }
        }
        let gradient = slopes.swap_remove(0);
        let gap = self.weights[0] * (self.values[0] - values[0]) + below + dot(&gradient, &taken);
        let plane = Plane { gradient, gap: gap.max(0.0) };
        let is_higher = -2.0 * KEPT * fall < dot(&plane.gradient, way) - plane.gap;
        if is_higher {
            hull.planes.push(plane);
        }
        Ok(is_higher || n_cuts < hull.cuts.len())
    }

    /// Whether a place is lower beside along what kinks and conditions leave free, led back to where they meet; the search
    /// goes there. The kinks are those between planes.
    fn leaves_along_kinks(&mut self, planes: &[Plane]) -> Result<bool, E> {
        let Some((first, others)) = planes.split_first() else { return Ok(false) };
        let steep = planes.iter().map(|plane| magnitude(&plane.gradient)).fold(0.0, f64::max);
        let normals = others.iter().map(|other| {
            let parts = other.gradient.iter().zip(&first.gradient);
            parts.map(|(other, first)| (other - first) / steep).collect::<Vec<f64>>()
        });
        let kinks: Vec<HoldingCondition> = normals
            .filter(|normal| KINK_SLOPE_RELATIVE < magnitude(normal))
            .map(|normal| HoldingCondition { idx: 0, normal, multiplier: 0.0 })
            .collect();
        let terms = Terms {
            gradients: &self.slopes,
            values: &self.weighted(&self.values),
            limits: &self.limits(&self.place),
            n_equations: self.problem.n_equations,
        };
        let Some(mut holding) = terms.holding().filter(|_| !kinks.is_empty()) else {
            return Ok(false);
        };
        holding.extend(kinks);
        for way in free_ways(&holding, self.place.len()) {
            for side in [-LEAST_PROBE_RELATIVE, LEAST_PROBE_RELATIVE] {
                let there = self.led_to_kinks(&way, side, steep)?;
                if self.is_lower(self.merit(&there.1), LEAST_PROBE_RELATIVE) {
                    self.leave_for(there, LEAST_PROBE_RELATIVE);
                    return Ok(true);
                }
            }
        }
        Ok(false)
    }

    /// The place a way away, and down from there to the kinks near by, which are so steep; not where it is so high there that
    /// the way crosses one more.
    fn led_to_kinks(
        &mut self,
        way: &[f64],
        reach: f64,
        steep: f64,
    ) -> Result<(Vec<f64>, Vec<f64>), E> {
        let highest = self.merit(&self.values) + KEPT * steep * reach.abs();
        let here = (self.place.clone(), self.values.clone());
        (self.place, self.values) = self.moved(way, reach)?;
        for _ in 0..KINK_HULL_RETURNS {
            if highest < self.merit(&self.values) {
                break;
            }
            let side = self.one_side()?;
            let Nearby::Lower(down) = self.nearby(&side, reach.abs())? else { break };
            (self.place, self.values) = self.moved(&down, 1.0)?;
        }
        let there = (std::mem::take(&mut self.place), std::mem::take(&mut self.values));
        (self.place, self.values) = here;
        Ok(there)
    }
}

impl Hull {
    fn steepest(&self) -> f64 {
        self.planes.iter().map(|plane| magnitude(&plane.gradient)).fold(0.0, f64::max)
    }

    /// By how much the planes are all lower behind a way.
    fn fall(&self, way: &[f64]) -> f64 {
        let heights = self.planes.iter().map(|plane| dot(&plane.gradient, way) - plane.gap);
        -heights.fold(f64::NEG_INFINITY, f64::max)
    }

    /// How many times as far as a way one may go along it before one of the cuts breaks.
    fn room(&self, way: &[f64]) -> f64 {
        let rooms = self.cuts.iter().map(|cut| (cut.constant, dot(&cut.normal, way)));
        let rooms = rooms.filter(|(_, change)| *change < 0.0);
        rooms.map(|(constant, change)| -constant / change).fold(f64::INFINITY, f64::min)
    }
}
