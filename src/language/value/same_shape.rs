//! The matrix of curves and surfaces that are the given ones on other knots, or parts of them: from the knots alone.

use super::{Value, affine::Differences, mapped::Question};
use crate::kernel::{
    Curve, PointFactors, PointSlopes, Surface, factors_of_same_curve, factors_of_same_surface,
};

impl Differences<'_> {
    /// The matrix of an answer all of whose curves and surfaces are given ones that move, as far as those here tell; none
    /// where it holds anything else.
    pub(super) fn same_shape(
        &self,
        Question { given, answer, .. }: &Question<'_>,
    ) -> Option<PointFactors> {
        let (mut made, mut held) = (Vec::new(), Vec::new());
        shapes(&self.base, &mut made);
        given.held.args.iter().for_each(|arg| shapes(arg, &mut held));
        let firsts = given.sets.iter().scan(0, |end, own| {
            let first = *end;
            *end += PointSlopes::n_points(own);
            Some(first)
        });
        let sets: Vec<(usize, &Value)> = firsts
            .zip(&given.nets)
            .map(|(first, &net)| Some((first, held[net].as_ref()?)))
            .collect::<Option<_>>()?;
        let mut all = Vec::new();
        for (idx, (net, own)) in answer.nets.iter().zip(&made).enumerate() {
            let own = own.as_ref()?;
            // As many curves as are given are made one of each, in their order.
            let (before, behind) = sets.split_at(idx.min(sets.len() - 1));
            let mut tried = behind.iter().chain(before);
            let (first, factors) =
                tried.find_map(|(first, whole)| Some((first, factors(whole, own)?)))?;
            all.extend(factors.into_iter().map(|(i, j, own)| (net.first + i, first + j, own)));
        }
        (!all.is_empty()).then_some(PointFactors::Alike(all))
    }
}

/// The curve or surface of each net of points in a value, in the order of
/// [`NumberPlaces::nets`](super::numbers::NumberPlaces); none of points as such.
fn shapes(value: &Value, all: &mut Vec<Option<Value>>) {
    match value {
        Value::Curve(Curve::Nurbs(_)) | Value::Surface(Surface::Nurbs(_)) => {
            all.push(Some(value.clone()));
        }
        Value::Point(_) => all.push(None),
        Value::List(items) if items.values().all(|item| matches!(item, Value::Point(_))) => {
            all.push(None);
        }
        Value::List(items) => items.values().for_each(|item| shapes(&item, all)),
        Value::Record(record) => record.iter().for_each(|(_, value)| shapes(value, all)),
        _ => {}
    }
}

fn factors(whole: &Value, made: &Value) -> Option<Vec<(usize, usize, f64)>> {
    match (whole, made) {
        (Value::Curve(Curve::Nurbs(whole)), Value::Curve(Curve::Nurbs(made))) => {
            factors_of_same_curve(whole, made)
        }
        (Value::Surface(Surface::Nurbs(whole)), Value::Surface(Surface::Nurbs(made))) => {
            factors_of_same_surface(whole, made)
        }
        _ => None,
    }
}
