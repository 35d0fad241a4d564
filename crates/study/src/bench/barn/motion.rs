//! How the obstacles of DynaBARN move: key frames in the code of Gazebo plugins, of which nothing else is published.
//!
//! Each plugin is a shared object for x86-64 that creates one animation. Its function `Load` hands over, in this order, the animation's length
//! and for each key frame its time, the translation's z, y and x, and three angles, all of them constants.

use std::{fs, path::Path};

use object::{Object, ObjectSection, ObjectSymbol};

use super::super::super::failure::{Failure, at};

/// Straight pieces for each stretch between two key frames.
const PIECES: usize = 8;
/// An animation takes so many seconds at least.
const SHORTEST: f64 = 0.1;
/// How long a jump from the end of an animation back to its beginning takes, in seconds.
const JUMP: f64 = 1e-3;

/// An animation, which begins again when it is over.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Animation {
    /// Its period, in seconds.
    pub length: f64,
    /// Time, x, y.
    pub frames: Vec<[f64; 3]>,
}

/// What `Load` does with constants.
enum Event {
    Constant(f64),
    Call,
}

impl Animation {
    /// Reads a plugin; `None` where it is not built like the others.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub(super) fn read(path: &Path) -> Result<Option<Self>, Failure> {
        Ok(Self::of(&fs::read(path).map_err(at(path))?))
    }

    fn of(bytes: &[u8]) -> Option<Self> {
        let file = object::File::parse(bytes).ok()?;
        let load = file.dynamic_symbols().find(|symbol| symbol.name().is_ok_and(|name| name.contains("obs_") && name.contains("4Load")))?;
        let data = |address: u64, size: u64| file.sections().find_map(|section| section.data_range(address, size).ok().flatten());
        let code = data(load.address(), load.size())?;
        let constant = |address: u64| Some(f64::from_le_bytes(data(address, 8)?.try_into().ok()?));
        Self::from_groups(&groups(events(code, load.address(), constant)))
    }

    /// The constants between two calls: the length, then by turns a time, a translation and a rotation.
    fn from_groups(groups: &[Vec<f64>]) -> Option<Self> {
        let ([length], frames) =
            groups.split_first().map(|(first, rest)| (first.as_slice(), rest)).and_then(|(first, rest)| Some(([*first.first()?], rest)))?;
        let frame = |group: &[Vec<f64>]| match group {
            [time, place, angles] => match (time.as_slice(), place.as_slice(), angles.len()) {
                (&[time], &[_, y, x], 3) => Some([time, x, y]),
                _ => None,
            },
            _ => None,
        };
        let frames: Vec<[f64; 3]> = frames.chunks(3).map(frame).collect::<Option<_>>()?;
        let grows = frames.windows(2).all(|pair| pair[0][0] < pair[1][0]) && frames.first()?[0] == 0.0 && frames.last()?[0] <= length;
        (grows
            && length >= SHORTEST
            && frames.iter().flatten().all(|number| number.is_finite())
            && groups.first()?.len() == 1
            && frames.len() > 1)
            .then_some(Self { length, frames })
    }

    /// Where it is between the `k`-th frame and the next, by the spline that Gazebo takes: its tangents are half the way between the frames
    /// around.
    fn between(&self, k: usize, share: f64) -> [f64; 2] {
        let n = self.frames.len();
        let point = |k: usize| [self.frames[k][1], self.frames[k][2]];
        let closed = point(0) == point(n - 1);
        let tangent = |k: usize| {
            let (before, after) = match k {
                0 if closed => (n - 2, 1),
                0 => (0, 1),
                k if k == n - 1 && closed => (n - 2, 1),
                k if k == n - 1 => (n - 2, n - 1),
                k => (k - 1, k + 1),
            };
            [0, 1].map(|axis| 0.5 * (point(after)[axis] - point(before)[axis]))
        };
        let (a, b, from, to) = (point(k), point(k + 1), tangent(k), tangent(k + 1));
        let (t, tt) = (share, share * share);
        let ttt = tt * t;
        [0, 1].map(|axis| {
            (2.0 * ttt - 3.0 * tt + 1.0) * a[axis]
                + (ttt - 2.0 * tt + t) * from[axis]
                + (3.0 * tt - 2.0 * ttt) * b[axis]
                + (ttt - tt) * to[axis]
        })
    }

    /// Places with their times, from 0 until `end`: straight pieces. From the end it jumps back to the beginning, around the arena.
    pub(super) fn course(&self, end: f64, around: f64) -> Vec<[f64; 3]> {
        let mut course: Vec<[f64; 3]> = Vec::new();
        let mut begun = 0.0;
        while begun < end {
            let first = self.frames[0];
            if let Some(&[time, x, y]) = course.last()
                && [x, y] != [first[1], first[2]]
            {
                let out = |y: f64| if y < 0.0 { -around } else { around };
                course.extend([[time + 0.2 * JUMP, x, out(y)], [time + 0.6 * JUMP, first[1], out(first[2])]]);
            }
            let late = if course.is_empty() { 0.0 } else { JUMP };
            if late == 0.0 || course.last().is_some_and(|&[_, x, y]| [x, y] != [first[1], first[2]]) {
                course.push([begun + late, first[1], first[2]]);
            }
            for k in 0..self.frames.len() - 1 {
                let (from, to) = (self.frames[k][0], self.frames[k + 1][0]);
                for piece in 1..=PIECES {
                    let share = piece as f64 / PIECES as f64;
                    let time = begun + from + share * (to - from);
                    if course.last().is_none_or(|last| time > last[0]) {
                        let [x, y] = self.between(k, share);
                        course.push([time, x, y]);
                    }
                }
            }
            begun += self.length;
        }
        course
    }
}

/// Constants that are loaded, and calls, in the order of the code: it was compiled without optimisation, so that nothing else comes between.
fn events(code: &[u8], address: u64, constant: impl Fn(u64) -> Option<f64>) -> Vec<Event> {
    let offset = |at: usize| code.get(at..at + 4).and_then(|bytes| bytes.try_into().ok()).map(i32::from_le_bytes);
    let mut events = Vec::new();
    let mut at = 0;
    while at < code.len() {
        // movsd xmm0, [rip + offset]; mov rax, [rip + offset]; pxor xmm0, xmm0; call.
        let found = match &code[at..] {
            [0xf2, 0x0f, 0x10, 0x05, ..] => Some((8, true)),
            [0x48, 0x8b, 0x05, ..] => Some((7, true)),
            [0x66, 0x0f, 0xef, 0xc0, ..] => {
                events.push(Event::Constant(0.0));
                Some((4, false))
            }
            [0xe8, ..] => {
                events.push(Event::Call);
                Some((5, false))
            }
            _ => None,
        };
        let Some((length, loads)) = found else {
            at += 1;
            continue;
        };
        if loads && let Some(offset) = offset(at + length - 4) {
            let place = (address + (at + length) as u64).wrapping_add_signed(i64::from(offset));
            events.extend(constant(place).map(Event::Constant));
        }
        at += length;
    }
    events
}

/// The constants between calls.
fn groups(events: Vec<Event>) -> Vec<Vec<f64>> {
    let mut groups = vec![Vec::new()];
    for event in events {
        match (event, groups.last_mut()) {
            (Event::Constant(number), Some(last)) => last.push(number),
            (Event::Call, Some(last)) if !last.is_empty() => groups.push(Vec::new()),
            _ => {}
        }
    }
    groups.retain(|group| !group.is_empty());
    groups
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The code of a plugin, in short: its constants are at 1000 and after.
    fn code() -> (Vec<u8>, Vec<f64>) {
        let numbers = vec![20.0, -4.0, 3.0, 5.0, 10.0, 6.0];
        let mut code = vec![0x55, 0x48, 0x89, 0xe5];
        let load = |code: &mut Vec<u8>, opcode: &[u8], k: i32| {
            code.extend(opcode);
            let next = code.len() as i32 + 4;
            code.extend((1000 + 8 * k - next).to_le_bytes());
        };
        let zero = |code: &mut Vec<u8>| code.extend([0x66, 0x0f, 0xef, 0xc0]);
        let call = |code: &mut Vec<u8>| code.extend([0xe8, 1, 2, 3, 4]);
        let frame = |code: &mut Vec<u8>, time: Option<i32>, y: i32, x: i32| {
            match time {
                Some(k) => load(code, &[0x48, 0x8b, 0x05], k),
                None => zero(code),
            }
            call(code);
            zero(code);
            load(code, &[0xf2, 0x0f, 0x10, 0x05], y);
            load(code, &[0xf2, 0x0f, 0x10, 0x05], x);
            call(code);
            (0..3).for_each(|_| zero(code));
            call(code);
            call(code);
        };
        call(&mut code);
        load(&mut code, &[0x48, 0x8b, 0x05], 0);
        call(&mut code);
        frame(&mut code, None, 1, 2);
        frame(&mut code, Some(3), 2, 1);
        frame(&mut code, Some(4), 5, 5);
        (code, numbers)
    }

    fn animation() -> Animation {
        let (code, numbers) = code();
        let constant = |address: u64| numbers.get(address.checked_sub(1000)? as usize / 8).copied();
        Animation::from_groups(&groups(events(&code, 0, constant))).unwrap()
    }

    #[test]
    fn key_frames_are_read_from_code() {
        let frames = vec![[0.0, 3.0, -4.0], [5.0, -4.0, 3.0], [10.0, 6.0, 6.0]];
        assert_eq!(animation(), Animation { length: 20.0, frames });
        assert_eq!(Animation::of(b"no shared object"), None);
        assert_eq!(Animation::from_groups(&[vec![20.0], vec![0.0], vec![0.0, 1.0]]), None);
    }

    /// The smallest shared object with that code: sections of code, of names and of one symbol.
    fn shared_object() -> Vec<u8> {
        let (code, numbers) = code();
        let mut text = code.clone();
        text.resize(1000, 0);
        numbers.iter().for_each(|number| text.extend(number.to_le_bytes()));
        let names = b"\0_ZN6gazebo5obs_14LoadEv\0";
        let mut symbols = vec![0; 24];
        symbols.extend(1_u32.to_le_bytes());
        symbols.extend([0x12, 0, 1, 0]);
        symbols.extend([0_u64.to_le_bytes(), (code.len() as u64).to_le_bytes()].concat());
        let parts: [(u32, &[u8], u32, u64); 3] = [(1, &text, 0, 0), (3, names, 0, 0), (11, &symbols, 2, 24)];
        let mut headers = vec![0_u8; 64];
        let mut body: Vec<u8> = Vec::new();
        for (kind, bytes, link, entry) in parts {
            let offset = (64 + body.len()) as u64;
            let flags_and_address = [2_u64, if kind == 1 { 0 } else { offset + 0x10_000 }];
            headers.extend([0_u32, kind].iter().flat_map(|word| word.to_le_bytes()));
            headers.extend(flags_and_address.iter().chain(&[offset, bytes.len() as u64]).flat_map(|word| word.to_le_bytes()));
            headers.extend([link, u32::from(kind == 11)].iter().flat_map(|word| word.to_le_bytes()));
            headers.extend([8, entry].iter().flat_map(|word| word.to_le_bytes()));
            body.extend(bytes);
        }
        let mut file = vec![0x7f, b'E', b'L', b'F', 2, 1, 1];
        file.resize(16, 0);
        file.extend([3_u16, 62].iter().flat_map(|word| word.to_le_bytes()));
        file.extend(1_u32.to_le_bytes());
        file.extend([0_u64, 0, (64 + body.len()) as u64].iter().flat_map(|word| word.to_le_bytes()));
        file.extend(0_u32.to_le_bytes());
        file.extend([64_u16, 56, 0, 64, 4, 2].iter().flat_map(|word| word.to_le_bytes()));
        file.extend(body);
        file.extend(headers);
        file
    }

    #[test]
    fn key_frames_are_read_from_a_shared_object() {
        assert_eq!(Animation::of(&shared_object()), Some(animation()));
    }

    #[test]
    fn an_animation_passes_its_frames_and_begins_again_outside() {
        let course = animation().course(30.0, 100.0);
        assert!(course.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        for frame in [[5.0, -4.0, 3.0], [10.0, 6.0, 6.0], [25.0, -4.0, 3.0]] {
            assert!(course.iter().any(|at| at.iter().zip(&frame).all(|(a, b)| (a - b).abs() < 1e-9)), "{frame:?} of {course:?}");
        }
        // From the last frame to the first one it goes around.
        let jump: Vec<&[f64; 3]> = course.iter().filter(|at| at[2].abs() == 100.0).collect();
        assert!(jump.len() == 2 && (jump[0][1], jump[1][1]) == (6.0, 3.0), "{jump:?}");
        // Half of the way from the first frame to the third is the tangent at the second.
        let [x, y] = animation().between(0, 0.5);
        assert!((x - (0.5 * (3.0 - 4.0) + 0.125 * (0.5 * -7.0 - 0.5 * 3.0))).abs() < 1e-12, "{x}");
        assert!((y - (0.5 * (-4.0 + 3.0) + 0.125 * (0.5 * 7.0 - 0.5 * 10.0))).abs() < 1e-12, "{y}");
    }
}
