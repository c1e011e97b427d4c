//! A digest of points: FNV-1a of 64 bits (G. Fowler, L. C. Noll and P. Vo, 1991), which is short,
//! well known and the same on every target; it detects change, not malice.

/// A running digest; start with [`new`](Self::new), feed words, read [`value`](Self::value).
///
/// ```
/// use testkit::digest::Digest;
/// let mut digest = Digest::new();
/// digest.bytes(b"foobar");
/// assert_eq!(digest.value(), 0x8594_4171_f739_67e8);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest {
    state: u64,
}

impl Default for Digest {
    fn default() -> Self {
        Self::new()
    }
}

impl Digest {
    /// The digest of nothing.
    pub const fn new() -> Self {
        Self { state: 0xcbf2_9ce4_8422_2325 }
    }

    /// Takes in bytes.
    pub fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.state = (self.state ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Takes in a value's bits, lowest byte first.
    pub fn value_of(&mut self, value: impl Digestible) {
        value.feed(self);
    }

    /// The digest so far.
    pub const fn value(self) -> u64 {
        self.state
    }
}

/// A value whose bits a [`Digest`] can take in, lowest byte first.
pub trait Digestible {
    /// Feeds its bits.
    fn feed(self, digest: &mut Digest);
}

macro_rules! digestible {
    ($($type:ty),*) => {$(
        impl Digestible for $type {
            fn feed(self, digest: &mut Digest) {
                digest.bytes(&self.to_le_bytes());
            }
        }
    )*};
}
digestible!(u32, f32, f64);

#[cfg(feature = "fixed-point")]
impl Digestible for hemidisc::Q15 {
    fn feed(self, digest: &mut Digest) {
        digest.bytes(&self.to_bits().to_le_bytes());
    }
}

#[cfg(feature = "fixed-point")]
impl Digestible for hemidisc::Q31 {
    fn feed(self, digest: &mut Digest) {
        digest.bytes(&self.to_bits().to_le_bytes());
    }
}

impl<T: Digestible, const N: usize> Digestible for [T; N] {
    fn feed(self, digest: &mut Digest) {
        for value in self {
            value.feed(digest);
        }
    }
}
