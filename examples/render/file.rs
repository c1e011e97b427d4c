//! Reads a scene from its file. An error names the file, the line and the field.

use crate::Failure;
use crate::render::description::Scene;
use ron::extensions::Extensions;
use ron::{Deserializer, Options};
use std::fs;
use std::path::{Path, PathBuf};

/// Where scenes are that are given by a name.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

/// The names of the scenes that come with the renderer.
pub fn names() -> Vec<String> {
    let files = fs::read_dir(folder()).into_iter().flatten().flatten().map(|entry| entry.path());
    let scenes = files.filter(|path| path.extension().is_some_and(|end| end == "ron"));
    let mut names: Vec<_> =
        scenes.filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned())).collect();
    names.sort();
    names
}

/// The file of a scene's name, or of a path that ends in `.ron`; and its text.
pub fn text(name: &str) -> Result<(PathBuf, String), Failure> {
    let own = names().iter().any(|known| known == name);
    let path = if own { folder().join(name).with_extension("ron") } else { PathBuf::from(name) };
    let refused = |wrong: &str| {
        let accepted = names().join(", ");
        Failure::Usage(format!(
            "--scene: {wrong}; accepted: {accepted}, or the path of a .ron file"
        ))
    };
    if path.extension().is_none_or(|end| end != "ron") {
        return Err(refused(&format!("{name:?} is not a scene")));
    }
    match fs::read_to_string(&path) {
        Ok(text) => Ok((path, text)),
        Err(error) => Err(refused(&format!("cannot read {}: {error}", path.display()))),
    }
}

/// The scene of a file's text.
pub fn scene(path: &Path, text: &str) -> Result<Scene, Failure> {
    parsed(text).map_err(|wrong| Failure::Usage(format!("--scene: {}:{wrong}", path.display())))
}

/// The scene of a text, or the line and column, field and what is wrong.
pub fn parsed(text: &str) -> Result<Scene, String> {
    let options = Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
    let at = |error: ron::error::SpannedError, field: &str| {
        let one_line = error.code.to_string().replace('\n', " ");
        format!("{}:{field} {one_line}", error.span.start)
    };
    let mut reader =
        Deserializer::from_str_with_options(text, &options).map_err(|error| at(error, ""))?;
    let scene = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        // Of the text as a whole there is none.
        let field = match error.path().to_string().as_str() {
            "." | "?" => String::new(),
            field => format!(" {field}:"),
        };
        at(reader.span_error(error.into_inner()), &field)
    })?;
    reader.end().map_err(|error| at(reader.span_error(error), ""))?;
    Ok(scene)
}
