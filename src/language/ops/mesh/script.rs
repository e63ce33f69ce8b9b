//! `script`: what another script defines, with parameters of the caller's choice.

use std::sync::Arc;

use crate::{
    diag::{Code, Diagnostic, Result},
    value::{Ctx, Record, op},
};

op! {
    /// What another script defines, as a record, with these values for its parameters.
    ///
    /// It is what `import` gives a name to, as an expression: in functions and comprehensions the parameters may
    /// depend on anything. The path is a text as it stands, since files are found before anything is evaluated, and
    /// relative to the file that names it. Parameters are given by name; the others have their defaults. Checks,
    /// prints and exports of the file do not run, and its names that begin with `_` stay its own. It is evaluated once
    /// for each set of parameters.
    /// The example's `ring.geo` has the lines `param radius = 10mm` and `curve rim = circle((0, 0), radius)`.
    script in Mesh -> Record {
        /// The path of the file.
        path: Arc<str>,
    }
    example "script(\"ring.geo\").radius" => "10";
    example "[for r in [1, 2, 4]: round(length(script(\"ring.geo\", radius = r).rim), digits = 3)]" => "[6.283, 12.566, 25.133]";
    refuses "script(\"ring.geo\", radios = 3)" => "E0801: `ring.geo` has no parameter `radios`";
    refuses "{ let name = \"ring\"  script(\"{name}.geo\") }" => "E0308: the path of a script is a plain string";
    names "script";
}

/// Whoever calls it as a value, outside of a script, has no files to find it among.
fn run(ctx: &mut Ctx<'_>, args: Args) -> Result<Record> {
    let message = format!("`{}` can be read in scripts only", args.path);
    Diagnostic::error(Code::NotConstant, ctx.span, message)
        .hint("a program runs a script in a session, and gives it values for its parameters")
        .fail()
}
