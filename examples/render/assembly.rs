//! A renderer of a scene, an arithmetic and the effects called for.
//!
//! Every effect doubles the number of types of renderer: each function below settles one and calls
//! the next.

use crate::render::description::{self as scene, Aperture, Scene};
use crate::render::effects::{Effect, Effects};
use crate::render::frame::{self, Region, Row, Settings};
use crate::render::objects::{named, planes, real, spheres, vector};
use crate::render::values::Exponent;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{
    AmbientOcclusion, BelowHorizon, DiscLight, Glossy, LensRay, Polygon, ThinLens,
};
use hemidisc::{Concentric, Frame};
use testkit::arithmetics::{EachRoot, Tested, every_root};
use testkit::tracer::{
    Ambient, Camera, Counts, Draw, Lens, Light, Mirror, Pinhole, PointLight, Reflection, Renderer,
    Sky, Unoccluded,
};

/// Renders a region of a scene with some of its effects, a step after each pass; or says which
/// field is wrong.
pub type Render =
    fn(&Scene, Effects, &Settings, &Region, &mut dyn FnMut()) -> Result<frame::Frame, String>;

/// The arithmetics that have a square root, by name.
///
/// No generic function, so that the renderers are compiled with this library and not with each
/// program.
pub fn renderers() -> impl Iterator<Item = (&'static str, Render)> {
    let mut renderers = Renderers(Vec::new());
    every_root(&mut renderers);
    renderers.0.into_iter()
}

struct Renderers(Vec<(&'static str, Render)>);

impl EachRoot for Renderers {
    fn each<A: Root<Real: Real> + Tested>(&mut self) {
        self.0.push((A::NAME, render::<A>));
    }
}

/// The function that renders in the arithmetic of a name.
pub fn renderer_of(arithmetic: &str) -> Option<Render> {
    let known = renderers().find(|(name, _)| *name == arithmetic);
    known.map(|(_, render)| render)
}

fn render<A: Root>(
    scene: &Scene,
    effects: Effects,
    settings: &Settings,
    region: &Region,
    step: &mut dyn FnMut(),
) -> Result<frame::Frame, String> {
    let mut frame = Err("not rendered".to_owned());
    let run = &mut |row: &Row<'_, A::Real>| frame = Ok(frame::render(row, settings, region, step));
    with_rows::<A>(scene, effects, settings, run)?;
    frame
}

/// Calls `run` with the rows of a scene and some of its effects.
pub fn with_rows<A: Root>(
    scene: &Scene,
    effects: Effects,
    settings: &Settings,
    run: &mut dyn FnMut(&Row<'_, A::Real>),
) -> Result<(), String> {
    let assembly = Assembly::<A> { scene, effects, settings, run };
    match scene.lens.as_ref().filter(|_| effects.has(Effect::ThinLens)) {
        None => assembly.with_lens(Pinhole),
        Some(lens) => assembly.with_lens(AnyLens::<A>::of(lens)?),
    }
}

/// A lens of either aperture: one type, as to look which it is costs nothing beside the rays.
enum AnyLens<A: Root> {
    Round(ThinLens<Concentric<A>, A::Real>),
    Hexagon(ThinLens<Polygon<A, 6>, A::Real>),
}

impl<A: Root> AnyLens<A> {
    fn of(lens: &scene::Lens) -> Result<Self, String> {
        let [radius, focus] = [lens.radius.0, lens.focus.0].map(real::<A>);
        let made = match lens.aperture {
            Aperture::Round => ThinLens::new(Concentric::new(), radius, focus).map(Self::Round),
            // With a corner up.
            Aperture::Hexagon => {
                ThinLens::new(Polygon::new(1 << 30), radius, focus).map(Self::Hexagon)
            }
        };
        made.map_err(|error| named::<A>("lens", error))
    }
}

impl<A: Root> Lens<A> for AnyLens<A> {
    fn ray(&self, centre: [A::Real; 2], draw: impl Draw, counts: &mut Counts) -> LensRay<A::Real> {
        match self {
            Self::Round(lens) => Lens::<A>::ray(lens, centre, draw, counts),
            Self::Hexagon(lens) => Lens::<A>::ray(lens, centre, draw, counts),
        }
    }
}

struct Assembly<'a, A: Root> {
    scene: &'a Scene,
    effects: Effects,
    settings: &'a Settings,
    run: &'a mut dyn FnMut(&Row<'_, A::Real>),
}

impl<A: Root> Assembly<'_, A> {
    fn with_lens<L: Lens<A> + Sync>(self, lens: L) -> Result<(), String> {
        let scene::Light { position, toward, two_sided, radius, .. } = &self.scene.light;
        let position = vector::<A>(position.0);
        let frame = Frame::normalized(vector::<A>(toward.0))
            .map_err(|error| named::<A>("light.toward", error))?;
        match radius.filter(|_| self.effects.has(Effect::DiscLight)) {
            None => {
                let (normal, two_sided) = (frame.unit(), *two_sided);
                self.with_light(lens, PointLight { position, normal, two_sided })
            }
            Some(radius) => {
                let light = DiscLight::<A>::new(position, frame, real::<A>(radius.0))
                    .map_err(|error| named::<A>("light.radius", error))?;
                self.with_light(lens, if *two_sided { light.two_sided() } else { light })
            }
        }
    }

    fn with_light<L, S>(self, lens: L, light: S) -> Result<(), String>
    where
        L: Lens<A> + Sync,
        S: Light<A> + Sync,
    {
        match self.scene.ambient.reach.filter(|_| self.effects.has(Effect::AmbientOcclusion)) {
            None => self.with_occlusion(lens, light, Unoccluded),
            Some(reach) => {
                let occlusion = AmbientOcclusion::<A>::new(real::<A>(reach.0))
                    .map_err(|error| named::<A>("ambient.reach", error))?;
                self.with_occlusion(lens, light, occlusion)
            }
        }
    }

    fn with_occlusion<L, S, O>(self, lens: L, light: S, occlusion: O) -> Result<(), String>
    where
        L: Lens<A> + Sync,
        S: Light<A> + Sync,
        O: Ambient<A> + Sync,
    {
        if self.effects.has(Effect::Glossy) {
            self.with_lobes(lens, light, occlusion, |exponent| {
                let parameter = exponent.0.to_string().parse();
                let parameter = parameter.map_err(|error| format!("exponent: {error}"))?;
                Glossy::<A>::new(parameter, BelowHorizon::Flip)
                    .map_err(|error| named::<A>("exponent", error))
            })
        } else {
            self.with_lobes(lens, light, occlusion, |_| Ok(Mirror))
        }
    }

    fn with_lobes<L, S, O, G>(
        self,
        lens: L,
        light: S,
        occlusion: O,
        lobe: impl Fn(Exponent) -> Result<G, String>,
    ) -> Result<(), String>
    where
        L: Lens<A> + Sync,
        S: Light<A> + Sync,
        O: Ambient<A> + Sync,
        G: Reflection<A> + Sync,
    {
        let Scene { camera, light: lamp, ambient, sky, .. } = self.scene;
        // Not the system's tangent: the picture is the same on every machine.
        let slope = real::<A>(libm::tan(camera.field_of_view.0.to_radians() / 2.0));
        let [position, ahead] = [camera.position.0, camera.ahead.0].map(vector::<A>);
        let renderer = Renderer {
            camera: Camera::new(position, ahead, slope, self.settings.size)
                .map_err(|error| named::<A>("camera.ahead", error))?,
            lens,
            light,
            intensity: vector::<A>(lamp.intensity.0),
            ambient: vector::<A>(ambient.colour.0),
            occlusion,
            sky: Sky { horizon: vector::<A>(sky.horizon.0), zenith: vector::<A>(sky.zenith.0) },
            spheres: &spheres(self.scene, &lobe)?,
            planes: &planes(self.scene, &lobe)?,
            source: self.settings.source()?,
        };
        (self.run)(&|from, samples, pixels| renderer.row(from, samples, pixels));
        Ok(())
    }
}
