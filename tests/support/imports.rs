//! Which file of a crate uses which: paths as the compiler reads them, resolved through `pub use`, without test code.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, Item, UseTree, visit::Visit};

/// File by file the files that it uses, with the names that it uses of them.
pub type Arrows = BTreeMap<String, BTreeMap<String, BTreeSet<String>>>;

/// The arrows of a crate, from its root file; files are named relative to the root file's folder.
pub fn arrows(root: &Path) -> Arrows {
    let folder = root.parent().unwrap().to_owned();
    let mut house = House { folder: folder.clone(), ..House::default() };
    house.read(root, &folder, None);
    let mut arrows = Arrows::new();
    for module in &house.modules {
        arrows.entry(module.file.clone()).or_default();
    }
    for at in 0..house.modules.len() {
        let module = &house.modules[at];
        for path in &module.paths {
            if let Some(Found::Item(file, name)) = house.resolve(at, path, 0).filter(|found| !found.is_of(&module.file)) {
                arrows.get_mut(&module.file).unwrap().entry(file).or_default().insert(name);
            }
        }
    }
    arrows
}

/// The circles: sets of files each of which leads to all others.
pub fn circles(arrows: &Arrows) -> Vec<BTreeSet<String>> {
    let reached: BTreeMap<&str, BTreeSet<&str>> = arrows.keys().map(|from| (from.as_str(), reach(arrows, from))).collect();
    let mut circles: Vec<BTreeSet<String>> = Vec::new();
    for (from, to) in &reached {
        if !to.contains(from) || circles.iter().any(|circle| circle.contains(*from)) {
            continue;
        }
        circles.push(to.iter().filter(|other| reached[*other].contains(from)).map(|file| (*file).to_owned()).collect());
    }
    circles
}

/// All files that a file leads to, itself only over others.
fn reach<'a>(arrows: &'a Arrows, from: &str) -> BTreeSet<&'a str> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&str> = arrows[from].keys().map(String::as_str).collect();
    while let Some(file) = open.pop() {
        if found.insert(file) {
            open.extend(arrows[file].keys().map(String::as_str));
        }
    }
    found
}

#[derive(Default)]
struct House {
    folder: PathBuf,
    modules: Vec<Module>,
}

#[derive(Default)]
struct Module {
    file: String,
    parent: Option<usize>,
    children: BTreeMap<String, usize>,
    /// What is defined here.
    items: BTreeSet<String>,
    /// What is imported, and from where.
    imports: BTreeMap<String, Vec<String>>,
    /// Modules all of whose names are imported.
    globs: Vec<Vec<String>>,
    /// Every path in the code, private imports included.
    paths: BTreeSet<Vec<String>>,
}

enum Found {
    Module(usize),
    /// Defined in this file, under this name.
    Item(String, String),
}

impl Found {
    fn is_of(&self, this: &str) -> bool {
        matches!(self, Self::Item(file, _) if file == this)
    }
}

impl House {
    /// Reads a file, and those of its modules, which lie in `folder`.
    fn read(&mut self, file: &Path, folder: &Path, parent: Option<usize>) -> usize {
        let text = fs::read_to_string(file).unwrap_or_else(|problem| panic!("{}: {problem}", file.display()));
        let parsed = syn::parse_file(&text).unwrap_or_else(|problem| panic!("{}: {problem}", file.display()));
        let name = file.strip_prefix(&self.folder).unwrap().to_string_lossy().replace('\\', "/");
        self.enter(&name, parsed.items, folder, parent)
    }

    fn enter(&mut self, file: &str, items: Vec<Item>, folder: &Path, parent: Option<usize>) -> usize {
        let at = self.modules.len();
        self.modules.push(Module { file: file.to_owned(), parent, ..Module::default() });
        for item in items {
            if is_test(attributes(&item)) {
                continue;
            }
            let module = &mut self.modules[at];
            match item {
                Item::Mod(child) => {
                    let name = child.ident.to_string();
                    let inside = folder.join(&name);
                    let number = if let Some((_, items)) = child.content {
                        self.enter(file, items, &inside, Some(at))
                    } else {
                        let flat = folder.join(format!("{name}.rs"));
                        let path = if flat.exists() { flat } else { inside.join("mod.rs") };
                        self.read(&path, &inside, Some(at))
                    };
                    self.modules[at].children.insert(name, number);
                }
                Item::Use(import) => {
                    // A private import is a use; one that hands on is none.
                    let private = matches!(import.vis, syn::Visibility::Inherited);
                    module.import(&import.tree, &mut Vec::new(), private);
                }
                other => {
                    module.items.extend(defined(&other));
                    let mut inner = Inner(Vec::new());
                    inner.visit_item(&other);
                    inner.0.iter().for_each(|tree| module.import(tree, &mut Vec::new(), true));
                    paths(other.into_token_stream(), &mut module.paths);
                }
            }
        }
        at
    }

    fn resolve(&self, from: usize, path: &[String], depth: usize) -> Option<Found> {
        if depth > 20 {
            return None;
        }
        let mut at = from;
        let mut rest = path;
        match rest.first()?.as_str() {
            "crate" => {
                at = 0;
                rest = &rest[1..];
            }
            "self" => rest = &rest[1..],
            _ => {}
        }
        while rest.first().is_some_and(|name| name == "super") {
            at = self.modules[at].parent?;
            rest = &rest[1..];
        }
        let mut found = Found::Module(at);
        while let (Found::Module(at), Some((name, after))) = (&found, rest.split_first()) {
            found = self.named(*at, name, depth)?;
            rest = after;
        }
        Some(found)
    }

    /// What a name means in a module.
    fn named(&self, at: usize, name: &str, depth: usize) -> Option<Found> {
        let module = &self.modules[at];
        if let Some(child) = module.children.get(name) {
            return Some(Found::Module(*child));
        }
        if module.items.contains(name) {
            return Some(Found::Item(module.file.clone(), name.to_owned()));
        }
        if let Some(path) = module.imports.get(name) {
            // `use name;` of another crate.
            return if path.len() == 1 && path[0] == name { None } else { self.resolve(at, path, depth + 1) };
        }
        module.globs.iter().find_map(|glob| match self.resolve(at, glob, depth + 1)? {
            Found::Module(of) if of != at => self.named(of, name, depth + 1),
            _ => None,
        })
    }
}

impl Module {
    fn import(&mut self, tree: &UseTree, before: &mut Vec<String>, private: bool) {
        match tree {
            UseTree::Path(path) => {
                before.push(path.ident.to_string());
                self.import(&path.tree, before, private);
                before.pop();
            }
            UseTree::Name(name) => self.bind(name.ident.to_string(), before, &name.ident.to_string(), private),
            UseTree::Rename(name) => self.bind(name.rename.to_string(), before, &name.ident.to_string(), private),
            UseTree::Glob(_) => self.globs.push(before.clone()),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.import(tree, before, private)),
        }
    }

    fn bind(&mut self, known_as: String, before: &[String], name: &str, private: bool) {
        let mut path = before.to_vec();
        let known_as = if name == "self" { before.last().cloned().unwrap_or(known_as) } else { known_as };
        if name != "self" {
            path.push(name.to_owned());
        }
        if private {
            self.paths.insert(path.clone());
        }
        self.imports.insert(known_as, path);
    }
}

/// Imports inside of functions.
struct Inner<'a>(Vec<&'a UseTree>);

impl<'a> Visit<'a> for Inner<'a> {
    fn visit_item_use(&mut self, import: &'a syn::ItemUse) {
        self.0.push(&import.tree);
    }
}

/// `a::b::c` anywhere in the code, in macros too.
fn paths(tokens: TokenStream, out: &mut BTreeSet<Vec<String>>) {
    let mut path: Vec<String> = Vec::new();
    // Colons since the last name, and whether a dot or colons lead to it that are no path's.
    let (mut colons, mut foreign) = (0, false);
    for token in tokens {
        match token {
            TokenTree::Ident(name) => {
                if colons != 2 {
                    flush(&mut path, out);
                }
                if !foreign {
                    path.push(name.to_string());
                }
                (colons, foreign) = (0, false);
            }
            TokenTree::Punct(mark) if mark.as_char() == ':' => colons += 1,
            TokenTree::Punct(mark) => {
                flush(&mut path, out);
                (colons, foreign) = (0, mark.as_char() == '.');
            }
            TokenTree::Group(group) => {
                flush(&mut path, out);
                (colons, foreign) = (0, false);
                paths(group.stream(), out);
            }
            TokenTree::Literal(_) => {
                flush(&mut path, out);
                (colons, foreign) = (0, false);
            }
        }
    }
    flush(&mut path, out);
}

fn flush(path: &mut Vec<String>, out: &mut BTreeSet<Vec<String>>) {
    if !path.is_empty() && path[0] != "Self" {
        out.insert(std::mem::take(path));
    }
    path.clear();
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg") && attribute.meta.to_token_stream().to_string().replace(' ', "").starts_with("cfg(test)")
    })
}

fn defined(item: &Item) -> Option<String> {
    Some(match item {
        Item::Const(item) => item.ident.to_string(),
        Item::Enum(item) => item.ident.to_string(),
        Item::Fn(item) => item.sig.ident.to_string(),
        Item::Macro(item) => item.ident.as_ref()?.to_string(),
        Item::Static(item) => item.ident.to_string(),
        Item::Struct(item) => item.ident.to_string(),
        Item::Trait(item) => item.ident.to_string(),
        Item::Type(item) => item.ident.to_string(),
        _ => return None,
    })
}
