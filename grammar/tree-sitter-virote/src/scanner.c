// What the grammar cannot say by itself: beginnings of lines, and comments that nest.

#include "tree_sitter/parser.h"

#include "tree_sitter/alloc.h"

enum Token { CALL, INDEX, MINUS, BLOCK_COMMENT, STRING_CONTENT, NEVER };

// The column, plus 1, behind a comment before which a line began, if a "(", "[" or "-" may follow
// on its line; else 0.
typedef struct {
  uint16_t column;
} Scanner;

void *tree_sitter_virote_external_scanner_create(void) { return ts_calloc(1, sizeof(Scanner)); }
void tree_sitter_virote_external_scanner_destroy(void *payload) { ts_free(payload); }
unsigned tree_sitter_virote_external_scanner_serialize(void *payload, char *buffer) {
  uint16_t column = ((Scanner *)payload)->column;
  buffer[0] = (char)(column & 0xFF);
  buffer[1] = (char)(column >> 8);
  return 2;
}
void tree_sitter_virote_external_scanner_deserialize(void *payload, const char *buffer, unsigned length) {
  Scanner *scanner = payload;
  scanner->column = 0;
  if (length == 2) {
    scanner->column = (uint16_t)((uint8_t)buffer[0] | ((uint8_t)buffer[1] << 8));
  }
}

static void advance(TSLexer *lexer) { lexer->advance(lexer, false); }

static bool is_space(int32_t c) {
  return c == ' ' || (c >= '\t' && c <= '\r') || c == 0x85 || c == 0xA0 || c == 0x1680 ||
         (c >= 0x2000 && c <= 0x200A) || c == 0x2028 || c == 0x2029 || c == 0x202F || c == 0x205F ||
         c == 0x3000 || c == 0xFEFF;
}

// The rest of a comment behind its "/*". Tells in `has_newline` whether it goes over several lines.
static bool rest_of_comment(TSLexer *lexer, bool *has_newline) {
  unsigned depth = 1;
  while (depth > 0 && !lexer->eof(lexer)) {
    int32_t c = lexer->lookahead;
    if (c == '\n') {
      *has_newline = true;
    }
    advance(lexer);
    if (c == '/' && lexer->lookahead == '*') {
      advance(lexer);
      depth++;
    } else if (c == '*' && lexer->lookahead == '/') {
      advance(lexer);
      depth--;
    }
  }
  return depth == 0;
}

static bool string_content(TSLexer *lexer) {
  bool has_any = false;
  while (!lexer->eof(lexer) && lexer->lookahead != '"' && lexer->lookahead != '\\' && lexer->lookahead != '{' &&
         lexer->lookahead != '\n') {
    advance(lexer);
    has_any = true;
  }
  lexer->result_symbol = STRING_CONTENT;
  return has_any;
}

// A token without width, if the next token stands on this line and continues the expression.
static bool continues(TSLexer *lexer, const bool *valid) {
  int32_t c = lexer->lookahead;
  if (c == '(' && valid[CALL]) {
    lexer->result_symbol = CALL;
    return true;
  }
  if (c == '[' && valid[INDEX]) {
    lexer->result_symbol = INDEX;
    return true;
  }
  if (c == '-' && valid[MINUS]) {
    lexer->result_symbol = MINUS;
    return true;
  }
  return false;
}

// A comment; the lookahead is its "/". Remembers whether a line began before it ended.
static bool block_comment(Scanner *scanner, TSLexer *lexer, bool has_newline) {
  advance(lexer);
  if (lexer->lookahead != '*') {
    return false;
  }
  advance(lexer);
  if (!rest_of_comment(lexer, &has_newline)) {
    return false;
  }
  lexer->mark_end(lexer);
  lexer->result_symbol = BLOCK_COMMENT;
  scanner->column = 0;
  if (has_newline) {
    uint32_t column = lexer->get_column(lexer);
    while (is_space(lexer->lookahead) && lexer->lookahead != '\n') {
      advance(lexer);
    }
    int32_t c = lexer->lookahead;
    if (c == '(' || c == '[' || c == '-' || c == '/') {
      scanner->column = (uint16_t)(column + 1);
    }
  }
  return true;
}

bool tree_sitter_virote_external_scanner_scan(void *payload, TSLexer *lexer, const bool *valid) {
  Scanner *scanner = payload;
  // While the parser recovers from an error every token is valid; only comments help then.
  bool is_recovering = valid[NEVER];
  if (valid[STRING_CONTENT] && !is_recovering) {
    scanner->column = 0;
    return string_content(lexer);
  }
  bool has_newline = scanner->column != 0 && scanner->column == (uint16_t)(lexer->get_column(lexer) + 1);
  while (is_space(lexer->lookahead)) {
    has_newline = has_newline || lexer->lookahead == '\n';
    lexer->advance(lexer, true);
  }
  if (lexer->lookahead == '/' && valid[BLOCK_COMMENT]) {
    return block_comment(scanner, lexer, has_newline);
  }
  if (is_recovering || has_newline) {
    return false;
  }
  lexer->mark_end(lexer);
  scanner->column = 0;
  return continues(lexer, valid);
}
