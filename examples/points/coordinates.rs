//! The coordinates to map: a range of a sequence, or lines of standard input.

use crate::Failure;
use crate::arguments::Arguments;
use hemidisc::catalogue::{SequenceVisitor, sequences};
use hemidisc::sequence::{Sequence, Sobol, SobolOwen};
use std::io::BufRead;
use std::ops::RangeInclusive;

/// What is done with the coordinates, once they are known to be good.
pub(crate) type Consume<'a> =
    &'a mut dyn FnMut(&mut dyn Iterator<Item = [u32; 2]>) -> Result<(), Failure>;

/// Hands the coordinates that the arguments ask for to `consume`, in constant memory for a
/// sequence.
pub(crate) fn coordinates(arguments: &Arguments, consume: Consume) -> Result<(), Failure> {
    if arguments.stdin {
        return consume(&mut read(std::io::stdin().lock())?.into_iter());
    }
    if let Some((pixel, samples)) = arguments.pixel()? {
        return consume(&mut (0..samples).map(|sample| pixel.sampler(sample).pair()));
    }
    let name = arguments.sequence.as_deref().unwrap_or_default();
    let [start, count] = [arguments.start(), arguments.count()];
    let mut selected = Selected { name, start, count, consume, result: Ok(()) };
    sequences(count, arguments.seed(), &mut selected)
        .map_err(|error| Failure::Usage(format!("--count: {error}")))?;
    selected.result
}

/// The first four dimensions of the sequence that the arguments ask for.
pub(crate) fn joint(
    arguments: &Arguments,
) -> Result<Box<dyn Iterator<Item = [[u32; 2]; 2]>>, Failure> {
    if let Some((pixel, samples)) = arguments.pixel()? {
        return Ok(Box::new((0..samples).map(move |sample| pixel.sampler(sample).joint())));
    }
    let range = indices(true, arguments.start(), arguments.count())?;
    Ok(if arguments.sequence.as_deref() == Some("sobol") {
        let sobol = Sobol::new(arguments.seed());
        Box::new(range.map(move |index| sobol.joint(index)))
    } else {
        let scrambled = SobolOwen::new(arguments.seed());
        Box::new(range.map(move |index| scrambled.joint(index)))
    })
}

/// Runs through the sequence of a name.
struct Selected<'a> {
    name: &'a str,
    start: u32,
    count: u32,
    consume: Consume<'a>,
    result: Result<(), Failure>,
}

impl SequenceVisitor for Selected<'_> {
    fn visit<S: Sequence>(&mut self, name: &'static str, sequence: S) {
        if name == self.name {
            let endless = sequence.size().is_none();
            self.result = indices(endless, self.start, self.count)
                .and_then(|range| (self.consume)(&mut range.map(|index| sequence.at(index))));
        }
    }
}

/// The rows from `start` on: to the end of a set of `count` points, or `count` of an endless one.
fn indices(endless: bool, start: u32, count: u32) -> Result<RangeInclusive<u32>, Failure> {
    let last = count - 1;
    if !endless && start <= count {
        return Ok(start..=last);
    }
    match start.checked_add(last) {
        Some(last) if endless => Ok(start..=last),
        _ => {
            let most = if endless { u32::MAX - last } else { count };
            let wrong = if endless { "runs past index 4294967295" } else { "is outside the set" };
            Err(Failure::Usage(format!(
                "--start: {start} with --count {count} {wrong}; accepted: an integer 0..={most}"
            )))
        }
    }
}

/// All pairs of the input, so that nothing is printed unless every line is good: 8 bytes each.
fn read(input: impl BufRead) -> Result<Vec<[u32; 2]>, Failure> {
    let mut pairs = Vec::new();
    for (number, line) in (1_u64..).zip(input.split(b'\n')) {
        let line = line.map_err(Failure::Input)?;
        let line = String::from_utf8_lossy(&line);
        let text = line.trim();
        // The header of this program's own output may come back.
        if text.is_empty() || (pairs.is_empty() && text == "u,v") {
            continue;
        }
        pairs.push(pair(text).ok_or_else(|| {
            let shown: String = text.chars().take(80).collect();
            Failure::Usage(format!(
                "--stdin: line {number} is {shown:?}; accepted: u,v with each 0x and 1 to 8 \
                 hexadecimal digits, as in 0x80000000,0x40000000"
            ))
        })?);
    }
    Ok(pairs)
}

fn pair(text: &str) -> Option<[u32; 2]> {
    let (u, v) = text.split_once(',')?;
    Some([cell(u)?, cell(v)?])
}

fn cell(text: &str) -> Option<u32> {
    let text = text.trim();
    let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))?;
    // `from_str_radix` alone would take a sign and any number of zeros.
    let plain = digits.len() <= 8 && digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    if plain { u32::from_str_radix(digits, 16).ok() } else { None }
}
