//! Says messages by patterns of Fluent.

use std::borrow::Cow;

use fluent_bundle::{FluentArgs, FluentResource, FluentValue, concurrent::FluentBundle};
use forage::kernel::{Argument, Message};

use crate::texts::Texts;

/// Says messages and texts in a language.
pub struct Speaker {
    tag: &'static str,
    bundle: FluentBundle<FluentResource>,
    texts: Texts,
}

impl Speaker {
    /// That of a language; `None` if there is no such language.
    pub fn of(tag: &str) -> Option<Self> {
        let tag = crate::tags().into_iter().find(|known| *known == tag)?;
        let mut bundle = FluentBundle::new_concurrent(vec![tag.parse().ok()?]);
        bundle.set_use_isolating(false);
        bundle.add_function("NUMBER", rounded).ok()?;
        let mut texts = Texts::of(tag)?;
        let patterns = std::mem::take(&mut texts.messages);
        let mut source = String::new();
        for (key, pattern) in &patterns {
            source.extend([key, " = ", &pattern.replace('\n', "\n    "), "\n"]);
        }
        // Of one that is not well-formed the others are there nevertheless; a test says which.
        let resource = FluentResource::try_new(source).unwrap_or_else(|(resource, _)| resource);
        bundle.add_resource_overriding(resource);
        Some(Self { tag, bundle, texts })
    }

    /// The language's tag.
    pub fn tag(&self) -> &'static str {
        self.tag
    }

    /// How a message is said; `None` if there are no words for it.
    pub fn message(&self, message: &Message) -> Option<String> {
        let pattern = self.bundle.get_message(message.key())?.value()?;
        let mut arguments = FluentArgs::new();
        for (name, argument) in message.arguments() {
            arguments.set(*name, value(argument));
        }
        let said = self.bundle.format_pattern(pattern, Some(&arguments), &mut Vec::new());
        Some(joined(&said).into_owned())
    }

    /// How a text of the catalogue is said: itself where there are no words for it. `place`: the names that lead to it.
    pub fn text<'a>(&'a self, text: &'a str, place: &str) -> &'a str {
        self.texts.say(text, place).unwrap_or(text)
    }
}

fn value(argument: &Argument) -> FluentValue<'_> {
    match argument {
        Argument::Number(number) => FluentValue::from(*number),
        Argument::Text(text) => FluentValue::from(text.as_str()),
        Argument::Message(message) => FluentValue::from(message.text().into_owned()),
    }
}

/// `NUMBER($x, digits: 1)`: so many digits after the point.
fn rounded<'a>(given: &[FluentValue<'a>], named: &FluentArgs<'_>) -> FluentValue<'a> {
    let (Some(FluentValue::Number(number)), Some(FluentValue::Number(digits))) = (given.first(), named.get("digits")) else {
        return FluentValue::Error;
    };
    // Digits are a small whole number, as the pattern has it.
    FluentValue::from(format!("{:.*}", digits.value as usize, number.value))
}

/// Between Han there is no space: where one is left by what was put in, it goes.
fn joined(said: &str) -> Cow<'_, str> {
    let han = |c: char| matches!(c, '\u{3000}'..='\u{303f}' | '\u{3400}'..='\u{9fff}' | '\u{ff00}'..='\u{ffef}');
    let characters: Vec<char> = said.chars().collect();
    let idle = |k: usize| characters[k] == ' ' && k > 0 && han(characters[k - 1]) && characters.get(k + 1).copied().is_some_and(han);
    if !(0..characters.len()).any(idle) {
        return Cow::Borrowed(said);
    }
    (0..characters.len()).filter(|&k| !idle(k)).map(|k| characters[k]).collect()
}

#[cfg(test)]
mod tests {
    use forage::message;

    use super::*;

    #[test]
    fn patterns_are_well_formed_and_said() {
        for tag in crate::tags() {
            let texts = Texts::of(tag).unwrap();
            for (key, pattern) in &texts.messages {
                let source = format!("{key} = {}\n", pattern.replace('\n', "\n    "));
                assert!(FluentResource::try_new(source).is_ok(), "{tag}, {key}: {pattern}");
            }
            assert_eq!(Speaker::of(tag).unwrap().tag(), tag);
        }
        assert!(Speaker::of("xx").is_none());
    }

    #[test]
    fn numbers_texts_and_messages_are_put_in() {
        let speaker = Speaker::of("zh-CN").unwrap();
        let said = speaker.message(&message!("ants-ant", "Ant {i}", i = 3_u64)).unwrap();
        assert!(said.contains('3') && !said.is_ascii(), "{said}");
        assert_eq!(speaker.message(&message!("demo-unknown", "No words")), None);
        assert_eq!(speaker.text("Inertia weight", "planners.pso.parameters.w.title"), "惯性权重");
        assert_eq!(speaker.text("no such text", ""), "no such text");
    }

    #[test]
    fn a_space_between_han_goes() {
        assert_eq!(joined("应为 整数， 或 3 个 A*"), "应为整数，或 3 个 A*");
        assert_eq!(joined("as it is"), "as it is");
    }

    #[test]
    fn numbers_are_rounded_as_in_english() {
        let speaker = Speaker::of("zh-CN").unwrap();
        let x = 12.25;
        let said = speaker.message(&message!(
            "drive-detour",
            "{obstacles} {numbers} ({x:.1}, {y:.1}); {length}",
            obstacles = 1_u64,
            numbers = "1",
            x,
            y = 0.35,
            length = message!("demo-length", "3 m")
        ));
        assert!(said.is_some_and(|said| said.contains("12.2") && said.contains("0.3") && said.contains("3 m")));
    }
}
