//! The rounds of a search for a least value: each begins with the sizes that its start tells, where the one before it
//! came to what is far away, or beside what is lower by other sizes.

use super::{
    answers::{Answers, CountedFunctions, Wanted},
    least_beyond::Beyond,
    least_floor::Floor,
    least_problem::{LeastEnd, LeastProblem},
    least_search::LeastSearch,
    pole_search::END_OF_NUMBERS,
};
use crate::{
    ceiling::{CONSTRAINED_RESTARTS, CONSTRAINED_ROUNDS},
    tolerance::{
        CONTRADICTION_RELATIVE, LEAST_FALL_REACH, LEAST_LOWER_RELATIVE, LEAST_PROBE_RELATIVE,
    },
};

/// Rounds behind which places beside the end were better again and again, at most.
const ROUNDS_LEFT: usize = 2;

/// Where a search ended, and how.
pub(super) struct Ended {
    pub(super) place: Vec<f64>,
    pub(super) values: Vec<f64>,
    pub(super) end: LeastEnd,
}

/// What the rounds behind the last one told.
#[derive(Default)]
struct RoundsBefore {
    /// How many there were.
    n_rounds: usize,
    /// What the function is where the first began.
    first: Option<f64>,
    /// Where the first came to be far away, which is told where those behind it tell nothing else.
    far: Option<Ended>,
    /// How often places beside an end were better again and again.
    n_left: usize,
}

impl LeastProblem<'_> {
    /// Where the rounds from the start end.
    ///
    /// # Errors
    /// Those of the functions.
    pub(super) fn rounds<F, E>(&self, asked: &mut CountedFunctions<F>) -> Result<Ended, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        let mut start = self.start.to_vec();
        let mut before = RoundsBefore::default();
        while before.n_rounds < CONSTRAINED_ROUNDS {
            let problem = LeastProblem { start: &start, ..*self };
            let mut search = LeastSearch::new(problem, asked)?;
            before.first.get_or_insert(search.values[0]);
            let end = search.end()?;
            let floor = before.floor(&mut search, self.start, end)?;
            let place = match floor {
                Floor::Told => {
                    search.refine()?;
                    let told = search.ended_by(LeastEnd::Settled);
                    let is_of_start = before.n_rounds == 1 || told.values.len() == 1;
                    if is_of_start || self.holds_at(&told.place, asked)? {
                        return Ok(told);
                    }
                    told.place
                }
                Floor::Other(end) => return Ok(before.told(search.ended_by(end))),
                Floor::Lower(place) => place,
            };
            start = place;
        }
        let search = LeastSearch::new(LeastProblem { start: &start, ..*self }, asked)?;
        Ok(before.told(search.ended_by(LeastEnd::Unsettled)))
    }

    /// Whether the conditions hold at a place by the sizes that it tells: what is nothing beside those of a round that
    /// began far away may be much.
    fn holds_at<F, E>(&self, place: &[f64], asked: &mut CountedFunctions<F>) -> Result<bool, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        let search = LeastSearch::new(LeastProblem { start: place, ..*self }, asked)?;
        Ok(search.most_broken() <= CONTRADICTION_RELATIVE)
    }
}

impl RoundsBefore {
    /// What is beside or beyond the end of a round; `first` is where the first one began.
    fn floor<F, E>(
        &mut self,
        search: &mut LeastSearch<'_, F>,
        first: &[f64],
        end: LeastEnd,
    ) -> Result<Floor, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        let is_first = self.n_rounds == 0;
        self.n_rounds += 1;
        let has_conditions = 1 < search.values.len();
        Ok(match end {
            LeastEnd::Unbounded if search.merit(&search.values) < END_OF_NUMBERS => {
                Floor::Other(end)
            }
            LeastEnd::Unbounded => self.beyond(search, is_first, end)?,
            LeastEnd::Unattained if !has_conditions => self.beyond(search, is_first, end)?,
            // Of the start there is nothing else to tell.
            LeastEnd::Flat if is_first && search.is_at_start() => Floor::Other(end),
            LeastEnd::Settled | LeastEnd::Flat => {
                let may_rest =
                    self.far.is_none() && self.first.is_some_and(|first| search.values[0] < first);
                search.floor(first, may_rest)?
            }
            LeastEnd::Unsettled if search.is_left && self.n_left < ROUNDS_LEFT => {
                self.n_left += 1;
                Floor::Lower(search.place.clone())
            }
            end => Floor::Other(end),
        })
    }

    /// What is beyond the end of a round that came to be far away, which may be far beside the unknowns at the start alone.
    fn beyond<F, E>(
        &mut self,
        search: &mut LeastSearch<'_, F>,
        is_first: bool,
        end: LeastEnd,
    ) -> Result<Floor, E>
    where
        F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
    {
        let here = search.ended_by(end);
        let beyond = match is_first {
            true => Beyond::Rises(here.place.clone()),
            false => search.beyond(end)?,
        };
        Ok(match beyond {
            Beyond::Falls(end) => Floor::Other(end),
            Beyond::Rises(place) => {
                let tells_more = |far: &Ended| far.end != end && end == LeastEnd::Unattained;
                if self.far.as_ref().is_none_or(tells_more) {
                    self.far = Some(here);
                }
                Floor::Lower(place)
            }
        })
    }

    /// What is told in the end: that a round came to be far away, where the last one tells nothing else; or where one
    /// settled, if it came to zero beside the whole fall and those behind it to nothing else.
    fn told(self, last: Ended) -> Ended {
        let tells_nothing = |far: &Ended| match last.end {
            LeastEnd::Unsettled => far.end == LeastEnd::Unattained,
            LeastEnd::Contradictory | LeastEnd::Flat => true,
            end => end == far.end,
        };
        self.far.filter(tells_nothing).unwrap_or(last)
    }
}

impl<F, E> LeastSearch<'_, F>
where
    F: FnMut(&[f64], Wanted) -> Result<Answers, E>,
{
    fn is_at_start(&self) -> bool {
        self.place.iter().zip(self.problem.start).all(|(x, from)| (x - from).abs() <= 0.0)
    }

    /// How the search ends that goes on from better places beside its ends.
    fn end(&mut self) -> Result<LeastEnd, E> {
        let began = self.values[0];
        let mut end = self.descend()?;
        let mut n_restarts = 0;
        loop {
            let goes_on = match end {
                LeastEnd::Settled => self.leaves_for_better()?,
                LeastEnd::Contradictory => n_restarts == 0 && self.is_led_back()?,
                _ => false,
            };
            if !goes_on {
                if end == LeastEnd::Settled && self.is_unproven {
                    end = LeastEnd::Unsettled;
                }
                break;
            }
            self.is_left = n_restarts == CONSTRAINED_RESTARTS;
            if self.is_left {
                // Whatever is nearer to a root is lower.
                let nothing =
                    LEAST_LOWER_RELATIVE * LEAST_LOWER_RELATIVE * (began - self.values[0]);
                let is_zero = self.left_by <= LEAST_FALL_REACH && self.values[0].abs() <= nothing;
                end = if is_zero { LeastEnd::Settled } else { LeastEnd::Unsettled };
                break;
            }
            end = self.descend()?;
            n_restarts += 1;
        }
        if matches!(end, LeastEnd::Settled | LeastEnd::Unsettled)
            && (self.values[0] < END_OF_NUMBERS || self.is_at_pole()?)
        {
            end = if self.falls_outward()? { LeastEnd::Unbounded } else { LeastEnd::Pole };
        }
        Ok(end)
    }

    /// Whether the function falls from what looks like a pole a little farther out from zero too, where numbers end.
    fn falls_outward(&mut self) -> Result<bool, E> {
        let out: Vec<f64> = self.place.iter().zip(&self.units).map(|(x, unit)| x / unit).collect();
        let values = self.moved(&out, LEAST_PROBE_RELATIVE)?.1;
        let there = self.merit(&values);
        Ok(there < self.merit(&self.values) || !there.is_finite())
    }

    fn ended_by(&self, end: LeastEnd) -> Ended {
        Ended { place: self.place.clone(), values: self.values.clone(), end }
    }
}
