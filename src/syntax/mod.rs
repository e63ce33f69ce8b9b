//! Text to tree and back. Pure, and never fails: any text gives a tree and diagnostics.

pub mod ast;
mod block_comment;
mod cursor;
mod lexed;
mod lexer;
mod operator;
mod outline;
mod parser;
mod print;
mod token;

pub use cursor::{OpenCall, is_name, open_call};
pub use outline::{
    CompletionPlace, Highlight, OutlinedStatement, PromptEntry, StatementRole, entry,
    free_placeholders, is_complete, parts, pieces, place,
};
pub use parser::parse;
pub use print::{format, print};
pub use token::KEYWORDS;
