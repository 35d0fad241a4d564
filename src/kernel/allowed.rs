//! Messages about values that JavaScript gives. They are here and not in the JavaScript interface, so that a native program
//! can list all messages.

use crate::message;

use super::Message;

macro_rules! said {
    ($($name:ident $key:literal $english:literal;)*) => {
        $(#[doc = concat!("`", $english, "`")]
        pub fn $name() -> Message {
            message!($key, $english)
        })*
    };
}

said! {
    number "error-number" "a number";
    value "error-value" "a number, a text, true or false";
    text "error-text" "a text";
    flag "error-flag" "true or false";
    freed "error-freed" "one that was freed";
    not_freed "error-not-freed" "one that was not freed";
    before_reset "error-before-reset" "one made before `reset()`";
    after_reset "error-after-reset" "one made after it";
    canvas "error-canvas" "the 2D context of an OffscreenCanvas of at most 16,777,216 pixels";
    list "error-list" "a list";
    point "error-point" "a point, [x, y]";
    two_points "error-two-points" "two points";
    point_in_space "error-point-in-space" "a point in space, [x, y, z]";
    direction "arm-direction" "a vector that is not 0";
    six_joints "arm-six-joints" "six joints in degrees";
    setup "error-setup" "an object with planner, scene, params and seed";
    parameters "error-parameters" "an object of parameters by name";
    steps "error-steps" "a number of steps, 1 or more";
    group_value "error-group-value" "a finite number, or null for a failed run";
    bytes "error-bytes-array" "a Uint8Array";
    color "error-color" "a colour, #rrggbb or #rrggbbaa";
    colors "error-colors" "2 to 16 colours";
    plain "error-plain" "made of plain objects, lists, texts, numbers, true, false and null";
    nothing "error-nothing" "nothing";
    function "error-function" "a function";
    object "error-an-object" "an object";
    iterable "error-iterable" "an iterable object";
    unreadable "error-unreadable" "an object that cannot be read";
}

/// Of what is in a part of a module that is not loaded.
pub fn loaded(part: &str) -> Message {
    message!("error-part-loaded", "one whose part of the module is loaded: call `await load('{part}')` before", part)
}

/// Of a module that broke down. It cannot say so itself: the package does.
pub fn module_dead(cause: &str) -> Message {
    message!(
        "error-module-dead",
        "the module broke down ({cause}): no call works until `reset()` restarts it, without the sessions that it had",
        cause
    )
}

/// Of a value of a kind of its own: `a function`.
pub fn of_kind(kind: &str) -> Message {
    message!("error-a", "a {kind}", kind)
}
