//! The stable codes of diagnostics, each with a title and a paragraph for `virote explain`.
//!
//! A code names a kind of mistake, never a wording: messages may improve, codes stay.

/// Declares the codes: variant, identity, title, explanation.
macro_rules! codes {
    ($( $variant:ident $id:literal $title:literal $essay:literal )+) => {
        /// The kind of a diagnostic.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Code {
            $( #[doc = $title] $variant, )+
        }

        impl Code {
            /// Every code, in the order of their identities.
            pub const ALL: &'static [Self] = &[ $( Self::$variant ),+ ];

            /// The stable identity, such as `E0201`.
            #[must_use]
            pub fn id(self) -> &'static str {
                match self { $( Self::$variant => $id ),+ }
            }

            /// The kind of mistake in a few words.
            #[must_use]
            pub fn title(self) -> &'static str {
                match self { $( Self::$variant => $title ),+ }
            }

            /// A paragraph: what it means, why it is an error, what to do.
            #[must_use]
            pub fn explanation(self) -> &'static str {
                match self { $( Self::$variant => $essay ),+ }
            }
        }
    };
}

codes! {
    // E00xx: the text itself.
    StrayText "E0001" "text that means nothing"
        "A character or a run of characters is not part of the language. Operators are spelled `and`, `or`, `not`; strings take double quotes; angles take a unit, as in `45deg`."
    UnclosedString "E0002" "a string is never closed"
        "A string begins with `\"` and ends with `\"` on the same line. Write `\\n` for a line break inside it, `\\\"` for a quotation mark, and `\\{` for a brace that is not an interpolation."
    UnclosedComment "E0003" "a comment is never closed"
        "A comment that begins with `/*` ends with `*/`. Such comments nest, so that a piece of script with comments in it can be switched off whole: every `/*` needs its own `*/`."
    NotUtf8 "E0004" "the file is not UTF-8 text"
        "Scripts are UTF-8 text. The message tells the first byte that is not. Save the file as UTF-8 in the editor; a byte-order mark is allowed."
    BadNumber "E0005" "a number that cannot be read"
        "Numbers are written `12`, `1_000`, `0.5`, `1e-3`, with digits on both sides of the point, and may carry a unit glued on: `12mm`, `30deg`. Numbers beyond 1.8e308 do not exist here."
    UnknownUnit "E0006" "a unit that does not exist"
        "Lengths take `um mm cm m km in ft`, angles take `deg rad turn`. A unit is glued to its number: `12mm`, `90deg`."
    BadEscape "E0007" "an escape that does not exist"
        "In a string a backslash begins `\\n`, `\\t`, `\\\"`, `\\\\`, `\\{`, `\\}` or `\\u{...}` with a hexadecimal code. Write `\\\\` for the backslash itself."
    SourceTooLarge "E0008" "the script is too large"
        "A script may be of 64 MiB. Larger ones are data: put the numbers into a file and `load` it."
    GmshScript "E0009" "a script for Gmsh"
        "Gmsh uses the same file ending for another language, in which `Point(1) = {0, 0, 0};` defines a point. Open such a file with Gmsh. In this language: `point p = (0, 0, 0)`."

    // E01xx: how statements and expressions are put together.
    Syntax "E0101" "something else was expected here"
        "The text does not follow the grammar at this place. Every statement begins with a keyword (`let`, `param`, `fn`, `point`, `curve`, `surface`, `region`, `face`, `solid`, `mesh`, `table`, `check`, `print`, `export`, `import`, `test`); the message tells what could stand here."
    UnclosedBracket "E0102" "a bracket is never closed"
        "Every `(`, `[` and `{` needs its counterpart before the next statement begins."
    StrayBracket "E0103" "a bracket closes nothing"
        "A closing bracket has no opening one, or another one than its own: brackets close in the opposite order of their opening."
    TooDeep "E0104" "nested too deeply"
        "Brackets, `if`s, function arrows and powers may stand 256 deep inside one another, and a chain of operators in one expression may have 4000 links. Give the inner parts names with `let`."
    ComparisonChain "E0105" "comparisons do not chain"
        "`a < b < c` is ambiguous to readers; write `a < b and b < c`. The same holds for ranges: `a..b..c` is not one."
    BadParameter "E0106" "a parameter must be a plain name"
        "The parameters of a function are names, for `fn` with an optional default: `fn f(a, b = 2) = a + b`, `(x, y) => x*y`."
    Misplaced "E0107" "a statement in the wrong place"
        "`geo`, `unit` and `tolerance` stand once each at the top level; `geo` first. Blocks hold definitions (`let`, `fn`, and kinds such as `curve`), then one value; effects such as `check`, `print` and `export` belong to the top level or to a `test`."
    WrongEdition "E0108" "an edition that this program does not know"
        "`geo 1` tells for which edition of the language the script was written. This program knows edition 1."

    // E02xx: names.
    UnknownName "E0201" "nothing has this name"
        "The name is neither defined in this file nor built in. Names may be used above their definition, but they must be defined somewhere in their scope. `virote doc` lists what is built in."
    Duplicate "E0202" "a name is defined twice"
        "Every name is defined once in its scope: there is no assignment, so a second definition would make one of the two meaningless. Choose another name."
    Cycle "E0204" "definitions go round in a circle"
        "A definition may use any other, above or below, but not itself by way of others, since then none of them has a value. Functions may call themselves."
    UnknownOperation "E0205" "no such built-in"
        "`virote doc NAME` explains a built-in; `virote doc` without a name lists all of them."

    Private "E0206" "a name that is private to its file"
        "Names that begin with `_` belong to their file alone. Import a public name, or give this one a name without the `_`."

    // E03xx: kinds of values.
    WrongKind "E0301" "a value of the wrong kind"
        "Here another kind of value is wanted. The message tells what was found. Kinds are not converted silently: `str` makes text of a value, `num` a number of text."
    BrokenPromise "E0302" "a definition is not of its promised kind"
        "`curve c = ...` promises a curve. Use the word that fits the value, or `let`, which promises nothing."
    UnitMismatch "E0303" "units that do not fit"
        "Numbers may carry powers of length and angle, from literals such as `10mm`, `5mm^2` and `30deg`, and from questions: `length(c)` is a length, `volume(s)` a volume, `curvature(c, t)` one over a length. Sums and comparisons need the same on both sides; a number without a unit counts as document units of length. Divide by `1mm` or `1deg` to take a unit away: `(t, curvature(c, t) / 1mm^-1)` is a point. To an angle only angles are added, where a number without a unit was once taken for radians: write `3rad` for `3`, or `angle / 1rad` for its plain number. `5mm^2` is five square millimetres, where it was once the square of 5mm: write `(5mm)^2` for that."
    MissingAngleUnit "E0304" "an angle needs its unit"
        "Where an angle is wanted, a bare number could mean degrees as well as radians. Write `90deg`, `1.57rad` or `0.25turn`."
    NotCallable "E0305" "this cannot be called"
        "Functions, curves `c(t)` and surfaces `s(u, v)` can be called. Between two elements of a list a missing comma looks like a call."
    NoField "E0306" "there is no such field"
        "Points have `.x .y .z`, curves `.domain .degree .knots .points` and more, records their own labels, tables their columns. The message lists the fields of this value."
    IndexOutside "E0307" "an index outside the list"
        "The elements of a list of n are `xs[0]` to `xs[n - 1]`; `xs[-1]` is the last one. Indices are whole numbers."
    NotConstant "E0308" "a value that must be known beforehand"
        "`tolerance` is needed before anything is evaluated, so its value is a plain positive number."

    // E04xx: calls.
    BadCall "E0401" "a call that does not fit its function"
        "Required arguments stand by position or by name, optional ones always by name: `circle((0, 0), 2, form = \"9-point\")`. The message shows the signature."
    BadChoice "E0402" "a word that is no choice"
        "The argument takes one of a few words; the message lists them."
    RecursionTooDeep "E0403" "calls without end"
        "Functions may call themselves, but not more than 10000 deep. Check that the recursion reaches its end for every argument."
    FailedAssert "E0404" "an assertion does not hold"
        "`assert(condition, message)` stops the evaluation of the definition that it stands in."

    // E05xx: arithmetic.
    DivisionByZero "E0501" "division by zero"
        "No operation yields infinity or an undefined number; a division by zero stops where it stands. Guard it with `if`."
    Domain "E0502" "outside the domain of a function"
        "The function has no value there: the square root and logarithm of a negative number, `asin` beyond 1, or a result beyond 1.8e308."
    NoDerivative "E0503" "no derivative"
        "`gradient`, and the tangent or curvature of a `parametric` curve or surface, need the derivatives of a function, which are carried through every operation in it. Some operations have none at some places, such as `abs` and `sqrt` at 0, and others have none at all, such as offsets and meshes. `gradient(f, at, differences = true)` takes differences through whatever the function does; points of a `parametric` can still be asked for."

    NoAnswer "E0504" "a search without an answer"
        "`solve`, `minimize`, `maximize` and `integrate` ask a function at many places. What they find is checked before it is given: a root is a change of sign without a jump, or a touch; an integral has a known error. Where there is no such answer, the message tells what was found instead, and where. Look at the function with `:plot` at the prompt, or in another range."

    // E06xx: geometry.
    TooFewPoints "E0601" "too few points"
        "A curve of degree p needs p + 1 control points or more, and so does each direction of a surface."
    BadKnots "E0602" "knots that do not fit"
        "A curve of degree p with n control points has n + p + 1 knots, which never decrease; none is repeated more than p + 1 times; and the domain, from knot p to knot n, is not empty."
    BadWeights "E0603" "weights that do not fit"
        "There is one weight a control point. Weights are not negative, and the first and the last are positive: else the curve would leave the hull of its points or run to infinity."
    BadDegree "E0604" "a degree out of range"
        "Degrees are whole numbers from 1 (for `bezier` from 0) to 100, and lower than the number of control points."
    RaggedGrid "E0605" "rows of unequal length"
        "The points of a surface form a grid: a list of rows, `grid[i][j]` with i along u and j along v, each row of the same length."
    OutsideDomain "E0606" "a parameter outside the domain"
        "A curve exists on its domain, `c.domain`, a surface on `s.domain_u` and `s.domain_v`. Beyond them there is nothing to ask about."
    Degenerate "E0607" "degenerate geometry"
        "The question has no answer at this place: a direction of length zero, a tangent or normal that does not exist, a circle without a radius, coincident data."
    BeyondTolerance "E0608" "a change beyond the tolerance"
        "A curve can lose a knot or a degree only as far as its shape allows. The message tells how far it would move. Allow that with a larger tolerance, or keep what it has."
    Gap "E0609" "curves that do not meet"
        "Curves are joined in the order given, each starting where the one before ends, within the document's tolerance. `reversed` turns a curve around; `tolerance` at the top of the script says which points count as one."
    BadParameters "E0610" "parameters of data that do not fit"
        "Each point of the data has one parameter, the place on the curve where it is to lie, and parameters increase from point to point. So it is with what else belongs to each point, such as derivatives. Without `parameters` they follow from the distances of the points."
    NotExact "E0611" "a form that the curve does not have"
        "Every conversion between forms of a curve is exact, and one that could not be is refused: cubic forms hold no higher degree, forms without weights no circle, chains of equal segments no others, and a form that is smooth at its joints no corner. The message tells the reason. Split the curve, or approximate it."

    OpenShell "E0612" "surfaces that enclose nothing"
        "A volume is enclosed by surfaces that close: every edge meets one other edge within the document's tolerance, of the same surface at a seam or of another one, or is collapsed to a point. Edges may run together where a body is thinner than the tolerance. The message tells the edge that does not, and where. Let edges with a small gap run through the same points, or raise the document's tolerance above the gap. Add what is missing, or ask for the `area`, which needs no inside."

    NotManifold "E0613" "a body that touches itself"
        "A body has one inside around each of its points: two cubes that share no more than an edge or a corner are two bodies, and no one body. So are faces that go through one another: those of a body meet in their edges alone. The message tells where. Move one of them by more than the document's tolerance, so that they overlap or keep apart, or keep them as two."
    RunTogether "E0614" "surfaces that run together"
        "Two surfaces lie within the document's tolerance of one another in an area, but are not parts of one surface: no curve is where they cross, and where the one leaves the other depends on every rounding. Of planes, cylinders, cones, spheres and tori that are one, and of parts of one surface, the borders tell what they have in common. Others must be made of one surface, or cross clearly. The message tells where."
    WithinTolerance "E0615" "a part that lies within the tolerance"
        "Within the document's tolerance things are one: a strip that is narrower is neither there nor gone, and borders that run so close to one another have no certain order. Let them coincide exactly (the same points, the same curve), or keep them apart by more; or state a smaller `tolerance` at the top of the script."
    NoRoom "E0616" "no room for a fillet"
        "A corner is rounded by an arc that touches both of its sides, so that the sides must be long enough for the radius, and not bend more. The message tells the corner, and up to which radius there is room."
    BeyondCentre "E0617" "an offset beyond a centre of curvature"
        "A surface that bends has centres of curvature on the side that it bends to. A face beside it at that distance comes together there, and beyond it turns back. The message tells how far the nearest is, and where. Take a smaller distance, or the other side."
    Unproven "E0619" "a result that could not be proven"
        "What bodies have together and apart adds up to the bodies themselves. Each result is checked so before it is given; this one failed, so that it is not given. That is a fault of the program and not of the script: please report it. Moving one of the bodies a little may help."

    // E07xx: files.
    FileMissing "E0701" "a file that cannot be read"
        "The file does not exist beside the script or cannot be read. Paths are relative to the file that names them."
    BadData "E0702" "a data file with a mistake"
        "The file's content does not follow its format. The message tells the line."
    UnknownFormat "E0703" "a file ending without a format"
        "The format of a file is chosen by its ending. The message lists the endings that exist."
    PathEscapes "E0704" "a path outside the output folder"
        "Scripts write below the output folder (by default the script's own folder) and nowhere else: no absolute paths, no `..` that leaves it, and never over the script or a file that it reads."
    CannotExport "E0705" "a value that the format cannot hold"
        "Meshes, curves and surfaces go into geometry formats, tables into `.csv` and `.json`. The message tells what was found."
    CannotWrite "E0706" "a file that cannot be written"
        "The operating system refused to write the file. What stood there before is untouched."
    DuplicateExport "E0707" "two exports to one file"
        "Each exported file has one `export` statement; a second one would overwrite the first. List several values in one statement: `export a, b to \"both.obj\"`."

    ImportCycle "E0708" "files import one another in a circle"
        "A file may import others, but not itself by way of them: none of them could be evaluated first. Move what both need into a third file that both import."

    // E08xx: parameters of the file.
    UnknownParameter "E0801" "no such parameter"
        "A value from outside replaces that of a `param` of the script; the message lists its parameters."
    BadParameterValue "E0802" "a value that the parameter does not allow"
        "A `param` may state a kind, a range, a step and choices; both its default and what replaces it must keep them."

    // E09xx: ceilings.
    TooLarge "E0901" "more than the ceiling"
        "Lists, meshes, degrees and steps have ceilings, so that a slip of the pen does not exhaust the machine. The message names the ceiling; those that are not set by the mathematics can be moved."
    Stopped "E0902" "stopped before it was done"
        "Whoever asked did not want to wait any longer. At the prompt Ctrl-C does this; the document stays as it was."

    Fault "E0903" "virote itself failed"
        "The program met something that its authors thought impossible. This is a fault of virote and not of the script: please report it, with the script and the message. Nothing was half-written, and what does not use the failed value was evaluated; another way to say the same may work until the fault is mended."

    // E10xx: claims.
    CheckFailed "E1001" "a check does not hold"
        "A claim of the script is false. The report shows the values of both sides and by how much they miss. All checks run, whatever the others say."
    CheckNotBool "E1002" "a check that is no claim"
        "`check` takes something that is true or false, mostly a comparison: `check length(c) < 100mm`."
    ErrorMissing "E1003" "an expected error did not come"
        "`expect error \"E0501\" 1 / 0` in a `test` holds if the expression fails with exactly that code. Here it has a value, or fails with another code; the report shows which."
    UnknownCode "E1004" "a code that no error has"
        "`expect error` takes the code of an error, such as `\"E0501\"`. `virote explain` lists all codes. Mistakes in the form of the text (E00xx, E01xx) are found before there is an expression, so that they can be told but not expected."

    // W00xx: warnings.
    Unclean "W0001" "the result needed help"
        "The construction has a result, but not all of what was asked could be promised. The message tells what was done."
    SelfIntersecting "W0002" "the result crosses itself"
        "Beside a tight bend an offset has cusps and loops: it is further away than the radius of curvature. The result is the true offset with these; a smaller distance has none. A curve that crosses the axis about which it is turned makes a surface that passes through itself, and so does a torus whose tube is thicker than its ring."
    DegenerateResult "W0003" "the result is degenerate"
        "There is a result, but less than was asked for, or one of many: a surface that is only a curve, surfaces that touch in a point and have no curve in common, a stretch of points that are all equally near. The message tells which."
    NotPositiveWeight "W0010" "a weight became zero or negative"
        "Between rational sections the weights swing like the points. Where the weight of a control point is not positive, the surface may leave the hull of its points; it still passes through all sections. A lower degree, `shape = \"monotone\"`, or sections with more even weights avoid it."
    FrameFlip "W0011" "a frame turns around"
        "A Frenet frame follows the side to which the path bends. Where the path goes over from one way of bending to the other, the frame turns around at once, and with it the section. `frame = \"rotation_minimizing\"` does not."
    DegreesMeant "W0012" "degrees may be meant"
        "Trigonometric functions take a number without a unit as radians. One such as 45 or 90, written as it stands, is more likely one of degrees: write `sin(90deg)`, or `sin(90rad)` where radians are meant."
    MembersCount "W0013" "members of a list count one by one"
        "`difference` keeps what is in the first of all its regions, and members of lists count one by one: of `difference(union(a, b), c)` with `a` and `b` apart it takes the smaller one away together with `c`. `[for r in union(a, b): difference(r, c)]` takes `c` from each; `difference([...union(a, b), c])` says that the first alone is meant. What is in all of the members of a list whose members are apart is nothing, and so is `intersection(union(a, b), c)`: `[for r in union(a, b): intersection(r, c)]` asks each of them."
}

impl Code {
    /// Whether it is the code of an error rather than of a warning.
    #[must_use]
    pub fn is_error(self) -> bool {
        self.id().starts_with('E')
    }

    /// The code with identity `id`, upper and lower case alike.
    #[must_use]
    pub fn from_id(id: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|code| code.id().eq_ignore_ascii_case(id))
    }
}

/// Codes of mistakes that are none any more, each with a title and what it meant: a code is never given
/// to another mistake.
pub const RETIRED: &[(&str, &str, &str)] = &[(
    "E0203",
    "a name hides another of the file",
    "This is no mistake any more: parameters, variables of comprehensions and names inside blocks and tests may hide names of around them. Within one scope a name is still defined once (E0202). Inside a block that defines a name, that name means the block's own, also above its definition: where the outer one is wanted too, one of them needs another name.",
)];

#[cfg(test)]
mod tests {
    use super::Code;

    #[test]
    fn identities_are_unique_and_in_order() {
        let ids: Vec<&str> = Code::ALL.iter().map(|code| code.id()).collect();
        let (errors, warnings): (Vec<&str>, Vec<&str>) =
            ids.iter().partition(|id| id.starts_with('E'));
        assert!(errors.is_sorted_by(|a, b| a < b) && warnings.is_sorted_by(|a, b| a < b));
        for code in Code::ALL {
            assert_eq!(Code::from_id(code.id()), Some(*code));
            assert!(code.explanation().ends_with('.'), "{}: a paragraph of sentences", code.id());
        }
    }
}
