//! 256 pixels of a scene without effects, with each alone and with all: the cost of used effects in
//! instructions and flash, and that unused ones cost nothing.

use crate::Visitor;
use core::hint::black_box;
use hemidisc::arithmetic::Root;
use testkit::golden::bare;
use testkit::golden::render::{self as scenes, Visitor as SceneVisitor};
use testkit::tracer::{Ambient, Lens, Light, Reflection, Renderer, Source};

/// Takes four rows of 64 pixels, across sky, balls and table.
struct Rows<'a>(&'a mut [[f32; 3]]);

impl Rows<'_> {
    fn each(&mut self, mut row: impl FnMut(u32, &mut [[f32; 3]])) {
        self.0.fill([0.0; 3]);
        for (pixels, y) in self.0.chunks_mut(64).zip([6, 18, 30, 42]) {
            row(y, pixels);
        }
    }
}

impl<A: Root<Real = f32>> SceneVisitor<A> for Rows<'_> {
    fn scene<L: Lens<A>, S: Light<A>, O: Ambient<A>, G: Reflection<A>>(
        &mut self,
        _: &'static str,
        scene: Renderer<'_, A, L, S, O, G, impl Source>,
    ) {
        self.each(|y, row| {
            scene.row([0, y], 0..1, row);
        });
    }
}

/// A scene, a function under its path. The scene is built in it, which is little beside 256 pixels.
macro_rules! scene {
    ($visitor:ident, $path:expr, |$exponents:ident, $rows:ident| $build:expr) => {{
        #[unsafe(export_name = $path)]
        #[inline(never)]
        fn fill($exponents: [f32; 2], pixels: &mut [[f32; 3]]) -> usize {
            let count = pixels.len();
            let $rows = &mut Rows(pixels);
            if $build.is_ok() { count } else { 0 }
        }
        let exponents = black_box([3000.0, 30.0]);
        $visitor.points($path, |_, pixels| fill(exponents, pixels));
    }};
}

/// The scenes of an arithmetic.
macro_rules! scenes {
    ($visitor:ident $name:literal $arithmetic:ident) => {
        scene!($visitor, concat!("render/plain/", $name), |_none, rows| {
            scenes::plain::<$arithmetic>(rows)
        });
        scene!($visitor, concat!("render/lens/", $name), |_none, rows| {
            scenes::with_lens::<$arithmetic>(rows)
        });
        scene!($visitor, concat!("render/light/", $name), |_none, rows| {
            scenes::with_light::<$arithmetic>(rows)
        });
        scene!($visitor, concat!("render/occlusion/", $name), |_none, rows| {
            scenes::with_occlusion::<$arithmetic>(rows)
        });
        scene!($visitor, concat!("render/glossy/", $name), |exponents, rows| {
            scenes::with_gloss::<$arithmetic>(exponents, rows)
        });
        scene!($visitor, concat!("render/still-life/", $name), |exponents, rows| {
            scenes::still_life::<$arithmetic>(exponents, rows)
        });
    };
}

/// The plain scene by a renderer without effects.
macro_rules! bare {
    ($visitor:ident $name:literal $arithmetic:ident) => {
        scene!($visitor, concat!("render/bare/", $name), |_none, rows| {
            scenes::with_bare::<$arithmetic>(|scene| {
                rows.each(|y, row| {
                    bare::row(&scene, [0, y], 0..1, row);
                })
            })
        });
    };
}

/// Scenes in the arithmetics of which boards have pictures.
macro_rules! arithmetics {
    ($visitor:ident $scenes:ident $(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident $($facts:tt)*);
    )*) => {
        $(arithmetics!(@ $boards $visitor $scenes $name $arithmetic);)*
    };
    (@ pictures $visitor:ident $scenes:ident $name:literal $arithmetic:ident) => {{
        use hemidisc::$arithmetic;
        $scenes!($visitor $name $arithmetic);
    }};
    (@ fills $visitor:ident $scenes:ident $name:literal $arithmetic:ident) => {};
    (@ digests $visitor:ident $scenes:ident $name:literal $arithmetic:ident) => {};
    (@ nothing $visitor:ident $scenes:ident $name:literal $arithmetic:ident) => {};
}

pub(crate) fn every(visitor: &mut impl Visitor) {
    hemidisc::for_each_arithmetic!(arithmetics visitor scenes);
    hemidisc::for_each_arithmetic!(arithmetics visitor bare);
}
