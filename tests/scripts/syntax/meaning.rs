//! What scripts mean: operators by precedence, statements by their parts, lines by their beginnings.

use virote::syntax::ast::{
    Arg, BinaryOp, Element, Expr, ExprKind, Statement, StatementKind, StringPart, UnaryOp, Unit,
};

use super::{parse_clean, scripts};

/// The expression with all its operators in parentheses.
fn nested(expr: &Expr<'_>) -> String {
    let list = |items: &[Expr<'_>]| items.iter().map(nested).collect::<Vec<_>>().join(", ");
    match &expr.kind {
        ExprKind::Number(value, unit) => format!("{value}{}", unit.map_or("", Unit::name)),
        ExprKind::Name(name) => (*name).to_owned(),
        ExprKind::Placeholder => "_".to_owned(),
        ExprKind::Group(inner) => format!("<{}>", nested(inner)),
        ExprKind::Point(items) => format!("point({})", list(items)),
        ExprKind::List(items) => {
            let items: Vec<String> = items
                .iter()
                .map(|item| match item {
                    Element::Item(item) => nested(item),
                    Element::Spread(list) => format!("...{}", nested(list)),
                })
                .collect();
            format!("[{}]", items.join(", "))
        }
        ExprKind::Unary(UnaryOp::Negate, operand) => format!("(-{})", nested(operand)),
        ExprKind::Unary(UnaryOp::Not, operand) => format!("(not {})", nested(operand)),
        ExprKind::Binary(op, operands) => {
            let [left, right] = &**operands;
            format!("({} {} {})", nested(left), spelling(*op), nested(right))
        }
        ExprKind::Within(parts) => {
            let [left, right, tolerance] = &**parts;
            format!("({} ~= {} within {})", nested(left), nested(right), nested(tolerance))
        }
        ExprKind::Pipe(parts) => format!("({} |> {})", nested(&parts[0]), nested(&parts[1])),
        ExprKind::Call(callee, args) => format!("{}({})", nested(callee), arguments(args)),
        ExprKind::Index(parts) => format!("{}[{}]", nested(&parts[0]), nested(&parts[1])),
        ExprKind::Field(owner, name) => format!("{}.{}", nested(owner), name.text),
        ExprKind::Lambda(parameters, body) => {
            let names: Vec<&str> = parameters.iter().map(|name| name.text).collect();
            format!("({} => {})", names.join(" "), nested(body))
        }
        ExprKind::If(parts) => {
            let [condition, first, second] = &**parts;
            format!("(if {} then {} else {})", nested(condition), nested(first), nested(second))
        }
        ExprKind::Record(fields) => {
            let fields: Vec<String> = fields
                .iter()
                .map(|field| match &field.value {
                    Some(value) => format!("{}: {}", field.name.text, nested(value)),
                    None => field.name.text.to_owned(),
                })
                .collect();
            format!("{{{}}}", fields.join(", "))
        }
        ExprKind::Block(block) => {
            format!("block of {} = {}", block.statements.len(), nested(&block.value))
        }
        other => format!("{other:?}"),
    }
}

fn arguments(args: &[Arg<'_>]) -> String {
    let args: Vec<String> = args
        .iter()
        .map(|arg| match arg.name {
            Some(name) => format!("{} = {}", name.text, nested(&arg.value)),
            None => nested(&arg.value),
        })
        .collect();
    args.join(", ")
}

fn spelling(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Or => "or",
        BinaryOp::And => "and",
        BinaryOp::Equal => "==",
        BinaryOp::NotEqual => "!=",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Near => "~=",
        BinaryOp::Range => "..",
        BinaryOp::RangeBelow => "..<",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Remainder => "%",
        BinaryOp::Power => "^",
    }
}

#[track_caller]
fn value_of<'a, 's>(statement: &'a Statement<'s>) -> &'a Expr<'s> {
    match &statement.kind {
        StatementKind::Definition(definition) => &definition.value,
        other => panic!("a definition, not {other:?}"),
    }
}

/// `source` is read as `meaning` says.
#[track_caller]
fn check(source: &str, meaning: &str) {
    let script = format!("let value = {source}");
    let tree = parse_clean(&script);
    assert_eq!(tree.statements.len(), 1, "{source}");
    assert_eq!(nested(value_of(&tree.statements[0])), meaning, "{source}");
}

#[test]
fn operators_bind_as_the_reference_says() {
    check("a |> f(b) |> g(c)", "((a |> f(b)) |> g(c))");
    check("a or b |> f", "((a or b) |> f)");
    check("a or b and c or d", "((a or (b and c)) or d)");
    check("not a and not b or c", "(((not a) and (not b)) or c)");
    check("not a == b", "(not (a == b))");
    check("not not a", "(not (not a))");
    check("a == b and c < d", "((a == b) and (c < d))");
    check("0..n - 1 == r", "((0 .. (n - 1)) == r)");
    check("a ..< b * 2", "(a ..< (b * 2))");
    check("a + b - c * d / e % f", "((a + b) - (((c * d) / e) % f))");
    check("-a * b", "((-a) * b)");
    check("-a + -b", "((-a) + (-b))");
    check("--a", "(-(-a))");
    check("-2^2", "(-(2 ^ 2))");
    check("2^-1 * 3", "((2 ^ (-1)) * 3)");
    check("2^3^4", "(2 ^ (3 ^ 4))");
    check("2^-3^4", "(2 ^ (-(3 ^ 4)))");
    check("-f(x)[0].y^2", "(-(f(x)[0].y ^ 2))");
    check("1/5mm", "(1 / 5mm)");
    check("(a + b) * c", "(<(a + b)> * c)");
}

#[test]
fn nearness_takes_its_tolerance() {
    check("a ~= b within 1 + 2 and c", "((a ~= b within (1 + 2)) and c)");
    check("a ~= b", "(a ~= b)");
    check("[1, 2] ~= xs within 0.5", "([1, 2] ~= xs within 0.5)");
}

#[test]
fn choices_and_functions_reach_to_the_end() {
    check("if a then b else c + 1", "(if a then b else (c + 1))");
    check("1 + if a then b else c + 1", "(1 + (if a then b else (c + 1)))");
    check("if a then if b then c else d else e", "(if a then (if b then c else d) else e)");
    check("x => y => x |> f(y)", "(x => (y => (x |> f(y))))");
    check("(u, v) => (u, v)", "(u v => point(u, v))");
    check("() => 1", "( => 1)");
    check("(x) => x", "(x => x)");
    check("f(x => x + 1, y)", "f((x => (x + 1)), y)");
    check("a and not b == c", "(a and (not (b == c)))");
}

#[test]
fn brackets_tell_groups_points_and_calls_apart() {
    check("(a)", "<a>");
    check("(a, b)", "point(a, b)");
    check("(a, b, c,)", "point(a, b, c)");
    check("f((a, b))", "f(point(a, b))");
    check("f(a, label = b, to = c, _)", "f(a, label = b, to = c, _)");
    check("f(_, at = _)", "f(_, at = _)");
    check("f()()[0](1)", "f()()[0](1)");
    check("(x => x)(2)", "<(x => x)>(2)");
    check("[...xs, y,]", "[...xs, y]");
    check("table({x: [1]})", "table({x: [1]})");
    check("p.to.point.if", "p.to.point.if");
}

#[test]
fn braces_tell_records_and_blocks_apart() {
    check("{}", "{}");
    check("{a}", "{a}");
    check("{a, b: 1, to: 2,}", "{a, b: 1, to: 2}");
    check("{ a + b }", "block of 0 = (a + b)");
    check("{ x => x }", "block of 0 = (x => x)");
    check("{ none }", "block of 0 = None");
    check("{ let a = 1  fn f(x) = x  curve c = g(a)  c(f(a)) }", "block of 3 = c(f(a))");
    check("{ let p = f(1); (p, 2) }", "block of 1 = point(p, 2)");
    check("{ let r = xs  table(r) }", "block of 1 = table(r)");
    check("{ let a = {u: 1}  {v: a} }", "block of 1 = {v: a}");
}

#[test]
fn a_bracket_or_minus_that_begins_a_line_begins_an_expression() {
    check("{\n let p = f\n (p, 2)\n}", "block of 1 = point(p, 2)");
    check("{\n let p = f\n [p]\n}", "block of 1 = [p]");
    check("{\n let p = f\n -p\n}", "block of 1 = (-p)");
    check("{ let p = f /* a\n line */ (p, 2) }", "block of 1 = point(p, 2)");
    check("[\n  (1, 2),\n  -3,\n  [4],\n]", "[point(1, 2), (-3), [4]]");
    check("a -\n b", "(a - b)");
    check("a\n + b\n |> f", "((a + b) |> f)");
    check("f(\n  1,\n)", "f(1)");
}

#[test]
fn numbers_take_units_and_ranges_take_points() {
    check("0..3", "(0 .. 3)");
    check("0..<3", "(0 ..< 3)");
    check("1_000.5e-3mm", "1.0005mm");
    check("1e3", "1000");
    check("5in + 2turn", "(5in + 2turn)");
    check("xs[-1]", "xs[(-1)]");
}

#[test]
fn names_may_be_of_any_script_and_words_of_place_are_names() {
    check(
        "größe + _x + step + all + expect + error",
        "(((((größe + _x) + step) + all) + expect) + error)",
    );
}

#[track_caller]
fn check_text(source: &str, text: &str) {
    let script = format!("let value = {source}");
    let tree = parse_clean(&script);
    let found = match &value_of(&tree.statements[0]).kind {
        ExprKind::Text(text) => text.clone(),
        ExprKind::Interpolation(pieces) => pieces
            .iter()
            .map(|piece| match piece {
                StringPart::Text(text) => text.clone(),
                StringPart::Expr(expr, None) => format!("<{}>", nested(expr)),
                StringPart::Expr(expr, Some(format)) => {
                    format!("<{}:{:?}{:?}>", nested(expr), format.digits, format.unit)
                }
            })
            .collect(),
        other => panic!("a text, not {other:?}"),
    };
    assert_eq!(found, text);
}

#[test]
fn strings_resolve_escapes_and_hold_expressions() {
    check_text(r#""a\n\t\"\\\{b} \u{3b1}""#, "a\n\t\"\\{b} α");
    check_text(r#""""#, "");
    check_text(r#""frame {i + 1}""#, "frame <(i + 1)>");
    check_text(r#""{a}{b} c {d}""#, "<a><b> c <d>");
    check_text(r#""{ {a: 1}.a }""#, "<{a: 1}.a>");
    check_text(r#""{f("x")} // no comment""#, r#"<f(Text("x"))> // no comment"#);
}

#[test]
fn statements_have_their_parts() {
    let tree = parse_clean(
        "geo 1; unit in\ntolerance 1e-6\nparam n: integer = 3 in 1..9 step 2 \"Count\"\n\
         param style = \"a\" in [\"a\", \"b\"]\nlet [a, b] = f() with (color = \"red\")\nlet {c} = g()\n\
         curves [a, b]\nfn h(x, to_ = 2) = x\ncheck a == b \"message {a}\"\nprint a, b,\n\
         export a, b to \"x.obj\" with (free_form = true)\nexport all to \"y.obj\"\n\
         import \"p.geo\" as p with (n = 2)\nimport \"q.geo\" (r, s)\n\
         test \"t\" { let z = 1; expect error \"E0501\" 1/0  check z == 1 }\n",
    );
    let kinds: Vec<String> = tree
        .statements
        .iter()
        .map(|statement| format!("{:?}", statement.kind))
        .map(|text| text.split(['(', ' ']).next().unwrap_or_default().to_owned())
        .collect();
    let expected = "Edition Unit Tolerance Param Param Definition Definition Definition Function Check \
                    Print Export Export Import Import Test";
    assert_eq!(kinds, expected.split_whitespace().collect::<Vec<_>>());
    let StatementKind::Test { body, .. } = &tree.statements[15].kind else { panic!("a test") };
    assert_eq!(body.len(), 3);
    let StatementKind::Param(param) = &tree.statements[3].kind else { panic!("a param") };
    assert!(
        param.kind.is_some()
            && param.allowed.is_some()
            && param.step.is_some()
            && param.label.is_some()
    );
    let StatementKind::Export(export) = &tree.statements[12].kind else { panic!("an export") };
    assert!(matches!(&export.subjects[..], [Expr { kind: ExprKind::Name("all"), .. }]));
}

#[test]
fn documentation_belongs_to_the_statement_that_follows() {
    let tree = parse_clean(
        "/// One\n///   two\n// no\nlet a = 1\n//// no\nlet b = [ /// no\n 2]\n///\nlet c = 3",
    );
    let docs: Vec<Option<&str>> = tree.statements.iter().map(|s| s.docs.as_deref()).collect();
    assert_eq!(docs, [Some("One\n  two"), None, Some("")]);
}

#[test]
fn statements_need_no_separator() {
    assert_eq!(parse_clean("let a = 1 let b = f curve c = g(b) check a == b").statements.len(), 4);
}

#[test]
fn spans_reach_from_the_first_to_the_last_byte() {
    let source = "\u{feff}let a = f( (1, 2) )  let b = -x + 2 ";
    let tree = parse_clean(source);
    let text = |span: virote::diag::Span| &source[span.range()];
    assert_eq!(text(tree.statements[0].span), "let a = f( (1, 2) )");
    assert_eq!(text(value_of(&tree.statements[0]).span), "f( (1, 2) )");
    assert_eq!(text(value_of(&tree.statements[1]).span), "-x + 2");
}

#[test]
fn real_scripts_have_no_mistakes() {
    for (_, source) in scripts() {
        parse_clean(&source);
    }
}
