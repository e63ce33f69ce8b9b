//! What a picture shows and how, as the command line has it: what each option takes, and what they
//! come to together.

use clap::Args;
use glam::DVec3;

use crate::{
    diag::nearest,
    export::{Oblique, Options, Stripes, View, Viewpoint},
    session::{ControlStyle, Extra, PictureContent, STRIPES},
    value::color_of,
};

/// What a picture shows, and how.
#[derive(Debug, Args)]
pub(super) struct PictureArgs {
    /// From where: top, front, right, bottom, back, left, isometric or oblique [default: top of
    /// what is flat, else isometric]
    #[arg(long, value_name = "VIEW", value_parser = view)]
    pub(super) view: Option<View>,
    /// Looks from this place, in the document's unit, instead of a named view
    #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true,
        conflicts_with = "view")]
    pub(super) camera: Option<DVec3>,
    /// What a camera looks at [default: the middle of what is drawn]
    #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true)]
    pub(super) look_at: Option<DVec3>,
    /// Draws what is nearer larger
    #[arg(long)]
    pub(super) perspective: bool,
    /// The angle at which an oblique view draws depth [default: 45deg]
    #[arg(long, value_name = "ANGLE", value_parser = degrees, allow_hyphen_values = true)]
    pub(super) oblique_angle: Option<f64>,
    /// How long an oblique view draws a unit of depth [default: 0.5]
    #[arg(long, value_name = "RATIO", value_parser = ratio)]
    pub(super) oblique_ratio: Option<f64>,
    /// Leaves out borders and outlines of surfaces, and edges of meshes
    #[arg(long)]
    pub(super) no_edges: bool,
    /// Lines inside a surface in each direction [default: 7]
    #[arg(long, value_name = "N", value_parser = isocurves)]
    pub(super) isocurves: Option<usize>,
    /// Leaves out the lines inside surfaces
    #[arg(long, conflicts_with = "isocurves")]
    pub(super) no_isocurves: bool,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "800x600", value_parser = size)]
    pub(super) size: [usize; 2],
    /// Shows beside it: control, comb, stripes, axes, labels or scale; may be given several times
    #[arg(long, value_name = "WHAT", value_parser = extra)]
    pub(super) show: Vec<Extra>,
    /// The colour of control polygons and nets, such as `#cc3333` or `steelblue`
    #[arg(long, value_name = "COLOR", value_parser = color)]
    pub(super) control_color: Option<[u8; 3]>,
    /// How wide their lines and points are, as a multiple of the usual
    #[arg(long, value_name = "N", value_parser = width)]
    pub(super) control_size: Option<f64>,
    /// How many stripes are mirrored all around, an even number [default: 24]
    #[arg(long, value_name = "N", value_parser = stripes)]
    pub(super) stripes: Option<usize>,
    /// The direction to the light of the stripes [default: to the viewer]
    #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true)]
    pub(super) light: Option<DVec3>,
    /// Draws only this definition; may be given several times
    #[arg(long, value_name = "NAME")]
    pub(super) only: Vec<String>,
    /// Draws also what the script defines and does not export
    #[arg(long, conflicts_with = "only")]
    pub(super) all: bool,
}

/// Most stripes.
const MOST_STRIPES: usize = 1000;
/// The most that lines and points of control nets are enlarged.
const MOST_WIDTH: f64 = 100.0;

/// What a picture is to show.
///
/// # Errors
/// A sentence for options that do not go together.
pub(super) fn content(drawn: &PictureArgs) -> Result<PictureContent<'_>, String> {
    let shows = |extra: Extra| drawn.show.contains(&extra);
    let goes_with = |option: &str, is_given: bool, extra: Extra, name: &str| {
        if is_given && !shows(extra) {
            return Err(format!("`--{option}` goes with `--show {name}`"));
        }
        Ok(())
    };
    goes_with("control-color", drawn.control_color.is_some(), Extra::Control, "control")?;
    goes_with("control-size", drawn.control_size.is_some(), Extra::Control, "control")?;
    goes_with("stripes", drawn.stripes.is_some(), Extra::Stripes, "stripes")?;
    goes_with("light", drawn.light.is_some(), Extra::Stripes, "stripes")?;
    if drawn.perspective && shows(Extra::Scale) {
        return Err("a scale holds in parallel views alone; leave out `--perspective`".to_owned());
    }
    if drawn.light == Some(DVec3::ZERO) {
        return Err("`--light` is a direction, and (0, 0, 0) gives none".to_owned());
    }
    let usual = Options::default();
    let control = ControlStyle::default();
    Ok(PictureContent {
        only: &drawn.only,
        with_helpers: drawn.all,
        extras: &drawn.show,
        control: ControlStyle {
            color: drawn.control_color.unwrap_or(control.color),
            size: drawn.control_size.unwrap_or(control.size),
        },
        stripes: Stripes { n_stripes: drawn.stripes.unwrap_or(STRIPES), light: drawn.light },
        options: Options {
            viewpoint: Viewpoint {
                view: drawn.view,
                oblique_angle: drawn.oblique_angle,
                oblique_ratio: drawn.oblique_ratio,
                camera: drawn.camera,
                look_at: drawn.look_at,
                is_perspective: drawn.perspective,
            },
            has_edges: !drawn.no_edges,
            n_isocurves: if drawn.no_isocurves {
                0
            } else {
                drawn.isocurves.unwrap_or(usual.n_isocurves)
            },
            ..usual
        },
        size: drawn.size,
    })
}

/// Reads the name of a view.
pub(super) fn view(text: &str) -> Result<View, String> {
    View::from_name(text).ok_or_else(|| {
        let names = || View::ALL.iter().map(|&(name, _)| name);
        match nearest(text, names()) {
            Some(near) => format!("there is no view `{text}`; did you mean `{near}`?"),
            None => {
                let names: Vec<&str> = names().collect();
                format!("there is no view `{text}`; views are {}", names.join(", "))
            }
        }
    })
}

/// Reads the name of what is shown beside the geometry.
pub(super) fn extra(text: &str) -> Result<Extra, String> {
    Extra::ALL.iter().find(|(name, _)| *name == text).map(|&(_, extra)| extra).ok_or_else(|| {
        let names = || Extra::ALL.iter().map(|&(name, _)| name);
        match nearest(text, names()) {
            Some(near) => format!("`{text}` cannot be shown; did you mean `{near}`?"),
            None => {
                let names: Vec<&str> = names().collect();
                format!("`{text}` cannot be shown, but {}", names.join(", "))
            }
        }
    })
}

/// Reads a width and a height in pixels.
pub(super) fn size(text: &str) -> Result<[usize; 2], String> {
    let wrong = || "write WIDTHxHEIGHT in pixels, for example 800x600".to_owned();
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(wrong)?;
    let side = |text: &str| text.trim().parse::<usize>().map_err(|_| wrong());
    let size = [side(width)?, side(height)?];
    if size.contains(&0) {
        return Err("a picture has at least one pixel on each side".to_owned());
    }
    Ok(size)
}

/// Reads a place, or a direction.
pub(super) fn place(text: &str) -> Result<DVec3, String> {
    let wrong = || "write X,Y,Z in the document's unit, for example 300,-400,250".to_owned();
    let inner = text.trim().trim_start_matches('(').trim_end_matches(')');
    let numbers: Result<Vec<f64>, _> = inner.split(',').map(|part| part.trim().parse()).collect();
    match numbers.map_err(|_| wrong())?[..] {
        [x, y, z] if x.is_finite() && y.is_finite() && z.is_finite() => Ok(DVec3::new(x, y, z)),
        _ => Err(wrong()),
    }
}

/// Reads an angle in degrees; in radians.
pub(super) fn degrees(text: &str) -> Result<f64, String> {
    let number = text.trim().trim_end_matches("deg").trim_end_matches('°').trim();
    match number.parse::<f64>() {
        Ok(angle) if angle.is_finite() => Ok(angle.to_radians()),
        _ => Err("write an angle in degrees, for example 30deg".to_owned()),
    }
}

fn number_within(text: &str, most: f64) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(number) if 0.0 < number && number <= most => Ok(number),
        _ => Err(format!("write a number above 0 and at most {most}")),
    }
}

/// Reads how long a unit of depth is on paper.
pub(super) fn ratio(text: &str) -> Result<f64, String> {
    number_within(text, Oblique::MOST_RATIO)
}

/// Reads how many times the usual width something has.
pub(super) fn width(text: &str) -> Result<f64, String> {
    number_within(text, MOST_WIDTH)
}

/// Reads a number of lines inside surfaces.
pub(super) fn isocurves(text: &str) -> Result<usize, String> {
    let most = Options::MOST_ISOCURVES;
    let wrong = || format!("write a whole number from 0 to {most}");
    text.trim().parse().ok().filter(|n| *n <= most).ok_or_else(wrong)
}

/// Reads a number of stripes.
pub(super) fn stripes(text: &str) -> Result<usize, String> {
    let wrong =
        || format!("write an even number from 2 to {MOST_STRIPES}: light and dark take turns");
    let is_right = |n: &usize| n.is_multiple_of(2) && (2..=MOST_STRIPES).contains(n);
    text.trim().parse().ok().filter(is_right).ok_or_else(wrong)
}

/// Reads a colour.
pub(super) fn color(text: &str) -> Result<[u8; 3], String> {
    color_of(text)
        .ok_or_else(|| "write #rrggbb, #rgb, or a name of CSS such as steelblue".to_owned())
}
