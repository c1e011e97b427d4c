//! Uniform lobe: z = 1 - r^2, density 1 / (2 pi) per steradian (the equal-area projection).

use super::lobe;
use core::marker::PhantomData;

/// z = 1 - r^2: equal areas of the disc to equal solid angles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct UniformLobe<A>(pub(super) PhantomData<A>);

lobe!(UniformLobe, uniform, uniform_block, lower_uniform, uniform_density);
