//! What is printed of each point: the crate's own bits, exact decimals, inverses, rejection.

use super::{hard_pairs, hex, hexes, pair, points, points_of, same, square};
use hemidisc::Invert;
use hemidisc::catalogue::{AVAILABLE_ARITHMETICS, DISC_MAPS, LOBES, POWER_LOBES, SEQUENCES};
use testkit::arithmetics::{EachArithmetic, Exponent, Number, Tested, every_arithmetic};
use testkit::errors::{EachMap, each_map, each_power_map};
use testkit::programs::map_arguments;

/// The maps of the command line with what they need; those that keep every point.
fn maps() -> Vec<String> {
    let mut maps = Vec::new();
    for disc in DISC_MAPS {
        maps.push(map_arguments("disc", disc, ""));
        for lobe in LOBES {
            let exponents = if POWER_LOBES.contains(lobe) { &EXPONENTS[..] } else { &[""] };
            maps.extend(exponents.iter().map(|e| map_arguments(lobe, disc, e)));
        }
    }
    maps
}

/// Of the power lobes, as arguments.
const EXPONENTS: [&str; 4] = ["0", "1", "50", "1e8"];

/// Of the power lobe, as an argument.
const EXPONENT: &str = "2.5";

/// Compares every map of the catalogue with the rows that the program prints.
struct SameBits {
    pairs: Vec<[u32; 2]>,
    maps: usize,
}

impl SameBits {
    fn check<A: Tested, const D: usize>(
        &mut self,
        name: &str,
        map: impl Invert<Point = [A::Real; D]>,
    ) {
        let arguments = format!("--map {name} --arithmetic {}", A::NAME);
        let rows = self.pairs.iter().map(|uv| {
            let point = map.sample(*uv);
            let components: Vec<_> = point.iter().map(|number| number.raw()).collect();
            [components.join(","), map.density(point).raw(), hex(&map.invert(point))]
        });
        let rows: Vec<_> = rows.collect();
        let columns = if D == 3 { "x,y,z" } else { "x,y" };
        let compare = |more: &str, header: &str, row: &dyn Fn(&[String; 3]) -> String| {
            let arguments = format!("{arguments} --raw {more}");
            let (printed, actual) = points_of(&self.pairs, &arguments).quiet();
            assert_eq!(printed, header, "{arguments}");
            same(&actual, rows.iter().map(row), &arguments);
        };
        compare("", columns, &|[point, ..]| point.clone());
        compare("--density", &format!("{columns},density"), &|[point, density, _]| {
            format!("{point},{density}")
        });
        compare("--invert", "u,v", &|[.., inverse]| inverse.clone());
        compare("--invert --density", "u,v,density", &|[_, density, inverse]| {
            format!("{inverse},{density}")
        });
        self.maps += 1;
    }
}

impl<A: Tested> EachMap<A> for SameBits {
    fn each<const D: usize, M: Invert<Point = [A::Real; D]>>(
        &mut self,
        kind: &'static str,
        disc: &'static str,
        map: M,
    ) {
        let name = map_arguments(kind, disc, EXPONENT);
        self.check::<A, _>(&name, map);
        if kind != "disc" && disc == "concentric" {
            // The default.
            self.check::<A, _>(&name.replace(" --disc concentric", ""), map);
        }
    }
}

fn prints_the_bits_of_the_crate<A: Tested>() {
    let mut check = SameBits { pairs: hard_pairs(), maps: 0 };
    each_map::<A>(&mut check);
    each_power_map::<A>(A::Parameter::exactly(EXPONENT.parse().unwrap()).unwrap(), &mut check);
    // Each map, and each lobe over the default.
    assert_eq!(check.maps, DISC_MAPS.len() * (1 + LOBES.len()) + LOBES.len());
}

testkit::test_each_arithmetic!(prints_the_bits_of_the_crate);

#[test]
fn the_default_arithmetic_is_libm_f32() {
    let arguments = "--sequence sobol --count 8 --map disc-polar";
    let named = points(&format!("{arguments} --arithmetic libm-f32")).quiet();
    assert_eq!(points(arguments).quiet(), named);
}

/// That decimals are what they should be of the raw bits, on every map.
struct Decimals;

impl EachArithmetic for Decimals {
    fn each<A: Tested>(&mut self) {
        for map in maps() {
            let arguments = format!("--arithmetic {} --map {map} --density", A::NAME);
            let (header, decimals) = points_of(&hard_pairs(), &arguments).quiet();
            let (same_header, raws) =
                points_of(&hard_pairs(), &format!("{arguments} --raw")).quiet();
            assert_eq!(header, same_header);
            assert_eq!(decimals.len(), hard_pairs().len());
            for (decimals, raws) in decimals.iter().zip(&raws) {
                assert_eq!(decimals.split(',').count(), header.split(',').count());
                assert_eq!(raws.split(',').count(), header.split(',').count());
                for (decimal, raw) in decimals.split(',').zip(raws.split(',')) {
                    assert_eq!(decimal, A::Real::decimal(raw), "{arguments}: {raw}");
                }
            }
        }
    }
}

#[test]
fn decimals_read_back_exactly() {
    every_arithmetic(&mut Decimals);
}

#[test]
fn libm_f64_gives_every_coordinate_back() {
    let gives_back = |map: &str| {
        let arguments = format!("--map {map} --arithmetic libm-f64 --invert");
        let (_, rows) = points_of(&hard_pairs(), &arguments).quiet();
        same(&rows, hexes(hard_pairs()), &arguments);
    };
    gives_back("square");
    maps().iter().for_each(|map| gives_back(map));
}

#[test]
fn the_square_is_not_rounded() {
    for arithmetic in AVAILABLE_ARITHMETICS {
        for raw in ["", " --raw"] {
            let arguments = format!("--map square --arithmetic {arithmetic}{raw}");
            let (header, rows) = points_of(&hard_pairs(), &arguments).quiet();
            assert_eq!(header, "u,v");
            same(&rows, hexes(hard_pairs()), &arguments);
        }
    }
    let (header, rows) = points("--sequence r2 --count 1 --map square --density").quiet();
    assert_eq!((header.as_str(), rows[0].as_str()), ("u,v,density", "0xc13fa9a9,0x91e10da5,1.0"));
}

/// Whether the centre of a cell of [-1, 1]^2 is in the disc: (2k + 1 - 2^32)^2 sum up to 2^64.
fn inside(row: &str) -> bool {
    let square = |k: u32| (2 * i128::from(k) + 1 - (1 << 32)).pow(2);
    let [u, v] = pair(row).map(square);
    u + v <= 1 << 64
}

#[test]
fn rejection_keeps_and_counts_what_is_inside() {
    for sequence in SEQUENCES {
        let arguments = format!("--sequence {sequence} --count 1024 --seed 3");
        let mut inside_rows = square(&arguments);
        inside_rows.retain(|row| inside(row));
        let kept = inside_rows.len();
        assert!((760..850).contains(&kept), "{sequence}: {kept}");
        let rejection = format!("{arguments} --map disc-rejection --arithmetic libm-f64");
        let run = points(&rejection);
        assert_eq!(run.status, 0);
        assert_eq!(run.stderr, format!("drawn 1024, kept {kept}\n"), "{sequence}");
        let (header, rows) = run.table();
        assert_eq!((header.as_str(), rows.len()), ("x,y", kept));
        let centres = inside_rows.iter().map(|row| {
            let [x, y] = pair(row).map(|k| (2.0 * f64::from(k) + 1.0) / 4_294_967_296.0 - 1.0);
            format!("{x:?},{y:?}")
        });
        same(&rows, centres, &rejection);
        let (header, rows) = points(&format!("{rejection} --invert --density")).table();
        assert_eq!(header, "u,v,density");
        let density = std::f64::consts::FRAC_1_PI;
        same(&rows, inside_rows.iter().map(|row| format!("{row},{density:?}")), &rejection);
    }
    let run = points_of(&[[0, 0], [0, 1 << 31]], "--map disc-rejection");
    assert_eq!((run.status, run.stderr.as_str()), (0, "drawn 2, kept 1\n"));
}
