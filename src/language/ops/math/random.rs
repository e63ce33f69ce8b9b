//! `random`: random numbers.

use crate::{
    diag::Result,
    ops::list::check_length,
    value::{Ctx, op},
};

op! {
    /// `n` random numbers from 0 to 1 without 1, uniformly spread; the same on every machine for the same seed.
    ///
    /// Vigna's SplitMix64 (Steele, Lea & Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014), the upper 53 bits of each word.
    random in Math -> Vec<f64> {
        /// How many.
        n: usize,
        /// A whole number that chooses the sequence.
        seed: i64 = 0,
    }
    example "len(random(3))" => "3";
    example "random(1)" => "[0.8833108082136426]";
}

fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Vec<f64>> {
    check_length(args.n as f64, ctx)?;
    let mut state = args.seed.cast_unsigned();
    Ok((0..args.n).map(|_| fraction(next(&mut state))).collect())
}

/// The next word of SplitMix64.
fn next(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut word = *state;
    word = (word ^ (word >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    word = (word ^ (word >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    word ^ (word >> 31)
}

/// The upper 53 bits as a fraction of one.
fn fraction(word: u64) -> f64 {
    (word >> 11) as f64 / (1u64 << 53) as f64
}
