//! The order of evaluation: who uses whom, and who goes round in a circle.
//!
//! Strongly connected components by Tarjan's algorithm (*Depth-first search and linear graph
//! algorithms*, SIAM J. Comput. 1, 1972), without recursion, so that a chain of a hundred
//! thousand definitions needs no stack.

use std::collections::VecDeque;

use super::super::ir::{Definition, DefinitionRole};
use crate::diag::{Code, Diagnostic};

/// Components of the graph of definitions, each after those that it uses. Functions may use one
/// another in circles; any other circle is reported and poisoned.
///
/// The definitions are numbered from `first`; what they use below that has its place already.
pub(super) fn order(
    definitions: &mut [Definition],
    first: usize,
    diagnostics: &mut Vec<Diagnostic>,
) -> Vec<Vec<usize>> {
    let edges: Vec<Vec<usize>> =
        definitions.iter().map(|definition| own_dependencies(definition, first)).collect();
    let edges: Vec<&[usize]> = edges.iter().map(Vec::as_slice).collect();
    let mut components = components(&edges);
    let mut cycles: Vec<Vec<usize>> = components
        .iter()
        .filter(|component| {
            let is_loop = component.len() > 1 || edges[component[0]].contains(&component[0]);
            let is_functions = component
                .iter()
                .all(|&idx| matches!(definitions[idx].role, DefinitionRole::Function));
            is_loop && !is_functions
        })
        .cloned()
        .collect();
    for component in &mut cycles {
        component.sort_unstable();
        diagnostics.push(report(definitions, &circle(component, &edges)));
        for &idx in component.iter() {
            definitions[idx].is_poisoned = true;
        }
    }
    components.iter_mut().flatten().for_each(|idx| *idx += first);
    components
}

/// What a definition uses of those numbered from `first`, counted from there.
fn own_dependencies(definition: &Definition, first: usize) -> Vec<usize> {
    definition.dependencies.iter().filter_map(|used| used.definition.checked_sub(first)).collect()
}

/// A vertex under way: the vertex and the next edge to look at.
struct Visit {
    vertex: usize,
    next_edge: usize,
}

/// Strongly connected components, each after those that it has edges to.
pub(super) fn components(edges: &[&[usize]]) -> Vec<Vec<usize>> {
    const UNSEEN: usize = usize::MAX;
    let n = edges.len();
    let (mut index, mut low, mut on_stack) = (vec![UNSEEN; n], vec![0; n], vec![false; n]);
    let (mut stack, mut found, mut n_seen) = (Vec::new(), Vec::new(), 0);
    for root in 0..n {
        if index[root] != UNSEEN {
            continue;
        }
        let mut path = vec![Visit { vertex: root, next_edge: 0 }];
        while let Some(visit) = path.last_mut() {
            let vertex = visit.vertex;
            if visit.next_edge == 0 {
                index[vertex] = n_seen;
                low[vertex] = n_seen;
                n_seen += 1;
                stack.push(vertex);
                on_stack[vertex] = true;
            }
            if let Some(&target) = edges[vertex].get(visit.next_edge) {
                visit.next_edge += 1;
                if index[target] == UNSEEN {
                    path.push(Visit { vertex: target, next_edge: 0 });
                } else if on_stack[target] {
                    low[vertex] = low[vertex].min(index[target]);
                }
                continue;
            }
            path.pop();
            if let Some(parent) = path.last() {
                low[parent.vertex] = low[parent.vertex].min(low[vertex]);
            }
            if low[vertex] == index[vertex] {
                found.push(take_component(vertex, &mut stack, &mut on_stack));
            }
        }
    }
    found
}

fn take_component(root: usize, stack: &mut Vec<usize>, on_stack: &mut [bool]) -> Vec<usize> {
    let mut component = Vec::new();
    while let Some(vertex) = stack.pop() {
        on_stack[vertex] = false;
        component.push(vertex);
        if vertex == root {
            break;
        }
    }
    component
}

/// A shortest circle through the first member of a component.
fn circle(component: &[usize], edges: &[&[usize]]) -> Vec<usize> {
    let start = component[0];
    let mut came_from = vec![None; component.len()];
    let mut queue = VecDeque::from([start]);
    while let Some(vertex) = queue.pop_front() {
        for &target in edges[vertex] {
            let Ok(place) = component.binary_search(&target) else { continue };
            if target == start {
                let mut path = vec![vertex];
                while let Some(&last) = path.last().filter(|&&last| last != start) {
                    let Some(before) =
                        component.binary_search(&last).ok().and_then(|at| came_from[at])
                    else {
                        break;
                    };
                    path.push(before);
                }
                path.reverse();
                return path;
            }
            if came_from[place].is_none() {
                came_from[place] = Some(vertex);
                queue.push_back(target);
            }
        }
    }
    component.to_vec()
}

/// Definitions of a circle that are shown; the rest is counted.
const MOST_SHOWN: usize = 6;

fn report(definitions: &[Definition], circle: &[usize]) -> Diagnostic {
    let first = &definitions[circle[0]];
    if let [only] = circle {
        let name = &definitions[*only].name;
        return Diagnostic::error(
            Code::Cycle,
            first.name_span,
            format!("`{name}` is defined by itself"),
        )
        .label("its own definition uses it")
        .hint("only functions (`fn`) may use themselves");
    }
    let names: Vec<String> = circle
        .iter()
        .take(MOST_SHOWN)
        .chain(&circle[..1])
        .map(|&idx| format!("`{}`", definitions[idx].name))
        .collect();
    let dots = if circle.len() > MOST_SHOWN {
        format!(" (and {} more)", circle.len() - MOST_SHOWN)
    } else {
        String::new()
    };
    let mut diagnostic = Diagnostic::error(
        Code::Cycle,
        first.name_span,
        format!("definitions go round in a circle: {}{dots}", names.join(" → ")),
    );
    for (&user, &used) in circle.iter().zip(circle.iter().cycle().skip(1)).take(MOST_SHOWN) {
        let text = format!("`{}` uses `{}`", definitions[user].name, definitions[used].name);
        diagnostic = if user == circle[0] {
            diagnostic.label(text)
        } else {
            diagnostic.also(definitions[user].name_span, text)
        };
    }
    diagnostic.hint("break the circle: one of them must stand without the others")
}
