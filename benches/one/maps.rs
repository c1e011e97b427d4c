//! Every map of every arithmetic: one point of stored coordinates. Power lobes with their density,
//! too.

use crate::calls::Calls;
use crate::words::Word;
use benches::EXPONENT;
use benches::failure::Failure;
use hemidisc::arithmetic::Arithmetic;
use hemidisc::catalogue::{self, MapVisitor, POWER_LOBES};
use hemidisc::{Invert, Map, UnitSquare};

macro_rules! arithmetics {
    ($(#[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident $facts:tt;)*) => {
        pub(crate) fn every(calls: &mut Calls<'_>) -> Result<(), Failure> {
            $(
                #[$cfg]
                of::<hemidisc::$arithmetic>(calls)?;
            )*
            Ok(())
        }
    };
}
hemidisc::for_each_arithmetic!(arithmetics);

fn of<A: Arithmetic<Real: Word>>(calls: &mut Calls<'_>) -> Result<(), Failure> {
    sample::<A, _>(calls, "square", "-", UnitSquare::<A>::new());
    catalogue::maps::<A>(&mut Maps { calls });
    let exponent =
        EXPONENT.to_string().parse::<A::Parameter>().map_err(|error| error.to_string())?;
    catalogue::power_maps::<A>(exponent, &mut Maps { calls })?;
    Ok(())
}

fn sample<A: Arithmetic, M: Map<Point: Word> + 'static>(
    calls: &mut Calls<'_>,
    name: &str,
    disc: &str,
    map: M,
) {
    let path = format!("map/{name}/{disc}/{}", A::NAME);
    calls.call(&path, move |given| map.sample(given.pair()));
}

struct Maps<'c, 'a> {
    calls: &'c mut Calls<'a>,
}

impl<A: Arithmetic<Real: Word>> MapVisitor<A> for Maps<'_, '_> {
    fn disc<M: Invert<Point = [A::Real; 2]> + 'static>(&mut self, name: &'static str, map: M) {
        sample::<A, _>(self.calls, "disc", name, map);
    }

    fn hemisphere<M: Invert<Point = [A::Real; 3]> + 'static>(
        &mut self,
        name: &'static str,
        disc: &'static str,
        map: M,
    ) {
        sample::<A, _>(self.calls, name, disc, map);
        if POWER_LOBES.contains(&name) {
            let path = format!("density/{name}/{disc}/{}", A::NAME);
            self.calls.call(&path, move |given| map.sample_with_density(given.pair()));
        }
    }
}
