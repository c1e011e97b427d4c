//! Points from Q15 to pixels.

use super::target::Broken;
use super::{SIZES, Target};
use embedded_graphics::prelude::*;
use hemidisc::sequence::{Correlated, Halton, Jittered, NRooks, Random, Sequence, SobolOwen};
use hemidisc::{Concentric, Points, Q15};
use std::collections::BTreeSet;
use testkit::panel::discs::{COUNT, DISCS, DOT, SEED, cells, disc, draw, pixel};

#[test]
fn any_16_bits_are_in_the_disc_s_box() {
    for cell in SIZES.into_iter().flat_map(|size| cells(Target::new(size).bounding_box())) {
        let disc = disc(cell);
        let area = disc.bounding_box();
        for bits in i16::MIN..=i16::MAX {
            let point = pixel(disc, [bits, bits.reverse_bits()].map(Q15::from_bits));
            assert!(disc.diameter == 0 || area.contains(point), "{bits} at {point} of {disc:?}");
        }
    }
}

/// The pixels of a set that is computed anew, in real numbers.
fn expected<S: Sequence>(size: [u32; 2], index: usize, sequence: S) -> BTreeSet<[i32; 2]> {
    let disc = cells(Target::new(size).bounding_box()).nth(index).map(disc).unwrap();
    let (radius, [left, top]) = (f64::from(disc.diameter) / 2.0, disc.top_left.into());
    let count = if disc.diameter == 0 { 0 } else { COUNT as u32 };
    let points = Points::new(sequence, Concentric::<Q15>::new()).take(count).unwrap();
    let pixels = points.iter().map(|point| {
        let [across, up] = point.map(|component| (radius * (1.0 + component.to_f64())).floor());
        // A pixel's centre is at most half a diagonal further out than the point.
        let from_centre = [across, up].map(|corner| corner + 0.5 - radius);
        assert!(from_centre[0].hypot(from_centre[1]) <= radius + 0.708, "{point:?}");
        [left + across as i32, top + (2.0 * radius - 1.0 - up) as i32]
    });
    pixels.collect()
}

#[test]
fn every_point_is_in_its_pixel_and_no_other_pixel_is_lit() -> Result<(), Broken> {
    for size in SIZES {
        let mut target = Target::new(size);
        draw(&mut target)?;
        let drawn: BTreeSet<[i32; 2]> = target.of(DOT).map(Into::into).collect();
        let all = [
            expected(size, 0, Random::new(SEED)),
            expected(size, 1, Jittered::new(16, 16, SEED).unwrap()),
            expected(size, 2, NRooks::new(256, SEED).unwrap()),
            expected(size, 3, Correlated::new(16, 16, SEED).unwrap()),
            expected(size, 4, Halton::new()),
            expected(size, 5, SobolOwen::new(SEED)),
        ];
        let all: BTreeSet<_> = all.into_iter().flatten().collect();
        let differ: Vec<_> = drawn.symmetric_difference(&all).collect();
        assert!(differ.is_empty(), "{size:?}: {differ:?}");
    }
    Ok(())
}

#[test]
fn an_error_ends_the_drawing_and_comes_through() -> Result<(), Broken> {
    let mut whole = Target::new([160, 128]);
    draw(&mut whole)?;
    // The background, and for each disc at least a rim, points and a caption.
    assert!(whole.transfers > 3 * DISCS.len());
    for broken_from in 0..whole.transfers {
        let mut target = Target::broken([160, 128], broken_from);
        assert_eq!(draw(&mut target), Err(Broken(broken_from)));
        assert_eq!(target.transfers, broken_from + 1);
    }
    Ok(())
}
