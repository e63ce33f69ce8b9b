//! Text to tree and back. Pure, and never fails: any text gives a tree and diagnostics.

pub mod ast;
mod bindings;
mod block_comment;
mod completion_place;
mod cursor;
mod lexed;
mod lexer;
mod operator;
mod outline;
mod parser;
mod print;
mod token;

pub use bindings::{Binding, bindings};
pub use completion_place::{CompletionPlace, open_code, place};
pub use cursor::{OpenCall, end_of_brackets, is_name, open_call, open_list};
pub use outline::{
    Highlight, OutlinedStatement, PromptEntry, StatementRole, entry, free_placeholders,
    is_complete, parts, pieces,
};
pub use parser::parse;
pub use print::{format, print};
pub use token::KEYWORDS;
