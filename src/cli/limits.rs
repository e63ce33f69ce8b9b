//! `--limit NAME=VALUE`: ceilings moved for a run.

use std::sync::LazyLock;

use crate::{
    diag::nearest,
    limits::{Ceiling, Limits},
};

/// A ceiling with its new value.
#[derive(Clone, Copy, Debug)]
pub(super) struct MovedCeiling {
    ceiling: &'static Ceiling,
    value: u64,
}

/// Reads `NAME=VALUE`; underscores may group the digits.
pub(super) fn limit(text: &str) -> Result<MovedCeiling, String> {
    let Some((name, value)) = text.split_once('=') else {
        return Err("write NAME=VALUE, for example steps=1_000_000".to_owned());
    };
    let (name, value) = (name.trim(), value.trim());
    let ceiling = Ceiling::from_name(name).ok_or_else(|| {
        let names = || Ceiling::ALL.iter().map(|ceiling| ceiling.name);
        match nearest(name, names()) {
            Some(near) => format!("no ceiling is called `{name}`; did you mean `{near}`?"),
            None => {
                let names: Vec<&str> = names().collect();
                format!("no ceiling is called `{name}`; there are {}", names.join(", "))
            }
        }
    })?;
    let number = value.replace('_', "").parse().ok();
    let mut limits = Limits::DEFAULT;
    match number.filter(|&number| ceiling.move_to(number, &mut limits)) {
        Some(value) => Ok(MovedCeiling { ceiling, value }),
        None => Err(format!("`{name}` is a whole number from 1 to {}", ceiling.most)),
    }
}

/// The default ceilings, some of them moved; of two for one ceiling the last counts.
pub(super) fn moved(moves: &[MovedCeiling]) -> Limits {
    moved_from(Limits::DEFAULT, moves)
}

/// Ceilings with some of them moved.
pub(super) fn moved_from(mut limits: Limits, moves: &[MovedCeiling]) -> Limits {
    for MovedCeiling { ceiling, value } in moves {
        // The value was judged when it was read.
        let _ = ceiling.move_to(*value, &mut limits);
    }
    limits
}

/// The ceilings with their defaults, for the help. Every start of the command asks for it, once for each of its verbs.
pub(super) fn help() -> &'static str {
    static HELP: LazyLock<String> = LazyLock::new(|| {
        let mut text = "Moves a ceiling; may be given several times\n\n".to_owned();
        for ceiling in Ceiling::ALL {
            let mut bounds = format!("default {}", grouped(ceiling.of(&Limits::DEFAULT)));
            if ceiling.most < Ceiling::OPEN {
                bounds.push_str(&format!(", at most {}", grouped(ceiling.most)));
            }
            text.push_str(&format!("- {}: {} [{bounds}]\n", ceiling.name, ceiling.docs));
        }
        text
    });
    &HELP
}

/// A number with its digits in groups of three.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push('_');
        }
        text.push(digit);
    }
    text
}
