//! What constructors refuse, word for word, and the largest and smallest that they accept.

use hemidisc::{
    Domain, Error,
    catalogue::Parameters,
    for_each_sequence, made_by,
    sequence::{self, Jittered, Regular, Stored},
};

fn refused<T>(result: Result<T, Error>) -> String {
    match result {
        Ok(_) => "accepted".to_string(),
        Err(error) => error.to_string(),
    }
}

/// What each sequence says to the parameters whose constructor takes one.
macro_rules! said {
    ($taken:literal $parameters:ident
        $($file:ident $sequence:ident $name:literal $kind:ident $new:ident($($part:ident),*);)*
    ) => {{
        let mut said = Vec::new();
        $(if [$(stringify!($part)),*].contains(&$taken) {
            let make = || -> Result<Option<u32>, Error> {
                let made = made_by!($kind sequence::$sequence::$new($($parameters.$part),*));
                Ok(made.size())
            };
            said.push((refused(make()), make().ok().flatten()));
        })*
        said
    }};
}

/// What each grid says to a shape.
fn grids(m: u32, n: u32) -> Vec<String> {
    let of = Parameters { columns: m, rows: n, count: 1, seed: 7, domain: Domain::new(7) };
    let said = for_each_sequence!(said "columns" of);
    let size = m.checked_mul(n).filter(|size| *size > 0);
    assert!(said.len() >= 4 && said.iter().all(|(_, found)| *found == size), "{m} x {n}: {said:?}");
    said.into_iter().map(|(text, _)| text).collect()
}

/// What each set of a number of points says to it.
fn sets(count: u32) -> Vec<String> {
    let of = Parameters { columns: 1, rows: 1, count, seed: 7, domain: Domain::new(7) };
    let said = for_each_sequence!(said "count" of);
    let size = Some(count).filter(|size| *size > 0);
    assert!(said.len() >= 2 && said.iter().all(|(_, found)| *found == size), "{count}: {said:?}");
    said.into_iter().map(|(text, _)| text).collect()
}

#[track_caller]
fn all_say(said: &[String], message: &str) {
    assert!(said.iter().all(|text| text == message), "{said:?}, not {message}");
}

#[test]
fn empty_sets() {
    for [m, n] in [[0, 0], [0, 1], [1, 0], [0, u32::MAX], [u32::MAX, 0]] {
        let message = format!("a grid of {m} x {n} points; accepted: at least 1 x 1");
        all_say(&grids(m, n), &message);
        assert_eq!(Regular::new(m, n), Err(Error::EmptyGrid { columns: m, rows: n }));
    }
    let message = "a set of 0 points; accepted: at least 1";
    all_say(&sets(0), message);
    assert_eq!(refused(Stored::new(&[])), message);
    assert_eq!(Stored::new(&[]), Err(Error::EmptySet));
}

#[test]
fn sets_too_large() {
    let half = 1 << 31;
    for [m, n] in [[65_536, 65_536], [u32::MAX, 2], [2, half], [half, 2], [u32::MAX, u32::MAX]] {
        let message = format!("a grid of {m} x {n} points; accepted: at most 4294967295 points");
        all_say(&grids(m, n), &message);
        assert_eq!(Jittered::new(m, n, 0), Err(Error::SetTooLarge { columns: m, rows: n }));
    }
}

#[test]
fn the_largest_and_the_smallest_sets() {
    for [m, n] in [[1, 1], [65_537, 65_535], [u32::MAX, 1], [1, u32::MAX], [2, u32::MAX / 2]] {
        all_say(&grids(m, n), "accepted");
    }
    for count in [1, u32::MAX] {
        all_say(&sets(count), "accepted");
    }
    assert_eq!(Stored::new(&[[7, 8]]).unwrap().size(), Some(1));
}
