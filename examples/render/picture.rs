//! A picture as sRGB bytes (IEC 61966-2-1) in a PNG file.

use crate::Failure;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};

/// Clamped, with sRGB's curve, rounded.
pub(crate) fn bytes(pixels: &[[f64; 3]]) -> Vec<u8> {
    let byte = |linear: &f64| {
        let linear = linear.clamp(0.0, 1.0);
        let curved = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * curved).round() as u8
    };
    pixels.iter().flatten().map(byte).collect()
}

/// A file that can be written.
pub(crate) struct Output {
    path: PathBuf,
    file: File,
}

impl Output {
    /// Makes the file, and its folder if it is not there.
    pub(crate) fn create(path: &Path) -> Result<Self, Failure> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let made = folder.map_or(Ok(()), fs::create_dir_all).and_then(|()| File::create(path));
        let wrong =
            |error| Failure::Usage(format!("--out: cannot write {}: {error}", path.display()));
        Ok(Self { path: path.to_owned(), file: made.map_err(wrong)? })
    }

    /// Writes the picture, and returns its path as text.
    pub(crate) fn write(self, [width, height]: [u32; 2], bytes: &[u8]) -> Result<String, Failure> {
        let path = self.path.display().to_string();
        let mut encoder = png::Encoder::new(BufWriter::new(self.file), width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let written = encoder.write_header().and_then(|mut writer| {
            writer.write_image_data(bytes)?;
            writer.finish()
        });
        match written {
            Ok(()) => Ok(path),
            Err(error) => Err(Failure::Output(path, io::Error::other(error))),
        }
    }
}
