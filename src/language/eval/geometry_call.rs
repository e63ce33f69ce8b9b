//! Calls of curves, surfaces and faces: their points.

use std::sync::Arc;

use super::{
    autodiff::{point_on_curve, point_on_surface},
    call::finite,
    machine::Machine,
};
use crate::{
    diag::{Code, Diagnostic, Result, Spanned},
    kernel::Surface,
    value::{At, Call, FromValue, Real, Type, Value},
};

impl Machine<'_> {
    /// The point of a curve, a surface or a face at the parameters of a call.
    #[inline(never)]
    pub(super) fn place_on(&mut self, callee: &Value, call: &Call) -> Result<Value> {
        let tolerance = self.env.tolerance;
        match callee {
            Value::Surface(_) | Value::JetSurface(_) => {
                let [u, v] = self.parameters(callee, "s(u, v)", call)?;
                let (point, used) =
                    self.meter().lend(|| point_on_surface(callee, [u, v], call.span));
                self.set_meter(used);
                finite(point?, "s(u, v)", call.span)
            }
            Value::Face(face) => {
                let parameters = self.parameters(callee, "f(u, v)", call)?;
                let surface = Value::Surface(Surface::Nurbs(Arc::clone(face.surface())));
                let [u, v] = parameters.each_ref().map(|parameter| parameter.value.value());
                let (point, used) = self.meter().lend(|| {
                    let point = point_on_surface(&surface, parameters, call.span)?;
                    face.check_inside([u, v], tolerance.distance).at(call.span)?;
                    Result::Ok(point)
                });
                self.set_meter(used);
                finite(point?, "f(u, v)", call.span)
            }
            _ => {
                let [t] = self.parameters(callee, "c(t)", call)?;
                let (point, used) = self.meter().lend(|| point_on_curve(callee, t, call.span));
                self.set_meter(used);
                finite(point?, "c(t)", call.span)
            }
        }
    }

    /// The parameters with which a curve or surface is called.
    fn parameters<const N: usize>(
        &self,
        callee: &Value,
        form: &str,
        call: &Call,
    ) -> Result<[Spanned<Real>; N]> {
        let bad = |span, message: String| {
            Diagnostic::error(Code::BadCall, span, message)
                .hint(format!("a {} is called as `{form}`", callee.kind()))
                .fail()
        };
        if let Some((label, _)) = call.named.first() {
            return bad(
                label.span,
                format!("a {} has no parameter `{}`", callee.kind(), label.value),
            );
        }
        if call.positional.len() != N {
            let found = call.positional.len();
            let parameters = if N == 1 { "parameter" } else { "parameters" };
            return bad(
                call.span,
                format!("a {} takes {N} {parameters}, found {found}", callee.kind()),
            );
        }
        let mut values = [(); N].map(|()| Spanned::new(Real::Plain(0.0), call.span));
        for (slot, arg) in values.iter_mut().zip(&call.positional) {
            let value = Real::from_value(&arg.value, arg.span).map_err(|mismatch| {
                let message =
                    mismatch.sentence(&format!("a parameter of a {}", callee.kind()), Type::Ratio);
                Box::new(Diagnostic::error(mismatch.code, arg.span, message))
            })?;
            *slot = Spanned::new(value, arg.span);
        }
        Ok(values)
    }
}
