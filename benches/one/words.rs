//! What calls give, as one word: all of it is used, and the next call can wait for it.

use hemidisc::effect::{DirectionSample, LensRay, LightSample};
use hemidisc::{Q15, Q31};

/// Can be made a word of which every bit of it is a part.
pub(crate) trait Word {
    /// The exclusive or of its words: one operation for each.
    fn word(self) -> u32;
}

impl Word for u32 {
    #[inline(always)]
    fn word(self) -> u32 {
        self
    }
}

impl Word for f32 {
    #[inline(always)]
    fn word(self) -> u32 {
        self.to_bits()
    }
}

impl Word for f64 {
    #[inline(always)]
    fn word(self) -> u32 {
        let bits = self.to_bits();
        (bits ^ bits >> 32) as u32
    }
}

impl Word for Q15 {
    #[inline(always)]
    fn word(self) -> u32 {
        self.to_bits() as u32
    }
}

impl Word for Q31 {
    #[inline(always)]
    fn word(self) -> u32 {
        self.to_bits() as u32
    }
}

impl<T: Word, const N: usize> Word for [T; N] {
    #[inline(always)]
    fn word(self) -> u32 {
        self.into_iter().fold(0, |word, part| word ^ part.word())
    }
}

impl<T: Word, U: Word> Word for (T, U) {
    #[inline(always)]
    fn word(self) -> u32 {
        self.0.word() ^ self.1.word()
    }
}

impl<T: Word> Word for Option<T> {
    #[inline(always)]
    fn word(self) -> u32 {
        self.map_or(0, T::word)
    }
}

impl<R: Word> Word for DirectionSample<R> {
    #[inline(always)]
    fn word(self) -> u32 {
        let Self { direction, density, weight, .. } = self;
        direction.word() ^ density.word() ^ weight.word()
    }
}

impl<R: Word> Word for LensRay<R> {
    #[inline(always)]
    fn word(self) -> u32 {
        let Self { origin, direction, density, weight, .. } = self;
        origin.word() ^ direction.word() ^ density.word() ^ weight.word()
    }
}

impl<R: Word> Word for LightSample<R> {
    #[inline(always)]
    fn word(self) -> u32 {
        let Self { point, direction, distance, density, weight, .. } = self;
        point.word() ^ direction.word() ^ [distance, density, weight].word()
    }
}
