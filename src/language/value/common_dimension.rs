//! The dimension of numbers that stand for one another.

use super::{Dimension, Number};

/// The dimension of numbers each of which may become the answer, one after another: what a function yields at
/// several places, a column, a list whose greatest is wanted. A bare number fits any but an angle, beside which only 0
/// says what it is.
#[derive(Clone, Copy, Debug, Default)]
pub struct CommonDimension {
    dim: Option<Dimension>,
    /// That of a number without an angle that is not 0.
    unsaid: Option<Dimension>,
}

impl CommonDimension {
    /// Takes one more.
    ///
    /// # Errors
    /// What was there before and what came, which do not mix.
    pub fn take(&mut self, number: Number) -> Result<(), [Dimension; 2]> {
        let before = self.dim.unwrap_or(number.dim);
        let common = before.common(number.dim).ok_or([before, number.dim])?;
        if number.dim.angle_power() == 0 && 0.0 < number.value.abs() {
            self.unsaid.get_or_insert(number.dim);
        }
        if let (true, Some(unsaid)) = (common.angle_power() != 0, self.unsaid) {
            let is_later = before.angle_power() != 0;
            return Err(if is_later { [before, number.dim] } else { [unsaid, number.dim] });
        }
        self.dim = Some(common);
        Ok(())
    }

    /// That of all; none before the first.
    #[must_use]
    pub fn known(&self) -> Option<Dimension> {
        self.dim
    }

    /// That of all; of none at all a bare number's.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        self.dim.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::CommonDimension;
    use crate::value::{Dimension, Number};

    const LENGTH: Number = Number { value: 2.0, dim: Dimension::LENGTH };

    fn of(numbers: &[Number]) -> Result<Dimension, [Dimension; 2]> {
        let mut common = CommonDimension::default();
        numbers.iter().try_for_each(|&number| common.take(number))?;
        Ok(common.dimension())
    }

    #[test]
    fn it_does_not_matter_which_number_comes_first() {
        let [zero, one, open] = [Number::bare(0.0), Number::bare(1.0), Number::open(3.0)];
        for [a, b, dim] in [
            [zero, LENGTH, LENGTH],
            [one, LENGTH, LENGTH],
            [open, LENGTH, open],
            [open, one, open],
            [zero, Number::angle(0.5), Number::angle(0.5)],
        ] {
            assert_eq!([of(&[a, b]), of(&[b, a])], [Ok(dim.dim); 2]);
        }
    }

    #[test]
    fn beside_an_angle_only_zero_says_nothing() {
        let (angle, zero, one) = (Number::angle(0.5), Number::bare(0.0), Number::bare(1.0));
        let mismatch = |dims: [Dimension; 2]| Err(dims);
        assert_eq!(of(&[one, angle]), mismatch([one.dim, angle.dim]));
        assert_eq!(of(&[angle, one]), mismatch([angle.dim, one.dim]));
        assert_eq!(of(&[one, zero, angle]), mismatch([one.dim, angle.dim]));
        assert_eq!(of(&[zero, angle, one]), mismatch([angle.dim, one.dim]));
        assert_eq!(of(&[LENGTH, angle]), mismatch([LENGTH.dim, angle.dim]));
    }
}
