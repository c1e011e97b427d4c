//! Hard cases by mpmath (tests/derive/maps.py), in `testkit/vectors`.

use crate::errors::{Pair, Reference};
use std::collections::HashMap;

/// One line of the table.
#[derive(Clone, Copy)]
pub struct Case {
    /// Its coordinates.
    pub uv: [u32; 2],
    /// Its point.
    pub exact: Reference,
}

/// The cases of each (map, disc map, bits of the exponent).
pub type Table = HashMap<(String, String, String), Vec<Case>>;

/// A double by its bits in hexadecimal.
pub fn double(bits: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(bits, 16).unwrap())
}

/// The table for coordinates of `bits` bits. Those that are not read are set to a pattern.
pub fn table(bits: u32) -> Table {
    let (text, unread) = match bits {
        32 => (include_str!("../vectors/maps.csv"), 0),
        16 => (include_str!("../vectors/maps_16.csv"), UNREAD),
        _ => panic!("no table for coordinates of {bits} bits"),
    };
    let mut table = Table::new();
    for line in text.lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        let pair = |i: usize| Pair { hi: double(fields[i]), lo: double(fields[i + 1]) };
        let word = |i: usize| {
            assert_eq!(fields[i].len() as u32, bits / 4);
            u32::from_str_radix(fields[i], 16).unwrap() << (32 - bits) | unread
        };
        let case = Case {
            uv: [word(3), word(4)],
            exact: Reference {
                x: pair(5),
                y: pair(7),
                z: (!fields[9].is_empty()).then(|| pair(9)),
                s2: pair(11),
                density: pair(13),
            },
        };
        let key = (fields[0].to_string(), fields[1].to_string(), fields[2].to_string());
        table.entry(key).or_default().push(case);
    }
    table
}

/// The low bits of a coordinate of which only the top 16 are read.
pub const UNREAD: u32 = 0x9e37;
