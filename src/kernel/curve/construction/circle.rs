//! Full circles as rational curves, in the four usual forms.

use glam::DVec3;

use crate::{Frame, GeomError, InputError, KnotVector, curve::NurbsCurve};

/// Which of the exact representations of a circle.
///
/// Piegl & Tiller, *A menagerie of rational B-spline circles*: as many control points each, one circle
/// all.
///
/// ```
/// use virote_kernel::{CircleForm, NurbsCurve, glam::DVec3};
///
/// let n_points = [9, 7, 7, 6];
/// for (form, n) in CircleForm::ALL.into_iter().zip(n_points) {
///     let circle = NurbsCurve::circle(DVec3::ZERO, 1.0, DVec3::X, DVec3::Z, form)?;
///     assert_eq!(circle.control_points().len(), n);
///     assert!(circle.sample(50).iter().all(|point| (point.length() - 1.0).abs() < 1e-14));
/// }
/// # Ok::<(), virote_kernel::GeomError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum CircleForm {
    /// Four quarter turns of degree 2 on a square of 9 points; continuous homogeneous derivative
    /// nowhere at the joints, parameter nearest to the angle.
    #[default]
    NinePoint,
    /// Two half turns of degree 2 with a knot each, 7 points on a square.
    SevenSquare,
    /// Three thirds of a turn of degree 2, 7 points on a triangle.
    SevenTriangle,
    /// One piece of degree 5 with 6 points, smooth everywhere.
    DegreeFive,
}

impl CircleForm {
    /// Every form, in the order of the reference.
    pub const ALL: [Self; 4] =
        [Self::NinePoint, Self::SevenSquare, Self::SevenTriangle, Self::DegreeFive];

    /// Its usual name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::NinePoint => "9-point",
            Self::SevenSquare => "7-square",
            Self::SevenTriangle => "7-triangle",
            Self::DegreeFive => "degree-5",
        }
    }
}

impl NurbsCurve {
    /// The full circle on 0..1, from `center + radius·x` counter-clockwise about the normal.
    ///
    /// `x_axis` needs not be normal to `normal`; its part that is counts. Piegl & Tiller, *The
    /// NURBS Book*, §7.5 and Example 7.10.
    ///
    /// ```
    /// use glam::DVec3;
    /// use virote_kernel::{CircleForm, NurbsCurve};
    ///
    /// for form in CircleForm::ALL {
    ///     let circle = NurbsCurve::circle(DVec3::ZERO, 2.0, DVec3::X, DVec3::Z, form)?;
    ///     assert!((circle.point_at(0.3).length() - 2.0).abs() < 1e-14);
    ///     assert!((circle.length(circle.domain()) - 4.0 * std::f64::consts::PI).abs() < 1e-12);
    /// }
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for a radius, [`InputError::ZeroAxis`], [`InputError::NotFinite`].
    pub fn circle(
        center: DVec3,
        radius: f64,
        x_axis: DVec3,
        normal: DVec3,
        form: CircleForm,
    ) -> Result<Self, GeomError> {
        let frame = Frame::from_normal(center, normal, Some(x_axis))?;
        Self::ellipse(frame, [radius; 2], form)
    }

    /// The full ellipse about the origin of a frame on 0..1, with its radii along x and y, from
    /// the end of the first counter-clockwise: the affine image of a circle.
    ///
    /// An ellipse of semi-axes a and b: (x/a)² + (y/b)² = 1 at every point.
    ///
    /// ```
    /// use virote_kernel::{CircleForm, Frame, NurbsCurve};
    ///
    /// let ellipse = NurbsCurve::ellipse(Frame::XY, [3.0, 2.0], CircleForm::NinePoint)?;
    /// let miss = |x: f64, y: f64| ((x / 3.0).powi(2) + (y / 2.0).powi(2) - 1.0).abs();
    /// assert!(ellipse.sample(20).iter().all(|p| miss(p.x, p.y) < 1e-14));
    /// # Ok::<(), virote_kernel::GeomError>(())
    /// ```
    ///
    /// # Errors
    /// [`InputError::NotPositive`] for a radius, [`InputError::NotFinite`].
    pub fn ellipse(frame: Frame, radii: [f64; 2], form: CircleForm) -> Result<Self, GeomError> {
        if let Some(&got) = radii.iter().find(|radius| !(radius.is_finite() && 0.0 < **radius)) {
            return Err(InputError::NotPositive { what: "the radius", got }.into());
        }
        let (degree, knots, polygon) = unit_circle(form);
        let knots = KnotVector::for_points(degree, polygon.len(), knots)?;
        let [rx, ry] = radii;
        let to_space = |&[x, y, _]: &[f64; 3]| frame.point(DVec3::new(x * rx, y * ry, 0.0));
        let points: Vec<DVec3> = polygon.iter().map(to_space).collect();
        let weights: Vec<f64> = polygon.iter().map(|point| point[2]).collect();
        Self::rational(knots, &points, &weights)
    }
}

/// Degree, knots and `[x, y, weight]` of the circle of radius one about the origin, from (1, 0).
fn unit_circle(form: CircleForm) -> (usize, Vec<f64>, Vec<[f64; 3]>) {
    let half = 0.5;
    match form {
        CircleForm::NinePoint => {
            let w = std::f64::consts::FRAC_1_SQRT_2;
            let corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
            let polygon = (0..9).map(|i| {
                let (x, y) = corners[i % 8];
                [f64::from(x), f64::from(y), if i % 2 == 0 { 1.0 } else { w }]
            });
            (2, joined_knots(&[0.25, 0.5, 0.75]), polygon.collect())
        }
        CircleForm::SevenSquare => {
            let knots = vec![0.0, 0.0, 0.0, 0.25, 0.5, 0.5, 0.75, 1.0, 1.0, 1.0];
            let polygon = [(1, 0), (1, 1), (-1, 1), (-1, 0), (-1, -1), (1, -1), (1, 0)];
            let weight = |i: usize| if i.is_multiple_of(3) { 1.0 } else { half };
            let rows = polygon.iter().enumerate();
            (2, knots, rows.map(|(i, &(x, y))| [f64::from(x), f64::from(y), weight(i)]).collect())
        }
        CircleForm::SevenTriangle => {
            let h = 0.5 * libm::sqrt(3.0);
            let polygon = vec![
                [1.0, 0.0, 1.0],
                [1.0, 2.0 * h, half],
                [-0.5, h, 1.0],
                [-2.0, 0.0, half],
                [-0.5, -h, 1.0],
                [1.0, -2.0 * h, half],
                [1.0, 0.0, 1.0],
            ];
            (2, joined_knots(&[1.0 / 3.0, 2.0 / 3.0]), polygon)
        }
        CircleForm::DegreeFive => {
            let w = 0.2;
            let polygon = vec![
                [1.0, 0.0, 1.0],
                [1.0, 4.0, w],
                [-3.0, 2.0, w],
                [-3.0, -2.0, w],
                [1.0, -4.0, w],
                [1.0, 0.0, 1.0],
            ];
            (5, [[0.0; 6], [1.0; 6]].concat(), polygon)
        }
    }
}

/// Knots on 0..1 of Bézier pieces of degree 2 that meet at the given parameters.
fn joined_knots(joints: &[f64]) -> Vec<f64> {
    let inner = joints.iter().flat_map(|&t| [t, t]);
    [0.0; 3].into_iter().chain(inner).chain([1.0; 3]).collect()
}
