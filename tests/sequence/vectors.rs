//! Sequences against sources other than this crate: the vectors of scipy in `tests/vectors/`, and
//! the crate `sobol_burley`, whose constants Owen scrambling uses.

use hemidisc::{
    Domain,
    bits::{
        hash::mix,
        state::{finish, step},
    },
    sequence::{Halton, Hammersley, R2, Regular, Sobol, SobolOwen},
};
use sobol_burley::parts::{owen_scramble_rev, sobol_rev};

/// The rows of a file of `tests/vectors/`, in which the first column is the index.
fn rows(file: &str, columns: &str, radix: u32) -> Vec<Vec<u64>> {
    let path = format!("{}/tests/vectors/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(columns), "{path}");
    let rows: Vec<Vec<u64>> = lines
        .map(|line| {
            let (index, values) = line.split_once(',').unwrap();
            let values = values.split(',').map(|value| u64::from_str_radix(value, radix).unwrap());
            [index.parse().unwrap()].into_iter().chain(values).collect()
        })
        .collect();
    let indices = rows.iter().map(|row| row[0]);
    assert!(indices.eq(0..1024), "{path}: not the first 1,024 points in order");
    rows
}

#[test]
fn sobol_is_that_of_scipy() {
    for row in rows("sobol.csv", "index,u_hex,v_hex", 16) {
        let point = Sobol::new(0).at(row[0] as u32).map(u64::from);
        assert_eq!(point[..], row[1..], "point {}", row[0]);
    }
}

#[test]
fn four_dimensions_are_those_of_scipy() {
    for row in rows("sobol_4d.csv", "index,u_hex,v_hex,w_hex,x_hex", 16) {
        let point = Sobol::new(0).joint(row[0] as u32).concat();
        let expected = row[1..].iter().map(|cell| *cell as u32);
        assert!(point.into_iter().eq(expected), "point {}", row[0]);
    }
}

/// Dimensions 2 and 3 are those of `sobol_burley`, whose indices have 16 bits, and the scrambled
/// ones are theirs with keys of their own.
#[test]
fn four_dimensions_are_made_of_the_same_parts() {
    for index in (0..2000).chain((0..2000).map(|i| mix(i) >> 16)) {
        let [_, second] = Sobol::new(0).joint(index);
        let expected =
            [2, 3].map(|dimension| sobol_rev(index.reverse_bits(), dimension).reverse_bits());
        assert_eq!(second, expected, "point {index}");
        for seed in 0..5 {
            let [order, u, _] = keys(seed);
            let shuffled = owen_scramble_rev(index.reverse_bits(), order).reverse_bits();
            let [_, [w, x]] = Sobol::new(0).joint(shuffled);
            let second_keys = finish(u64::from(order) << 32 | u64::from(u));
            let expected = [(w, second_keys as u32), (x, (second_keys >> 32) as u32)]
                .map(|(cell, key)| owen_scramble_rev(cell.reverse_bits(), key).reverse_bits());
            let [first, second] = SobolOwen::new(seed).joint(index);
            assert_eq!(second, expected, "point {index}, seed {seed}");
            assert_eq!(first, SobolOwen::new(seed).at(index));
        }
    }
}

/// A coordinate is ceil(2^32 x) of the exact x.
#[test]
fn halton_is_that_of_scipy() {
    for row in rows("halton.csv", "index,u_num,u_den,v_num,v_den", 10) {
        let point = Halton::new().at(row[0] as u32);
        for (axis, fraction) in row[1..].chunks(2).enumerate() {
            let expected = (u128::from(fraction[0]) << 32).div_ceil(u128::from(fraction[1]));
            assert_eq!(u128::from(point[axis]), expected, "point {}, axis {axis}", row[0]);
        }
    }
}

/// Hammersley's v is Halton's u, the radical inverse in base 2; its u is i / N, rounded up.
#[test]
fn hammersley_is_the_radical_inverse() {
    for row in rows("halton.csv", "index,u_num,u_den,v_num,v_den", 10) {
        let inverse = (row[1] << 32) / row[2];
        for count in [1024, 1025, 10_007] {
            let [u, v] = Hammersley::new(count).unwrap().at(row[0] as u32);
            let fraction = (row[0] << 32).div_ceil(u64::from(count));
            assert_eq!([u, v].map(u64::from), [fraction, inverse], "point {} of {count}", row[0]);
        }
    }
}

/// The steps are 2^32 / g and 2^32 / g^2 for g^3 = g + 1, rounded; the second one to an odd
/// integer.
#[test]
fn r2_steps_on_the_plastic_number() {
    let g = (0..100).fold(1.5_f64, |g, _| (g + 1.0).cbrt());
    let exact = [1.0 / g, 1.0 / (g * g)].map(|step| step * 4_294_967_296.0);
    let steps = R2::new(0).at(0).map(f64::from);
    assert!((steps[0] - exact[0]).abs() <= 0.5, "{steps:?}, exactly {exact:?}");
    assert!((steps[1] - exact[1]).abs() <= 1.0, "{steps:?}, exactly {exact:?}");
    assert_eq!(R2::new(0).at(1), R2::new(0).at(0).map(|step| step.wrapping_mul(2)));
}

/// Values worked by hand: centres of 2 x 2 and of 3 x 1 cells.
#[test]
fn regular_centres() {
    let quarters = [[1_u32, 1], [3, 1], [1, 3], [3, 3]].map(|point| point.map(|k| k << 30));
    let square = Regular::new(2, 2).unwrap();
    assert_eq!([0, 1, 2, 3].map(|i| square.at(i)), quarters);
    let row = Regular::new(3, 1).unwrap();
    // 2^32 / 6, 2^32 / 2 and 5 2^32 / 6, rounded down.
    assert_eq!([0, 1, 2].map(|i| row.at(i)[0]), [715_827_882, 1 << 31, 3_579_139_413]);
}

/// `sobol_burley` has points below index 2^16 only.
#[test]
fn sobol_is_that_of_sobol_burley() {
    for index in 0..1_u32 << 16 {
        let point =
            [0, 1].map(|dimension| sobol_rev(index.reverse_bits(), dimension).reverse_bits());
        assert_eq!(Sobol::new(0).at(index), point, "point {index}");
    }
}

/// The second dimension by its recurrence, for every bit of the index: direction numbers
/// v_k = v_(k-1) ^ (v_(k-1) >> 1), of the primitive polynomial x + 1 (Bratley and Fox 1988).
fn second_dimension(index: u32) -> u32 {
    let directions = std::iter::successors(Some(1_u32 << 31), |v| Some(v ^ (v >> 1)));
    let set = directions.take(32).enumerate().filter(|(bit, _)| index >> bit & 1 == 1);
    set.fold(0, |sum, (_, direction)| sum ^ direction)
}

#[test]
fn sobol_follows_its_recurrence() {
    let powers = (0..32).map(|bit| 1 << bit);
    for index in powers.chain((0..100_000).map(mix)).chain(u32::MAX - 1000..=u32::MAX) {
        let point = [index.reverse_bits(), second_dimension(index)];
        assert_eq!(Sobol::new(0).at(index), point, "point {index}");
    }
}

/// A domain's three keys: order, u, v. They are by the library's own hashes, which this file takes
/// as given; the goldens pin them.
fn keys(seed: u32) -> [u32; 3] {
    let state = step(u64::from_be_bytes(*b"hemidisc"), seed.into());
    let words = finish(state);
    let [order, u] = [(words >> 32) as u32, words as u32];
    [order, u, (order ^ u.rotate_left(16)).wrapping_mul(0x9e37_79b9)]
}

/// Owen-scrambled Sobol is these parts put together: shuffle the index, take the point, scramble
/// each axis, with the keys of the seed's domain.
#[test]
fn sobol_owen_is_made_of_the_same_parts() {
    for seed in (0..200).chain([1 << 16, 1 << 31, u32::MAX]) {
        let [order, u, v] = keys(seed);
        let points = SobolOwen::new(seed);
        assert_eq!(points, SobolOwen::in_domain(Domain::new(seed)));
        for index in (0..100).chain((0..1000).map(|i| mix(i ^ seed))) {
            let shuffled = owen_scramble_rev(index.reverse_bits(), order).reverse_bits();
            // The scramble takes coordinates with their bits reversed, as the index is dimension 0.
            let expected = [(shuffled, u), (second_dimension(shuffled).reverse_bits(), v)]
                .map(|(reversed, key)| owen_scramble_rev(reversed, key).reverse_bits());
            assert_eq!(points.at(index), expected, "point {index}, seed {seed}");
        }
    }
}
