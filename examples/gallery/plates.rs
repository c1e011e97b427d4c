//! The plates, by the names of their files.

mod exhibits;
mod hemisphere;
mod lobes;
mod overview;
mod sequence;

use crate::sets::Set;
use hemidisc::catalogue::SEQUENCES;
use std::error::Error;

/// A picture and the name of its file.
pub(crate) struct Plate {
    pub(crate) file: String,
    pub(crate) svg: String,
}

/// How many there are: one for each sequence, and four more.
pub(crate) const COUNT: usize = SEQUENCES.len() + 4;

/// Draws every plate from the sets of each size, smallest first; `seen` is called after each.
pub(crate) fn draw(
    sets: &[Vec<Set>],
    seen: &mut dyn FnMut(&str),
) -> Result<Vec<Plate>, Box<dyn Error>> {
    let mut plates = Vec::with_capacity(COUNT);
    let mut add = |name: &str, svg| {
        plates.push(Plate { file: format!("{name}.svg"), svg });
        seen(name);
    };
    for name in SEQUENCES {
        add(name, sequence::draw(&of_sequence(sets, name))?);
    }
    let [lecture, overview, hammersley] = [
        largest(sets, "multi-jittered")?,
        largest(sets, "correlated")?,
        largest(sets, "hammersley")?,
    ];
    add("hemisphere", hemisphere::draw(lecture)?);
    add("lobes", lobes::draw(lecture)?);
    add("exhibits", exhibits::draw(lecture, sets)?);
    add("overview", overview::draw(overview, hammersley)?);
    Ok(plates)
}

fn of_sequence<'a>(sets: &'a [Vec<Set>], name: &str) -> Vec<&'a Set> {
    sets.iter().flatten().filter(|set| set.sequence == name).collect()
}

fn largest<'a>(sets: &'a [Vec<Set>], name: &str) -> Result<&'a Set, String> {
    let largest = of_sequence(sets, name).into_iter().max_by_key(|set| set.count);
    largest.ok_or_else(|| format!("no sequence named {name} in the catalogue"))
}

/// A sequence's name as the field writes it.
fn title(name: &str) -> &str {
    match name {
        "nrooks" => "n-rooks",
        "correlated" => "correlated multi-jittered",
        "hammersley" => "Hammersley",
        "halton" => "Halton",
        "sobol" => "Sobol",
        "sobol-owen" => "Owen-scrambled Sobol",
        "r2" => "R2",
        name => name,
    }
}
