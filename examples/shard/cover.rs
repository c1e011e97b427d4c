//! The range of each shard, and whether the ranges of some parts make up the whole.

use std::ops::Range;

/// The shard of a number, counted from 0, of `of` consecutive ranges of 0..`len` whose lengths
/// differ by at most 1.
///
/// Those of `Points::shard`. There are empty ones where `of` exceeds `len`; and shard I of K is
/// shards 2I and 2I + 1 of 2K, so that one that took too long may be handed out again in halves.
pub fn range(len: u32, shard: u16, of: u16) -> Range<u32> {
    // At most `len`, for shard + 1 <= of.
    let edge = |k: u64| (u64::from(len) * k / u64::from(of)) as u32;
    edge(shard.into())..edge(u64::from(shard) + 1)
}

/// What a part says of itself.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Of its file.
    pub name: String,
    pub shard: u16,
    pub shards: u16,
    /// That of the shard.
    pub range: Range<u32>,
}

/// The order in which pieces make up 0..`len` without a gap or an overlap; or which of them is at
/// fault.
///
/// `unit` is what is counted, in the plural.
pub fn order(len: u32, unit: &str, pieces: &[Piece]) -> Result<Vec<usize>, String> {
    let mut order: Vec<_> = (0..pieces.len()).collect();
    order.sort_by_key(|index| {
        let Piece { shard, shards, range, .. } = &pieces[*index];
        (range.start, range.end, *shards, *shard)
    });
    let sorted = || order.iter().map(|index| &pieces[*index]);
    for (piece, next) in sorted().zip(sorted().skip(1)) {
        if (piece.shard, piece.shards) == (next.shard, next.shards) {
            let [one, other] = [&piece.name, &next.name];
            let Piece { shard, shards, .. } = piece;
            return Err(format!("duplicate: {one} and {other} are both shard {shard} of {shards}"));
        }
    }
    absent(len, unit, pieces)?;
    let mut previous: Option<&Piece> = None;
    for piece in sorted().filter(|piece| !piece.range.is_empty()) {
        let end = previous.map_or(0, |previous| previous.range.end);
        let Range { start, .. } = piece.range;
        match previous {
            Some(previous) if start < end => {
                return Err(format!(
                    "overlap: {} and {} both have {unit} {start}..{}",
                    previous.name,
                    piece.name,
                    end.min(piece.range.end)
                ));
            }
            _ if start > end => return Err(format!("missing: {unit} {end}..{start}")),
            _ => previous = Some(piece),
        }
    }
    match previous.map_or(0, |previous| previous.range.end) {
        end if end < len => Err(format!("missing: {unit} {end}..{len}")),
        _ => Ok(order),
    }
}

/// Names the shards that there should be, where all pieces are of one number of shards.
fn absent(len: u32, unit: &str, pieces: &[Piece]) -> Result<(), String> {
    /// As many are named.
    const MOST: usize = 8;
    let Some(Piece { shards, .. }) = pieces.first() else { return Ok(()) };
    if pieces.iter().any(|piece| piece.shards != *shards) {
        return Ok(());
    }
    let mut present = vec![false; (*shards).into()];
    pieces.iter().for_each(|piece| present[usize::from(piece.shard)] = true);
    let absent: Vec<_> = (0..*shards).filter(|shard| !present[usize::from(*shard)]).collect();
    if absent.is_empty() {
        return Ok(());
    }
    let named = absent.iter().take(MOST).map(|shard| {
        let Range { start, end } = range(len, *shard, *shards);
        format!("shard {shard} of {shards} ({unit} {start}..{end})")
    });
    let named = named.collect::<Vec<_>>().join(", ");
    let more = match absent.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    Err(format!("missing: {named}{more}"))
}
