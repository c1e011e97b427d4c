//! A picture by passes and parts of rows.

use super::target::Broken;
use super::{SIZES, Target};
use core::ops::Range;
use std::cell::RefCell;
use testkit::panel::picture::{PASSES, draw};
use testkit::panel::scene::Objects;
use testkit::panel::srgb::encode;

/// Light that tells the pixels of a panel apart, for the first of the samples alone.
fn pattern([x, y]: [u32; 2], samples: Range<u32>, sums: &mut [[f32; 3]]) {
    for (x, sum) in (x..).zip(sums).filter(|_| samples.start == 0) {
        *sum = [x % 7, y % 11, x / 7 + y / 11].map(|k| samples.len() as f32 * k as f32 / 64.0);
    }
}

#[test]
fn passes_come_to_the_picture_rendered_at_once() -> Result<(), Broken> {
    let objects = Objects::new().unwrap();
    for size in [[160, 128], [101, 53]] {
        let scene = objects.still_life(size, 3).unwrap();
        let [width, height] = size;
        let mut whole = Vec::new();
        for y in 0..height {
            let mut row = vec![[0.0; 3]; width as usize];
            scene.row([0, y], 0..3, &mut row);
            whole.extend(row.into_iter().map(|sum| encode(sum.map(|sum| sum * (1.0 / 3.0)))));
        }
        let mut target = Target::new(size);
        for pass in PASSES {
            draw(&mut target, pass, 3, |from, samples, sums| {
                scene.row(from, samples, sums);
            })?;
        }
        assert_eq!(target.pixels(), whole);
    }
    Ok(())
}

#[test]
fn each_pass_covers_the_panel_with_the_nearest_rows_above() -> Result<(), Broken> {
    for size in SIZES {
        let mut target = Target::new(size);
        for (pass, tall) in PASSES.into_iter().zip([8, 4, 2, 1]) {
            draw(&mut target, pass, 2, pattern)?;
            for (x, y) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y))) {
                let mut light = [[0.0; 3]];
                pattern([x, y / tall * tall], 0..1, &mut light);
                assert_eq!(target.at(x, y), encode(light[0]), "({x}, {y}) of {size:?}");
            }
        }
    }
    Ok(())
}

#[test]
fn no_pixel_is_rendered_twice() -> Result<(), Broken> {
    for size in SIZES {
        let rendered = RefCell::new(Vec::new());
        for pass in PASSES {
            draw(&mut Target::new(size), pass, 4, |[x, y], samples, sums| {
                assert_eq!(samples, 0..4);
                rendered.borrow_mut().extend((x..).zip(sums).map(|(x, _)| (y, x)));
            })?;
        }
        let mut rendered = rendered.into_inner();
        rendered.sort_unstable();
        let every = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (y, x)));
        assert!(rendered.into_iter().eq(every), "{size:?}");
    }
    Ok(())
}

#[test]
fn an_error_ends_the_drawing_and_comes_through() -> Result<(), Broken> {
    let mut whole = Target::new([101, 53]);
    for pass in PASSES {
        let before = whole.transfers;
        draw(&mut whole, pass, 1, pattern)?;
        for broken_from in 0..whole.transfers - before {
            let mut target = Target::broken([101, 53], broken_from);
            assert_eq!(draw(&mut target, pass, 1, pattern), Err(Broken(broken_from)));
            assert_eq!(target.transfers, broken_from + 1);
        }
    }
    // Two parts of each row.
    assert_eq!(whole.transfers, 2 * 53);
    Ok(())
}
