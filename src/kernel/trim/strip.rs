//! Faces and regions as strips over which whoever likes integrates.

use glam::DVec3;

use super::{Face, plane::ParameterPlane};
use crate::{Frame, GeomError, Interval, Region, region::RegionStrip};

/// Part of a region or a face over which an integral is one of integrals: by x from one end to the other, by y across.
///
/// Of a region x and y are lengths in its frame, of a face parameters in a scale of their own.
///
/// ```
/// use std::sync::Arc;
/// use virote_kernel::{Face, Frame, NurbsSurface, Tolerance};
///
/// let face = Face::whole(Arc::new(NurbsSurface::sphere(Frame::XY, 2.0)?), Tolerance::DEFAULT)?;
/// let strips = face.strips()?;
/// let strip = &strips[0];
/// let y = strip.across().at(0.5);
/// let x = strip.places_at(y);
/// let (point, area) = strip.at([0.5 * (x[0] + x[1]), y]);
/// assert!((point.length() - 2.0).abs() < 1e-14 && 0.0 < area);
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Debug)]
pub struct AreaStrip<'a> {
    strip: RegionStrip,
    carrier: StripCarrier<'a>,
}

#[derive(Clone, Debug)]
enum StripCarrier<'a> {
    Plane(Frame),
    /// With the x of the surface's knots.
    Surface(&'a ParameterPlane, Vec<f64>),
}

impl AreaStrip<'_> {
    /// Between which y it lies.
    #[must_use]
    pub fn across(&self) -> Interval {
        self.strip.across()
    }

    /// Where it begins and ends in x at a y, and between these where pieces of the surface meet, in order.
    #[must_use]
    pub fn places_at(&self, y: f64) -> Vec<f64> {
        let [start, end] = self.strip.ends_at(y);
        let mut places = vec![start];
        if let StripCarrier::Surface(_, lines) = &self.carrier {
            places.extend(lines.iter().filter(|line| start < **line && **line < end));
        }
        places.push(end);
        places
    }

    /// A point of it, and the area there to one of x times y.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> (DVec3, f64) {
        let place = DVec3::new(x, y, 0.0);
        match &self.carrier {
            StripCarrier::Plane(frame) => (frame.point(place), 1.0),
            StripCarrier::Surface(plane, _) => {
                let [u, v] = plane.parameters(place);
                let [point, along_u, along_v] = plane.surface.tangents_at(u, v);
                let stretch = along_u.cross(along_v).length();
                (point, stretch / (plane.scales[0] * plane.scales[1]))
            }
        }
    }
}

impl Region {
    /// The strips that it consists of, for integrals over it.
    ///
    /// # Errors
    /// Those of [`Self::strips`].
    pub fn area_strips(&self) -> Result<Vec<AreaStrip<'static>>, GeomError> {
        let frame = self.frame();
        let strips = self.strips()?.into_iter();
        Ok(strips.map(|strip| AreaStrip { strip, carrier: StripCarrier::Plane(frame) }).collect())
    }
}

impl Face {
    /// The strips that it consists of, for integrals over it; none goes over a knot of v.
    ///
    /// # Errors
    /// Those of [`Region::strips`].
    pub fn strips(&self) -> Result<Vec<AreaStrip<'_>>, GeomError> {
        let plane = &self.plane;
        let scaled = |breaks: Vec<f64>, scale: f64| -> Vec<f64> {
            breaks.into_iter().map(|at| scale * at).collect()
        };
        let lines_x = scaled(plane.surface.knots_u().breaks(), plane.scales[0]);
        let lines_y = scaled(plane.surface.knots_v().breaks(), plane.scales[1]);
        let mut found = Vec::new();
        for strip in self.parts.iter().map(Region::strips).collect::<Result<Vec<_>, _>>()?.concat()
        {
            let across = strip.across();
            let mut heights = vec![across.start()];
            let inside = |line: &f64| across.start() < *line && *line < across.end();
            heights.extend(lines_y.iter().copied().filter(inside));
            heights.push(across.end());
            for pair in heights.windows(2) {
                let strip = strip.between(Interval::new(pair[0], pair[1])?);
                let carrier = StripCarrier::Surface(plane, lines_x.clone());
                found.push(AreaStrip { strip, carrier });
            }
        }
        Ok(found)
    }
}
