//! The families: each member is a line here, and all else that names every member is expanded from
//! these lists.
//!
//! `for_each_FAMILY!(callback)` calls `callback!` with the lines of the family. Words after the
//! callback go before the lines. The library declares its modules by them, and the catalogue,
//! `arbitrary`, the tests, the benches, the fuzz targets and the firmware have their members from
//! them. `cfg` lines count where the callback is expanded: a crate that expands a list has features
//! of the same names.

/// The sequences: file, type, name, and the constructor with what it takes.
///
/// `checked` constructors return a `Result`. What they take are the fields of
/// `catalogue::Parameters`.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_sequence {
    ($callback:ident $($first:tt)*) => {
        $callback! { $($first)*
            regular Regular "regular" checked new(columns, rows);
            random Random "random" total in_domain(domain);
            jittered Jittered "jittered" checked new(columns, rows, seed);
            n_rooks NRooks "nrooks" checked new(count, seed);
            multi_jittered MultiJittered "multi-jittered" checked new(columns, rows, seed);
            correlated Correlated "correlated" checked new(columns, rows, seed);
            hammersley Hammersley "hammersley" checked new(count);
            halton Halton "halton" total new();
            sobol Sobol "sobol" total new(seed);
            sobol_owen SobolOwen "sobol-owen" total in_domain(domain);
            r2 R2 "r2" total new(seed);
        }
    };
}

/// What a constructor of a sequence gives: a `checked` one's value, or its error by `?`.
#[doc(hidden)]
#[macro_export]
macro_rules! made_by {
    (checked $made:expr) => {
        $made?
    };
    (total $made:expr) => {
        $made
    };
}

/// The arithmetics: file, type, name, and whether it is of floats, which effects take.
///
/// For the tests and the boards, in parentheses:
///
/// - `const` kernels, of which tables can be made, or `runtime` ones;
/// - what the boards have of effects in it: `nothing`, `digests`, `fills` too, or `pictures` too;
/// - how many bits of a coordinate it reads;
/// - the error of its density at a given point;
/// - the crate whose version decides its bytes.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_arithmetic {
    ($callback:ident $($first:tt)*) => {
        $callback! { $($first)*
            #[cfg(feature = "libm")]
            libm_f64 LibmF64 "libm-f64" float
                (runtime digests, 32, f64::EPSILON / 2.0, Some("libm"));
            #[cfg(feature = "libm")]
            libm_f32 LibmF32 "libm-f32" float
                (runtime fills, 32, f32::EPSILON as f64 / 2.0, Some("libm"));
            #[cfg(all())]
            fast_f32 FastF32 "fast-f32" float
                (const pictures, 32, f32::EPSILON as f64 / 2.0, None);
            #[cfg(feature = "micromath")]
            micromath_f32 MicromathF32 "micromath-f32" float
                (runtime pictures, 32, 1e-4, Some("micromath"));
            #[cfg(feature = "fixed-point")]
            q31 Q31 "q31" fixed
                (const nothing, 32, 1.0 / 2_147_483_648.0, None);
            #[cfg(feature = "fixed-point")]
            q15 Q15 "q15" fixed
                (const nothing, 16, 1.0 / 32_768.0, None);
            #[cfg(feature = "fixed-point")]
            q15_div Q15Div "q15-div" fixed
                (const nothing, 16, 1.0 / 32_768.0, None);
        }
    };
}

/// The disc maps of `map/disc.rs`: kernel, type and name.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_disc_map {
    ($callback:ident $($first:tt)*) => {
        $callback! { $($first)*
            polar Polar "polar";
            concentric Concentric "concentric";
        }
    };
}

/// The lobes: file, type, alias over a disc map, name, and what a lobe takes besides the disc map.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_lobe {
    ($callback:ident $($first:tt)*) => {
        $callback! { $($first)*
            uniform UniformLobe Uniform "uniform" ();
            cosine CosineLobe Cosine "cosine" ();
            power PowerLobe Power "power" (exponent);
        }
    };
}

/// The effects: file, type and name on command lines.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_effect {
    ($callback:ident $($first:tt)*) => {
        $callback! { $($first)*
            thin_lens ThinLens "lens";
            disc_light DiscLight "light";
            ambient_occlusion AmbientOcclusion "occlusion";
            glossy Glossy "glossy";
        }
    };
}
