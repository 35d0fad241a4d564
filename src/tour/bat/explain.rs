//! What a bat did in the last iteration, and with what numbers.

use crate::{
    kernel::{Inspection, Message},
    label, message,
    tour::explain::{quantity, random_start},
};

use super::{Bat, Bats, LastMove, Local, Range};

impl Bats {
    /// Adds it to a tour’s explanation.
    pub(super) fn tell(&self, i: usize, inspection: &mut Inspection) {
        let Bat { loudness, pulse_rate, last_move, .. } = &self.swarm[i];
        inspection.title = message!("tour-bat", "Bat {i}", i = i + 1);
        let LastMove { tries, hamming, .. } = *last_move;
        let (event, range) = match last_move.range {
            Range::None => ("start", random_start()),
            Range::Far => (
                "crossover",
                message!(
                    "tour-bat-far",
                    "Before, it differed from the best at {hamming} places, half of all or more, and tried {tries} × crossover with it (PMX).",
                    hamming,
                    tries
                ),
            ),
            Range::Near if self.alone == Some(i) => {
                ("2-opt", message!("tour-bat-alone", "It would try {tries} × a random 2-opt move.", tries))
            }
            Range::Near => (
                "2-opt",
                message!(
                    "tour-bat-near",
                    "Before, it differed from the best at {hamming} places, fewer than half, and tried {tries} × a random 2-opt move.",
                    hamming,
                    tries
                ),
            ),
        };
        let helped = match last_move.range {
            Range::Far | Range::Near if self.local.is_some() => message!("tour-bat-helped", "Local search improved the best of them."),
            _ => Message::default(),
        };
        let gained = match last_move.range {
            Range::None => Message::default(),
            _ if last_move.gain > 0.0 => {
                message!("tour-bat-shorter", "The best try made its tour {by:.4} shorter.", by = last_move.gain)
            }
            _ if last_move.gain < 0.0 => {
                message!("tour-bat-longer", "The best try is its tour now, {by:.4} longer than before.", by = -last_move.gain)
            }
            _ => message!("tour-bat-no-gain", "No try was shorter than its own tour."),
        };
        let local = match last_move.local {
            Local::Passed => Message::default(),
            Local::Tried => {
                message!("tour-bat-refused", "Its pulse let it try an insertion in the best tour; it did not take that.")
            }
            Local::Taken => {
                message!(
                    "tour-bat-inserted",
                    "It took the best tour with one stop inserted elsewhere: quieter now, and its pulse rate falls."
                )
            }
        };
        inspection.event = if last_move.local == Local::Taken { "insertion" } else { event };
        inspection.summary = range.then(helped).then(gained).then(local);
        let values = [
            quantity(label!("tour-different-before", "hamming", "HD", "places that differed before"), hamming as f64),
            quantity(label!("tour-tries", "tries", "v", "tries"), tries as f64),
            quantity(label!("tour-tries-gain", "gain", "\\Delta D", "gained by them"), last_move.gain),
            quantity(label!("tour-candidate-around-best", "candidate", "D'", "tour around the best"), last_move.candidate),
            quantity(label!("tour-candidate-gain", "local_gain", "\\Delta D'", "gained by taking it"), last_move.local_gain),
            quantity(label!("tour-loudness", "loudness", "A", "loudness"), *loudness),
            quantity(label!("tour-pulse-rate", "pulse_rate", "r", "pulse rate"), *pulse_rate),
        ];
        inspection.values.extend(values.into_iter().flatten());
        inspection.formulas = match last_move.range {
            Range::None => vec!["length"],
            _ => vec!["tries", "loudness", "pulse", "length"],
        };
    }
}
