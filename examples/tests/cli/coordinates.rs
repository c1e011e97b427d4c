//! Which coordinates are printed: references, formulas, ranges, seeds and standard input.

use super::{hex, hexes, leave_after, pair, points, points_of, run, same, square};
use hemidisc::catalogue::SEQUENCES;
use hemidisc::screen::Pixel;
use hemidisc::sequence::{Sobol, SobolOwen};
use hemidisc::{Domain, Screen};

macro_rules! takes {
    ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*) => {
        /// What the constructor of each sequence takes.
        const TAKES: &[(&str, &[&str])] = &[$(($name, &[$(stringify!($part)),*])),*];
    };
}
hemidisc::for_each_sequence!(takes);

/// The sequences whose constructors take one of these.
fn taking(parts: &[&str]) -> Vec<&'static str> {
    let takes = TAKES.iter().filter(|(_, takes)| takes.iter().any(|part| parts.contains(part)));
    takes.map(|(name, _)| *name).collect()
}

/// Sets whose points depend on their number; the others are endless.
fn sets() -> Vec<&'static str> {
    taking(&["columns", "count"])
}

/// Rows of a file of vectors, without its header and the index at the start of each.
fn vectors(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().skip(1).zip(0..).map(|(line, index)| {
        let mut fields = line.split(',');
        assert_eq!(fields.next(), Some(format!("{index}").as_str()));
        fields.collect()
    })
}

/// ceil(2^32 x) of a rational x.
fn up(numerator: u64, denominator: u64) -> u32 {
    let scaled = (u128::from(numerator) << 32).div_ceil(u128::from(denominator));
    u32::try_from(scaled).expect("x < 1")
}

#[test]
fn sobol_is_the_reference() {
    let expected =
        vectors(include_str!("../../../tests/vectors/sobol.csv")).map(|fields| match fields[..] {
            [u, v] => format!("0x{u},0x{v}"),
            _ => panic!("{fields:?}"),
        });
    let expected: Vec<_> = expected.collect();
    assert_eq!(expected.len(), 1024);
    same(&square("--sequence sobol --count 1024"), expected, "sobol");
}

#[test]
fn halton_is_the_reference() {
    let expected = vectors(include_str!("../../../tests/vectors/halton.csv")).map(|fields| {
        let numbers: Vec<u64> = fields.iter().map(|n| n.parse().expect("an integer")).collect();
        match numbers[..] {
            [u, of_u, v, of_v] => [up(u, of_u), up(v, of_v)],
            _ => panic!("{fields:?}"),
        }
    });
    let expected = hexes(expected);
    assert_eq!(expected.len(), 1024);
    same(&square("--sequence halton --count 1024"), expected, "halton");
}

/// Starts of runs of 100 rows: the first, some with all bits in use, the last.
const STARTS: [u32; 3] = [0, 0x5bd1_e9ff, u32::MAX - 99];

/// Compares rows of an endless sequence with a formula, for low and for high indices.
#[track_caller]
fn follows(name: &str, formula: impl Fn(u32) -> [u32; 2]) {
    for start in STARTS {
        let rows = square(&format!("--sequence {name} --count 100 --start {start}"));
        let expected = hexes((0..100).map(|i| formula(start + i)));
        same(&rows, expected, &format!("{name} from {start}"));
    }
}

#[test]
fn high_indices_of_sobol_follow_the_recurrence() {
    follows("sobol", |index| {
        let mut direction = 1_u32 << 31;
        let mut v = 0;
        for bit in 0..32 {
            v ^= if index >> bit & 1 == 1 { direction } else { 0 };
            direction ^= direction >> 1;
        }
        [index.reverse_bits(), v]
    });
}

#[test]
fn high_indices_of_halton_are_exact() {
    follows("halton", |index| {
        let (mut rest, mut numerator, mut denominator) = (u64::from(index), 0, 1);
        while rest > 0 {
            numerator = 3 * numerator + rest % 3;
            denominator *= 3;
            rest /= 3;
        }
        [index.reverse_bits(), up(numerator, denominator)]
    });
}

#[test]
fn r2_is_its_formula() {
    follows("r2", |i| {
        [0xc13f_a9a9_u64, 0x91e1_0da5].map(|step| (((u64::from(i) + 1) * step) % (1 << 32)) as u32)
    });
}

/// Compares the last rows of sets, at most 1024 of them, with a formula of index and count.
#[track_caller]
fn ends_as(name: &str, formula: impl Fn(u64, u64) -> [u32; 2]) {
    for count in [1_u32, 2, 3, 10, 12, 100, 1000, 1024, 3_486_784_401, u32::MAX] {
        let start = count.saturating_sub(1024);
        let expected = (start..count).map(|index| formula(index.into(), count.into()));
        let rows = square(&format!("--sequence {name} --count {count} --start {start}"));
        same(&rows, hexes(expected), &format!("{name} of {count}"));
    }
}

#[test]
fn hammersley_is_its_formula() {
    ends_as("hammersley", |index, count| [up(index, count), (index as u32).reverse_bits()]);
}

#[test]
fn regular_is_its_formula() {
    ends_as("regular", |index, count| {
        let columns = (1..=count.isqrt()).rev().find(|columns| count % columns == 0).unwrap();
        let centre = |c: u64, of: u64| (((2 * c + 1) << 31) / of) as u32;
        [centre(index % columns, columns), centre(index / columns, count / columns)]
    });
}

#[test]
fn shards_together_are_the_whole() {
    for name in SEQUENCES {
        let whole = square(&format!("--sequence {name} --count 150 --seed 9"));
        assert_eq!(whole.len(), 150, "{name}");
        for cut in [0, 1, 64, 149] {
            if sets().contains(name) {
                let tail = square(&format!("--sequence {name} --count 150 --start {cut} --seed 9"));
                assert_eq!(tail, whole[cut..], "{name} from {cut}");
            } else {
                let shard = |start, count| {
                    square(&format!("--sequence {name} --count {count} --start {start} --seed 9"))
                };
                let [a, b, c] = [shard(0, cut + 1), shard(cut + 1, 3), shard(cut + 4, 200)];
                let together = [a, b, c].concat();
                assert_eq!(together[..150], whole, "{name} cut at {cut}");
            }
        }
        if sets().contains(name) {
            assert!(square(&format!("--sequence {name} --count 150 --start 150")).is_empty());
        } else {
            let last = square(&format!("--sequence {name} --count 2 --start {}", u32::MAX - 1));
            let alone = square(&format!("--sequence {name} --count 1 --start {}", u32::MAX));
            assert_eq!(last[1..], alone, "{name}");
        }
    }
}

#[test]
fn the_largest_sets_count_to_the_end() {
    let [count, start] = [u32::MAX, u32::MAX - 3];
    for name in sets() {
        let arguments = format!("--sequence {name} --count {count} --start {start} --map square");
        let (status, lines, stderr) = leave_after(9, &arguments);
        assert_eq!((status, lines.len(), stderr.as_str()), (0, 4, ""), "{name}: {lines:?}");
    }
}

#[test]
fn seeds_move_the_sequences_that_take_one() {
    for name in SEQUENCES {
        let rows = |seed| square(&format!("--sequence {name} --count 64 --seed {seed}"));
        assert_eq!(rows(0), square(&format!("--sequence {name} --count 64")), "{name}: default 0");
        let ignored = !taking(&["seed", "domain"]).contains(name);
        for seed in [1, 2, u32::MAX] {
            assert_eq!(rows(0) == rows(seed), ignored, "{name}, seed {seed}");
        }
    }
}

/// The pairs of a sequence, as they are.
fn pairs(arguments: &str) -> Vec<[u32; 2]> {
    square(arguments).iter().map(|row| pair(row)).collect()
}

#[test]
fn seeds_shift_sobol_by_xor_and_r2_by_addition() {
    type Difference = fn(u32, u32) -> u32;
    for (name, difference) in
        [("sobol", (|a, b| a ^ b) as Difference), ("r2", |a, b| u32::wrapping_sub(a, b))]
    {
        let plain = pairs(&format!("--sequence {name} --count 64"));
        let seeded = pairs(&format!("--sequence {name} --count 64 --seed 5"));
        let shifts = seeded.iter().zip(&plain);
        let mut shifts = shifts.map(|(a, b)| [0, 1].map(|axis| difference(a[axis], b[axis])));
        let first = shifts.next().expect("64 points");
        assert!(first[0] != 0 && first[1] != 0 && first[0] != first[1], "{name}: {first:x?}");
        assert!(shifts.all(|shift| shift == first), "{name}");
    }
}

#[test]
fn aligned_blocks_of_scrambled_sobol_are_nets() {
    for (seed, start) in [(0, 0), (1, 0), (0, u32::MAX - 1023), (0xdead_beef_u32, 0x5bd1_e800)] {
        let range = format!("--count 1024 --start {start}");
        let all = pairs(&format!("--sequence sobol-owen {range} --seed {seed}"));
        assert_ne!(all, pairs(&format!("--sequence sobol {range}")), "seed {seed} scrambles");
        for (bits, columns) in (0..=10).flat_map(|bits| (0..=bits).map(move |a| (bits, a))) {
            for (number, block) in all.chunks(1 << bits).enumerate() {
                // Elementary intervals: 2^columns of u by 2^(bits - columns) of v.
                let interval = |[u, v]: &[u32; 2]| {
                    [u64::from(*u) >> (32 - columns), u64::from(*v) >> (32 - bits + columns)]
                };
                let mut hit: Vec<_> = block.iter().map(interval).collect();
                hit.sort_unstable();
                hit.dedup();
                let expected = 1 << bits;
                assert_eq!(hit.len(), expected, "seed {seed}, block {number}, 2^{columns} columns");
            }
        }
    }
}

#[test]
fn lines_of_standard_input_may_be_written_freely() {
    let input = b"u,v\n\n0x1,0xaBcDeF01\r\n  0X0000000f , 0xFFFFFFFF \n\n \n0x0,0x00";
    let (header, rows) = run(&["--stdin", "--map", "square"], input).quiet();
    assert_eq!(header, "u,v");
    assert_eq!(rows, hexes([[1, 0xabcd_ef01], [15, u32::MAX], [0, 0]]));
    assert_eq!(points_of(&[], "--map square").quiet().1, [""; 0]);
}

#[test]
fn a_bad_line_is_named_with_its_number() {
    let bad: [&[u8]; 13] = [
        b"0x1",
        b"0x1,",
        b",0x1",
        b"0x1,0x2,0x3",
        b"1,2",
        b"0x1,2",
        b"0.5,0.5",
        b"0x,0x1",
        b"0x123456789,0x0",
        b"0x000000001,0x0",
        b"0x+1,0x0",
        b"0x1 0x2",
        b"0x1\xff,0x2",
    ];
    for line in bad {
        let input = [b"0x1,0x2\n\n".as_slice(), line, b"\n0x3,0x4\n"].concat();
        let run = run(&["--stdin", "--map", "square"], &input);
        let text = String::from_utf8_lossy(line);
        let named = format!("--stdin: line 3 is \"{text}\"; accepted: u,v ");
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{text}");
        assert!(run.stderr.contains(&named) && run.stderr.lines().count() == 1, "{}", run.stderr);
    }
    // A header further down is not one.
    assert_eq!(run(&["--stdin", "--map", "square"], b"0x1,0x2\nu,v\n").status, 2);
}

/// A screen's pixel has the points of its sampler, through any map.
#[test]
fn a_pixel_of_a_screen_has_its_points() {
    let screen = Screen::new(Domain::new(7), [64, 48], 5).unwrap();
    let expected = |pixel: Pixel| (0..5).map(move |i| pixel.sampler(i).pair());
    for (x, y) in [(0, 0), (3, 5), (63, 47)] {
        let arguments =
            format!("--sequence sobol-owen --seed 7 --screen 64,48 --spp 5 --pixel {x},{y}");
        let pixel = screen.pixel(x, y).unwrap();
        assert_eq!(square(&arguments), hexes(expected(pixel)));
        let (header, rows) = points(&format!("{arguments} --map disc-concentric --raw")).quiet();
        assert_eq!((header.as_str(), rows.len()), ("x,y", 5));
    }
}

/// Four columns: the first two are the sequence's, scrambled or not, of a pixel too.
#[test]
fn four_dimensions_are_four_columns() {
    let joint = |pairs: [[u32; 2]; 2]| pairs.map(|pair| hex(&pair)).join(",");
    let four = |arguments: &str| {
        let (header, rows) = points(&format!("{arguments} --dimensions 4 --map square")).quiet();
        assert_eq!(header, "u,v,w,x");
        rows
    };
    for seed in [0, 9] {
        let rows = four(&format!("--sequence sobol --count 40 --start 3 --seed {seed}"));
        assert!(rows.into_iter().eq((3..43).map(|i| joint(Sobol::new(seed).joint(i)))));
        let rows = four(&format!("--sequence sobol-owen --count 40 --seed {seed}"));
        assert!(rows.into_iter().eq((0..40).map(|i| joint(SobolOwen::new(seed).joint(i)))));
    }
    let pixel = Screen::new(Domain::new(0), [9, 9], 8).unwrap().pixel(1, 2).unwrap();
    let rows = four("--sequence sobol-owen --screen 9,9 --spp 8 --pixel 1,2");
    assert!(rows.into_iter().eq((0..8).map(|i| joint(pixel.sampler(i).joint()))));
}
