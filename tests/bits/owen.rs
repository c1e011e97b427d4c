//! Owen's scramble against the crate `sobol_burley`, whose constants it uses.

use hemidisc::bits::{
    hash::mix,
    owen::{scramble, scramble_reversed},
};
use sobol_burley::parts::owen_scramble_rev;

#[test]
fn owen_scrambling_is_that_of_sobol_burley() {
    let check = |x, seed| {
        let expected = owen_scramble_rev(x, seed);
        assert_eq!(scramble_reversed(x, seed), expected, "{x:#x} with seed {seed:#x}");
        assert_eq!(scramble(x.reverse_bits(), seed), expected.reverse_bits());
    };
    let edges = (0..32).flat_map(|bit| [1 << bit, (1_u32 << bit) - 1, !(1 << bit)]);
    let edges: Vec<u32> = edges.chain([0, u32::MAX]).collect();
    for (&x, &seed) in edges.iter().flat_map(|x| edges.iter().map(move |seed| (x, seed))) {
        check(x, seed);
    }
    for i in 0..1_000_000 {
        check(mix(i), mix(!i));
    }
}
