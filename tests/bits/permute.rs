//! `permute`: a bijection for every length and seed, and as good as a random one.
//!
//! Rounds of swap-or-not were measured on a copy of the function with the rounds as a parameter (least
//! number from which p > 1e-6 stays, for 200 to 3,200 draws a cell): places and pairs of places at
//! lengths to 100 need 8 to 10; all permutations 6 to 8 at length 3, 13 to 14 at length 8. A round
//! leaves an element with probability 1/2, so r rounds leave len / 2^r more than chance does.

use hemidisc::bits::{hash::mix, permute::permute};
use testkit::chi_square::{assert_random, assert_uniform};

/// Orders of seeds that callers use: counted, hashed, counted in the high bits.
type Order = fn(u32) -> u32;
const ORDERS: [(&str, Order); 3] =
    [("counted", |i| i), ("hashed", |i| mix(i ^ 0x5bd1_e995)), ("reversed", u32::reverse_bits)];

/// Seeds with few or all bits set, and those that start a round with a state of 0 or repeat it.
fn adversarial() -> impl Iterator<Item = u32> {
    let special = [0, u32::MAX, 0x9e37_79b9, 0x61c8_8647, 0xe58d_538d, 0x5555_5555];
    (0..32).map(|bit| 1 << bit).chain(special)
}

fn assert_bijection(len: u32, seed: u32, seen: &mut Vec<bool>) {
    seen.clear();
    seen.resize(len as usize, false);
    for i in 0..len {
        let place = permute(i, len, seed);
        assert!(place < len, "{i} of {len}, seed {seed:#x}: {place}");
        assert!(!seen[place as usize], "length {len}, seed {seed:#x}: {place} twice");
        seen[place as usize] = true;
    }
}

#[test]
fn bijection_for_every_length_to_1024() {
    let mut seen = Vec::new();
    for len in 1..=1024 {
        let every = if len <= 256 { 1 } else { 5 };
        for seed in adversarial().step_by(every) {
            assert_bijection(len, seed, &mut seen);
        }
    }
}

#[test]
fn bijection_for_large_lengths() {
    let mut seen = Vec::new();
    for len in [65_535, 65_536, 65_537, 1 << 20, 1_000_003] {
        for seed in [0, u32::MAX, 0x8000_0000] {
            assert_bijection(len, seed, &mut seen);
        }
    }
}

/// Near 2^31 and 2^32: a sample of both ends and of hashed indices is mapped one to one, into range.
#[test]
fn bijection_for_lengths_near_the_largest() {
    let half = 1_u32 << 31;
    for len in [half - 1, half, half + 1, 3_000_000_019, u32::MAX - 1, u32::MAX] {
        let ends = (0..40_000).flat_map(|i| [i, len - 1 - i]);
        let mut indices: Vec<u32> =
            ends.chain((0..100_000).map(mix).filter(|&i| i < len)).collect();
        indices.sort_unstable();
        indices.dedup();
        for seed in [0, 1, u32::MAX, 0x8000_0000] {
            let mut places: Vec<u32> = indices.iter().map(|&i| permute(i, len, seed)).collect();
            assert!(places.iter().all(|&place| place < len), "length {len}, seed {seed:#x}");
            places.sort_unstable();
            places.dedup();
            assert_eq!(places.len(), indices.len(), "length {len}, seed {seed:#x}");
        }
    }
}

#[test]
fn an_index_outside_stays() {
    for (index, len) in [(0, 0), (7, 0), (5, 5), (6, 5), (u32::MAX, 5), (u32::MAX, u32::MAX)] {
        assert_eq!(permute(index, len, 7), index, "{index} of {len}");
    }
    assert_eq!(permute(0, 1, 7), 0);
}

/// The rank of the permutation that a seed selects among all of its length.
fn rank(len: u32, seed: u32) -> usize {
    let places: Vec<u32> = (0..len).map(|i| permute(i, len, seed)).collect();
    places.iter().enumerate().fold(0, |rank, (i, place)| {
        let later_and_less = places[i + 1..].iter().filter(|&other| other < place).count();
        rank * (len as usize - i) + later_and_less
    })
}

/// Short lengths: every permutation is reached, and each equally often.
#[test]
fn all_permutations_of_short_lengths() {
    for (order, seed) in ORDERS {
        for len in 2..=8 {
            let mut counts = vec![0; (1..=len as usize).product()];
            let each = if len > 6 { 30 } else { 200 };
            for i in 0..each * counts.len() as u32 {
                counts[rank(len, seed(i))] += 1;
            }
            assert!(counts.iter().all(|&count| count > 0), "length {len}, {order} seeds");
            assert_uniform(&counts, &format!("permutations of {len}, {order} seeds"));
        }
    }
}

fn lengths() -> impl Iterator<Item = u32> {
    (2..=16).chain([31, 64, 100])
}

/// The place of an element over seeds.
#[test]
fn places_are_uniform() {
    for (order, seed) in ORDERS {
        for len in lengths() {
            for element in (0..len).step_by(len.div_ceil(16) as usize) {
                let mut counts = vec![0; len as usize];
                for i in 0..(400 * len).max(20_000) {
                    counts[permute(element, len, seed(i)) as usize] += 1;
                }
                assert_uniform(&counts, &format!("place of {element} of {len}, {order} seeds"));
            }
        }
    }
}

/// The places of two elements over seeds: neighbours, the ends, the middle.
#[test]
fn pairs_of_places_are_uniform() {
    for (order, seed) in ORDERS {
        for len in lengths().filter(|&len| len > 2) {
            for [a, b] in [[0, 1], [0, len - 1], [len / 2, len / 2 - 1], [1, len - 2]] {
                if a == b {
                    continue;
                }
                let mut counts = vec![0; (len * (len - 1)) as usize];
                for i in 0..(50 * counts.len() as u32).max(20_000) {
                    let (first, second) = (permute(a, len, seed(i)), permute(b, len, seed(i)));
                    let second = second - u32::from(second > first);
                    counts[(first * (len - 1) + second) as usize] += 1;
                }
                let what = format!("places of {a} and {b} of {len}, {order} seeds");
                if len > 4 { assert_random(&counts, &what) } else { assert_uniform(&counts, &what) }
            }
        }
    }
}

/// Elements that stay in place, and neighbours that stay neighbours: 1 of each on average in a random
/// permutation, up to 1/16 more here.
#[test]
fn few_elements_stay() {
    for (len, trials) in [(100, 20_000), (257, 8000), (1000, 3000), (65_537, 100)] {
        let (mut stay, mut follow) = (0, 0);
        for seed in 0..trials {
            let places: Vec<u32> = (0..len).map(|i| permute(i, len, seed)).collect();
            stay += (0..len).zip(&places).filter(|&(i, &place)| i == place).count();
            follow += places.windows(2).filter(|pair| pair[0] + 1 == pair[1]).count();
        }
        let spread = 5.0 / f64::from(trials).sqrt();
        for (name, total) in [("stay", stay), ("follow", follow)] {
            let mean = total as f64 / f64::from(trials);
            let range = 1.0 - spread..=17.0 / 16.0 + spread;
            assert!(range.contains(&mean), "{mean} of {len} {name}");
        }
    }
}

/// No simple seed is the identity, nor is 0xe58d538d, which would be if a round's key did not depend on
/// the number of the round: the hash gives it back, and every round would undo the one before.
#[test]
fn seeds_are_not_the_identity() {
    for len in [16, 17, 100, 1000, 65_537, u32::MAX] {
        for seed in adversarial() {
            let stay = (0..len.min(1000)).filter(|&i| permute(i, len, seed) == i).count();
            assert!(stay < 12, "{stay} of {len} stay, seed {seed:#x}");
        }
    }
}
