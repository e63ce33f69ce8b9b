//! Steps from section to section of a skin, by which a rule finds the parameters of the sections.

use glam::{DVec3, DVec4};

use crate::{
    SectionParameters,
    homogeneous::{place, place_speed},
    tolerance::{EXACT_RELATIVE, VANISHING_RELATIVE},
};

/// Steps from section to section along lines of their control points, which tell the parameters by a rule.
#[derive(Debug)]
pub(super) struct SectionSteps {
    rule: SectionParameters,
    /// The control points of each line, one for each section.
    lines: Vec<Vec<DVec4>>,
    /// Of each step of each line its length as the rule takes it, and how that grows with the way; of none the latter
    /// is told where both ends are at one place.
    steps: Vec<Vec<(f64, Option<DVec4>)>>,
    /// The lengths of the lines that count.
    wholes: Vec<Option<f64>>,
    n_counting: f64,
}

impl SectionSteps {
    /// Of two sections or more; none of fewer.
    pub(super) fn new(rule: SectionParameters, lines: Vec<Vec<DVec4>>) -> Option<Self> {
        let origin = place(*lines.first()?.first()?);
        let step = |ends: &[DVec4]| {
            let [before, behind] = [ends[0], ends[1]].map(|end| rule.measured(origin, end));
            let leg = behind - before;
            let length = leg.length();
            match rule {
                SectionParameters::Uniform => (1.0, Some(DVec4::ZERO)),
                _ if length <= 0.0 => (0.0, None),
                SectionParameters::Average | SectionParameters::Places => {
                    (length, Some(leg / length))
                }
                SectionParameters::Centripetal => {
                    let root = length.sqrt();
                    (root, Some(leg / (2.0 * length * root)))
                }
            }
        };
        let steps: Vec<Vec<_>> =
            lines.iter().map(|line| line.windows(2).map(step).collect()).collect();
        let whole = |steps: &Vec<(f64, _)>| steps.iter().map(|(length, _)| length).sum();
        let wholes: Vec<f64> = steps.iter().map(whole).collect();
        let longest = wholes.iter().copied().fold(0.0, f64::max);
        let wholes: Vec<Option<f64>> = wholes
            .into_iter()
            .map(|whole| (VANISHING_RELATIVE * longest < whole).then_some(whole))
            .collect();
        let n_counting = wholes.iter().flatten().count() as f64;
        (!steps[0].is_empty()).then_some(Self { rule, lines, steps, wholes, n_counting })
    }

    fn parameters(&self) -> Vec<f64> {
        let n_steps = self.steps[0].len();
        let mut found = vec![0.0];
        for k in 0..n_steps {
            let lines = self.steps.iter().zip(&self.wholes);
            let shares = lines.filter_map(|(steps, whole)| whole.map(|whole| steps[k].0 / whole));
            found.push(found[k] + shares.sum::<f64>() / self.n_counting);
        }
        found
    }

    /// Whether these are the parameters that the rule tells.
    pub(super) fn are_of(&self, parameters: &[f64]) -> bool {
        let found = self.parameters();
        let mut pairs = found.iter().zip(parameters);
        found.len() == parameters.len() && pairs.all(|(a, b)| (a - b).abs() <= EXACT_RELATIVE)
    }

    /// How fast the parameters move where the control points of some lines do, each with its index; none where a point
    /// comes away from a neighbour at its place.
    pub(super) fn speeds(&self, moving: Vec<(usize, Vec<DVec4>)>) -> Option<Vec<f64>> {
        let n_sections = self.lines[0].len();
        let first = self.lines[0][0];
        let own = moving.first().filter(|(line, _)| *line == 0);
        let speed_of_origin = own.map_or(DVec3::ZERO, |(_, slopes)| place_speed(first, slopes[0]));
        let origin = [place(first), speed_of_origin];
        let moving = if speed_of_origin == DVec3::ZERO {
            moving
        } else {
            // What is told about the origin moves with it.
            let mut all = vec![vec![DVec4::ZERO; n_sections]; self.lines.len()];
            moving.into_iter().for_each(|(line, slopes)| all[line] = slopes);
            all.into_iter().enumerate().collect()
        };
        let mut by_step = vec![0.0; n_sections - 1];
        for (line, slopes) in &moving {
            let pairs = self.lines[*line].iter().zip(slopes);
            let speeds: Vec<DVec4> = pairs
                .map(|(&point, &slope)| self.rule.measured_speed(origin, [point, slope]))
                .collect();
            let steps = &self.steps[*line];
            let mut growths = Vec::with_capacity(steps.len());
            for ((_, along), ends) in steps.iter().zip(speeds.windows(2)) {
                let way = ends[1] - ends[0];
                match along {
                    Some(along) => growths.push(along.dot(way)),
                    None if way.length() <= 0.0 => growths.push(0.0),
                    None => return None,
                }
            }
            let Some(whole) = self.wholes[*line] else { continue };
            let growth: f64 = growths.iter().sum();
            for ((sum, own), (length, _)) in by_step.iter_mut().zip(growths).zip(steps) {
                *sum += (own - length / whole * growth) / whole;
            }
        }
        let mut speeds = vec![0.0];
        speeds.extend(by_step.iter().scan(0.0, |sum, own| {
            *sum += own / self.n_counting;
            Some(*sum)
        }));
        speeds[n_sections - 1] = 0.0;
        Some(speeds)
    }

    /// The steps whose ends are at one place, each by its line and the section before it.
    pub(super) fn without_length(&self) -> impl Iterator<Item = (usize, usize)> {
        self.steps.iter().enumerate().flat_map(|(line, steps)| {
            let at_one_place = move |(section, (_, along)): (usize, &(f64, Option<DVec4>))| {
                along.is_none().then_some((line, section))
            };
            steps.iter().enumerate().filter_map(at_one_place)
        })
    }

    /// How something grows with the ways from section to section along a line of polynomial sections, from its growths
    /// with the parameters: for each step by a vector times how the way grows along another one.
    pub(super) fn growths(&self, line: usize, by_parameter: &[DVec3]) -> Vec<(DVec3, DVec3)> {
        let Some(whole) = self.wholes[line] else { return Vec::new() };
        let steps = &self.steps[line];
        // The parameters behind a step grow with it, but the last one.
        let mut behind = DVec3::ZERO;
        let mut growths = vec![DVec3::ZERO; steps.len()];
        for k in (1..steps.len()).rev() {
            behind += by_parameter[k];
            growths[k - 1] = behind;
        }
        let held: DVec3 =
            growths.iter().zip(steps).map(|(growth, (length, _))| *growth * *length).sum();
        let shared = held / whole;
        let pairs = growths.into_iter().zip(steps);
        pairs
            .map(|(growth, (_, along))| {
                let along = along.map_or(DVec3::ZERO, DVec4::truncate);
                ((growth - shared) / (whole * self.n_counting), along)
            })
            .collect()
    }
}
