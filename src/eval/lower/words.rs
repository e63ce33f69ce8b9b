//! Words that people bring along from other languages, and what to write here.

/// What to write instead of `name`, when it is the habit of another language.
pub(super) fn advice(name: &str) -> Option<&'static str> {
    Some(match name {
        "null" | "nil" | "undef" | "undefined" | "None" => "the empty value is written `none`",
        "True" => "write `true`",
        "False" => "write `false`",
        "PI" | "Pi" | "M_PI" => "write `pi`",
        "var" | "const" | "set" => "definitions begin with `let`",
        "function" | "def" | "func" | "module" => "functions are defined as `fn name(a, b) = ...`",
        "return" => "a function is one expression: `fn f(x) = x^2`",
        "echo" => "write `print`, a statement of its own",
        _ => return None,
    })
}
