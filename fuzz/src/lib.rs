//! The checks of `testkit::checks`, as fuzz targets.

pub use libfuzzer_sys;
pub use testkit::checks;

/// A target that runs the check of a name; bytes that do not make an input stay out of the corpus.
#[macro_export]
macro_rules! target {
    ($name:ident) => {
        $crate::libfuzzer_sys::fuzz_target!(|data: &[u8]| -> $crate::libfuzzer_sys::Corpus {
            match $crate::checks::$name::check(data) {
                Ok(()) => $crate::libfuzzer_sys::Corpus::Keep,
                Err(_) => $crate::libfuzzer_sys::Corpus::Reject,
            }
        });
    };
}
