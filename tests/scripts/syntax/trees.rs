//! Trees of all shapes, such as the parser could have made them: parentheses stand where the
//! operators need them.

use proptest::prelude::{BoxedStrategy, Just, Strategy, any, prop_oneof};
use proptest::{collection, option, sample};

use virote::diag::Span;
use virote::syntax::ast::{
    Arg, BinaryOp, Block, Comprehension, Definition, Element, Export, Expr, ExprKind, Field,
    Function, Generator, Import, Kind, Name, Param, Parameter, Pattern, Statement, StatementKind,
    StringPart, TextFormat, Tree, UnaryOp, Unit,
};

type S = &'static str;

const NAMES: &[S] = &["a", "b_1", "_private", "größe", "step", "all", "expect", "error", "bezier"];
const LABELS: &[S] = &["a", "to", "point", "u", "tolerance", "if", "step"];
const BINARY: &[BinaryOp] = &[
    BinaryOp::Or,
    BinaryOp::And,
    BinaryOp::Equal,
    BinaryOp::NotEqual,
    BinaryOp::Less,
    BinaryOp::LessEqual,
    BinaryOp::Greater,
    BinaryOp::GreaterEqual,
    BinaryOp::Near,
    BinaryOp::Range,
    BinaryOp::RangeBelow,
    BinaryOp::Add,
    BinaryOp::Subtract,
    BinaryOp::Multiply,
    BinaryOp::Divide,
    BinaryOp::Remainder,
    BinaryOp::Power,
];
const KINDS: &[Kind] = &[
    Kind::Point,
    Kind::Curve,
    Kind::Surface,
    Kind::Mesh,
    Kind::Points,
    Kind::Curves,
    Kind::Surfaces,
    Kind::Meshes,
    Kind::Tables,
];

fn at(kind: ExprKind<'static>) -> Expr<'static> {
    Expr { kind, span: Span::default() }
}

fn name() -> impl Strategy<Value = Name<'static>> + Clone {
    sample::select(NAMES).prop_map(|text| Name { text, span: Span::default() })
}

fn label() -> impl Strategy<Value = Name<'static>> + Clone {
    sample::select(LABELS).prop_map(|text| Name { text, span: Span::default() })
}

/// How tightly an expression holds together: loosest 0.
fn level(expr: &Expr<'_>) -> u8 {
    match &expr.kind {
        ExprKind::If(_) | ExprKind::Lambda(..) => 0,
        ExprKind::Pipe(_) => 1,
        ExprKind::Binary(op, _) => level_of(*op),
        ExprKind::Unary(UnaryOp::Not, _) => 4,
        ExprKind::Within(_) => 5,
        ExprKind::Unary(UnaryOp::Negate, _) => 9,
        _ => 11,
    }
}

fn level_of(op: BinaryOp) -> u8 {
    match op {
        BinaryOp::Or => 2,
        BinaryOp::And => 3,
        BinaryOp::Range | BinaryOp::RangeBelow => 6,
        BinaryOp::Add | BinaryOp::Subtract => 7,
        BinaryOp::Multiply | BinaryOp::Divide | BinaryOp::Remainder => 8,
        BinaryOp::Power => 10,
        _ => 5,
    }
}

/// In parentheses if it is looser than `least`.
fn held(expr: Expr<'static>, least: u8) -> Expr<'static> {
    if level(&expr) < least { at(ExprKind::Group(Box::new(expr))) } else { expr }
}

fn binary(op: BinaryOp, left: Expr<'static>, right: Expr<'static>) -> ExprKind<'static> {
    let own = level_of(op);
    let (left_least, right_least) = match op {
        // To the right; a minus may stand in an exponent.
        BinaryOp::Power => (own + 1, 9),
        // Not in chains.
        _ if own == 5 || own == 6 => (own + 1, own + 1),
        _ => (own, own + 1),
    };
    ExprKind::Binary(op, Box::new([held(left, left_least), held(right, right_least)]))
}

/// Something that can be called: literals cannot, and `1.x` would be a number.
fn callee(expr: Expr<'static>) -> Expr<'static> {
    match expr.kind {
        ExprKind::Name(_)
        | ExprKind::Group(_)
        | ExprKind::Call(..)
        | ExprKind::Field(..)
        | ExprKind::Index(_) => expr,
        _ => at(ExprKind::Group(Box::new(expr))),
    }
}

fn number() -> impl Strategy<Value = ExprKind<'static>> {
    let value = prop_oneof![
        (0..100_u32).prop_map(f64::from),
        any::<f64>().prop_map(f64::abs).prop_filter("finite", |value| value.is_finite()),
    ];
    let units: Vec<Unit> = Unit::ALL.iter().map(|&(_, unit)| unit).collect();
    (value, option::of(sample::select(units)))
        .prop_map(|(value, unit)| ExprKind::Number(value, unit))
}

fn leaf() -> BoxedStrategy<Expr<'static>> {
    prop_oneof![
        number(),
        ".{0,6}".prop_map(ExprKind::Text),
        any::<bool>().prop_map(ExprKind::Bool),
        Just(ExprKind::None),
        sample::select(NAMES).prop_map(ExprKind::Name),
    ]
    .prop_map(at)
    .boxed()
}

/// An expression of any shape.
pub(super) fn expr() -> BoxedStrategy<Expr<'static>> {
    leaf()
        .prop_recursive(5, 40, 4, |inner| {
            prop_oneof![
                operators(inner.clone()),
                brackets(inner.clone()),
                functions(inner.clone()),
                texts_and_blocks(inner),
            ]
            .prop_map(at)
        })
        .boxed()
}

fn operators(
    inner: impl Strategy<Value = Expr<'static>> + Clone + 'static,
) -> impl Strategy<Value = ExprKind<'static>> {
    let two = (inner.clone(), inner.clone());
    prop_oneof![
        4 => (sample::select(BINARY), two.clone()).prop_map(|(op, (l, r))| binary(op, l, r)),
        1 => inner.clone().prop_map(|x| ExprKind::Unary(UnaryOp::Negate, Box::new(held(x, 9)))),
        1 => inner.clone().prop_map(|x| ExprKind::Unary(UnaryOp::Not, Box::new(held(x, 4)))),
        1 => (two.clone(), inner.clone()).prop_map(|((a, b), c)| {
            ExprKind::Within(Box::new([held(a, 6), held(b, 6), held(c, 6)]))
        }),
        1 => two.clone().prop_map(|(a, b)| ExprKind::Pipe(Box::new([held(a, 1), callee(b)]))),
        1 => two.prop_map(|(a, b)| ExprKind::Index(Box::new([callee(a), b]))),
        1 => (inner, label()).prop_map(|(x, name)| ExprKind::Field(Box::new(callee(x)), name)),
    ]
}

fn brackets(
    inner: impl Strategy<Value = Expr<'static>> + Clone + 'static,
) -> impl Strategy<Value = ExprKind<'static>> {
    let element = prop_oneof![
        4 => inner.clone().prop_map(Element::Item),
        1 => inner.clone().prop_map(Element::Spread),
    ];
    let long_field =
        (label(), inner.clone()).prop_map(|(name, value)| Field { name, value: Some(value) });
    let field = prop_oneof![
        3 => long_field,
        1 => name().prop_map(|name| Field { name, value: None }),
    ];
    let generator = (pattern(), inner.clone(), option::of(inner.clone()))
        .prop_map(|(pattern, source, condition)| Generator { pattern, source, condition });
    let comprehension = (collection::vec(generator, 1..3), inner.clone())
        .prop_map(|(generators, body)| Comprehension { generators, body });
    prop_oneof![
        inner.clone().prop_map(|x| ExprKind::Group(Box::new(x))),
        collection::vec(inner, 2..4).prop_map(ExprKind::Point),
        collection::vec(element, 0..6).prop_map(ExprKind::List),
        collection::vec(field, 0..4).prop_map(ExprKind::Record),
        comprehension.prop_map(|c| ExprKind::Comprehension(Box::new(c))),
    ]
}

fn functions(
    inner: impl Strategy<Value = Expr<'static>> + Clone + 'static,
) -> impl Strategy<Value = ExprKind<'static>> {
    let three = [inner.clone(), inner.clone(), inner.clone()];
    prop_oneof![
        2 => (inner.clone(), collection::vec(arg(inner.clone(), true), 0..4))
            .prop_map(|(x, args)| ExprKind::Call(Box::new(callee(x)), args)),
        1 => (collection::vec(name(), 0..3), inner)
            .prop_map(|(names, body)| ExprKind::Lambda(names, Box::new(body))),
        1 => three.prop_map(|parts| ExprKind::If(Box::new(parts))),
    ]
}

fn arg(
    value: impl Strategy<Value = Expr<'static>> + Clone + 'static,
    may_be_left_out: bool,
) -> BoxedStrategy<Arg<'static>> {
    if !may_be_left_out {
        return (label(), value).prop_map(|(name, value)| Arg { name: Some(name), value }).boxed();
    }
    let value = prop_oneof![4 => value, 1 => Just(at(ExprKind::Placeholder))];
    (option::of(label()), value).prop_map(|(name, value)| Arg { name, value }).boxed()
}

fn text_format() -> impl Strategy<Value = Option<TextFormat<'static>>> {
    let unit = || prop_oneof![Just("mm^2"), Just("1/m")];
    let format = |digits, unit| TextFormat { digits, unit, span: Span::default() };
    prop_oneof![
        Just(None),
        (0_usize..20).prop_map(move |digits| Some(format(Some(digits), None))),
        (option::of(0_usize..20), unit())
            .prop_map(move |(digits, unit)| Some(format(digits, Some(unit)))),
    ]
}

fn texts_and_blocks(
    inner: impl Strategy<Value = Expr<'static>> + Clone + 'static,
) -> impl Strategy<Value = ExprKind<'static>> {
    let pieces = (".{0,3}", collection::vec((inner.clone(), text_format(), ".{0,3}"), 1..3));
    let interpolation = pieces.prop_map(|(first, rest)| {
        let mut pieces = vec![StringPart::Text(first)];
        for (expr, format, text) in rest {
            pieces.extend([StringPart::Expr(expr, format), StringPart::Text(text)]);
        }
        pieces.retain(|piece| !matches!(piece, StringPart::Text(text) if text.is_empty()));
        ExprKind::Interpolation(pieces)
    });
    let statement = definition(inner.clone()).prop_map(|kind| Statement {
        docs: None,
        kind,
        span: Span::default(),
    });
    let block = (collection::vec(statement, 0..3), inner).prop_map(|(mut statements, value)| {
        // In a block `mesh (0)` and `table (0)` are calls.
        for statement in &mut statements {
            if let StatementKind::Definition(definition) = &mut statement.kind
                && matches!(definition.kind, Kind::Mesh | Kind::Table)
                && matches!(definition.pattern, Pattern::Anonymous)
            {
                let name = Name { text: NAMES[0], span: Span::default() };
                definition.pattern = Pattern::Name(name);
            }
        }
        // `{ a }` is a record.
        let is_record = statements.is_empty() && matches!(value.kind, ExprKind::Name(_));
        let value = if is_record { at(ExprKind::Group(Box::new(value))) } else { value };
        ExprKind::Block(Box::new(Block { statements, value }))
    });
    prop_oneof![interpolation, block]
}

fn pattern() -> impl Strategy<Value = Pattern<'static>> + Clone {
    let names = || collection::vec(name(), 0..3);
    prop_oneof![
        3 => name().prop_map(Pattern::Name),
        1 => names().prop_map(|names| Pattern::List(names, Span::default())),
        1 => names().prop_map(|names| Pattern::Record(names, Span::default())),
    ]
}

fn definition(
    value: impl Strategy<Value = Expr<'static>> + Clone + 'static,
) -> impl Strategy<Value = StatementKind<'static>> {
    let with = || collection::vec(arg(leaf(), false), 0..2);
    let parameter =
        (name(), option::of(value.clone())).prop_map(|(name, default)| Parameter { name, default });
    let named = prop_oneof![Just(Pattern::Anonymous), name().prop_map(Pattern::Name)];
    prop_oneof![
        (pattern(), value.clone(), with()).prop_map(|(pattern, value, with)| {
            StatementKind::Definition(Definition { kind: Kind::Let, pattern, value, with })
        }),
        (sample::select(KINDS), named, value.clone(), with()).prop_map(
            |(kind, pattern, value, with)| {
                StatementKind::Definition(Definition { kind, pattern, value, with })
            }
        ),
        (name(), collection::vec(parameter, 0..3), value).prop_map(|(name, parameters, body)| {
            StatementKind::Function(Box::new(Function { name, parameters, body }))
        }),
    ]
}

fn text() -> impl Strategy<Value = Expr<'static>> {
    "[a-z./{}\"\\\\]{0,8}".prop_map(|text| at(ExprKind::Text(text)))
}

/// What may stand at the top level and in tests.
fn effect() -> impl Strategy<Value = StatementKind<'static>> {
    let options = || collection::vec(arg(leaf(), false), 0..3);
    let check = (expr(), option::of(text()))
        .prop_map(|(claim, message)| StatementKind::Check { claim, message });
    let export = (collection::vec(expr(), 1..3), text(), options());
    let import = (text(), option::of(name()), option::of(collection::vec(name(), 0..3)), options());
    prop_oneof![
        4 => definition(expr()),
        1 => check,
        1 => collection::vec(expr(), 1..4).prop_map(StatementKind::Print),
        1 => export.prop_map(|(subjects, path, options)| {
            StatementKind::Export(Box::new(Export { subjects, path, options }))
        }),
        1 => import.prop_map(|(path, alias, names, with)| {
            StatementKind::Import(Box::new(Import { path, alias, names, with }))
        }),
    ]
}

fn top_level() -> impl Strategy<Value = StatementKind<'static>> {
    let param = (
        name(),
        option::of(name()),
        expr(),
        option::of(expr()),
        option::of(expr()),
        option::of(text()),
    )
        .prop_map(|(name, kind, default, allowed, step, label)| {
            StatementKind::Param(Box::new(Param { name, kind, default, allowed, step, label }))
        });
    let expectation =
        (text(), expr()).prop_map(|(code, subject)| StatementKind::ExpectError { code, subject });
    let tested = prop_oneof![4 => effect(), 1 => expectation];
    let test = (text(), collection::vec(statement(tested), 0..3))
        .prop_map(|(name, body)| StatementKind::Test { name, body });
    prop_oneof![4 => effect(), 1 => param, 1 => test]
}

fn statement(
    kind: impl Strategy<Value = StatementKind<'static>>,
) -> impl Strategy<Value = Statement<'static>> {
    let docs = option::of(collection::vec("( ?[a-z/]{1,5}){0,3}", 1..3));
    (docs, kind).prop_map(|(docs, kind)| Statement {
        docs: docs.map(|lines| lines.join("\n")),
        kind,
        span: Span::default(),
    })
}

/// A script of any shape.
pub(super) fn tree() -> impl Strategy<Value = Tree<'static>> {
    let setting = |kind| Statement { docs: None, kind, span: Span::default() };
    let first = option::of(Just(setting(StatementKind::Edition(at(ExprKind::Number(1.0, None))))));
    let unit = option::of(sample::select(vec!["mm", "in", "ft"]));
    (first, unit, collection::vec(statement(top_level()), 0..5)).prop_map(
        move |(first, unit, rest)| {
            let unit = unit.map(|text| Name { text, span: Span::default() });
            let unit = unit.map(|name| setting(StatementKind::Unit(name)));
            Tree { statements: first.into_iter().chain(unit).chain(rest).collect() }
        },
    )
}
