//! Sums of radiance in fixed point: the same bits in any order.
//!
//! Sums of floats depend on their order, sums of integers do not. So a pass, some samples of a
//! pixel, is summed in the arithmetic's own numbers, in order and from zero; it is rounded once, to
//! units of 2^-32, and passes are added as integers, from any threads, processes or machines.
//!
//! A pass is below 2^18 = 2^50 units in magnitude, and of [`MOST_PASSES`] the sum is below 2^63.
//! A larger, infinite or NaN pass marks the sum for good, in any order too. The mean is then
//! infinite and the pixel white, like a mean of at least 2^18 / 2^16 = 4.

use hemidisc::arithmetic::Real;
use std::ops::AddAssign;

/// Passes whose sum cannot overflow.
pub const MOST_PASSES: u32 = 1 << 13;

const UNITS: f64 = (1_u64 << 32) as f64;
const LIMIT: f64 = (1_u64 << 50) as f64;

/// Stands for all that is not in range; no sum of passes is as low.
const BEYOND: i64 = i64::MIN;

/// Red, green and blue of a pixel, in units of 2^-32.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sum(pub [i64; 3]);

impl Sum {
    /// Of a pass in the numbers of an arithmetic; ties are rounded away from zero.
    pub fn of_pass<R: Real>(pass: [R; 3]) -> Self {
        Self(pass.map(|component| {
            let units = (component.into() * UNITS).round();
            // False for NaN.
            if units.abs() < LIMIT { units as i64 } else { BEYOND }
        }))
    }
}

impl AddAssign for Sum {
    fn add_assign(&mut self, other: Self) {
        for (sum, more) in self.0.iter_mut().zip(other.0) {
            let within = *sum != BEYOND && more != BEYOND;
            *sum = sum.checked_add(more).filter(|_| within).unwrap_or(BEYOND);
        }
    }
}

/// Mean radiance of pixels from their sums over a number of samples.
pub fn means(sums: &[Sum], samples: u32) -> Vec<[f64; 3]> {
    let share = 1.0 / (UNITS * f64::from(samples));
    let mean = |sum: i64| if sum == BEYOND { f64::INFINITY } else { share * sum as f64 };
    sums.iter().map(|sum| sum.0.map(mean)).collect()
}
