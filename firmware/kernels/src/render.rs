//! 256 pixels of a scene that calls for no effect, and of the same one with all: what effects cost in instructions
//! and in flash where they are, and that they cost nothing where they are not.

use crate::Visitor;
use crate::scenes::{self, Visitor as SceneVisitor};
use crate::tracer::{Ambient, Lens, Light, Points, Reflection, Renderer};
use core::hint::black_box;
use hemidisc::arithmetic::Root;
use hemidisc::{FastF32, MicromathF32};

/// Takes four rows of 64 pixels, across sky, balls and table.
struct Rows<'a>(&'a mut [[f32; 3]]);

impl<A: Root<Real = f32>> SceneVisitor<A> for Rows<'_> {
    fn scene<L: Lens<A>, S: Light<A>, O: Ambient<A>, G: Reflection<A>>(
        &mut self,
        _: &'static str,
        scene: Renderer<'_, A, L, S, O, G, impl Points>,
    ) {
        self.0.fill([0.0; 3]);
        for (row, y) in self.0.chunks_mut(64).zip([6, 18, 30, 42]) {
            scene.row([0, y], 0..1, row);
        }
    }
}

/// The scenes of an arithmetic, each a function under its path. The scene is built in it, which is little beside
/// 256 pixels.
macro_rules! scenes {
    ($visitor:ident: $($name:literal $arithmetic:ident;)*) => {$(
        {
            #[unsafe(export_name = concat!("render/plain/", $name))]
            #[inline(never)]
            fn fill(pixels: &mut [[f32; 3]]) -> usize {
                let built = scenes::plain::<$arithmetic>(&mut Rows(pixels));
                if built.is_ok() { pixels.len() } else { 0 }
            }
            $visitor.points(concat!("render/plain/", $name), |_, pixels| fill(pixels));
        }
        {
            #[unsafe(export_name = concat!("render/still-life/", $name))]
            #[inline(never)]
            fn fill(exponents: [f32; 2], pixels: &mut [[f32; 3]]) -> usize {
                let built = scenes::still_life::<$arithmetic>(exponents, &mut Rows(pixels));
                if built.is_ok() { pixels.len() } else { 0 }
            }
            let exponents = black_box([3000.0, 30.0]);
            $visitor.points(concat!("render/still-life/", $name), |_, pixels| fill(exponents, pixels));
        }
    )*};
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    scenes! {
        visitor:
        "fast-f32" FastF32;
        "micromath-f32" MicromathF32;
    }
}
