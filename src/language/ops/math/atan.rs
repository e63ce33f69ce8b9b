//! `atan`: the angle with a given tangent.

use super::angle_of;
use crate::{
    diag::Result,
    value::{Angle, At, Ctx, OnNumbers, Real, op},
};

op! {
    /// The angle between -90 and 90 degrees whose tangent is `x`.
    atan in Math -> Angle<Real> {
        /// A number.
        x: Real,
    }
    example "atan(1)" => "45deg";
    encloses crate::kernel::Enclosure::atan;
    on_numbers OnNumbers::One(angle_of, libm::atan);
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Angle<Real>> {
    args.x.atan().at(ctx.span).map(Angle)
}
