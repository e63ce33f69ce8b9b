//! Files that import one another in a circle cannot be read one by one.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

use super::tidy::{strip, visit};

/// The packages: a file belongs to the longest root.
const ROOTS: [&str; 3] = ["src", "src/kernel", "src/language"];

/// The rules of the grammar, which call one another as what they read holds one another: an expression
/// a block, a block statements, a statement expressions. They count as one file.
const GRAMMAR: [&str; 5] = ["body", "expression", "literal", "primary", "statement"];

/// A module by its path from the root of its package.
type Module = Vec<String>;

/// What the files of a package import of one another.
fn imports(root: &str) -> BTreeMap<Module, BTreeSet<Module>> {
    let mut paths = Vec::new();
    visit(Path::new(root), &mut paths);
    let home = |path: &str| {
        let roots = ROOTS.into_iter().filter(|root| path.starts_with(&format!("{root}/")));
        roots.max_by_key(|root| root.len())
    };
    let is_own = |path: &String| home(path) == Some(root);
    let modules: BTreeMap<Module, String> =
        paths.into_iter().filter(is_own).map(|path| (module(&path, root), path)).collect();
    let imported = |own: &Module, path: &str| {
        let text = fs::read_to_string(path).expect("UTF-8");
        let uses = used(&text).into_iter().filter_map(|path| absolute(own, &path));
        let known = uses.filter_map(|path| {
            (1..=path.len())
                .rev()
                .map(|n| path[..n].to_vec())
                .find(|head| modules.contains_key(head))
        });
        known.map(as_one).collect::<BTreeSet<_>>()
    };
    let mut all: BTreeMap<Module, BTreeSet<Module>> = BTreeMap::new();
    for (own, path) in &modules {
        let own_as_one = as_one(own.clone());
        let mut found = imported(own, path);
        found.remove(&own_as_one);
        all.entry(own_as_one).or_default().extend(found);
    }
    all
}

/// The grammar in the place of a file of its rules.
fn as_one(module: Module) -> Module {
    match &module[..] {
        [syntax, parser, rule]
            if syntax == "syntax" && parser == "parser" && GRAMMAR.contains(&&**rule) =>
        {
            ["syntax", "parser", "grammar"].map(str::to_owned).to_vec()
        }
        _ => module,
    }
}

fn module(path: &str, root: &str) -> Module {
    let below = path.trim_start_matches(root).trim_start_matches('/').trim_end_matches(".rs");
    let mut names: Module = below.split('/').map(str::to_owned).collect();
    names.pop_if(|last| last == "mod");
    names
}

/// The paths of all `use` of a file outside its tests, braces written out.
fn used(text: &str) -> Vec<Module> {
    let text = text.split("#[cfg(test)]\nmod tests").next().unwrap_or_default();
    let mut is_in_string = false;
    let code: Vec<String> = text.lines().map(|line| strip(line, &mut is_in_string)).collect();
    let mut found = Vec::new();
    for statement in code.join("\n").split(';') {
        let Some((before, tree)) = statement.rsplit_once("use ") else { continue };
        // What is handed on is not needed to read the file.
        let is_handed_on = ["pub", ")"].iter().any(|end| before.trim_end().ends_with(end));
        if !is_handed_on && (before.trim_end().is_empty() || before.ends_with(['\n', ' '])) {
            expand(&[], tree, &mut found);
        }
    }
    found
}

/// Adds the paths of a tree of imports that stands behind others.
fn expand(prefix: &[String], tree: &str, found: &mut Vec<Module>) {
    let tree = tree.trim();
    let (head, rest) = match tree.split_once('{') {
        Some((head, rest)) => (head, rest.trim_end().strip_suffix('}')),
        None => (tree, None),
    };
    let names = head.split("::").map(|name| name.split(" as ").next().unwrap_or_default().trim());
    let path: Module = prefix
        .iter()
        .cloned()
        .chain(names.filter(|name| !name.is_empty()).map(str::to_owned))
        .collect();
    let Some(rest) = rest else {
        found.push(path);
        return;
    };
    let (mut depth, mut start) = (0, 0);
    for (i, c) in rest.char_indices().chain([(rest.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                if !rest[start..i].trim().is_empty() {
                    expand(&path, &rest[start..i], found);
                }
                start = i + 1;
            }
            _ => {}
        }
    }
}

/// A path from the root of the package; a bare name may be that of a module below.
fn absolute(own: &Module, path: &[String]) -> Option<Module> {
    let n_up = path.iter().take_while(|name| *name == "super").count();
    let (head, rest): (&[String], &[String]) = match path.first()?.as_str() {
        "crate" => (&[], &path[1..]),
        "self" => (own, &path[1..]),
        "super" => (own.get(..own.len().checked_sub(n_up)?)?, &path[n_up..]),
        _ => (own, path),
    };
    Some([head, rest].concat())
}

/// A way from a module back to itself.
fn circle(imports: &BTreeMap<Module, BTreeSet<Module>>) -> Option<Vec<Module>> {
    imports.keys().find_map(|start| {
        let mut came_from: BTreeMap<&Module, &Module> = BTreeMap::new();
        let mut todo = vec![start];
        while let Some(module) = todo.pop() {
            for next in &imports[module] {
                if next == start {
                    let mut way = vec![start.clone(), module.clone()];
                    let mut at = module;
                    while let Some(before) = came_from.get(at) {
                        way.push((*before).clone());
                        at = before;
                    }
                    way.reverse();
                    return Some(way);
                }
                if !came_from.contains_key(next) {
                    came_from.insert(next, module);
                    todo.push(next);
                }
            }
        }
        None
    })
}

#[test]
fn circles_are_seen() {
    let imports = |pairs: &[(&str, &[&str])]| {
        let module = |name: &&str| vec![(*name).to_owned()];
        pairs.iter().map(|(own, used)| (module(own), used.iter().map(module).collect())).collect()
    };
    assert_eq!(circle(&imports(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])])), None);
    let way = circle(&imports(&[("a", &["b"]), ("b", &["c"]), ("c", &["b"])]));
    assert_eq!(way.expect("b and c").len(), 3);
    let text = "use super::{a::{self, B as C}, d};\nuse crate::{e, f::g};\nfn h() { self::i() }";
    let own = ["x", "y"].map(str::to_owned).to_vec();
    let paths: Vec<String> =
        used(text).iter().filter_map(|path| Some(absolute(&own, path)?.join("::"))).collect();
    assert_eq!(paths, ["x::a::self", "x::a::B", "x::d", "e", "f::g"]);
    assert!(used("pub use a::B;\npub(super) use c::D;").is_empty());
    let below = absolute(&own, &used("use z::W;")[0]);
    assert_eq!(below.expect("a path").join("::"), "x::y::z::W");
}

#[test]
fn no_two_files_import_one_another() {
    let mut complaints = Vec::new();
    for root in ROOTS {
        let imports = imports(root);
        assert!(300 < imports.values().map(BTreeSet::len).sum::<usize>(), "{root} was not read");
        let way = circle(&imports).map(|way| way.iter().map(|module| module.join("/")).collect());
        complaints.extend(way.map(|way: Vec<String>| way.join(" -> ")));
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}
