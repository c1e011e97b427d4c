//! Errors in a caller's values, each with the value and what is accepted.

use core::fmt;

/// An axis of the unit square.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Axis {
    /// The first coordinate.
    U,
    /// The second coordinate.
    V,
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::U => "u",
            Self::V => "v",
        })
    }
}

/// Why a constructor or a conversion refused its arguments.
///
/// Every variant carries the offending value; its [`Display`](fmt::Display) form is one line that
/// also says what is accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A coordinate that is not a number in [0, 1).
    Coordinate {
        /// Which axis.
        axis: Axis,
        /// What was given (an `f32` widens to `f64` exactly).
        value: f64,
    },
    /// A set of no points.
    EmptySet,
    /// A grid without columns or without rows.
    EmptyGrid {
        /// Columns asked for.
        columns: u32,
        /// Rows asked for.
        rows: u32,
    },
    /// A grid whose number of points does not fit in a `u32`.
    SetTooLarge {
        /// Columns asked for.
        columns: u32,
        /// Rows asked for.
        rows: u32,
    },
    /// A grid for a sampler, of more columns or rows than a `u16` counts.
    GridSize {
        /// Columns asked for.
        columns: u32,
        /// Rows asked for.
        rows: u32,
    },
    /// A pixel outside its screen.
    Pixel {
        /// The pixel asked for, x and y.
        pixel: [u32; 2],
        /// Width and height of the screen.
        screen: [u32; 2],
    },
    /// A stored set with more than `u32::MAX` points.
    StoredTooLong {
        /// Points in the slice.
        len: usize,
    },
    /// A range of indices that does not lie within the set.
    Range {
        /// First index asked for.
        start: u64,
        /// How many points were asked for.
        count: u64,
        /// How many the set has; 2^32 for an endless sequence.
        len: u64,
    },
    /// A range of indices that ends before it starts.
    ReversedRange {
        /// First index asked for.
        start: u64,
        /// The index after the last.
        end: u64,
    },
    /// A shard number that is not below the number of shards.
    Shard {
        /// Shard asked for, counted from 0.
        shard: u32,
        /// Number of shards.
        of: u32,
    },
    /// A fixed-size request for more points than the set has.
    TooShort {
        /// Points in the set.
        len: u32,
        /// Points wanted.
        wanted: usize,
    },
    /// A buffer that cannot hold the set.
    Capacity {
        /// Points in the set.
        len: u32,
        /// Points the buffer can hold.
        capacity: usize,
    },
    /// An exponent that is not a finite number above -1.
    Exponent {
        /// What was given (an `f32` widens to `f64` exactly).
        value: f64,
    },
    /// An exponent that is not a number from 0 to below 2^32, which fixed point holds.
    FixedExponent {
        /// What was given; NaN for a text that is not a number.
        value: f64,
    },
    /// A vector that is not near unit length.
    NotUnit {
        /// The square of its length.
        length_squared: f64,
    },
    /// Two vectors of the same direction or of opposite ones, which span no plane: a tangent along
    /// the normal, parallel axes, a camera that looks straight up.
    Parallel {
        /// The cosine of the angle between the two.
        cosine: f64,
    },
    /// A vector without a direction: zero, infinite or not a number.
    NoDirection,
    /// A limit of zero draws for each point.
    NoDraws,
    /// A radius that is not a finite number from 0 on.
    Radius {
        /// What was given (an `f32` widens to `f64` exactly).
        value: f64,
    },
    /// A position with a component that is not finite, or of a light whose rim has one.
    Position {
        /// The first such component (an `f32` widens to `f64` exactly).
        value: f64,
    },
    /// A distance that is not above 0, or a lens's so small that radius / distance is not finite.
    Distance {
        /// What was given (an `f32` widens to `f64` exactly).
        value: f64,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Coordinate { axis, value } => {
                write!(f, "coordinate {axis} is {value}; accepted: 0 <= {axis} < 1")
            }
            Self::EmptySet => f.write_str("a set of 0 points; accepted: at least 1"),
            Self::EmptyGrid { columns, rows } => {
                write!(f, "a grid of {columns} x {rows} points; accepted: at least 1 x 1")
            }
            Self::SetTooLarge { columns, rows } => write!(
                f,
                "a grid of {columns} x {rows} points; accepted: at most {} points",
                u32::MAX
            ),
            Self::GridSize { columns, rows } => write!(
                f,
                "a grid of {columns} x {rows} points for a sampler; accepted: at most 65535 x 65535"
            ),
            Self::Pixel { pixel: [x, y], screen: [width, height] } => write!(
                f,
                "pixel {x}, {y} of a screen of {width} x {height}; accepted: x below {width} and y below {height}"
            ),
            Self::StoredTooLong { len } => {
                write!(f, "a stored set of {len} points; accepted: at most {}", u32::MAX)
            }
            Self::Range { count: count @ 0x1_0000_0000.., .. } => {
                write!(f, "a range of {count} points; accepted: at most {} points", u32::MAX)
            }
            Self::ReversedRange { start, end } => {
                write!(f, "a range from {start} to {end}; accepted: an end not below the start")
            }
            Self::Range { start, count, len } => write!(
                f,
                "{count} points from index {start} are outside the set; accepted: indices below {len}"
            ),
            Self::Shard { shard, of } => {
                write!(f, "shard {shard} of {of}; accepted: shard below the number of shards")
            }
            Self::TooShort { len, wanted } => {
                write!(f, "{wanted} points wanted of a set of {len}; accepted: at most {len}")
            }
            Self::Capacity { len, capacity } => write!(
                f,
                "a set of {len} points for a buffer of {capacity}; accepted: at most {capacity}"
            ),
            Self::Exponent { value } => {
                write!(f, "exponent is {value}; accepted: a finite number above -1")
            }
            Self::FixedExponent { value } => {
                write!(f, "exponent is {value}; accepted in fixed point: 0 <= e < 4294967296")
            }
            Self::NotUnit { length_squared } => {
                write!(f, "a vector with length squared {length_squared}; accepted: 1 within 1/128")
            }
            Self::Parallel { cosine } => write!(
                f,
                "two vectors with the cosine {cosine} between them; accepted: any but the same direction and its opposite"
            ),
            Self::NoDirection => f.write_str(
                "a vector that is zero, infinite or not a number; accepted: finite, not zero",
            ),
            Self::NoDraws => f.write_str("a limit of 0 draws a point; accepted: at least 1"),
            Self::Radius { value } => {
                write!(
                    f,
                    "radius is {value}; accepted: a finite number, at least 0, of a finite square"
                )
            }
            Self::Position { value } => {
                write!(
                    f,
                    "a position with a component of {value}; accepted: finite numbers; of a light, those that its rim is at, too"
                )
            }
            Self::Distance { value } => {
                write!(
                    f,
                    "distance is {value}; accepted: a number above 0, infinity included; of a lens, one that radius / distance is finite for"
                )
            }
        }
    }
}

impl core::error::Error for Error {}
