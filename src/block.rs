//! Blocks: 64 points at a time, one array a component, which is the layout that vector code needs.
//!
//! A sequence makes the coordinates of a block, a map makes its points, and
//! [`Points`](crate::Points) stores them: component by component, or interleaved.

/// Points in a block.
pub const BLOCK: usize = 64;

/// One component of each point of a block.
pub type Lanes<T> = [T; BLOCK];

/// One coordinate of each point of a block.
pub type Block = Lanes<u32>;

/// A point: an array of its components. Sealed.
pub trait Point: Copy + sealed::Sealed {
    /// The number type of its components.
    type Component: Copy;
    /// A block of points, one array a component: `[Lanes<Component>; D]`.
    type Components;

    /// A point whose components are all 0: to initialise a buffer.
    fn zero() -> Self;

    /// A block of such points.
    #[doc(hidden)]
    fn zeros() -> Self::Components;

    /// Writes the point into its slot, a component at a time: LLVM likes that better than an array
    /// whose parts it has just formed.
    #[doc(hidden)]
    fn store(self, slot: &mut Self);

    /// Writes the point into a lane of a block.
    #[doc(hidden)]
    fn put(self, components: &mut Self::Components, lane: usize);

    /// Stores a block point by point.
    #[doc(hidden)]
    fn interleave(components: &Self::Components, points: &mut [Self; BLOCK]);
}

impl<R: Copy + Default, const D: usize> Point for [R; D] {
    type Component = R;
    type Components = [Lanes<R>; D];

    #[inline(always)]
    fn zero() -> Self {
        [R::default(); D]
    }

    #[inline(always)]
    fn zeros() -> [Lanes<R>; D] {
        [[R::default(); BLOCK]; D]
    }

    #[inline(always)]
    fn store(self, slot: &mut Self) {
        for (component, value) in slot.iter_mut().zip(self) {
            *component = value;
        }
    }

    #[inline(always)]
    fn put(self, components: &mut [Lanes<R>; D], lane: usize) {
        for (lanes, value) in components.iter_mut().zip(self) {
            lanes[lane] = value;
        }
    }

    #[inline(always)]
    fn interleave(components: &[Lanes<R>; D], points: &mut [Self; BLOCK]) {
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
