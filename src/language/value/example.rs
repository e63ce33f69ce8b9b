//! Samples of use and misuse in the declaration of an operation.

/// A tested sample of use: an expression and what `print` says of it.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The expression.
    pub code: &'static str,
    /// Its value as text.
    pub prints: &'static str,
}

/// A tested sample of misuse: an expression and the error that it is.
#[derive(Clone, Copy, Debug)]
pub struct RefusalExample {
    /// The expression.
    pub code: &'static str,
    /// The code of the error and its message, `E0607: the radius must be positive, found -2`.
    pub says: &'static str,
}

/// What the picture of an operation in the reference shows.
#[derive(Clone, Copy, Debug)]
pub enum ExamplePicture {
    /// The value of an expression.
    Value(&'static str),
    /// The definitions of a script.
    Scene(&'static str),
}
