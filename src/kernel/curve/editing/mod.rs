//! The same curve in another form, and curves cut, joined and continued.

pub(super) mod basis_change;
pub(super) mod compatible;
pub(super) mod denominator;
pub(super) mod edit;
pub(super) mod either;
pub(super) mod extend;
pub(super) mod join;
pub(super) mod product;
pub(super) mod reduce;
pub(super) mod standard;
