//! Several splines on one degree and one knot vector: what curves and surfaces share of it.

use super::{
    GeomError, Interval, KnotVector, refine::ControlLines, tolerance::KNOT_CLUSTER_RELATIVE,
};
use crate::sorting::sort_by;

/// A knot inside a domain, with the number of the spline that it belongs to.
#[derive(Clone, Copy)]
struct OwnedKnot {
    knot: f64,
    times: usize,
    owner: usize,
}

/// Knots of different splines that count as one.
struct KnotCluster {
    /// The smallest, which stands for all.
    knot: f64,
    /// The highest multiplicity.
    times: usize,
    members: Vec<OwnedKnot>,
}

/// The same splines on the highest degree among them, the domain of the first, and one knot vector
/// with every knot of any of them as often as it stands in one.
///
/// Knots of different splines closer than [`KNOT_CLUSTER_RELATIVE`] of the domain become one; those
/// of one spline stay apart. Splines that agree already come back as they are; others are
/// clamped. Piegl & Tiller, *The NURBS Book*, §10.3.
///
/// # Errors
/// `KnotError::KnotMultiplicity` where knots fall together for lack of digits on that domain.
pub(crate) fn on_common_knots(splines: Vec<ControlLines>) -> Result<Vec<ControlLines>, GeomError> {
    let Some(first) = splines.first() else { return Ok(splines) };
    if splines.iter().all(|spline| spline.knots == first.knots) {
        return Ok(splines);
    }

    // Bring all to one degree and one domain.
    let degree = splines.iter().map(|spline| spline.knots.degree()).max().unwrap_or(0);
    let domain = first.knots.domain();
    let raised = |spline: &ControlLines| {
        let ControlLines { knots, lines } = spline.clamped().elevated(degree)?;
        let knots = KnotVector::new(degree, knots.on(domain).as_slice().to_vec())?;
        Ok(ControlLines { knots, lines })
    };
    let splines: Vec<ControlLines> =
        splines.iter().map(raised).collect::<Result<_, GeomError>>()?;

    // Insert into each what only others have.
    let clusters = clusters(&splines, domain);
    let refined = |(owner, spline): (usize, ControlLines)| {
        let knots = on_clusters(&spline.knots, &clusters, owner);
        let missing = missing_knots(&clusters, &knots);
        ControlLines { knots, ..spline }.with_knots(&missing)
    };
    splines.into_iter().enumerate().map(refined).collect()
}

/// The inner knots of all splines, those near one another together.
///
/// A cluster reaches as far from its first knot as knots may be moved, so that it does not grow
/// from neighbour to neighbour; and it holds one knot of a spline at most, so that none that
/// somebody placed beside another one is lost.
fn clusters(splines: &[ControlLines], domain: Interval) -> Vec<KnotCluster> {
    let inner = |(owner, spline): (usize, &ControlLines)| {
        let distinct = spline.knots.distinct().into_iter();
        let owned = distinct.map(move |(knot, times)| OwnedKnot { knot, times, owner });
        owned.filter(move |owned| domain.start() < owned.knot && owned.knot < domain.end())
    };
    let mut all: Vec<OwnedKnot> = splines.iter().enumerate().flat_map(inner).collect();
    sort_by(&mut all, |a, b| a.knot.total_cmp(&b.knot));
    let same = KNOT_CLUSTER_RELATIVE * domain.length();
    let mut clusters: Vec<KnotCluster> = Vec::new();
    for owned in all {
        match clusters.last_mut() {
            Some(last)
                if owned.knot - last.knot <= same
                    && last.members.iter().all(|member| member.owner != owned.owner) =>
            {
                last.times = last.times.max(owned.times);
                last.members.push(owned);
            }
            _ => clusters.push(KnotCluster {
                knot: owned.knot,
                times: owned.times,
                members: vec![owned],
            }),
        }
    }
    clusters
}

/// The knots of a spline, each moved to the one that stands for its cluster.
fn on_clusters(knots: &KnotVector, clusters: &[KnotCluster], owner: usize) -> KnotVector {
    let mut moved: Vec<(f64, f64)> = Vec::new();
    for cluster in clusters {
        let own = cluster.members.iter().filter(|member| member.owner == owner);
        moved.extend(own.map(|member| (member.knot, cluster.knot)));
    }
    knots.map(|t| match moved.binary_search_by(|(knot, _)| knot.total_cmp(&t)) {
        Ok(index) => moved[index].1,
        Err(_) => t,
    })
}

fn missing_knots(clusters: &[KnotCluster], knots: &KnotVector) -> Vec<f64> {
    let missing = |cluster: &KnotCluster| {
        vec![cluster.knot; cluster.times.saturating_sub(knots.exact_multiplicity(cluster.knot))]
    };
    clusters.iter().flat_map(missing).collect()
}
