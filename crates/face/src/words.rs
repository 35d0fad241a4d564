//! Messages, said by the host: a module without English carries their keys.

use std::cell::RefCell;

use js_sys::{Function, Object, Reflect};
use wasm_bindgen::prelude::*;

use forage::kernel::{
    Argument, Message,
    message::{self, Speak},
};

thread_local!(static SAY: RefCell<Option<Function>> = const { RefCell::new(None) });

/// Sets how messages are said: a function of a key and an object of arguments (numbers and texts) that returns the text, or
/// undefined where it has no words. A module that has its English inside needs none.
#[wasm_bindgen(js_name = speakBy)]
pub fn speak_by(say: &Function) {
    SAY.set(Some(say.clone()));
    message::speak_by(speak as Speak);
}

fn speak(message: &Message) -> Option<String> {
    let say = SAY.with_borrow(Clone::clone)?;
    let arguments = Object::new();
    for (name, argument) in message.arguments() {
        let argument = match argument {
            Argument::Number(number) => JsValue::from(*number),
            Argument::Text(text) => JsValue::from(text),
            Argument::Message(message) => JsValue::from(&*message.text()),
        };
        // Setting a property of an ordinary object cannot fail.
        let _ = Reflect::set(&arguments, &(*name).into(), &argument);
    }
    say.call2(&JsValue::UNDEFINED, &message.key().into(), &arguments).ok()?.as_string()
}
