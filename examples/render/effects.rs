//! Which of the effects a scene has, or a picture is rendered with.

use serde::{Deserialize, Serialize};
use std::str::FromStr;

macro_rules! effects {
    ($($file:ident $effect:ident $name:literal;)*) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Effect {
            $($effect,)*
        }

        impl Effect {
            pub const ALL: &[Self] = &[$(Self::$effect),*];

            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$effect => $name,)*
                }
            }
        }
    };
}
hemidisc::for_each_effect!(effects);

/// A set of effects; its text is that of the command line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Effects {
    bits: u8,
}

impl Effects {
    pub const NONE: Self = Self { bits: 0 };

    pub const fn has(self, effect: Effect) -> bool {
        self.bits >> effect as u8 & 1 == 1
    }

    pub const fn with(self, effect: Effect) -> Self {
        Self { bits: self.bits | 1 << effect as u8 }
    }

    pub const fn without(self, effect: Effect) -> Self {
        Self { bits: self.bits & !(1 << effect as u8) }
    }

    pub fn each(self) -> impl Iterator<Item = Effect> {
        Effect::ALL.iter().copied().filter(move |effect| self.has(*effect))
    }

    /// What the command line accepts of a scene with these effects.
    pub fn accepted(self) -> String {
        let names: Vec<_> = self.each().map(Effect::name).collect();
        match names.len() {
            0 => "none".to_owned(),
            1 => format!("{}, or none", names.concat()),
            _ => format!("some of {}, with commas between; or none", names.join(",")),
        }
    }
}

impl FromIterator<Effect> for Effects {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        effects.into_iter().fold(Self::NONE, Self::with)
    }
}

impl From<Effects> for String {
    fn from(effects: Effects) -> Self {
        let names: Vec<_> = effects.each().map(Effect::name).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(",") }
    }
}

impl TryFrom<String> for Effects {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl FromStr for Effects {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text == "none" {
            return Ok(Self::NONE);
        }
        let mut effects = Self::NONE;
        for name in text.split(',') {
            let effect = Effect::ALL.iter().copied().find(|effect| effect.name() == name);
            let effect = effect.ok_or_else(|| format!("{name:?} is not an effect"))?;
            if effects.has(effect) {
                return Err(format!("{name} is named twice"));
            }
            effects = effects.with(effect);
        }
        Ok(effects)
    }
}
