//! Slopes of what is affine, from steps of several variables at once.

use super::{
    affine::{Differences, Line, all_moved},
    numbers::NumberPlaces,
    packed::{Growth, MovingNumbers, Pack},
    reach::{Moved, PointReach},
};

/// How many times fewer steps variables have to take that are moved as they are, before that is tried.
const FEWER_AS_THEY_ARE: usize = 4;

/// The same of those that are moved beside others that reach other points.
const FEWER_IN_PART: usize = 5;

/// By how many control points more is reached than told beside where a curve is cut.
const WIDER: f64 = 3.0;

/// How variables are moved together.
#[derive(Clone, Copy)]
pub(super) enum Way {
    /// Each along a coordinate that is free.
    Turned(Reach),
    /// The same, with what each curve or surface of a list reaches told by its own control points.
    TurnedApart,
    /// Each as it is, beside those that reach other points.
    AsTheyAre,
}

/// Which points of an answer a control point may reach.
#[derive(Clone, Copy)]
pub(super) enum Reach {
    /// Those that the first ones tell.
    Narrow,
    /// A few more.
    Wide,
    Any,
}

impl Way {
    /// The way that serves most often and costs least comes first.
    const ALL: [Self; 5] = [
        Self::Turned(Reach::Narrow),
        Self::TurnedApart,
        Self::AsTheyAre,
        Self::Turned(Reach::Wide),
        Self::Turned(Reach::Any),
    ];
}

/// Variables by those that are moved together.
pub(super) struct Packed {
    pub(super) answer: NumberPlaces,
    /// What those do that were moved first.
    pub(super) known: Vec<Vec<Growth>>,
    /// The others.
    pub(super) packs: Vec<Pack>,
}

impl Differences<'_> {
    /// The same from steps of several variables at once; none where they do not go together.
    pub(super) fn together(&mut self, n_variables: usize) -> Option<Vec<Growth>> {
        let moving = MovingNumbers::new(self.args, all_moved(self.args, &[])?, n_variables)?;
        let first = moving.first_ones();
        let (mut has_parts, mut has_wholes) = (false, false);
        for way in Way::ALL {
            let has_sense = match way {
                Way::Turned(Reach::Any) => !has_wholes,
                Way::Turned(Reach::Wide) => has_parts,
                Way::TurnedApart => has_parts && moving.has_lists(),
                Way::Turned(Reach::Narrow) | Way::AsTheyAre => !first.is_empty(),
            };
            if !has_sense {
                continue;
            }
            let packed = match way {
                Way::TurnedApart => {
                    let apart = moving.apart();
                    self.packed(&apart, &apart.first_ones(), way)
                }
                _ => self.packed(&moving, &first, way),
            };
            if let Some(packed) = packed {
                let is_turning = !matches!(way, Way::AsTheyAre);
                let is_in_part = packed.packs.iter().any(Pack::is_in_part);
                has_parts |= is_in_part;
                has_wholes |= !is_in_part;
                // What mixes coordinates seems to reach all where two are moved along others.
                let is_mixed = is_turning
                    && !is_in_part
                    && packed
                        .known
                        .iter()
                        .any(|own| 1 < own.len() && !self.are_straight(own.iter()));
                if !is_mixed && let Some(lines) = self.lines_of(&moving, packed) {
                    return Some(lines);
                }
            }
        }
        None
    }

    /// Variables by those that are moved together, the first ones moved; none where hardly any go together.
    pub(super) fn packed(
        &mut self,
        moving: &MovingNumbers,
        first: &[[Moved; 2]],
        way: Way,
    ) -> Option<Packed> {
        let answer = NumberPlaces::of([&self.base]);
        let is_turning = !matches!(way, Way::AsTheyAre);
        let margin = match way {
            Way::Turned(Reach::Any) => None,
            Way::Turned(Reach::Wide) => Some(WIDER),
            Way::Turned(Reach::Narrow) | Way::TurnedApart | Way::AsTheyAre => Some(0.0),
        };
        let first = if margin.is_some() { first } else { &[] };
        let moved_first: Vec<usize> = first.iter().flatten().map(|moved| moved.variable).collect();
        let packs = moving.packs(&moved_first, &[], &answer, is_turning);
        let known = self.measured(moving, &packs, &answer)?;
        let grown =
            |moved: Moved| known.iter().flatten().find(|line| line.variable == moved.variable);
        let reach = |pair: &[Moved; 2]| {
            let [a, b] = [grown(pair[0])?, grown(pair[1])?];
            let reach = PointReach::new(pair, [&a.growth, &b.growth], (&answer, margin?));
            Some((pair[0], reach))
        };
        let reaches = first.iter().map(reach).collect::<Option<Vec<_>>>()?;
        let mut others = moving.variables();
        others.retain(|variable| !moved_first.contains(variable));
        let packs = moving.packs(&others, &reaches, &answer, is_turning);
        let fewer = match packs.iter().any(Pack::is_in_part) {
            true => FEWER_IN_PART,
            false if is_turning => 1,
            false => FEWER_AS_THEY_ARE,
        };
        let is_fewer = fewer * packs.len() < others.len();
        is_fewer.then_some(Packed { answer, known, packs })
    }

    /// The growths of variables by steps of packs of them, each held against these.
    pub(super) fn measured(
        &mut self,
        moving: &MovingNumbers,
        packs: &[Pack],
        answer: &NumberPlaces,
    ) -> Option<Vec<Vec<Growth>>> {
        let args = moving.args(packs)?;
        let mut together = Differences {
            args: &args,
            base: self.base.clone(),
            run: &mut *self.run,
            plain: self.plain.clone(),
        };
        let lines = together.lines(packs.len()).ok()?;
        let apart =
            |line: &Line| packs[line.variable].taken_apart((line.step, &line.growth), answer);
        Some(lines.iter().map(apart).collect())
    }

    /// The growths by all variables; none where they do not go together, which those that do not bend one another tell.
    fn lines_of(&mut self, moving: &MovingNumbers, packed: Packed) -> Option<Vec<Growth>> {
        let Packed { answer, known: mut by_pack, packs } = packed;
        by_pack.extend(self.measured(moving, &packs, &answer)?);
        if !self.are_straight(by_pack.iter().flatten()) {
            for own in &by_pack {
                if !self.are_straight(own.iter()) {
                    return None;
                }
            }
        }
        Some(by_pack.into_iter().flatten().collect())
    }
}
