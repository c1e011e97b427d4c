//! Blocks: 64 points at a time, or 16, one array a component, which is the layout that vector code
//! needs.
//!
//! A sequence makes the coordinates of a block, a map makes its points, and
//! [`Points`](crate::Points) stores them: component by component, or interleaved.

/// Points in a block.
pub const BLOCK: usize = 64;

/// Points in a short block, for sets of that many, as of a pixel, and for the ends of longer ones.
pub const SHORT_BLOCK: usize = 16;

/// One component of each point of a block.
pub type Lanes<T, const N: usize = BLOCK> = [T; N];

/// One coordinate of each point of a block.
pub type Block<const N: usize = BLOCK> = Lanes<u32, N>;

/// A point: an array of its components. Sealed.
pub trait Point: Copy + sealed::Sealed {
    /// The number type of its components.
    type Component: Copy;
    /// A block of N points, one array a component: `[Lanes<Component, N>; D]`.
    type Components<const N: usize>;

    /// A point whose components are all 0: to initialise a buffer.
    fn zero() -> Self;

    /// A block of such points.
    #[doc(hidden)]
    fn zeros<const N: usize>() -> Self::Components<N>;

    /// Writes the point into its slot, a component at a time: LLVM likes that better than an array
    /// whose parts it has just formed.
    #[doc(hidden)]
    fn store(self, slot: &mut Self);

    /// Writes the point into a lane of a block.
    #[doc(hidden)]
    fn put<const N: usize>(self, components: &mut Self::Components<N>, lane: usize);

    /// Stores a block point by point.
    #[doc(hidden)]
    fn interleave<const N: usize>(components: &Self::Components<N>, points: &mut [Self; N]);
}

impl<R: Copy + Default, const D: usize> Point for [R; D] {
    type Component = R;
    type Components<const N: usize> = [Lanes<R, N>; D];

    #[inline(always)]
    fn zero() -> Self {
        [R::default(); D]
    }

    #[inline(always)]
    fn zeros<const N: usize>() -> [Lanes<R, N>; D] {
        [[R::default(); N]; D]
    }

    #[inline(always)]
    fn store(self, slot: &mut Self) {
        for (component, value) in slot.iter_mut().zip(self) {
            *component = value;
        }
    }

    #[inline(always)]
    fn put<const N: usize>(self, components: &mut [Lanes<R, N>; D], lane: usize) {
        for (lanes, value) in components.iter_mut().zip(self) {
            lanes[lane] = value;
        }
    }

    #[inline(always)]
    fn interleave<const N: usize>(components: &[Lanes<R, N>; D], points: &mut [Self; N]) {
        for (lane, point) in points.iter_mut().enumerate() {
            for (value, lanes) in point.iter_mut().zip(components) {
                *value = lanes[lane];
            }
        }
    }
}

mod sealed {
    pub trait Sealed {}
    impl<R: Copy + Default, const D: usize> Sealed for [R; D] {}
}
