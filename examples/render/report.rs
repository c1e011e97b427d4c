//! What each effect took, as JSON.
//!
//! The seconds of an effect are those of the frame less those of a second frame without the effect,
//! at least 0: rays that an effect sends run the same code as all others, so there is no clock to
//! stop around it. Of an effect that is not called for they are 0. Its rays are those that its
//! points directed: without a lens, a disc or a lobe a pinhole, a point light or a mirror sends as
//! many, which count for no effect.

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
    for effect in Effect::ALL {
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
        Effect::Lens => counts.lens,
        Effect::Light => counts.light,
        Effect::Occlusion => counts.occlusion,
        Effect::Glossy => counts.glossy,
    }
}
