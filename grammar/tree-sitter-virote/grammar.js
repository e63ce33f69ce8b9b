/**
 * The `.geo` language, edition 1, for editors. ../virote.ebnf is normative.
 *
 * The scanner (src/scanner.c) knows what a context-free grammar cannot: that a "(", "[" or "-" that is
 * the first token of its line continues no expression, and that comments nest.
 */

/// <reference types="tree-sitter-cli/dsl" />

const PREC = {
  pipe: 1, or: 2, and: 3, not: 4, comparison: 5, range: 6, sum: 7, product: 8, sign: 9, power: 10, postfix: 11,
};

const KINDS = [
  "point", "curve", "surface", "mesh", "table",
  "points", "curves", "surfaces", "meshes", "tables",
];

// Kinds that are words at the start of a statement only.
const WORD_KINDS = ["region", "regions", "face", "faces", "solid", "solids"];

const KEYWORDS = [
  "geo", "unit", "tolerance", "param", "let", "fn",
  ...KINDS,
  "check", "print", "export", "import", "test",
  "in", "with", "as", "to", "for", "if", "then", "else",
  "and", "or", "not", "true", "false", "none", "within",
];

const LENGTHS = ["um", "mm", "cm", "m", "km", "in", "ft"];
const ANGLES = ["deg", "rad", "turn"];

const list = (item) => optional(seq(item, repeat(seq(",", item)), optional(",")));
const several = (item) => seq(item, repeat(seq(",", item)), optional(","));

module.exports = grammar({
  name: "virote",

  word: ($) => $.identifier,

  // Without width: what follows on the same line continues the expression.
  externals: ($) => [$._call, $._index, $._minus, $.block_comment, $.string_content, $._never],

  extras: ($) => [/[\s\uFEFF]/, $.line_comment, $.doc_comment, $.block_comment],

  supertypes: ($) => [$._statement, $._expression],

  conflicts: ($) => [[$.lambda_parameters, $._expression], [$.record, $._expression], [$.print]],

  rules: {
    script: ($) => repeat(choice(";", $._statement)),

    _statement: ($) =>
      choice(
        $.edition, $.document_unit, $.tolerance, $.param, $.definition, $.function,
        $.check, $.print, $.export, $.import, $.test,
      ),

    edition: ($) => seq("geo", $.number),
    document_unit: ($) => seq("unit", field("unit", alias(choice(...LENGTHS), $.unit))),
    tolerance: ($) => seq("tolerance", $._expression),

    param: ($) =>
      seq(
        "param", field("name", $.identifier),
        optional(seq(":", field("kind", alias($.identifier, $.kind)))),
        "=", field("default", $._expression),
        optional(seq("in", field("allowed", $._expression))),
        optional(seq("step", field("step", $._expression))),
        optional(field("label", $.string)),
      ),

    definition: ($) =>
      choice(
        seq("let", field("pattern", $._pattern), "=", field("value", $._expression), optional($.with)),
        seq(
          field("kind", alias(choice(...KINDS, ...WORD_KINDS), $.kind)),
          optional(seq(field("pattern", $._name), "=")),
          field("value", $._expression),
          optional($.with),
        ),
      ),

    _pattern: ($) => choice($.identifier, $.list_pattern, $.record_pattern),
    list_pattern: ($) => seq("[", list($.identifier), "]"),
    record_pattern: ($) => seq("{", list($.identifier), "}"),

    function: ($) =>
      seq(
        "fn", field("name", $.identifier), "(", list($.parameter), ")",
        "=", field("body", $._expression),
      ),
    parameter: ($) => seq(field("name", $.identifier), optional(seq("=", field("default", $._expression)))),

    check: ($) => seq("check", $._expression, optional(field("message", $.string))),
    print: ($) => seq("print", several($._expression)),
    export: ($) =>
      seq("export", choice("all", several($._expression)), "to", field("path", $.string), optional($.with)),
    import: ($) =>
      seq(
        "import", field("path", $.string),
        optional(seq("as", field("name", $.identifier))),
        optional(seq("(", list($.identifier), ")")),
        optional($.with),
      ),
    with: ($) => seq("with", "(", list($.argument), ")"),

    test: ($) =>
      seq("test", field("name", $.string), "{", repeat(choice(";", $._statement, $.expectation)), "}"),
    expectation: ($) => seq("expect", "error", field("code", $.string), $._expression),

    _expression: ($) =>
      choice(
        $.number, $.string, $.boolean, $.none, $._name,
        $.group, $.point, $.list, $.comprehension, $.record, $.block,
        $.call, $.index, $.field,
        $.binary, $.unary, $.near, $.if, $.lambda,
      ),

    binary: ($) => {
      const row = (assoc, level, ...signs) =>
        assoc(
          level,
          seq(field("left", $._expression), field("operator", signs.length > 1 ? choice(...signs) : signs[0]), field("right", $._expression)),
        );
      const sum = (...sign) =>
        prec.left(PREC.sum, seq(field("left", $._expression), ...sign, field("right", $._expression)));
      return choice(
        row(prec.left, PREC.pipe, "|>"),
        row(prec.left, PREC.or, "or"),
        row(prec.left, PREC.and, "and"),
        row(prec.left, PREC.comparison, "==", "!=", "<", "<=", ">", ">="),
        row(prec.left, PREC.range, "..", "..<"),
        sum(field("operator", "+")),
        sum($._minus, field("operator", "-")),
        row(prec.left, PREC.product, "*", "/", "%"),
        row(prec.right, PREC.power, "^"),
      );
    },

    near: ($) =>
      prec.left(
        PREC.comparison,
        seq(
          field("left", $._expression), "~=", field("right", $._expression),
          optional(seq("within", field("tolerance", $._expression))),
        ),
      ),

    unary: ($) =>
      choice(
        prec(PREC.sign, seq("-", $._expression)),
        prec(PREC.not, seq("not", $._expression)),
      ),

    if: ($) =>
      prec.right(
        seq(
          "if", field("condition", $._expression),
          "then", field("then", $._expression),
          "else", field("else", $._expression),
        ),
      ),

    lambda: ($) =>
      prec.right(seq(field("parameters", $.lambda_parameters), "=>", field("body", $._expression))),
    lambda_parameters: ($) => choice($._name, seq("(", list($._name), ")")),

    call: ($) =>
      prec(
        PREC.postfix,
        seq(
          field("function", choice($._callee, alias("mesh", $.identifier), alias("table", $.identifier))),
          $._call, "(", list($.argument), ")",
        ),
      ),
    index: ($) => prec(PREC.postfix, seq($._expression, $._index, "[", $._expression, "]")),
    field: ($) => prec(PREC.postfix, seq($._expression, ".", field("label", $._label))),
    // Literals cannot be called: a "(" behind them begins something else.
    _callee: ($) => choice($._name, $.group, $.call, $.index, $.field),

    argument: ($) =>
      seq(optional(seq(field("label", $._label), "=")), choice($._expression, $.placeholder)),
    placeholder: (_) => "_",

    group: ($) => seq("(", $._expression, optional(","), ")"),
    point: ($) =>
      seq("(", $._expression, ",", $._expression, optional(seq(",", $._expression)), optional(","), ")"),
    list: ($) => seq("[", list(choice($.spread, $._expression)), "]"),
    spread: ($) => seq("...", $._expression),

    comprehension: ($) =>
      seq(
        "[", "for", several($.generator),
        ":", field("body", $._expression), optional(","), "]",
      ),
    generator: ($) =>
      seq(
        field("pattern", $._pattern), "in", field("source", $._expression),
        optional(seq("if", field("condition", $._expression))),
      ),

    // `{ a }` is a record, not a block.
    record: ($) => prec.dynamic(1, seq("{", list(choice($.pair, $._name)), "}")),
    pair: ($) => seq(field("label", $._label), ":", field("value", $._expression)),

    block: ($) =>
      seq("{", repeat(choice(";", $.definition, $.function)), field("value", $._expression), repeat(";"), "}"),

    // Where a statement could begin, a word of a kind may be a name as well.
    _name: ($) => choice($.identifier, alias(choice(...WORD_KINDS), $.identifier)),
    _label: ($) => choice($._name, alias(choice(...KEYWORDS), $.identifier)),

    boolean: (_) => choice("true", "false"),
    none: (_) => "none",

    number: ($) => seq($.digits, optional($.unit)),
    digits: (_) => /[0-9](_?[0-9])*(\.[0-9](_?[0-9])*)?([eE][+-]?[0-9]+)?/,
    unit: (_) => token.immediate(choice(...LENGTHS, ...ANGLES)),

    // On one line.
    string: ($) =>
      seq('"', repeat(choice($.string_content, $.escape, $.interpolation)), token.immediate('"')),
    escape: (_) => token.immediate(seq("\\", choice(/[nt"\\{}]/, /u\{[0-9a-fA-F]+\}/))),
    interpolation: ($) => seq(token.immediate("{"), $._expression, optional($.format), "}"),
    format: (_) => token(seq(":", /[^{}"\n]+/)),

    identifier: (_) => /[\p{XID_Start}_]\p{XID_Continue}*/,

    line_comment: (_) => token(seq("//", /[^\n]*/)),
    doc_comment: (_) => token(prec(1, /\/\/\/[^\/\n][^\n]*/)),
  },
});
