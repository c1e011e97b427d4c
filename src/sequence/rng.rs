//! Random points from any `rand_core` generator: an iterator, because a generator has state.

use rand_core::Rng;

/// Endless uniform points drawn from a generator: two `u32` words each, u first.
///
/// ```
/// use hemidisc::{Concentric, LibmF32, sequence::FromRng};
/// use rand::{SeedableRng, rngs::SmallRng};
/// let map = Concentric::<LibmF32>::new();
/// let mut rng = SmallRng::seed_from_u64(7);
/// let mut lens = [[0.0_f32; 2]; 16];
/// for (slot, uv) in lens.iter_mut().zip(FromRng::new(&mut rng)) {
///     *slot = map.sample(uv);
/// }
/// ```
#[derive(Clone, Debug)]
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct FromRng<R> {
    rng: R,
}

impl<R: Rng> FromRng<R> {
    /// Draws from `rng`, which may be a `&mut` borrow.
    pub const fn new(rng: R) -> Self {
        Self { rng }
    }

    /// Returns the generator, in its state after the draws.
    #[must_use]
    pub fn into_inner(self) -> R {
        self.rng
    }
}

impl<R: Rng> Iterator for FromRng<R> {
    type Item = [u32; 2];

    #[inline]
    fn next(&mut self) -> Option<[u32; 2]> {
        Some([self.rng.next_u32(), self.rng.next_u32()])
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (usize::MAX, None)
    }
}
