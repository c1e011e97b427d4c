//! What each effect took, as JSON.
//!
//! The time of an effect is the frame's less that of a second frame without the effect, at least 0.
//! An effect's rays run the same code as all others, so they cannot be timed separately. For an
//! unused effect it is 0. An effect's rays are those that its points directed. The rays of a
//! pinhole, a point light or a mirror count for no effect.

use examples::Failure;
use examples::render::effects::{Effect, Effects};
use examples::render::frame::Frame;
use testkit::tracer::{Counts, Tally};

/// The report on a frame; `render` renders others, to compare with.
pub(crate) fn json(
    effects: Effects,
    frame: &Frame,
    render: &mut impl FnMut(Effects) -> Result<Frame, Failure>,
) -> Result<String, Failure> {
    let mut fields = Vec::new();
    for effect in Effect::ALL.iter().copied() {
        let called_for = effects.has(effect);
        let seconds = if called_for {
            (frame.seconds - render(effects.without(effect))?.seconds).max(0.0)
        } else {
            0.0
        };
        let tally = tally(&frame.counts, effect);
        fields.push(format!(
            "\"{}\": {{\"called_for\": {called_for}, \"points_drawn\": {}, \"rays\": {}, \
             \"seconds\": {seconds:.6}}}",
            effect.name(),
            tally.points,
            tally.rays
        ));
    }
    Ok(format!("{{\"effects\": {{{}}}}}\n", fields.join(", ")))
}

/// The tally of an effect.
pub(crate) const fn tally(counts: &Counts, effect: Effect) -> Tally {
    match effect {
        Effect::ThinLens => counts.lens,
        Effect::DiscLight => counts.light,
        Effect::AmbientOcclusion => counts.occlusion,
        Effect::Glossy => counts.glossy,
    }
}
