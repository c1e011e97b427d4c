//! Ranges of shards, and what makes up the whole.

use examples::shard::cover::{Piece, order, range};
use hemidisc::sequence::R2;
use hemidisc::{FastF32, Points, UnitSquare};

#[test]
fn ranges_are_those_of_points() {
    for (len, of) in [(1, 1), (5, 2), (10, 3), (5, 7), (64, 65_535), (u32::MAX, 7)] {
        let all = Points::with_range(R2::new(0), UnitSquare::<FastF32>::new(), ..len).unwrap();
        let mut next = 0;
        for shard in (0..of).step_by(usize::from(of / 50).max(1)) {
            let range = range(len, shard, of);
            let points = all.shard(shard.into(), of.into()).unwrap();
            assert_eq!(range.len() as u64, u64::from(points.len()), "shard {shard} of {of}");
            assert!(range.is_empty() || points.coordinates(0) == Some(R2::new(0).at(range.start)));
            assert!(range.start >= next && range.end <= len);
            next = range.end;
        }
        assert_eq!(range(len, 0, of).start, 0);
        assert_eq!(range(len, of - 1, of).end, len);
    }
}

#[test]
fn a_shard_is_two_of_twice_as_many() {
    for (len, of) in [(1, 1), (10, 3), (5, 7), (u32::MAX, 1001)] {
        for shard in 0..of {
            let [left, right] = [2 * shard, 2 * shard + 1].map(|half| range(len, half, 2 * of));
            assert_eq!(left.end, right.start);
            assert_eq!(range(len, shard, of), left.start..right.end);
        }
    }
}

/// Some shards, and of how many.
type Shards<'a> = &'a [(u16, u16)];

/// Shards of 10 rows.
fn pieces(shards: Shards<'_>) -> Vec<Piece> {
    let piece = |(shard, shards): &(u16, u16)| Piece {
        name: format!("{shard}/{shards}"),
        shard: *shard,
        shards: *shards,
        range: range(10, *shard, *shards),
    };
    shards.iter().map(piece).collect()
}

#[test]
fn what_makes_up_the_whole_is_put_in_order() {
    let orders: [(Shards<'_>, &[usize]); 5] = [
        (&[(0, 1)], &[0]),
        (&[(2, 3), (0, 3), (1, 3)], &[1, 2, 0]),
        (&[(1, 2), (1, 4), (0, 4)], &[2, 1, 0]),
        // Of 20 each other shard is empty.
        (
            &[(1, 20), (4, 5), (1, 5), (3, 5), (2, 5), (0, 20), (2, 20), (3, 20)],
            &[5, 0, 6, 7, 2, 4, 3, 1],
        ),
        (&[(1, 2), (0, 2)], &[1, 0]),
    ];
    for (shards, expected) in orders {
        assert_eq!(order(10, "rows", &pieces(shards)).as_deref(), Ok(expected), "{shards:?}");
    }
}

#[test]
fn what_does_not_is_refused() {
    let cases: [(Shards<'_>, &str); 10] = [
        (&[(0, 3), (2, 3)], "missing: shard 1 of 3 (rows 3..6)"),
        (&[(1, 3)], "missing: shard 0 of 3 (rows 0..3), shard 2 of 3 (rows 6..10)"),
        (&[(1, 2), (0, 2), (1, 2)], "duplicate: 1/2 and 1/2 are both shard 1 of 2"),
        // Though it is empty.
        (&[(0, 11), (0, 11)], "duplicate: 0/11 and 0/11 are both shard 0 of 11"),
        (&[(0, 2), (1, 2), (0, 4)], "overlap: 0/4 and 0/2 both have rows 0..2"),
        (&[(0, 2), (1, 2), (1, 4)], "overlap: 0/2 and 1/4 both have rows 2..5"),
        (&[(0, 1), (1, 3)], "overlap: 0/1 and 1/3 both have rows 3..6"),
        (&[(0, 4), (1, 2)], "missing: rows 2..5"),
        (&[(1, 4), (1, 2)], "missing: rows 0..2"),
        (&[(0, 2), (2, 4)], "missing: rows 7..10"),
    ];
    for (shards, expected) in cases {
        assert_eq!(order(10, "rows", &pieces(shards)), Err(expected.to_owned()), "{shards:?}");
    }
    let eleven: Vec<_> = (0..11).filter(|shard| *shard != 0).map(|shard| (shard, 11)).collect();
    let message = order(10, "rows", &pieces(&eleven)).unwrap_err();
    assert_eq!(message, "missing: shard 0 of 11 (rows 0..0)");
    let message = order(10, "rows", &pieces(&[(9, 10)])).unwrap_err();
    assert!(message.ends_with("shard 7 of 10 (rows 7..8) and 1 more"), "{message}");
}
