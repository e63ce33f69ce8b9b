//! `virote graph`: what depends on what, for Graphviz or as JSON.

use std::path::Path;

use serde_json::{Value as Json, json};

use super::{
    exit_status::ExitStatus,
    inspect::look,
    run_args::OutputArgs,
    standard_streams::{say, say_exactly},
};
use crate::{
    disk::{Script, ScriptFiles},
    eval::{DependencyNode, Graph},
    session::Session,
};

/// Characters of an effect that a picture shows.
const MOST_SHOWN: usize = 40;

/// The shape of each kind of node; a plural has the shape of its singular, doubled.
const SHAPES: &[(&str, &str)] = &[
    ("param", "invhouse"),
    ("fn", "hexagon"),
    ("import", "component"),
    ("let", "box"),
    ("point", "circle"),
    ("curve", "ellipse"),
    ("surface", "parallelogram"),
    ("region", "house"),
    ("face", "pentagon"),
    ("solid", "box3d"),
    ("mesh", "trapezium"),
    ("table", "cylinder"),
    ("check", "diamond"),
    ("print", "note"),
    ("export", "folder"),
];

/// `virote graph FILE [--json]`
pub(super) fn run(path: &Path, is_json: bool, talk: &OutputArgs) -> ExitStatus {
    let ask = |session: &Session, script: &Script, files: &ScriptFiles| {
        session.graph(&script.name, &script.bytes, files)
    };
    look(path, talk, ask, |script, _, graph| {
        if is_json {
            say_exactly(&format!("{:#}\n", graph_json(&script.name, graph)));
        } else {
            say(&dot(&script.name, graph));
        }
    })
}

/// The graph for Graphviz: an arrow points from what uses to what is used, and inputs are left.
fn dot(file: &str, graph: &Graph) -> String {
    let mut text = format!("digraph {} {{\n  rankdir = RL\n\n", quoted(file));
    for node in &graph.nodes {
        let (shape, n_lines) = shape(node.kind);
        let label = match &node.text {
            Some(said) => format!("{}\n{}", node.name, shortened(said)),
            None => node.name.clone(),
        };
        let label = quoted(&label);
        let lines = if n_lines > 1 { format!(", peripheries = {n_lines}") } else { String::new() };
        let name = quoted(&node.name);
        text.push_str(&format!("  {name} [label = {label}, shape = {shape}{lines}]\n"));
    }
    text.push('\n');
    for node in &graph.nodes {
        for &used in &node.uses {
            let (user, used) = (quoted(&node.name), quoted(&graph.nodes[used].name));
            text.push_str(&format!("  {user} -> {used}\n"));
        }
    }
    text.push_str("}\n");
    text
}

/// The shape of a kind, and how many lines go around it.
fn shape(kind: &str) -> (&'static str, usize) {
    let of = |word: &str| SHAPES.iter().find(|(kind, _)| *kind == word).map(|&(_, shape)| shape);
    let singular =
        kind.strip_suffix("es").and_then(of).or_else(|| kind.strip_suffix('s').and_then(of));
    match (of(kind), singular) {
        (Some(shape), _) => (shape, 1),
        (None, Some(shape)) => (shape, 2),
        (None, None) => ("box", 1),
    }
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{}…", text[..end].trim_end()),
        None => text.to_owned(),
    }
}

/// A quoted name; Graphviz knows `\"`, `\\` and, in labels, `\n`.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

fn graph_json(file: &str, graph: &Graph) -> Json {
    let node = |node: &DependencyNode| {
        let uses: Vec<&str> = node.uses.iter().map(|&idx| graph.nodes[idx].name.as_str()).collect();
        let mut json = json!({ "name": node.name, "kind": node.kind, "line": node.line });
        if let Some(text) = &node.text {
            json["text"] = json!(text);
        }
        json["uses"] = json!(uses);
        json
    };
    json!({ "file": file, "nodes": graph.nodes.iter().map(node).collect::<Vec<Json>>() })
}

#[cfg(test)]
mod tests {
    use super::shape;
    use crate::syntax::ast::Kind;

    #[test]
    fn every_kind_has_its_shape() {
        for (word, _) in Kind::ALL {
            assert!(*word == "let" || shape(word).0 != "box", "{word}");
        }
        assert_eq!((shape("mesh").1, shape("meshes").1, shape("curves").1), (1, 2, 2));
    }
}
