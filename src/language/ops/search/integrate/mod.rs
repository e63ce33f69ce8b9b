//! `integrate`: the integral of a function over a range, a box, a curve, a region, a face or a surface.

mod domain;
mod found;
mod integrand;
mod moving_cuts;
mod moving_range;
mod parts;
mod strips;

use domain::{Domain, domains};
use found::Found;
use integrand::Integrand;
use parts::{Part, over_all};

use super::Over;
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::{
        Jet,
        tolerance::{EXACT_RELATIVE, INTEGRAL_RELATIVE},
    },
    value::{Callback, Ctx, Dimension, IntoValue, Number, Real, Record, Value, Vector, op},
};

op! {
    /// Integral of a function over a range; or over a box of two or three ranges, the length of a curve, the area
    /// of a region, a face or a surface, or several curves or several areas together. Of numbers it is a number,
    /// of points a point.
    ///
    /// It is known to thirteen digits of the integral of the function's size, or within `tolerance`; over boxes
    /// and areas to twelve. A region or face is divided into strips, so that the function is asked inside of it only;
    /// where the border of a face is known within a tolerance, so is the integral. Kinks and jumps are found, and the
    /// range is cut there. What none of the places that are asked shows is not seen: of a smooth function these are some
    /// 30, and 200 evenly spread more before the answer is believed, along a curve as well; 16 for each range of several and
    /// each direction of an area, so that a peak that is narrower than a hundredth of the range, or there than a tenth,
    /// may lie between them; add up the integrals on both sides of its top. Ends of
    /// ranges and borders are never asked for, so that a function may grow without bound there: at 0 to all digits,
    /// elsewhere as near as numbers are apart, which a `tolerance` of 1e-6 allows for. An integral that has no finite
    /// value, or does not settle, is refused with the place.
    ///
    /// Over a range whose end lies before its start it is the negative, over one of no length 0. Derivatives pass
    /// through: that of an integral is the integral of the derivative, by an end of the range the function there, and
    /// by a place at which the function jumps, the jump.
    /// Piessens et al., *QUADPACK*, §2.2.1.
    integrate in Math -> Value {
        /// A function that yields a number or a point: of a number over a range, of as many as there are ranges
        /// over a box, of a point over a curve or an area.
        f: Spanned<Callback>,
        /// The range; or a list of two or three, a curve, a region, a face, a surface, a list of curves or of areas.
        over: Spanned<Over>,
        /// How far the integral may be off, in units of its own; thirteen digits unless given.
        tolerance: Option<Spanned<Number>>,
        /// Whether a record tells how it was found: the `integral`, the `error` that two rules leave, and
        /// `evaluations`.
        report: bool = false,
    }
    example "integrate(x => x^2, 0..3) ~= 9" => "true";
    example "integrate(t => sqrt(1 - t^2), -1..1) ~= pi/2" => "true";
    example "integrate(t => (t, 1), 0..2) ~= (2, 2)" => "true";
    example "integrate(x => 2cm, 0cm..30mm) == 3cm * 2cm" => "true";
    example "\"{integrate(s => if s < 1cm then 0 else 2mm, 0cm..2cm):.1cm^2}\"" => "\"0.2cm^2\"";
    example "integrate((x, y) => x * y^2, [0..1, 0..3]) ~= 4.5" => "true";
    example "integrate(p => p.y^2, circle((0, 0), 2)) ~= 8*pi" => "true";
    example "integrate(p => p.x^2, region(circle((0, 0), 2))) ~= 4*pi" => "true";
    example "integrate(p => p.z^2, sphere((0, 0), 1)) ~= 4*pi/3 within 1e-10" => "true";
    example "gradient(a => integrate(x => a^2 * x, 0..2), 3) ~= 12" => "true";
    example "gradient(b => integrate(x => x^2, 0..b), 3) ~= 9" => "true";
    example "gradient(a => integrate(x => if x < a then 5 else 2, 0..1), 0.25) ~= 3" => "true";
    example "integrate(x => x, 3..0) ~= -4.5" => "true";
    example "integrate(x => x^2, 0..3, report = true).evaluations" => "228";
    refuses "integrate(x => 1/x, 0..1)" => "E0504: the integral does not settle near 0";
    refuses "integrate(x => x, 3)" => "E0301: an integral is over a range, a box, a curve, a region, a face or a surface, found the number 3";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Value> {
    let domains = domains(&args.over.map(|over| over.0))?;
    let tolerances = match &args.tolerance {
        Some(tolerance) if tolerance.value.value <= 0.0 => {
            let message = format!("`tolerance` is {}; it must be above zero", tolerance.value);
            return Diagnostic::error(Code::Domain, tolerance.span, message).fail();
        }
        Some(tolerance) => [EXACT_RELATIVE, tolerance.value.value],
        None => [INTEGRAL_RELATIVE, 0.0],
    };
    let parts: Vec<Part<'_>> = domains.iter().map(Part::new).collect::<Result<_>>()?;
    let mut integrand = Integrand::new(ctx, &args.f);
    let Found { value: values, error, .. } = over_all(&parts, &mut integrand, tolerances)?;
    let n_asked = integrand.n_asked;
    let like = domains.iter().find_map(Domain::like);
    let mut reals: Vec<Real> = values.iter().copied().map(Real::Plain).collect();
    if let Some(like) = like.or_else(|| integrand.like.take().filter(|_| integrand.is_varying())) {
        integrand.carry(like.clone());
        let flat = over_all(&parts, &mut integrand, tolerances)?.value;
        let series = flat.chunks(like.coefficients().len());
        let jet = |(series, &value): (&[f64], &f64)| -> Jet {
            like.with_coefficients(series).with_value(value)
        };
        reals = series.zip(&values).map(jet).map(Real::Jet).collect();
    }
    let (own, mut dim) = (integrand.dimension(), Dimension::OPEN);
    let integral = match <[Real; 3]>::try_from(reals) {
        Ok(point) => Vector::new(point).into_value(),
        Err(reals) => {
            let extent = domains.first().map_or(Dimension::NONE, Domain::dimension);
            dim = own.times(extent).ok_or_else(|| {
                let message = "the dimension of the integral has powers that are too high";
                Box::new(Diagnostic::error(Code::UnitMismatch, args.f.span, message))
            })?;
            let value = reals.into_iter().next().unwrap_or(Real::Plain(0.0));
            Number { value, dim }.into_value()
        }
    };
    if !args.report {
        return Ok(integral);
    }
    let fields = [
        ("integral", integral),
        ("error", Number { value: error, dim }.into_value()),
        ("evaluations", Value::number(n_asked as f64)),
    ];
    Ok(Record::new(fields.map(|(label, value)| (label.into(), value))).into_value())
}
