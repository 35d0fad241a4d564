//! Questions in words, and the command lines that repeat their runs.

use std::fmt::Write;

use super::claim::{Arm, On, Part, Question, Until};

impl Part {
    /// Where, in words.
    pub(super) fn place(&self) -> String {
        match self.on.as_slice() {
            [] => String::new(),
            [On::Scene(name)] => (*name).to_owned(),
            [On::Map { generator, settings, map }] => format!("{generator} {map}, {settings}").trim_end_matches(", ").to_owned(),
            [On::Map { settings, .. }, ..] => format!("{} generated scenes, {settings}", self.on.len()).trim_end_matches(", ").to_owned(),
            _ => format!("{} scenes", self.on.len()),
        }
    }

    /// The command that repeats the first run of an arm.
    pub(super) fn command(&self, arm: &Arm) -> String {
        let (first, scene) = match self.on.first() {
            Some(On::Scene(name)) => (String::new(), (*name).to_owned()),
            Some(On::Map { generator, settings, map }) => {
                let set: String = settings.split_whitespace().flat_map(|pair| [" --set ", pair]).collect();
                (format!("forage generate {generator}{set} --seed {map} --out map.json; "), "map.json".to_owned())
            }
            None => return String::new(),
        };
        let mut text = format!("{first}forage run {} --scene {scene} --seed {}", arm.planner, self.seeds[0]);
        arm.params.iter().for_each(|(name, value)| text.extend([" --set ", name, "=", &value.to_string()]));
        arm.motion.iter().for_each(|(name, value)| text.extend([" --motion-set ", name, "=", &value.to_string()]));
        if let Until::Iteration(k) = self.until {
            let _ = write!(text, " --iterations {k}");
        }
        text
    }
}

impl Question {
    /// In words; the first planner is the one that the claim speaks for.
    pub fn text(&self) -> String {
        match self {
            Self::Less(measure) => format!("smaller {}", measure.name),
            Self::LessAcross(measure) => format!("smaller {} across maps", measure.name),
            Self::More(measure) => format!("larger {}", measure.name),
            Self::SpreadsLess(measure) => format!("smaller spread of the {}", measure.name),
            Self::Sooner { at, .. } => format!("fewer {}", at.name),
            Self::MoreOften(event) | Self::MoreOftenInPairs(event) => format!("more often {}", event.name),
            Self::AtLeast(event, share) => format!("at least {:.0} % of the runs {}", 100.0 * share, event.name),
            Self::Never(event) => format!("never {}", event.name),
            Self::AtMost(measure, limit) => format!("mean {} at most {limit}", measure.name),
            Self::SpreadsAtMost(measure, limit) => format!("standard deviation of the {} at most {limit}", measure.name),
            Self::Grows(measure) => format!("{} grows in this order", measure.name),
            Self::Open(_) => "cannot be asked".to_owned(),
        }
    }
}
