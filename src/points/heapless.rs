//! Points in `heapless` vectors, whose capacity they never exceed.

use super::Points;
use crate::error::Error;
use crate::map::Map;
use crate::sequence::Sequence;

impl<S: Sequence, M: Map> Points<S, M> {
    /// Appends points until the set or the vector's capacity ends; returns how many.
    ///
    /// ```
    /// use hemidisc::{Concentric, LibmF32, Points, sequence::R2};
    /// let lens = Points::new(R2::new(0), Concentric::<LibmF32>::new());
    /// let mut buffer: heapless::Vec<[f32; 2], 16> = heapless::Vec::new();
    /// assert_eq!(lens.extend_heapless(&mut buffer), 16);
    /// ```
    pub fn extend_heapless<const N: usize>(&self, vec: &mut heapless::Vec<M::Point, N>) -> usize {
        let before = vec.len();
        for point in self.iter().take(vec.capacity() - before) {
            // There is room, so nothing is refused.
            if vec.push(point).is_err() {
                break;
            }
        }
        vec.len() - before
    }

    /// The whole set in a vector of capacity `N`.
    ///
    /// # Errors
    /// [`Error::Capacity`] if the set is larger than `N`.
    pub fn to_heapless<const N: usize>(&self) -> Result<heapless::Vec<M::Point, N>, Error> {
        if self.len as usize > N {
            return Err(Error::Capacity { len: self.len, capacity: N });
        }
        let mut vec = heapless::Vec::new();
        self.extend_heapless(&mut vec);
        Ok(vec)
    }
}
