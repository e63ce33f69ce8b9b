//! Derivatives of solids through regions: each wall is the skin of borders that vary.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result, Span, Spanned},
    kernel::{
        Curve, NurbsCurve, NurbsSurface, Region, SectionParameters, Solid, Surface, VariedCurve,
        VariedRegion, VariedSolid, VariedSurface, VariedWall, join,
    },
    ops::surface::{moving::is_as_given, section::SectionPlaces, skin_options::SkinOptions},
    value::{
        At, Ctx, FromValue, IntoValue, NoDerivative, RealRegion, RealSolid, Record, Value,
        through_affine, through_shape, with_form_of,
    },
};

/// A border of a region: the curves along it, and whether these run backwards.
type GivenBorder = (Vec<Value>, bool);

/// A solid with the walls through the borders of regions; plain where no region varies.
pub(super) fn with_walls(
    ctx: &mut Ctx<'_>,
    options: &SkinOptions,
    (regions, span): (&[RealRegion], Span),
    sides: &[Arc<NurbsSurface>],
    solid: Arc<Solid>,
) -> Result<RealSolid> {
    let varied = regions.iter().find_map(RealRegion::varied);
    let Some(n_variables) = varied.map(VariedRegion::n_variables) else {
        return Ok(RealSolid::Plain(solid));
    };
    let mut borders: Vec<_> = Vec::with_capacity(regions.len());
    for region in regions {
        borders.push(given_borders(region, span)?.into_iter());
    }
    let mut walls = Vec::with_capacity(sides.len());
    for (idx, side) in sides.iter().enumerate() {
        let (curves, ways) = borders.iter_mut().filter_map(Iterator::next).unzip();
        let sections = VaryingSections { options, curves, ways, span };
        let side = match sections.side(ctx, side)? {
            Some(varied) => varied,
            None => VariedSurface::fixed(Arc::clone(side), n_variables).at(span)?,
        };
        walls.push(VariedWall::new(side, 0 < idx, options.is_closed).at(span)?);
    }
    Ok(RealSolid::Varied(Arc::new(VariedSolid::between(solid, walls, n_variables))))
}

/// The borders of a region, the outer one first.
fn given_borders(region: &RealRegion, span: Span) -> Result<Vec<GivenBorder>> {
    let Some(varied) = region.varied() else {
        let fixed = |border: NurbsCurve| (vec![border.into_value()], false);
        return Ok(region.plain().borders().at(span)?.into_iter().map(fixed).collect());
    };
    let curve = |curve: &VariedCurve| Value::JetCurve(Arc::new(curve.clone()));
    Ok(varied.borders().map(|(curves, way)| (curves.iter().map(curve).collect(), way)).collect())
}

/// Borders of regions that belong together, some of which vary.
struct VaryingSections<'a> {
    options: &'a SkinOptions,
    /// The curves along each.
    curves: Vec<Vec<Value>>,
    /// Whether they run backwards.
    ways: Vec<bool>,
    span: Span,
}

impl VaryingSections<'_> {
    /// A side with its slopes; none where it has none.
    fn side(&self, ctx: &mut Ctx<'_>, side: &Arc<NurbsSurface>) -> Result<Option<VariedSurface>> {
        let report = match side.report().map(IntoValue::into_value) {
            Some(Value::Record(report)) => report,
            _ => unreachable!("a skin tells how it was made"),
        };
        let mut held = self.options.clone();
        // Sections that run beside one another as they are go on to do so where they move a little.
        held.is_aligned &= !is_as_given(&report);
        let found = match self.options.moving_rule() {
            Some(rule) => self.moving(ctx, &held, (rule, &report))?,
            None => None,
        };
        let found = match found {
            Some(found) => found,
            None => self.through(ctx, &held)?,
        };
        let plain = Value::Surface(Surface::Nurbs(Arc::clone(side)));
        match with_form_of(&found, &plain) {
            Some(Value::JetSurface(varied)) => Ok(Some((*varied).clone())),
            Some(_) => Ok(None),
            None => no_derivative(NoDerivative::OtherForm, ctx.span),
        }
    }

    /// The side whose parameters a rule finds: as it is with these held, and how they move on top; none where that is not
    /// known.
    fn moving(
        &self,
        ctx: &mut Ctx<'_>,
        held: &SkinOptions,
        (rule, report): (SectionParameters, &Record),
    ) -> Result<Option<Value>> {
        let listed = report.get("parameters").map(|found| Vec::from_value(found, self.span));
        let Some(Ok(listed)) = listed else { return Ok(None) };
        let mut held = held.clone();
        held.parameters = Spanned::new(SectionPlaces::Listed(listed.clone()), self.span);
        let Value::JetSurface(fixed) = self.through(ctx, &held)? else { return Ok(None) };
        let moved = fixed.with_moving_sections(rule, self.options.degree.value, &listed);
        Ok(moved.at(self.span)?.map(|moved| Value::JetSurface(Arc::new(moved))))
    }

    /// The side from those of borders a step beside.
    fn through(&self, ctx: &mut Ctx<'_>, options: &SkinOptions) -> Result<Value> {
        let n_warnings = ctx.caller.n_warnings();
        let args: Vec<Value> =
            self.curves.iter().map(|curves| Value::list(curves.clone())).collect();
        let mut run = |args: &[Value]| {
            let sections = args.iter().zip(&self.ways).map(|(curves, &way)| {
                let curves = Vec::<Arc<NurbsCurve>>::from_value(curves, self.span);
                self.section(&curves.unwrap_or_default(), way, ctx)
            });
            let sections = sections.collect::<Result<Vec<Curve>>>()?;
            let made = options.surface(ctx, sections, self.span);
            // What there is to be said of the sections themselves is said.
            ctx.caller.keep_warnings(n_warnings);
            made.map(IntoValue::into_value)
        };
        // A rule may look at knots; what is listed does not.
        let found = match options.parameters.value {
            SectionPlaces::Listed(_) => through_shape(&args, &mut run)?,
            SectionPlaces::By(_) => through_affine(&args, &mut run)?,
        };
        found.or_else(|reason| no_derivative(reason, ctx.span))
    }

    /// The border along curves, as its region has it.
    fn section(&self, curves: &[Arc<NurbsCurve>], way: bool, ctx: &Ctx<'_>) -> Result<Curve> {
        let curve = match curves {
            [single] => Arc::clone(single),
            _ => {
                let all: Vec<NurbsCurve> = curves.iter().map(|curve| (**curve).clone()).collect();
                Arc::new(join(&all, ctx.tolerance.distance).at(self.span)?)
            }
        };
        Ok(Region::border_along(&curve, way, ctx.tolerance.angle).at(self.span)?.into())
    }
}

fn no_derivative<T>(reason: NoDerivative, span: Span) -> Result<T> {
    let message = format!("`skin`: {}", reason.message());
    Diagnostic::error(Code::NoDerivative, span, message).hint(reason.hint()).fail()
}
