//! Records of an exchange file. ISO 10303-21, §7 and §11.

use glam::DVec3;

use super::super::text::TextBuffer;

/// The number by which records name one another.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Id(usize);

/// Records in the order of their numbers.
pub(super) struct Records {
    pub(super) text: TextBuffer,
    n_records: usize,
    /// The context of curves of parameters, once there is one.
    plane: Option<Id>,
}

impl Records {
    pub(super) fn new() -> Self {
        Self { text: TextBuffer::default(), n_records: 0, plane: None }
    }

    /// A record of what `write` writes.
    pub(super) fn add(&mut self, write: impl FnOnce(&mut Self)) -> Id {
        self.n_records += 1;
        let id = self.n_records;
        self.text.push("#").count(id).push("=");
        write(self);
        self.text.push(";\n");
        Id(id)
    }

    pub(super) fn text(&mut self, text: &str) -> &mut Self {
        self.text.push(text);
        self
    }

    pub(super) fn id(&mut self, Id(id): Id) -> &mut Self {
        self.text.push("#").count(id);
        self
    }

    pub(super) fn ids(&mut self, ids: &[Id]) -> &mut Self {
        self.list(ids, |records, &id| {
            records.id(id);
        })
    }

    pub(super) fn count(&mut self, n: usize) -> &mut Self {
        self.text.count(n);
        self
    }

    /// A number, which must have a decimal point.
    pub(super) fn real(&mut self, value: f64) -> &mut Self {
        self.text.pointed(value, "E");
        self
    }

    pub(super) fn truth(&mut self, truth: bool) -> &mut Self {
        self.text(if truth { ".T." } else { ".F." })
    }

    pub(super) fn place(&mut self, point: DVec3) -> &mut Self {
        self.list(&point.to_array(), |records, &x| {
            records.real(x);
        })
    }

    /// The coordinates of a place in the plane of parameters.
    pub(super) fn pair(&mut self, place: DVec3) -> &mut Self {
        self.list(&[place.x, place.y], |records, &x| {
            records.real(x);
        })
    }

    /// The context of curves of parameters, of which one is enough.
    pub(super) fn plane_of_parameters(&mut self) -> Id {
        if let Some(id) = self.plane {
            return id;
        }
        let id = self.add(|r| {
            r.text("(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()");
            r.text("REPRESENTATION_CONTEXT('2D SPACE',''))");
        });
        self.plane = Some(id);
        id
    }

    /// A list in brackets.
    pub(super) fn list<T>(
        &mut self,
        items: &[T],
        mut write: impl FnMut(&mut Self, &T),
    ) -> &mut Self {
        self.text("(");
        for (i, item) in items.iter().enumerate() {
            self.text(if i == 0 { "" } else { "," });
            write(self, item);
        }
        self.text(")")
    }

    /// A string: characters beyond ASCII by their numbers.
    pub(super) fn string(&mut self, text: &str) -> &mut Self {
        let mut out = String::with_capacity(text.len() + 2);
        out.push('\'');
        for c in text.chars() {
            match c {
                '\'' => out.push_str("''"),
                '\\' => out.push_str("\\\\"),
                ' '..='~' => out.push(c),
                c => out.push_str(&format!("\\X4\\{:08X}\\X0\\", c as u32)),
            }
        }
        out.push('\'');
        self.text(&out)
    }
}
