//! Every file of a family is in the family's list, so that no member escapes the tests.

use hemidisc::catalogue::{
    ARITHMETICS, AVAILABLE_ARITHMETICS, ArithmeticVisitor, SEQUENCES, SequenceVisitor, arithmetics,
    sequences,
};
use hemidisc::sequence::{Sequence, grid};
use hemidisc::{Error, arithmetic::Arithmetic};
use std::collections::BTreeSet;
use std::path::Path;

/// The names of the source files of a family.
fn files(family: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(family);
    let entries = std::fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
        .map(|path| path.file_stem().unwrap().to_string_lossy().into_owned())
        .collect()
}

/// The names of the disc maps that the source defines.
#[cfg(feature = "libm")]
fn disc_maps() -> BTreeSet<String> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/map/disc.rs");
    let text = std::fs::read_to_string(source).unwrap();
    let defined = text.lines().filter_map(|line| line.strip_prefix("disc_map!("));
    // The type, then the kernel, whose name is the map's.
    defined.map(|map| map.split([',', ' ']).nth(2).unwrap().to_owned()).collect()
}

struct Names(Vec<&'static str>);

impl SequenceVisitor for Names {
    fn visit<S: Sequence>(&mut self, name: &'static str, _: S) {
        self.0.push(name);
    }
}

impl ArithmeticVisitor for Names {
    fn visit<A: Arithmetic>(&mut self) {
        self.0.push(A::NAME);
    }
}

#[test]
fn every_sequence_is_listed() {
    let mut names = Names(Vec::new());
    sequences(64, 0, &mut names).unwrap();
    assert_eq!(names.0, SEQUENCES);
    // What takes points of the caller's, and what sequences share, has no place in a list of what
    // makes points.
    let others = ["stored", "shuffled", "shifted", "rng", "walk", "in_domain"];
    macro_rules! listed {
        ($($file:ident $sequence:ident $name:literal $kind:ident $new:ident $parts:tt;)*) => {
            [$(stringify!($file)),*]
        };
    }
    let listed = hemidisc::for_each_sequence!(listed);
    let expected: BTreeSet<_> = listed.into_iter().chain(others).map(String::from).collect();
    assert_eq!(files("sequence"), expected);
}

#[test]
fn every_arithmetic_is_listed() {
    let mut names = Names(Vec::new());
    arithmetics(&mut names);
    assert_eq!(names.0, AVAILABLE_ARITHMETICS);
    // Those of this build are some of all, in the same order.
    let mut all = ARITHMETICS.iter();
    assert!(names.0.iter().all(|name| all.any(|listed| listed == name)), "{:?}", names.0);
    if cfg!(all(feature = "libm", feature = "micromath", feature = "fixed-point")) {
        assert_eq!(names.0, ARITHMETICS);
    }
    let machinery = ["fixed", "float"];
    let listed = ARITHMETICS.iter().map(|name| name.replace('-', "_"));
    let expected: BTreeSet<_> = listed.chain(machinery.map(String::from)).collect();
    assert_eq!(files("arithmetic"), expected);
}

#[cfg(feature = "libm")]
#[test]
fn every_map_is_listed() {
    use hemidisc::catalogue::{DISC_MAPS, LOBES, MapVisitor, POWER_LOBES, maps, power_maps};
    use hemidisc::{LibmF32, Map};
    #[derive(Default)]
    struct Maps {
        discs: BTreeSet<String>,
        lobes: BTreeSet<(String, String)>,
    }
    impl MapVisitor<LibmF32> for Maps {
        fn disc<M: Map>(&mut self, name: &'static str, _: M) {
            self.discs.insert(name.into());
        }
        fn hemisphere<M: Map>(&mut self, name: &'static str, disc: &'static str, _: M) {
            self.lobes.insert((name.into(), disc.into()));
        }
    }
    let mut found = Maps::default();
    maps::<LibmF32>(&mut found);
    power_maps::<LibmF32>(1.0, &mut found).unwrap();
    let discs = disc_maps();
    assert_eq!(found.discs, discs);
    let lobes = files("map/hemisphere");
    let pairs = lobes.iter().flat_map(|lobe| discs.iter().map(|d| (lobe.clone(), d.clone())));
    assert_eq!(found.lobes, pairs.collect());
    let names = |list: &[&str]| list.iter().map(|name| (*name).to_owned()).collect();
    assert_eq!((names(DISC_MAPS), names(LOBES)), (discs.clone(), lobes));
    let mut powers = Maps::default();
    power_maps::<LibmF32>(1.0, &mut powers).unwrap();
    let powers: BTreeSet<_> = powers.lobes.into_iter().map(|(lobe, _)| lobe).collect();
    assert_eq!(names(POWER_LOBES), powers);
}

struct Sizes(Vec<Option<u32>>);

impl SequenceVisitor for Sizes {
    fn visit<S: Sequence>(&mut self, _: &'static str, sequence: S) {
        self.0.push(sequence.size());
    }
}

#[test]
fn grids_have_exactly_their_points() {
    let large = [65_535, 65_536, 65_537, 1 << 30, 4_294_836_225, u32::MAX - 1, u32::MAX];
    for count in (1..=1000).chain(large) {
        let [columns, rows] = grid(count);
        assert_eq!(columns.checked_mul(rows), Some(count));
        // No divisor is between the two.
        let nearer =
            (u64::from(columns) + 1..=u64::from(count).isqrt()).find(|d| u64::from(count) % d == 0);
        assert!(columns <= rows && nearer.is_none(), "{count}: {columns} x {rows}, {nearer:?}");
        let mut sizes = Sizes(Vec::new());
        sequences(count, 7, &mut sizes).unwrap();
        assert_eq!(sizes.0.len(), SEQUENCES.len());
        assert!(sizes.0.iter().flatten().all(|&of| of == count), "{count}");
    }
    assert_eq!([grid(32), grid(7), grid(35), grid(300)], [[4, 8], [1, 7], [5, 7], [15, 20]]);
    assert_eq!(grid(u32::MAX), [65_535, 65_537]);
    assert_eq!(grid(4_294_967_291), [1, 4_294_967_291], "a prime");
    let mut sizes = Sizes(Vec::new());
    let empty = sequences(0, 0, &mut sizes);
    assert_eq!(empty, Err(Error::EmptyGrid { columns: 0, rows: 0 }));
    assert_eq!(sizes.0, [], "nothing is visited");
}

#[test]
fn every_effect_is_listed() {
    use hemidisc::catalogue::EFFECTS;
    macro_rules! listed {
        ($($file:ident $effect:ident $name:literal;)*) => {
            (vec![$(stringify!($file).to_string()),*], vec![$($name),*])
        };
    }
    let (mut listed, names) = hemidisc::for_each_effect!(listed);
    assert_eq!(names, EFFECTS);
    // An aperture is a map, and a heuristic a function of densities: no effects.
    listed.extend(["polygon".into(), "heuristics".into()]);
    assert_eq!(files("effect"), listed.into_iter().collect());
}
