//! What a list among the arguments of a union, an intersection or a difference means, where it may mean more than was
//! thought of.

use crate::{
    diag::{Code, Diagnostic, Span},
    value::{Ctx, List, Value},
};

/// How many members the lists among several arguments have; one where there is one argument alone, or no list.
#[derive(Clone, Copy, Debug)]
pub(super) struct ListedMembers {
    first: usize,
    most: usize,
}

impl ListedMembers {
    pub(super) fn of(arguments: &List) -> Self {
        if arguments.len() < 2 {
            return Self { first: 1, most: 1 };
        }
        let counts: Vec<usize> = arguments
            .iter()
            .map(|argument| match argument {
                Value::List(members) => members.len(),
                _ => 1,
            })
            .collect();
        Self { first: counts[0], most: counts.iter().copied().fold(1, usize::max) }
    }

    /// Warns of a list in front of what is taken away: but for its first member it is taken away as well.
    pub(super) fn warn_of_difference(self, ctx: &mut Ctx<'_>, span: Span, one: &str) {
        if self.first < 2 {
            return;
        }
        let message = format!(
            "of the first list only its first {one} is kept: the others are taken away with the rest"
        );
        ctx.warn(
            Diagnostic::warning(Code::MembersCount, span, message)
                .hint("`[for r in a: difference(r, b)]` takes them from each, `difference([...a, b])` says that this is meant"),
        );
    }

    /// Warns where nothing is in all of them, and a list of several is among them.
    pub(super) fn warn_of_no_intersection(self, ctx: &mut Ctx<'_>, span: Span) {
        if self.most < 2 {
            return;
        }
        let message = "nothing is in all of them: of a list each member counts, also of one whose members are apart";
        ctx.warn(
            Diagnostic::warning(Code::MembersCount, span, message)
                .hint("`[for r in a: intersection(r, b)]` asks for each what it has in common with `b`, `intersection([...a, b])` says that this is meant"),
        );
    }
}
