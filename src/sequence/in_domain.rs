//! Sequences of a domain: what a sampler draws from.
//!
//! Two domains' points must be independent, also where an effect pairs them. A scramble or a shift
//! of the axes is not enough for that: points in one order pair alike whatever their axes. So each
//! member of a family has an order of its own, by a shuffle where the sequence has none.

use super::{
    Correlated, Halton, Jittered, MultiJittered, R2, Random, Sequence, Shifted, Shuffled, SobolOwen,
};
use crate::bits::grid::Grid;
use crate::domain::Domain;
use crate::error::Error;
use core::fmt::Debug;
use core::hash::Hash;
use core::num::NonZeroU16;

/// A family of sequences with an independent member for each domain.
///
/// A renderer that takes an `S: InDomain` runs on any of them: `SobolOwen`, `Random`, `R2`,
/// `Halton`, and the sets of a grid.
///
/// ```
/// use hemidisc::{Domain, Sampler};
/// use hemidisc::sequence::{GridSize, InDomain, MultiJittered, R2, SobolOwen};
///
/// fn mean<S: InDomain>(size: S::Size) -> f64 {
///     let pixel = Domain::new(7).pixel(3, 4);
///     let values = (0..64).map(|i| Sampler::<S>::of(pixel, size, i).child(1).unit_f64());
///     values.sum::<f64>() / 64.0
/// }
///
/// let pixel = GridSize::new(8, 8)?;
/// for mean in [mean::<SobolOwen>(()), mean::<R2>(()), mean::<MultiJittered>(pixel)] {
///     assert!((mean - 0.5).abs() < 0.01);
/// }
/// # Ok::<(), hemidisc::Error>(())
/// ```
pub trait InDomain {
    /// What a member takes besides its domain: `()`, or the [`GridSize`] of a set.
    type Size: Copy + Debug + PartialEq + Eq + Hash;

    /// A member.
    type Sequence: Sequence;

    /// The member of a domain.
    #[must_use]
    fn in_domain(domain: Domain, size: Self::Size) -> Self::Sequence;

    /// Two pairs for an effect of four dimensions, such as a point of the pixel and one of the lens.
    ///
    /// [`SobolOwen`] gives the first four dimensions of one sequence, whose points are even in all
    /// four together. The other families give two independent pairs.
    #[must_use]
    #[inline]
    fn joint(domain: Domain, size: Self::Size, index: u32) -> [[u32; 2]; 2] {
        [domain, domain.aside(*b"two more")].map(|domain| Self::in_domain(domain, size).at(index))
    }

    /// One number, independent of the pair of the same index.
    #[must_use]
    #[inline]
    fn cell(domain: Domain, size: Self::Size, index: u32) -> u32 {
        let [cell, _] = Self::in_domain(domain.aside(*b"one more"), size).at(index);
        cell
    }
}

/// The columns and rows of the sets that a sampler draws from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct GridSize {
    columns: NonZeroU16,
    rows: NonZeroU16,
}

impl GridSize {
    /// A grid of `columns` x `rows`; [`grid`](super::grid) has those of a number of samples.
    ///
    /// # Errors
    /// [`Error::EmptyGrid`] if either is 0; [`Error::GridSize`] if either exceeds 65535.
    pub const fn new(columns: u32, rows: u32) -> Result<Self, Error> {
        if columns > u16::MAX as u32 || rows > u16::MAX as u32 {
            return Err(Error::GridSize { columns, rows });
        }
        match (NonZeroU16::new(columns as u16), NonZeroU16::new(rows as u16)) {
            (Some(columns), Some(rows)) => Ok(Self { columns, rows }),
            _ => Err(Error::EmptyGrid { columns, rows }),
        }
    }

    /// Columns of the grid.
    #[must_use]
    pub const fn columns(self) -> u32 {
        self.columns.get() as u32
    }

    /// Rows of the grid.
    #[must_use]
    pub const fn rows(self) -> u32 {
        self.rows.get() as u32
    }

    const fn grid(self) -> Grid {
        Grid::of_sides([self.columns, self.rows])
    }
}

impl InDomain for SobolOwen {
    type Size = ();
    type Sequence = Self;

    #[inline]
    fn in_domain(domain: Domain, (): ()) -> Self {
        Self::in_domain(domain)
    }

    #[inline]
    fn joint(domain: Domain, (): (), index: u32) -> [[u32; 2]; 2] {
        Self::in_domain(domain).joint(index)
    }

    /// Of the domain's [`Stream`](crate::domain::Stream), whose aligned blocks of 2^k are even.
    #[inline]
    fn cell(domain: Domain, (): (), index: u32) -> u32 {
        domain.stream().at(index)
    }
}

impl InDomain for Random {
    type Size = ();
    type Sequence = Self;

    #[inline]
    fn in_domain(domain: Domain, (): ()) -> Self {
        Self::in_domain(domain)
    }
}

/// Endless sequences without an order of their own.
macro_rules! shifted {
    ($($sequence:ident $textbook:expr;)*) => {$(
        impl InDomain for $sequence {
            type Size = ();
            /// Shuffled within aligned blocks of 2^k, and shifted.
            type Sequence = Shuffled<Shifted<Self>>;

            #[inline]
            fn in_domain(domain: Domain, (): ()) -> Self::Sequence {
                Shuffled::new(Shifted::new($textbook, domain), domain)
            }
        }
    )*};
}

shifted! {
    R2 Self::new(0);
    Halton Self::new();
}

/// Sets of a grid.
macro_rules! sets {
    ($($sequence:ident)*) => {$(
        impl InDomain for $sequence {
            type Size = GridSize;
            type Sequence = Shuffled<Self>;

            #[inline]
            fn in_domain(domain: Domain, size: GridSize) -> Self::Sequence {
                Shuffled::new(Self::on(size.grid(), domain.seed()), domain)
            }
        }
    )*};
}

sets!(Jittered MultiJittered Correlated);
