//! A part: the file of a shard.
//!
//! One line of text says what it is: the format, and a RON value with the program, the job, which
//! shard of how many it is, which range of the job that is, and how many bytes follow. Those are
//! the shard's, little-endian.

use crate::job::{Job, Work};
use examples::Failure;
use examples::render::output::Output;
use examples::shard::cover::{self, Piece};
use ron::ser::PrettyConfig;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

const FORMAT: &str = "hemidisc shard, format 1: ";

/// Longer first lines are not read.
const LONGEST: u64 = 1 << 16;

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    program: String,
    job: Job,
    shard: u16,
    shards: u16,
    range: Range<u32>,
    bytes: u64,
}

impl Header {
    fn new(job: &Job, shard: u16, shards: u16) -> Self {
        let range = cover::range(job.len(), shard, shards);
        Self {
            program: concat!("hemidisc ", env!("CARGO_PKG_VERSION")).to_owned(),
            job: job.clone(),
            shard,
            shards,
            bytes: job.bytes(range.clone()),
            range,
        }
    }
}

/// Computes a shard and writes its part.
pub(crate) fn write(
    work: &dyn Work,
    shard: u16,
    shards: u16,
    output: Output,
) -> Result<String, Failure> {
    let header = Header::new(work.job(), shard, shards);
    output.write(|out| {
        let text = ron::to_string(&header).map_err(io::Error::other)?;
        writeln!(out, "{FORMAT}{text}")?;
        work.write(shard, shards, out)
    })
}

/// A part that was found to be whole.
pub(crate) struct Part {
    path: PathBuf,
    header: Header,
    /// Bytes of the first line.
    ahead: u64,
}

impl Part {
    /// Reads the first line of a file.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let wrong = |wrong: &str| Failure::Usage(format!("{}: {wrong}", path.display()));
        let failed = |error: io::Error| wrong(&format!("cannot be read: {error}"));
        let file = File::open(path).map_err(failed)?;
        let length = file.metadata().map_err(failed)?.len();
        let mut line = Vec::new();
        BufReader::new(file).take(LONGEST).read_until(b'\n', &mut line).map_err(failed)?;
        let text = line.strip_prefix(FORMAT.as_bytes());
        let text = text.ok_or_else(|| wrong("is not a part; accepted: what --shard I writes"))?;
        let header: Header = ron::de::from_bytes(text)
            .map_err(|error| wrong(&format!("has a broken first line: {error}")))?;

        let Header { job, shard, shards, range, bytes, .. } = &header;
        let due = (shard < shards).then(|| cover::range(job.len(), *shard, *shards));
        if due.as_ref() != Some(range) || *bytes != job.bytes(range.clone()) {
            return Err(wrong("has a broken first line: its range is not that of its shard"));
        }
        let ahead = line.len() as u64;
        match length.checked_sub(ahead) {
            Some(found) if found == *bytes => Ok(Self { path: path.to_owned(), header, ahead }),
            found => {
                let found = found.unwrap_or_default();
                Err(wrong(&format!("is not whole: {found} bytes of data, not {bytes}")))
            }
        }
    }

    pub(crate) const fn job(&self) -> &Job {
        &self.header.job
    }

    pub(crate) fn name(&self) -> String {
        self.path.display().to_string()
    }

    pub(crate) fn range(&self) -> Range<u32> {
        self.header.range.clone()
    }

    pub(crate) fn piece(&self) -> Piece {
        let Header { shard, shards, .. } = self.header;
        Piece { name: self.name(), shard, shards, range: self.range() }
    }

    /// Where a part of another job, or of another version of the program, differs first: here, and
    /// there.
    pub(crate) fn difference(&self, other: &Self) -> Option<[String; 2]> {
        let [own, others] = [self, other].map(|part| {
            // Strings, numbers and enumerations: there is nothing in it that RON has no text for.
            let job = ron::ser::to_string_pretty(part.job(), PrettyConfig::default());
            format!("program: {}\n{}", part.header.program, job.unwrap_or_default())
        });
        let mut lines = own.lines().zip(others.lines());
        let (own, others) = lines.find(|(own, others)| own != others)?;
        Some([own, others].map(|line| line.trim().trim_end_matches([',', '(']).to_owned()))
    }

    /// The bytes of the shard.
    pub(crate) fn data(&self) -> io::Result<impl Read> {
        let mut file = File::open(&self.path)?;
        file.seek(SeekFrom::Start(self.ahead))?;
        Ok(BufReader::new(file).take(self.header.bytes))
    }
}
