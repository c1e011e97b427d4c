//! Cosine lobe: z = sqrt(1 - r^2), density z / pi per steradian (Malley's method: the orthographic
//! projection of the disc).

use super::lobe;
use core::marker::PhantomData;

/// z = sqrt(1 - r^2): the point of the sphere above the point of the disc.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct CosineLobe<A>(pub(super) PhantomData<A>);

lobe!(CosineLobe, cosine, cosine_block, lower_cosine, cosine_density);
