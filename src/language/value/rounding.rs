//! Numbers of so many digits behind the point, as they are written.

/// Digits behind the point beyond which every number is itself, and before it beyond which it is 0.
const MOST: i64 = 400;

/// The number of so many digits behind the point that is nearest to the shortest text of `x`; halves go away from zero.
pub(crate) fn rounded_to(x: f64, digits: i64) -> f64 {
    let digits = digits.clamp(-MOST, MOST);
    let text = format!("{:e}", x.abs());
    let Some((mantissa, exponent)) = text.split_once('e') else { return x };
    let Ok(exponent) = exponent.parse::<i64>() else { return x };
    let figures: Vec<u8> = mantissa.bytes().filter(u8::is_ascii_digit).collect();
    // The first figure counts 10^exponent; those from here on go away.
    let n_kept = exponent + 1 + digits;
    if n_kept < 0 {
        return 0.0;
    }
    let n_kept = n_kept as usize;
    let Some(&next) = figures.get(n_kept) else { return x };
    let kept: String = figures[..n_kept].iter().map(|&figure| char::from(figure)).collect();
    let whole = kept.parse::<u64>().unwrap_or(0) + u64::from(b'5' <= next);
    let rounded = format!("{whole}e{}", -digits).parse::<f64>().unwrap_or(x.abs());
    rounded.copysign(x) + 0.0
}
