//! Domains: the points of siblings are independent, and so are their streams. A shuffle keeps its
//! set and changes the order.

use hemidisc::{
    Domain,
    bits::hash::mix,
    invariant,
    sequence::{MultiJittered, Regular, Sequence, Shuffled, Sobol, SobolOwen, Stored},
};
use std::collections::HashSet;
use testkit::chi_square::{assert_random, assert_uniform};

/// Cells of a 4 x 4 grid that the first `count` pairs of coordinates fill.
fn filled(count: u32, pair: impl Fn(u32) -> [u32; 2]) -> u32 {
    let cells =
        (0..count).map(pair).fold(0_u16, |cells, [a, b]| cells | 1 << (a >> 30 << 2 | b >> 30));
    cells.count_ones()
}

/// Pairs that share an order leave 12 of 16 cells empty. Siblings fill as
/// many as 4 x 4 random permutations of a binary tree do, 16 (1 - (3/4)^(n/4)) for n points; over
/// 100,000 pairs 10.9, 14.4 and 15.8 were measured, and all 16 cells in 3-9, 43-47 and 92-93 % of them.
#[test]
fn siblings_pair_as_if_independent() {
    let (sobol, scrambled) = (Sobol::new(0), Sobol::new(7));
    assert_eq!(filled(64, |i| [sobol.at(i)[0], scrambled.at(i)[0]]), 4);

    // Of 1000 pairs: how many may fill less than half, and must fill all.
    let counts = [(16, 10.94, 90, 15), (32, 14.41, 5, 380), (64, 15.84, 0, 900)];
    for (count, expected, poor, full) in counts {
        for (axis, other) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let fills: Vec<u32> = (0..1000)
                .map(|i| {
                    let parent = Domain::new(7).child(i);
                    let lens = SobolOwen::in_domain(parent.child(0));
                    let light = SobolOwen::in_domain(parent.child(1));
                    filled(count, |i| [lens.at(i)[axis], light.at(i)[other]])
                })
                .collect();
            let what = format!("{count} points, axes {axis} and {other}");
            let mean = f64::from(fills.iter().sum::<u32>()) / 1000.0;
            assert!((mean - expected).abs() < 0.25, "{what}: {mean} cells, expected {expected}");
            let [few, all] =
                [0..8, 16..17].map(|r| fills.iter().filter(|&f| r.contains(f)).count());
            assert!(few <= poor && all >= full, "{what}: {few} fill less than half, {all} all");
        }
    }
}

/// Streams and points of one domain, and of a child and its parent, pair as if independent.
#[test]
fn streams_pair_as_if_independent() {
    for axis in [0, 1] {
        let mut sums = [0; 3];
        for i in 0..1000 {
            let domain = Domain::new(i);
            let (points, stream) = (SobolOwen::in_domain(domain), domain.stream());
            let child = domain.child(0);
            let (below, other) = (SobolOwen::in_domain(child), child.stream());
            sums[0] += filled(64, |i| [points.at(i)[axis], stream.at(i)]);
            sums[1] += filled(64, |i| [points.at(i)[axis], below.at(i)[axis]]);
            sums[2] += filled(64, |i| [stream.at(i), other.at(i)]);
        }
        assert!(sums.iter().all(|&sum| (15_500..16_000).contains(&sum)), "{sums:?} of 16,000");
    }
}

/// The order of the first 64 points of a domain, as what the places differ in from the first: the
/// scramble of an axis hides a difference that all have in common.
fn order(domain: Domain) -> Vec<u32> {
    let shuffled = Shuffled::new(Sobol::new(0), domain);
    let place = |i| shuffled.at(i)[0].reverse_bits() & 63;
    (1..64).map(|i| place(i) ^ place(0)).collect()
}

/// Pairs of domains of which the first 64 points have the same order.
fn alike(domains: impl Iterator<Item = Domain>) -> usize {
    let mut orders: Vec<_> = domains.map(order).collect();
    orders.sort_unstable();
    orders.chunk_by(|a, b| a == b).map(|alike| alike.len() * (alike.len() - 1) / 2).sum()
}

/// The shuffle has so many orders of 64 points that 1 of some 80,000 pairs of random keys share
/// one: of 6.25 million pairs some 76. No family of domains has more than random states have.
#[test]
fn few_domains_share_an_order() {
    let root = Domain::new(7);
    let random = |seed: u32| {
        (0..3536)
            .map(move |i| Domain::from_words([mix(mix(2 * i) ^ seed), mix(mix(2 * i + 1) ^ !seed)]))
    };
    let expected = (0..8).map(|seed| alike(random(seed))).sum::<usize>() as f64 / 8.0;
    assert!((60.0..95.0).contains(&expected), "{expected}");
    let most = expected + 5.0 * expected.sqrt();
    type Member = fn(Domain, u32) -> Domain;
    let families: [(&str, Member); 6] = [
        ("seeds", |_, i| Domain::new(i)),
        ("siblings", |root, i| root.child(i)),
        ("pixels in x", |root, i| root.pixel(i, 5)),
        ("pixels in y", |root, i| root.pixel(5, i)),
        ("bounces", |root, i| root.child(i >> 2).child(i & 3)),
        ("generations", |root, i| (0..=i).fold(root, |domain, _| domain.child(1))),
    ];
    for (what, member) in families {
        let found = alike((0..3536).map(|i| member(root, i))) as f64;
        println!("{what}: {found}, {expected} of random states");
        assert!(found <= most, "{what}: {found} pairs, {expected} of random states");
    }
}

/// The correlation of 16 values with 16 others, in the order of their indices.
fn correlation(pair: impl Fn(u32) -> [u32; 2]) -> f64 {
    let centred = |cell: u32| f64::from(cell) / 4_294_967_296.0 - 0.5;
    let products = (0..16).map(|i| pair(i).map(centred)).map(|[a, b]| a * b);
    12.0 * products.sum::<f64>() / 16.0
}

/// Siblings, parents and children, neighbours in x and in y: the correlation of their points, axis
/// by axis and with the stream, is 0 over 2^16 pairs, and its spread is that of random states.
#[test]
fn neighbours_are_not_correlated() {
    type Neighbours = fn(u32) -> [Domain; 2];
    const PAIRS: u32 = 1 << 16;
    let moments = |neighbours: &dyn Fn(u32) -> [Domain; 2]| {
        let mut sums = [[0.0; 2]; 5];
        for i in 0..PAIRS {
            let [a, b] = neighbours(i);
            let [first, second] = [a, b].map(SobolOwen::in_domain);
            let streams = [a, b].map(Domain::stream);
            let found = [
                correlation(|i| [first.at(i)[0], second.at(i)[0]]),
                correlation(|i| [first.at(i)[0], second.at(i)[1]]),
                correlation(|i| [first.at(i)[1], second.at(i)[1]]),
                correlation(|i| [first.at(i)[0], streams[0].at(i)]),
                correlation(|i| streams.map(|stream| stream.at(i))),
            ];
            for (sums, found) in sums.iter_mut().zip(found) {
                *sums = [sums[0] + found, sums[1] + found * found];
            }
        }
        sums.map(|sums| sums.map(|sum| sum / f64::from(PAIRS)))
    };
    let random = |i: u32| [[mix(i), mix(!i)], [mix(i ^ 0x5555), mix(i ^ 0xaaaa_0000)]];
    let expected = moments(&|i| random(i).map(Domain::from_words));
    let families: [(&str, Neighbours); 5] = [
        ("siblings", |i| {
            [Domain::new(i >> 8).child(i & 255), Domain::new(i >> 8).child((i & 255) + 1)]
        }),
        ("parent and child", |i| [Domain::new(i), Domain::new(i).child(0)]),
        ("in x", |i| {
            [Domain::new(7).pixel(i & 255, i >> 8), Domain::new(7).pixel((i & 255) + 1, i >> 8)]
        }),
        ("in y", |i| {
            [Domain::new(7).pixel(i & 255, i >> 8), Domain::new(7).pixel(i & 255, (i >> 8) + 1)]
        }),
        ("two bounces", |i| {
            [Domain::new(7).child(i).child(5), Domain::new(7).child(i).child(5).child(5)]
        }),
    ];
    for (what, neighbours) in families {
        for (place, ([mean, square], [_, usual])) in
            moments(&neighbours).into_iter().zip(expected).enumerate()
        {
            // The deviation of a mean of 2^16.
            let deviation = (usual / f64::from(PAIRS)).sqrt();
            assert!(mean.abs() < 5.0 * deviation, "{what}, {place}: {mean} of {deviation}");
            assert!(
                (square / usual - 1.0).abs() < 0.05,
                "{what}, {place}: {square}, usually {usual}"
            );
        }
    }
}

fn domains() -> Vec<(&'static str, Vec<Domain>)> {
    let root = Domain::new(0);
    vec![
        ("seeds", (0..1 << 14).map(Domain::new).collect()),
        ("children", (0..1 << 14).map(|key| root.child(key)).collect()),
        ("pixels", (0..1 << 14).map(|i| root.pixel(i & 127, i >> 7)).collect()),
        ("high keys", (0..1 << 14).map(|i| root.child(i << 18)).collect()),
        ("bounces", (0..1 << 14).map(|i| root.child(i >> 2).child(i & 3)).collect()),
    ]
}

#[test]
fn first_points_differ() {
    for (name, domains) in domains() {
        let domains = &domains[..1000];
        let points: HashSet<_> = domains.iter().map(|&d| SobolOwen::in_domain(d).at(0)).collect();
        let streams: HashSet<_> = domains.iter().map(|d| d.stream().at(0)).collect();
        let seeds: HashSet<_> = domains.iter().map(|d| d.seed()).collect();
        let distinct = [domains.iter().collect::<HashSet<_>>().len(), points.len()];
        assert_eq!(distinct, [1000; 2], "{name}");
        assert_eq!([streams.len(), seeds.len()], [1000; 2], "{name}");
    }
}

/// The first points over domains are uniform, and those of neighbours are not related.
#[test]
fn first_points_are_uniform() {
    for (name, domains) in domains() {
        let firsts: Vec<_> = domains.iter().map(|&d| SobolOwen::in_domain(d).at(0)).collect();
        let streams: Vec<_> = domains.iter().map(|d| d.stream().at(0)).collect();
        let count = |cells: &mut dyn Iterator<Item = [u32; 2]>| {
            let mut counts = [0; 256];
            cells.for_each(|[a, b]| counts[(a >> 28 << 4 | b >> 28) as usize] += 1);
            counts
        };
        assert_random(&count(&mut firsts.iter().copied()), &format!("first points over {name}"));
        for axis in [0, 1] {
            let mut neighbours = firsts.windows(2).map(|pair| [pair[0][axis], pair[1][axis]]);
            let what = format!("axis {axis} of first points of neighbouring {name}");
            assert_random(&count(&mut neighbours), &what);
            let mut paired = firsts.iter().zip(&streams).map(|(point, &t)| [point[axis], t]);
            assert_random(&count(&mut paired), &format!("axis {axis} and the stream over {name}"));
        }
    }
}

/// The branches of all samples of a split are one sequence: aligned blocks are nets.
#[test]
fn splits_are_one_stream() {
    let split = Domain::new(7).split(3, 4);
    let points = SobolOwen::in_domain(split.domain());
    for block in [0, 64, 1 << 20] {
        let indices = (block..block + 64).flat_map(|sample| split.branches(sample).unwrap());
        assert!(indices.eq(4 * block..4 * (block + 64)));
        assert_eq!(invariant::net(&points, 4 * block, 8, &mut [0; 8]), Ok(()));
    }
}

/// The order of a shuffled set of `size` points: where each came from.
fn assert_shuffled(set: impl Sequence, what: &str) {
    let size = set.size().unwrap();
    let sorted = |sequence: &dyn Fn(u32) -> [u32; 2]| {
        let mut points: Vec<_> = (0..size).map(sequence).collect();
        points.sort_unstable();
        points
    };
    let orders = [Domain::new(1), Domain::new(2)].map(|domain| {
        let shuffled = Shuffled::new(set, domain);
        assert_eq!(shuffled.size(), Some(size), "{what}");
        assert_eq!(sorted(&|i| shuffled.at(i)), sorted(&|i| set.at(i)), "{what}: other points");
        (0..size).map(|i| shuffled.at(i)).collect::<Vec<_>>()
    });
    let straight: Vec<_> = (0..size).map(|i| set.at(i)).collect();
    for (a, b) in [(&orders[0], &orders[1]), (&orders[0], &straight), (&orders[1], &straight)] {
        let same = a.iter().zip(b).filter(|(a, b)| a == b).count();
        assert!(same < 10 + size as usize / 4, "{what}: {same} of {size} stay");
    }
}

#[test]
fn a_shuffle_keeps_the_set() {
    assert_shuffled(Regular::new(8, 8).unwrap(), "regular");
    assert_shuffled(MultiJittered::new(37, 27, 7).unwrap(), "multi-jittered");
    // A multiset: every fourth point four times.
    let points: Vec<_> = (0..400).map(|i| [mix(i / 4), mix(!(i / 4))]).collect();
    assert_shuffled(Stored::new(&points).unwrap(), "stored");

    // Which point comes first is uniform over domains.
    let set = Regular::new(4, 4).unwrap();
    let mut counts = [0; 16];
    for key in 0..16_000 {
        let [u, v] = Shuffled::new(set, Domain::new(1).child(key)).at(0);
        counts[(u >> 30 << 2 | v >> 30) as usize] += 1;
    }
    assert_uniform(&counts, "first point of a shuffled grid");
}

/// A shuffle of an endless sequence takes aligned blocks of 2^k to aligned blocks of 2^k.
#[test]
fn a_shuffle_keeps_aligned_blocks() {
    let index = |[u, _]: [u32; 2]| u.reverse_bits();
    for key in 0..50 {
        let shuffled = Shuffled::new(Sobol::new(0), Domain::new(key));
        for k in 0..=10_u32 {
            for start in [0, 1 << k, 7 << k, (u32::MAX >> k) << k] {
                let mut block: Vec<_> =
                    (0..1 << k).map(|i| index(shuffled.at(start + i))).collect();
                block.sort_unstable();
                let first = block[0];
                assert_eq!(first % (1 << k), 0, "key {key}, 2^{k} from {start}");
                assert!(block.into_iter().zip(first..).all(|(a, b)| a == b), "key {key}, 2^{k}");
            }
        }
    }
    let starts: HashSet<_> =
        (0..1000).map(|key| index(Shuffled::new(Sobol::new(0), Domain::new(key)).at(0))).collect();
    assert_eq!(starts.len(), 1000, "orders of different domains start alike");
}

/// A checkpoint: the words of a domain are all of it.
#[test]
fn words_are_the_whole_domain() {
    for i in 0..1000 {
        let words = [mix(i), mix(!i)];
        let domain = Domain::from_words(words);
        assert_eq!(domain.to_words(), words);
        let made = Domain::new(i).pixel(i, 3).child(2);
        let again = Domain::from_words(made.to_words());
        assert_eq!((again, again.child(1)), (made, made.child(1)));
        assert_eq!(again.stream().at(5), made.stream().at(5));
        assert_eq!(SobolOwen::in_domain(again).at(5), SobolOwen::in_domain(made).at(5));
    }
}
