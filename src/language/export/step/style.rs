//! Colours and layers. ISO 10303-46.

use super::{
    super::{Item, unique_values::UniqueValues},
    entity::{Id, Records},
};

/// Styles and layers, as far as items have any.
#[derive(Default)]
pub(super) struct StepPresentation {
    styled: Vec<Id>,
    /// The styles of surfaces and of curves by colour.
    surfaces: UniqueValues<[u8; 3], Id>,
    curves: UniqueValues<[u8; 3], Id>,
    layers: UniqueValues<String, Vec<Id>>,
}

impl StepPresentation {
    /// Notes how a surface looks: its faces have the colour, its model the layer.
    pub(super) fn surface(&mut self, item: &Item, faces: &[Id], model: Id, file: &mut Records) {
        self.layer(item, model);
        if let Some(color) = item.color {
            let style = *self.surfaces.entry(&color, || surface_style(color, file)).1;
            faces.iter().for_each(|&face| self.style(style, face, file));
        }
    }

    /// Notes how a curve looks.
    pub(super) fn curve(&mut self, item: &Item, curve: Id, file: &mut Records) {
        self.layer(item, curve);
        if let Some(color) = item.color {
            let style = *self.curves.entry(&color, || curve_style(color, file)).1;
            self.style(style, curve, file);
        }
    }

    /// Notes the layer of something.
    pub(super) fn layer(&mut self, item: &Item, id: Id) {
        let Some(layer) = &item.layer else { return };
        self.layers.entry(layer, Vec::new).1.push(id);
    }

    fn style(&mut self, style: Id, id: Id, file: &mut Records) {
        self.styled.push(file.add(|r| {
            r.text("STYLED_ITEM('color',(").id(style).text("),").id(id).text(")");
        }));
    }

    /// Writes what holds all of it together.
    pub(super) fn write(&self, context: Id, file: &mut Records) {
        for (name, members) in self.layers.pairs() {
            file.add(|r| {
                r.text("PRESENTATION_LAYER_ASSIGNMENT(").string(name).text(",'',").ids(members);
                r.text(")");
            });
        }
        if !self.styled.is_empty() {
            file.add(|r| {
                r.text("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',");
                r.ids(&self.styled).text(",").id(context).text(")");
            });
        }
    }
}

fn colour([red, green, blue]: [u8; 3], file: &mut Records) -> Id {
    let level = |level: u8| f64::from(level) / 255.0;
    file.add(|r| {
        r.text("COLOUR_RGB('',").real(level(red)).text(",").real(level(green)).text(",");
        r.real(level(blue)).text(")");
    })
}

/// A record of one member.
fn around(before: &str, id: Id, after: &str, file: &mut Records) -> Id {
    file.add(|r| {
        r.text(before).id(id).text(after);
    })
}

fn surface_style(color: [u8; 3], file: &mut Records) -> Id {
    let colour = colour(color, file);
    let fill = around("FILL_AREA_STYLE_COLOUR('',", colour, ")", file);
    let area = around("FILL_AREA_STYLE('',(", fill, "))", file);
    let surface = around("SURFACE_STYLE_FILL_AREA(", area, ")", file);
    let side = around("SURFACE_SIDE_STYLE('',(", surface, "))", file);
    let usage = around("SURFACE_STYLE_USAGE(.BOTH.,", side, ")", file);
    around("PRESENTATION_STYLE_ASSIGNMENT((", usage, "))", file)
}

fn curve_style(color: [u8; 3], file: &mut Records) -> Id {
    let colour = colour(color, file);
    let font = file.add(|r| {
        r.text("DRAUGHTING_PRE_DEFINED_CURVE_FONT('continuous')");
    });
    let style = file.add(|r| {
        r.text("CURVE_STYLE('',").id(font).text(",POSITIVE_LENGTH_MEASURE(0.1),").id(colour);
        r.text(")");
    });
    around("PRESENTATION_STYLE_ASSIGNMENT((", style, "))", file)
}
