//! A file that is written completely or not at all, and standard output.
//!
//! It is written under another name beside its own and renamed at the end, so that a reader during
//! the write, or after a crash, finds the old file. A device or a pipe is written directly.

use crate::Failure;
use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

pub struct Output {
    name: String,
    path: PathBuf,
    file: BufWriter<Target>,
}

enum Target {
    Renamed(NamedTempFile),
    Direct(File),
}

impl Output {
    /// Makes the file, and its folder if it is not there.
    pub fn create(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        // Of a link what it leads to is replaced, and not the link.
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        match Target::create(&path) {
            Ok(file) => Ok(Self { name, path, file: BufWriter::new(file) }),
            Err(error) => Err(Failure::Usage(format!("--out: cannot write {name}: {error}"))),
        }
    }

    /// A folder with as much room as there is for the file.
    pub fn folder(&self) -> PathBuf {
        match self.file.get_ref() {
            Target::Renamed(file) => file.path().parent().map(Path::to_owned).unwrap_or_default(),
            Target::Direct(_) => std::env::temp_dir(),
        }
    }

    /// Fills the file by a function, gives it its name and returns that.
    pub fn write(
        mut self,
        fill: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<String, Failure> {
        let written = fill(&mut self.file)
            .and_then(|()| self.file.into_inner().map_err(io::IntoInnerError::into_error))
            .and_then(|target| target.keep(&self.path));
        match written {
            Ok(()) => Ok(self.name),
            Err(error) => Err(Failure::Output(self.name, error)),
        }
    }
}

impl Target {
    fn create(path: &Path) -> io::Result<Self> {
        if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            return Ok(Self::Direct(File::create(path)?));
        }
        let named = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = named.unwrap_or(Path::new("."));
        fs::create_dir_all(folder)?;
        let mut builder = tempfile::Builder::new();
        // As for any new file, less the process's mask; not for the owner alone.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        builder.tempfile_in(folder).map(Self::Renamed)
    }

    fn keep(self, path: &Path) -> io::Result<()> {
        match self {
            Self::Renamed(file) => file.persist(path).map(drop).map_err(|error| error.error),
            Self::Direct(_) => Ok(()),
        }
    }
}

impl Write for Target {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::Renamed(file) => file.write(bytes),
            Self::Direct(file) => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Renamed(file) => file.flush(),
            Self::Direct(file) => file.flush(),
        }
    }
}

/// Prints a text; a reader that has seen enough of it (`| head`) is no error.
pub fn say(text: &str) -> Result<(), Failure> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::Output("standard output".into(), error))
        }
        _ => Ok(()),
    }
}
