//! A picture as sRGB bytes (IEC 61966-2-1) in a PNG file.

use std::io::{self, Write};

/// Clamped, with sRGB's curve, rounded.
pub fn bytes(pixels: &[[f64; 3]]) -> Vec<u8> {
    let byte = |linear: &f64| {
        let linear = linear.clamp(0.0, 1.0);
        let curved = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            // Not the system's power: the bytes are the same on every machine.
            1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
        };
        (255.0 * curved).round() as u8
    };
    pixels.iter().flatten().map(byte).collect()
}

/// Writes the file.
pub fn png(out: &mut dyn Write, [width, height]: [u32; 2], pixels: &[[f64; 3]]) -> io::Result<()> {
    let mut encoder = png::Encoder::new(out, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes(pixels))?;
    writer.finish().map_err(io::Error::from)
}
