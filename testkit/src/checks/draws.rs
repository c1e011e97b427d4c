//! Points by chance: rejection's iterators, a generator as a sequence, and maps as distributions.

use super::convert::assert_clear;
use crate::arithmetics::{EachArithmetic, Tested};
use hemidisc::disc::Rejection;
use hemidisc::sequence::Random;
use hemidisc::{Concentric, Error, Map, Points, UnitSquare};

/// Draws of a seed, a number of candidates and a limit for each point.
#[derive(arbitrary::Arbitrary, Clone, Copy, Debug)]
pub struct Draws {
    seed: u32,
    count: u8,
    limit: u8,
}

impl EachArithmetic for Draws {
    fn each<A: Tested>(&mut self) {
        self.rejected::<A>();
        drawn::<A>(self.seed);
    }
}

impl Draws {
    /// The survivors in order, and how many candidates they took.
    fn rejected<A: Tested>(self) {
        let square = UnitSquare::<A>::new();
        let random = Random::new(self.seed);
        let count = u32::from(self.count);
        let points = Points::with_range(random, square, ..count).unwrap();
        let survivors: Vec<_> =
            points.iter_coordinates().filter_map(Rejection::<A>::sample).collect();
        let mut kept = Rejection::<A, _>::new(points.iter_coordinates());
        assert_eq!(kept.size_hint(), (0, Some(count as usize)));
        assert!(kept.by_ref().eq(survivors.iter().copied()), "{} {self:?}", A::NAME);
        assert_eq!((kept.drawn(), kept.kept()), (count.into(), survivors.len() as u64));
        let endless = || (0..).map(move |index| random.at(index));
        assert!(Rejection::<A, _>::with_draws(endless(), count).eq(survivors.iter().copied()));

        let limit = u32::from(self.limit);
        match Rejection::<A, _>::with_limit(endless(), limit) {
            Ok(mut bounded) => {
                let (mut next, disc) = (0, Concentric::<A>::new());
                for point in bounded.by_ref().take(16) {
                    // The first that is inside, or the last one mapped.
                    let inside = |at: &u32| Rejection::<A>::inside(random.at(*at));
                    let last = next + limit - 1;
                    let at = (next..last).find(inside).unwrap_or(last);
                    let expected = if at == last {
                        Some(disc.sample(random.at(at)))
                    } else {
                        Rejection::<A>::sample(random.at(at))
                    };
                    assert_eq!(Some(point), expected, "{} {self:?}", A::NAME);
                    next = at + 1;
                }
                assert_eq!(bounded.drawn(), next.into(), "{} {self:?}", A::NAME);
                assert!(bounded.kept() <= 16);
            }
            Err(error) => {
                assert_clear(&error);
                assert_eq!((error, limit), (Error::NoDraws, 0));
            }
        }
    }
}

/// A map draws two words of a generator, u first; the generator as a sequence gives the same.
#[cfg(all(feature = "rand", feature = "rand_core"))]
fn drawn<A: Tested>(seed: u32) {
    use hemidisc::sequence::FromRng;
    use hemidisc::{Cosine, Polar};
    use rand::distr::Distribution;
    use rand::{SeedableRng, rngs::SmallRng};
    let mut rng = SmallRng::seed_from_u64(seed.into());
    let mut points = FromRng::new(rng.clone());
    let mut uv = || points.next().unwrap();
    let (square, concentric) = (UnitSquare::<A>::new(), Concentric::<A>::new());
    let (polar, cosine) = (Polar::<A>::new(), Cosine::<A>::new());
    assert_eq!(Distribution::sample(&square, &mut rng), Map::sample(&square, uv()));
    assert_eq!(Distribution::sample(&concentric, &mut rng), Map::sample(&concentric, uv()));
    assert_eq!(Distribution::sample(&polar, &mut rng), Map::sample(&polar, uv()));
    assert_eq!(Distribution::sample(&cosine, &mut rng), Map::sample(&cosine, uv()));
    assert_eq!(points.into_inner(), rng);
}

#[cfg(not(all(feature = "rand", feature = "rand_core")))]
fn drawn<A: Tested>(_: u32) {}
