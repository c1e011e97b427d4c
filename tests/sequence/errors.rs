//! What constructors refuse, word for word, and the largest and smallest that they accept.

use hemidisc::{
    Error,
    sequence::{Correlated, Hammersley, Jittered, MultiJittered, NRooks, Regular, Stored},
};

fn refused<T>(result: Result<T, Error>) -> String {
    match result {
        Ok(_) => "accepted".to_string(),
        Err(error) => error.to_string(),
    }
}

/// What each grid says to a shape.
fn grids(m: u32, n: u32) -> [String; 4] {
    [
        refused(Regular::new(m, n)),
        refused(Jittered::new(m, n, 7)),
        refused(MultiJittered::new(m, n, 7)),
        refused(Correlated::new(m, n, 7)),
    ]
}

#[test]
fn empty_sets() {
    for [m, n] in [[0, 0], [0, 1], [1, 0], [0, u32::MAX], [u32::MAX, 0]] {
        let message = format!("a grid of {m} x {n} points; accepted: at least 1 x 1");
        assert_eq!(grids(m, n), [0; 4].map(|_| message.clone()));
        assert_eq!(Regular::new(m, n), Err(Error::EmptyGrid { columns: m, rows: n }));
    }
    let message = "a set of 0 points; accepted: at least 1";
    assert_eq!(refused(NRooks::new(0, 7)), message);
    assert_eq!(refused(Hammersley::new(0)), message);
    assert_eq!(refused(Stored::new(&[])), message);
    assert_eq!(Stored::new(&[]), Err(Error::EmptySet));
}

#[test]
fn sets_too_large() {
    let half = 1 << 31;
    for [m, n] in [[65_536, 65_536], [u32::MAX, 2], [2, half], [half, 2], [u32::MAX, u32::MAX]] {
        let message = format!("a grid of {m} x {n} points; accepted: at most 4294967295 points");
        assert_eq!(grids(m, n), [0; 4].map(|_| message.clone()));
        assert_eq!(Jittered::new(m, n, 0), Err(Error::SetTooLarge { columns: m, rows: n }));
    }
}

#[test]
fn the_largest_and_the_smallest_sets() {
    for [m, n] in [[1, 1], [65_537, 65_535], [u32::MAX, 1], [1, u32::MAX], [2, u32::MAX / 2]] {
        assert_eq!(grids(m, n), [0; 4].map(|_| "accepted"));
    }
    for count in [1, u32::MAX] {
        assert_eq!(NRooks::new(count, 0).unwrap().size(), Some(count));
        assert_eq!(Hammersley::new(count).unwrap().size(), Some(count));
    }
    assert_eq!(Stored::new(&[[7, 8]]).unwrap().size(), Some(1));
}
