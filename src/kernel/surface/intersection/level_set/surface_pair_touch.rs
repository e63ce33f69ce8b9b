//! Two surfaces before their crossings are looked for: the poles and collapsed edges that they share.

use super::{collapsed::collapsed, surface_pair::SurfacePair, tangential_contact::poles};
use crate::{
    Direction::{U, V},
    NurbsSurface,
    tolerance::LAST_BIT,
};

impl<'s> SurfacePair<'s> {
    /// Of surfaces that touch within that share of the tolerance.
    pub(super) fn new(
        surfaces: [&'s NurbsSurface; 2],
        [tolerance, share]: [f64; 2],
        size: f64,
    ) -> Self {
        let [a, b] = surfaces;
        let domains = [a.domain_u(), a.domain_v(), b.domain_u(), b.domain_v()];
        let magnitude = a.bounds().magnitude().max(b.bounds().magnitude());
        let contact = share * tolerance;
        let poles = poles(surfaces, contact);
        let rounding = 8.0 * LAST_BIT * magnitude;
        let collapsed = collapsed(surfaces, contact);
        let creases =
            [(a, U), (a, V), (b, U), (b, V)].map(|(surface, along)| surface.creases(along));
        Self { surfaces, domains, creases, tolerance, contact, size, rounding, poles, collapsed }
    }
}
