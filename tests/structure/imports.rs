//! The files of a crate, and which of them imports which.
//!
//! An import is a `use` or a path from `crate`, `super` or `self`. It leads to the file that
//! defines what it names: re-exports are followed. A module's re-export of what is below it is no
//! import, nor is what tests alone have.

use crate::tokens::{Token, tokens};
use std::collections::{BTreeMap, BTreeSet};

/// Files by their paths from the repository's root, with `/`.
pub type Files = BTreeMap<String, String>;

/// A path in the code, such as `crate`, `map`, `Map`.
type Path = Vec<String>;

/// A `use` of one name.
struct Use {
    path: Path,
    /// What it is called here; `*` for all.
    name: String,
    public: bool,
}

/// A module of a file, or one written within it.
#[derive(Default)]
struct Module {
    file: String,
    children: BTreeMap<String, Path>,
    uses: Vec<Use>,
    /// Paths in the code that begin with `crate`, `super` or `self`.
    inline: Vec<Path>,
}

/// The modules of a crate by their paths; the root's is empty.
type Modules = BTreeMap<Path, Module>;

/// Reads the module of a file, and those that it declares.
fn read(files: &Files, file: &str, at: Path, modules: &mut Modules) {
    let Some(source) = files.get(file) else { panic!("{file} is not there") };
    let (folder, name) = file.rsplit_once('/').unwrap_or(("", file));
    let folder = match name {
        "lib.rs" | "main.rs" | "mod.rs" => folder.to_owned(),
        _ => format!("{folder}/{}", name.trim_end_matches(".rs")),
    };
    let mut parser = Parser { files, modules, file, tokens: tokens(source), next: 0 };
    parser.module(at, &folder);
}

/// The modules and files of a folder, but for those of folders in it.
fn beside(files: &Files, folder: &str) -> Vec<(String, String)> {
    let within = files.keys().filter_map(|file| {
        let name = file.strip_prefix(folder)?.strip_prefix('/')?.strip_suffix(".rs")?;
        (!name.contains('/') && folder.starts_with("src/")).then(|| (name.to_owned(), file.clone()))
    });
    within.collect()
}

struct Parser<'a> {
    files: &'a Files,
    modules: &'a mut Modules,
    file: &'a str,
    tokens: Vec<Token>,
    next: usize,
}

impl Parser<'_> {
    fn peek(&self, ahead: usize) -> Option<&Token> {
        self.tokens.get(self.next + ahead)
    }

    fn sees(&self, ahead: usize, text: &str) -> bool {
        self.peek(ahead).is_some_and(|token| token.is(text))
    }

    fn word(&self, ahead: usize) -> Option<String> {
        match self.peek(ahead) {
            Some(Token::Word(word)) => Some(word.clone()),
            _ => None,
        }
    }

    /// Whether a path goes on with `::`.
    fn continues(&self, ahead: usize) -> bool {
        self.sees(ahead, ":") && self.sees(ahead + 1, ":")
    }

    /// Passes a bracket with all that is in it.
    fn pass(&mut self) {
        let mut depth = 0;
        while let Some(token) = self.peek(0) {
            match token {
                Token::Sign('(' | '[' | '{') => depth += 1,
                Token::Sign(')' | ']' | '}') => depth -= 1,
                _ => {}
            }
            self.next += 1;
            if depth == 0 {
                return;
            }
        }
    }

    /// Passes an item: to the end of its first braces, or to its semicolon.
    fn pass_item(&mut self) {
        while self.peek(0).is_some() {
            if self.sees(0, ";") {
                self.next += 1;
                return;
            }
            let braces = self.sees(0, "{");
            if braces || self.sees(0, "(") || self.sees(0, "[") {
                self.pass();
                if braces {
                    return;
                }
            } else {
                self.next += 1;
            }
        }
    }

    /// Reads a module to its closing brace or to the end of the file.
    fn module(&mut self, at: Path, folder: &str) {
        let mut module = Module { file: self.file.to_owned(), ..Module::default() };
        let (mut depth, mut tests, mut elsewhere, mut public) = (0, false, false, false);
        while self.peek(0).is_some() {
            if self.sees(0, "#") {
                let start = self.next;
                self.next += 1 + usize::from(self.sees(1, "!"));
                self.pass();
                let words = &self.tokens[start..self.next];
                let has = |text: &str| words.iter().any(|token| token.is(text));
                tests |= has("test") && !has("not");
                elsewhere |= has("path");
                continue;
            }
            if tests {
                self.pass_item();
                (tests, elsewhere, public) = (false, false, false);
                continue;
            }
            if self.sees(0, "pub") {
                public = true;
                self.next += 1;
                if self.sees(0, "(") {
                    self.pass();
                }
                continue;
            }
            if self.sees(0, "use") {
                self.next += 1;
                self.import(Vec::new(), public, &mut module.uses);
            } else if self.sees(0, "mod")
                && let Some(name) = self.word(1)
            {
                let child: Path = at.iter().cloned().chain([name.clone()]).collect();
                self.next += 2;
                let folder = format!("{folder}/{name}");
                if self.sees(0, "{") {
                    self.next += 1;
                    self.module(child.clone(), &folder);
                    module.children.insert(name, child);
                } else if !elsewhere {
                    // A file of another crate's, which a `#[path]` names, is none of this tree.
                    let nested = format!("{folder}/mod.rs");
                    let file = format!("{folder}.rs");
                    let file = if self.files.contains_key(&file) { file } else { nested };
                    read(self.files, &file, child.clone(), self.modules);
                    module.children.insert(name, child);
                }
            } else if self.starts_path() {
                let mut path: Path = self.word(0).into_iter().collect();
                self.next += 1;
                while self.continues(0)
                    && let Some(word) = self.word(2)
                {
                    path.push(word);
                    self.next += 3;
                }
                module.inline.push(path);
            } else {
                depth += i32::from(self.sees(0, "{")) - i32::from(self.sees(0, "}"));
                self.next += 1;
                if depth < 0 {
                    break;
                }
            }
            (elsewhere, public) = (false, false);
        }
        // Lists declare the modules of families. `tests` are compiled for tests alone.
        if folder != "src" && self.next >= self.tokens.len() {
            for (name, file) in beside(self.files, folder) {
                if name != "tests" && !module.children.contains_key(&name) {
                    let child: Path = at.iter().cloned().chain([name.clone()]).collect();
                    read(self.files, &file, child.clone(), self.modules);
                    module.children.insert(name, child);
                }
            }
        }
        self.modules.insert(at, module);
    }

    /// `crate::`, `super::` or `self::`, but for the `$crate` of a macro.
    fn starts_path(&self) -> bool {
        let after_dollar = self.next > 0 && self.tokens[self.next - 1].is("$");
        let root = ["crate", "super", "self"].iter().any(|word| self.sees(0, word));
        root && !after_dollar && self.continues(1) && self.word(3).is_some()
    }

    /// The names of a `use`, to its end.
    fn import(&mut self, mut path: Path, public: bool, uses: &mut Vec<Use>) {
        let mut name = None;
        loop {
            if self.sees(0, "{") {
                self.next += 1;
                while !self.sees(0, "}") && self.peek(0).is_some() {
                    self.import(path.clone(), public, uses);
                    self.next += usize::from(self.sees(0, ","));
                }
                self.next += 1;
                return;
            }
            if self.sees(0, "as") {
                name = self.word(1);
                self.next += 2;
            } else if self.sees(0, "*") {
                name = Some("*".to_owned());
                self.next += 1;
            } else if let Some(word) = self.word(0) {
                // `map::{self}` is `map`.
                if path.is_empty() || word != "self" {
                    path.push(word);
                }
                self.next += 1;
            } else if self.continues(0) {
                self.next += 2;
            } else {
                let name = name.or_else(|| path.last().cloned()).unwrap_or_default();
                uses.push(Use { path, name, public });
                return;
            }
        }
    }
}

/// The module that has what a path names, seen from a module; none for another crate's.
fn resolve(modules: &Modules, from: &Path, path: &[String], depth: u32) -> Option<Path> {
    let (first, mut rest) = path.split_first()?;
    let mut at = match first.as_str() {
        "crate" => Vec::new(),
        "self" => from.clone(),
        "super" => from[..from.len().checked_sub(1)?].to_vec(),
        child => {
            rest = path;
            modules[from].children.get(child)?;
            from.clone()
        }
    };
    while let Some((name, after)) = rest.split_first() {
        let module = &modules[&at];
        if name == "super" {
            at.pop()?;
        } else if let Some(child) = module.children.get(name) {
            at = child.clone();
        } else {
            let named = module.uses.iter().find(|import| import.name == *name);
            let Some(import) = named.filter(|_| depth > 0) else { break };
            let whole: Path = import.path.iter().chain(after).cloned().collect();
            return resolve(modules, &at, &whole, depth - 1);
        }
        rest = after;
    }
    Some(at)
}

/// Which files each file of the crate with this root file imports.
pub fn imports(files: &Files, root: &str) -> BTreeMap<String, BTreeSet<String>> {
    let mut modules = Modules::new();
    read(files, root, Vec::new(), &mut modules);
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (at, module) in &modules {
        let edges = found.entry(module.file.clone()).or_default();
        let uses = module.uses.iter().map(|import| (&import.path, import.public));
        let inline = module.inline.iter().map(|path| (path, false));
        for (path, public) in uses.chain(inline) {
            let Some(target) = resolve(&modules, at, path, 8) else { continue };
            let re_export = public && target.starts_with(at);
            let file = &modules[&target].file;
            if !re_export && *file != module.file {
                edges.insert(file.clone());
            }
        }
    }
    found
}

/// The circles: sets of files each of which imports, by others, every one of the set.
pub fn circles(imports: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<BTreeSet<String>> {
    let reached = |from: &String| {
        let mut seen = BTreeSet::new();
        let mut left = vec![from];
        while let Some(file) = left.pop() {
            for next in imports.get(file).into_iter().flatten() {
                if seen.insert(next.clone()) {
                    left.push(next);
                }
            }
        }
        seen
    };
    let all: BTreeMap<_, _> = imports.keys().map(|file| (file, reached(file))).collect();
    let circle = |file: &String| -> BTreeSet<String> {
        let back = |other: &&String| all.get(other).is_some_and(|reached| reached.contains(file));
        all[file].iter().filter(back).cloned().collect()
    };
    all.keys().map(|file| circle(file)).filter(|circle| circle.len() > 1).collect()
}
