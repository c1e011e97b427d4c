//! A small scene in code, with no effect, each of the four alone and all of them, and the lines of
//! `render.txt`: digests of each at 64 x 48, in an arithmetic of floats, and the points drawn and
//! rays sent for each effect.
//!
//! As `lines.rs`, compiled by the host and the firmware alike; so is the renderer.

use super::bare;
use crate::digest::{Digest, Digestible};
use crate::tracer::{
    Ambient, Camera, Checker, Counts, Finish, Lens, Light, Material, Mirror, Pinhole, Plane,
    PointLight, Reflection, Renderer, Sky, Source, Sphere, Unoccluded,
};
use core::fmt::Arguments;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use hemidisc::{Domain, Error, Frame, Unit};

/// Pixels across and down.
pub const SIZE: [u32; 2] = [64, 48];
const SAMPLES: u32 = 2;

/// Takes a scene with effects of any types.
pub trait Visitor<A: Root> {
    /// Takes a scene.
    fn scene<L: Lens<A>, S: Light<A>, O: Ambient<A>, G: Reflection<A>>(
        &mut self,
        name: &'static str,
        scene: Renderer<'_, A, L, S, O, G, impl Source>,
    );
}

/// A number in thousandths, by operations that round alike everywhere.
fn milli<R: Real>(n: i32) -> R {
    let magnitude = R::over_2_32(n.unsigned_abs()) / R::over_2_32(1000);
    if n < 0 { -magnitude } else { magnitude }
}

fn vector<R: Real>(v: [i32; 3]) -> [R; 3] {
    v.map(milli)
}

/// The parts of a scene that are effects, or what stands in for them.
struct Parts<L, S, O, G> {
    lens: L,
    light: S,
    occlusion: O,
    /// Of silver and of brass.
    gloss: [G; 2],
}

/// Three balls on a chequered table.
fn table<A, L, S, O, G>(
    parts: Parts<L, S, O, G>,
    take: impl FnOnce(Renderer<'_, A, L, S, O, G, Domain>),
) -> Result<(), Error>
where
    A: Root,
    L: Lens<A>,
    S: Light<A>,
    O: Ambient<A>,
    G: Reflection<A>,
{
    let material =
        |albedo, finish| Material { albedo: vector(albedo), emission: vector([0; 3]), finish };
    let ball = |centre, radius, material| Sphere {
        centre: vector(centre),
        radius: milli(radius),
        material,
    };
    let [silver, brass] = parts.gloss;
    let silver = Finish::Glossy(vector([800, 800, 750]), silver);
    let brass = Finish::Glossy(vector([700, 550, 250]), brass);
    let spheres = [
        ball([0, 800, -200], 800, material([30, 30, 30], silver)),
        ball([1400, 500, 400], 500, material([120, 80, 30], brass)),
        ball([-900, 400, 900], 400, material([550, 120, 60], Finish::Matte)),
    ];
    let planes = [Plane {
        point: vector([0; 3]),
        frame: Frame::new(vector([0, 1000, 0]))?,
        material: material([580, 550, 500], Finish::Matte),
        checker: Some(Checker { albedo: vector([160, 170, 200]), size: milli(700) }),
    }];
    let camera =
        Camera::new(vector([200, 1700, 5000]), vector([-30, -210, -1000]), milli(325), SIZE)?;
    let sky = Sky { horizon: vector([500, 500, 550]), zenith: vector([150, 250, 500]) };
    take(Renderer {
        camera,
        lens: parts.lens,
        light: parts.light,
        intensity: vector([58_000, 53_000, 45_000]),
        ambient: vector([160, 170, 210]),
        occlusion: parts.occlusion,
        sky,
        spheres: &spheres,
        planes: &planes,
        source: Domain::new(7),
    });
    Ok(())
}

const LAMP: [i32; 3] = [-2600, 4600, 2600];

fn point<A: Root>() -> Result<PointLight<A>, Error> {
    let normal = Unit::new(vector([0, -1000, 0]))?;
    Ok(PointLight { position: vector(LAMP), normal, two_sided: false })
}

fn lens<A: Root>() -> Result<ThinLens<Polygon<A, 6>, A::Real>, Error> {
    ThinLens::new(Polygon::new(1 << 30), milli(100), milli(4900))
}

fn disc<A: Root>() -> Result<DiscLight<A>, Error> {
    DiscLight::new(vector(LAMP), Frame::new(vector([0, -1000, 0]))?, milli(600))
}

fn occlusion<A: Root>() -> Result<AmbientOcclusion<A>, Error> {
    AmbientOcclusion::new(milli(1200))
}

fn gloss<A: Root>([silver, brass]: [A::Parameter; 2]) -> Result<[Glossy<A>; 2], Error> {
    let gloss = |exponent| Glossy::new(exponent, BelowHorizon::Flip);
    Ok([gloss(silver)?, gloss(brass)?])
}

/// The table without an effect.
pub fn plain<A: Root>(visitor: &mut impl Visitor<A>) -> Result<(), Error> {
    with_bare(|scene| visitor.scene("plain", scene))
}

/// The same, its types known.
pub fn with_bare<A: Root>(take: impl FnOnce(bare::Scene<'_, A, Domain>)) -> Result<(), Error> {
    let gloss = [Mirror, Mirror];
    table(Parts { lens: Pinhole, light: point()?, occlusion: Unoccluded, gloss }, take)
}

/// The table with depth of field alone.
pub fn with_lens<A: Root>(visitor: &mut impl Visitor<A>) -> Result<(), Error> {
    let gloss = [Mirror, Mirror];
    let parts = Parts { lens: lens::<A>()?, light: point()?, occlusion: Unoccluded, gloss };
    table(parts, |scene| visitor.scene("lens", scene))
}

/// The table with soft shadows alone.
pub fn with_light<A: Root>(visitor: &mut impl Visitor<A>) -> Result<(), Error> {
    let gloss = [Mirror, Mirror];
    let parts = Parts { lens: Pinhole, light: disc()?, occlusion: Unoccluded, gloss };
    table(parts, |scene| visitor.scene("light", scene))
}

/// The table with occlusion alone.
pub fn with_occlusion<A: Root>(visitor: &mut impl Visitor<A>) -> Result<(), Error> {
    let gloss = [Mirror, Mirror];
    let parts = Parts { lens: Pinhole, light: point()?, occlusion: occlusion()?, gloss };
    table(parts, |scene| visitor.scene("occlusion", scene))
}

/// The table with glossy reflection alone; the exponents are those of silver and brass, 3000 and
/// 30.
pub fn with_gloss<A: Root>(
    exponents: [A::Parameter; 2],
    visitor: &mut impl Visitor<A>,
) -> Result<(), Error> {
    let gloss = gloss(exponents)?;
    table(Parts { lens: Pinhole, light: point()?, occlusion: Unoccluded, gloss }, |scene| {
        visitor.scene("glossy", scene)
    })
}

/// The table with all four.
pub fn still_life<A: Root>(
    exponents: [A::Parameter; 2],
    visitor: &mut impl Visitor<A>,
) -> Result<(), Error> {
    let gloss = gloss(exponents)?;
    let parts = Parts { lens: lens::<A>()?, light: disc()?, occlusion: occlusion()?, gloss };
    table(parts, |scene| visitor.scene("still-life", scene))
}

/// A line for each scene.
struct Digests<'a>(&'a mut dyn FnMut(Arguments));

impl<A: Root<Real: Digestible>> Visitor<A> for Digests<'_> {
    fn scene<L: Lens<A>, S: Light<A>, O: Ambient<A>, G: Reflection<A>>(
        &mut self,
        name: &'static str,
        scene: Renderer<'_, A, L, S, O, G, impl Source>,
    ) {
        let (mut digest, mut counts) = (Digest::new(), Counts::default());
        let [_, height] = SIZE;
        for y in 0..height {
            // A row is all that a board keeps of the picture.
            let mut row = [[A::Real::ZERO; 3]; SIZE[0] as usize];
            counts += scene.row([0, y], 0..SAMPLES, &mut row);
            row.into_iter().for_each(|pixel| digest.value_of(pixel));
        }
        let Counts { base, lens, light, occlusion, glossy } = counts;
        (self.0)(format_args!(
            "{} {name} {:016x} base={base} lens={lens} light={light} \
             occlusion={occlusion} glossy={glossy}",
            A::NAME,
            digest.value()
        ));
    }
}

/// The lines of one arithmetic.
pub fn digests<A: Root<Real: Digestible>>(lines: &mut dyn FnMut(Arguments)) -> Result<(), Error> {
    let mut visitor = Digests(lines);
    plain::<A>(&mut visitor)?;
    with_lens::<A>(&mut visitor)?;
    with_light::<A>(&mut visitor)?;
    with_occlusion::<A>(&mut visitor)?;
    let (Ok(silver), Ok(brass)) = ("3000".parse(), "30".parse()) else {
        return Err(Error::Exponent { value: f64::NAN });
    };
    let exponents = [silver, brass];
    with_gloss::<A>(exponents, &mut visitor)?;
    still_life::<A>(exponents, &mut visitor)
}

macro_rules! file {
    ($(
        #[$cfg:meta] $file:ident $arithmetic:ident $name:literal $kind:ident
        ($form:ident $boards:ident $($facts:tt)*);
    )*) => {
        /// The lines of every arithmetic of which boards have pictures.
        pub fn file(lines: &mut dyn FnMut(Arguments)) -> Result<(), Error> {
            $(
                #[$cfg]
                file!(@ $boards $arithmetic lines);
            )*
            Ok(())
        }
    };
    (@ pictures $arithmetic:ident $lines:ident) => {
        digests::<hemidisc::$arithmetic>($lines)?
    };
    (@ fills $arithmetic:ident $lines:ident) => {};
    (@ digests $arithmetic:ident $lines:ident) => {};
    (@ nothing $arithmetic:ident $lines:ident) => {};
}
hemidisc::for_each_arithmetic!(file);
