//! The third and the fourth dimension of Sobol's sequence, which have no matrix of a simple form.
//!
//! The direction numbers are those of S. Joe and F. Kuo ("Constructing Sobol Sequences with Better
//! Two-Dimensional Projections", 2008): polynomials x^2 + x + 1 and x^3 + x + 1, first numbers 1, 3
//! and 1, 3, 1. A product takes the columns of four bits at a time from a table.

/// For each dimension and each four bits of an index, the lowest first: the sums of their columns,
/// reversed.
static COLUMNS: [[[u32; 16]; 8]; 2] = [columns(&[1, 3], 0b1), columns(&[1, 3, 1], 0b01)];

/// The table of a dimension, from its first odd numbers and the inner coefficients of its
/// polynomial, the highest first.
const fn columns(first: &[u32], inner: u32) -> [[u32; 16]; 8] {
    let degree = first.len();
    // Number k, m_k 2^(32 - k), is the column of bit k - 1 of the index.
    let mut numbers = [0; 32];
    let mut k = 0;
    while k < 32 {
        numbers[k] = if k < degree {
            first[k] << (31 - k)
        } else {
            let mut sum = numbers[k - degree] ^ numbers[k - degree] >> degree;
            let mut back = 1;
            while back < degree {
                if inner >> (degree - 1 - back) & 1 == 1 {
                    sum ^= numbers[k - back];
                }
                back += 1;
            }
            sum
        };
        k += 1;
    }
    let mut table = [[0; 16]; 8];
    let mut bit = 0;
    while bit < 32 {
        let column = numbers[bit].reverse_bits();
        let mut bits = 0;
        while bits < 16 {
            if bits >> (bit % 4) & 1 == 1 {
                table[bit / 4][bits] ^= column;
            }
            bits += 1;
        }
        bit += 1;
    }
    table
}

/// The reversed coordinates of dimensions 2 and 3, counted from 0, at an index.
#[inline]
pub(crate) const fn higher_dimensions(index: u32) -> [u32; 2] {
    let mut coordinates = [0; 2];
    let mut group = 0;
    while group < 8 {
        let bits = (index >> (4 * group) & 15) as usize;
        coordinates[0] ^= COLUMNS[0][group][bits];
        coordinates[1] ^= COLUMNS[1][group][bits];
        group += 1;
    }
    coordinates
}
