//! Rejection: draw candidates from [-1, 1]^2, keep those inside the disc.
//!
//! The inside-test is exact, on integers: with magnitudes m and n of the two coordinates about the
//! centre, (2m + 1)^2 + (2n + 1)^2 <= 2^64 is m (m + 1) + n (n + 1) < 2^62. About 1 - pi/4 = 21.5 %
//! of the candidates are lost, and with them the strata of a stratified set.

use crate::arithmetic::{Arithmetic, Back, assert_rounds};
use crate::coordinates::fold;
use crate::error::Error;
use core::iter::Take;
use core::marker::PhantomData;
use core::num::NonZeroU32;

/// An iterator adaptor that keeps the candidates inside the disc.
///
/// The draws are bounded: by the length of the candidates ([`new`](Self::new)), to a number in all
/// ([`with_draws`](Self::with_draws)) or to a number for each point
/// ([`with_limit`](Self::with_limit)).
///
/// ```
/// use hemidisc::{Concentric, LibmF32, Points, disc::Rejection, sequence::Regular};
/// let grid = Points::new(Regular::new(4, 4)?, Concentric::<LibmF32>::new());
/// let mut kept = Rejection::<LibmF32, _>::new(grid.iter_coordinates());
/// assert_eq!(kept.by_ref().count(), 12);
/// assert_eq!((kept.drawn(), kept.kept()), (16, 12));
/// # Ok::<(), hemidisc::Error>(())
/// ```
#[derive(Clone, Debug)]
#[must_use = "iterators are lazy and do nothing unless consumed"]
pub struct Rejection<A, I = ()> {
    candidates: I,
    limit: Option<NonZeroU32>,
    drawn: u64,
    kept: u64,
    arithmetic: PhantomData<A>,
}

impl<A: Arithmetic, I: Iterator<Item = [u32; 2]>> Rejection<A, I> {
    /// Draws until the candidates end; their exact length is the bound.
    pub const fn new(candidates: I) -> Self
    where
        I: ExactSizeIterator,
    {
        Self::unchecked(candidates, None)
    }

    /// Draws at most `limit` candidates for each point, from candidates that may never end.
    ///
    /// The `limit`-th is not rejected: wherever it lies, the concentric map takes it to the disc.
    /// So independent candidates give uniform points for any limit, and one point in
    /// 4.66^(`limit` - 1) is not an original candidate.
    ///
    /// # Errors
    /// [`Error::NoDraws`] for a limit of 0.
    pub fn with_limit(candidates: I, limit: u32) -> Result<Self, Error> {
        match NonZeroU32::new(limit) {
            Some(limit) => Ok(Self::unchecked(candidates, Some(limit))),
            None => Err(Error::NoDraws),
        }
    }

    /// Draws `draws` candidates in all, from candidates that may never end.
    pub fn with_draws(candidates: I, draws: u32) -> Rejection<A, Take<I>> {
        Rejection::unchecked(candidates.take(draws as usize), None)
    }

    const fn unchecked(candidates: I, limit: Option<NonZeroU32>) -> Self {
        Self { candidates, limit, drawn: 0, kept: 0, arithmetic: PhantomData }
    }

    /// Candidates drawn so far.
    #[must_use]
    pub const fn drawn(&self) -> u64 {
        self.drawn
    }

    /// Candidates found inside and kept so far; one that was mapped does not count.
    #[must_use]
    pub const fn kept(&self) -> u64 {
        self.kept
    }
}

impl<A: Arithmetic> Rejection<A> {
    /// Whether a candidate is inside the disc, exactly.
    #[must_use]
    #[inline]
    pub const fn inside([u, v]: [u32; 2]) -> bool {
        const fn square(k: u32) -> u64 {
            let (m, _) = fold(k);
            m as u64 * (m as u64 + 1)
        }
        square(u) + square(v) < 1 << 62
    }

    /// The point of a candidate, if it is inside: (2u - 1, 2v - 1).
    #[must_use]
    #[inline]
    pub fn sample(uv: [u32; 2]) -> Option<[A::Real; 2]> {
        assert_rounds::<A>();
        Self::inside(uv).then(|| A::centred(uv))
    }

    /// The density of the survivors: 1 / pi, and 0 outside the disc.
    #[must_use]
    #[inline]
    pub fn density(point: [A::Real; 2]) -> A::Real {
        assert_rounds::<A>();
        A::Back::disc_density(point)
    }

    /// The candidate of a point.
    #[must_use]
    #[inline]
    pub fn invert(point: [A::Real; 2]) -> [u32; 2] {
        assert_rounds::<A>();
        A::Back::invert_centred(point)
    }
}

impl<A: Arithmetic, I: Iterator<Item = [u32; 2]>> Iterator for Rejection<A, I> {
    type Item = [A::Real; 2];

    fn next(&mut self) -> Option<[A::Real; 2]> {
        let mut left = self.limit.map(NonZeroU32::get);
        loop {
            let candidate = self.candidates.next()?;
            self.drawn += 1;
            if let Some(left) = &mut left {
                *left -= 1;
                if *left == 0 {
                    return Some(A::concentric_point(candidate));
                }
            }
            if let Some(point) = Rejection::<A>::sample(candidate) {
                self.kept += 1;
                return Some(point);
            }
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (0, self.candidates.size_hint().1)
    }
}

impl<A: Arithmetic, I: core::iter::FusedIterator<Item = [u32; 2]>> core::iter::FusedIterator
    for Rejection<A, I>
{
}
