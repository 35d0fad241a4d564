//! A planner's state: the hash that golden runs and links carry, and its size, both from the same list of fields.

use std::{
    cell::Cell,
    collections::{BTreeMap, BTreeSet, VecDeque},
    sync::{Arc, OnceLock},
};

/// Derives [`trait@State`] from the fields of a struct or enum.
///
/// Every field counts in hash and size, unless it is marked `#[state(skip)]` (counted, not hashed: scratch memory and caches,
/// which no result depends on) or `#[state(shared)]` (neither: what follows from the setup, or from the other fields).
///
/// ```
/// use forage::kernel::{Digest, State};
///
/// #[derive(State, Clone)]
/// struct Walker {
///     position: [f64; 2],
///     visited: Vec<u32>,
///     #[state(skip)]
///     scratch: Vec<f64>,
/// }
/// let hash = |walker: &Walker| Digest::of(walker).hex();
/// let walker = Walker { position: [0.0, 1.0], visited: vec![7], scratch: vec![] };
/// assert_ne!(hash(&walker), hash(&Walker { visited: vec![8], ..walker.clone() }));
/// assert_eq!(hash(&walker), hash(&Walker { scratch: vec![0.5], ..walker.clone() }));
/// ```
pub use forage_derive::State;

/// A state with a hash and a size: the run's hash and the size of its keyframes are computed from them.
pub trait State {
    /// Adds the whole state to a hash.
    fn digest(&self, out: &mut Digest);
    /// The memory that it owns besides its own `size_of`, in bytes; approximate, since an allocator rounds up.
    fn heap_size(&self) -> usize;
}

/// FNV-1a over 64-bit words, each multiplication followed by a fold so that high bits reach low ones.
#[derive(Debug, Clone)]
pub struct Digest {
    hash: u64,
    random: bool,
    #[cfg(not(target_arch = "wasm32"))]
    census: Census,
}

/// What the conformance suite wants to know of a state besides its hash.
#[cfg(not(target_arch = "wasm32"))]
#[derive(Debug, Clone, Default)]
struct Census {
    words: u64,
    leaves_streams_out: bool,
}

impl Default for Digest {
    fn default() -> Self {
        Self {
            hash: 0xcbf2_9ce4_8422_2325,
            random: false,
            #[cfg(not(target_arch = "wasm32"))]
            census: Census::default(),
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Digest {
    /// A hash of all but the streams of random numbers.
    pub(crate) fn without_streams() -> Self {
        Self { census: Census { words: 0, leaves_streams_out: true }, ..Self::default() }
    }

    /// The number of words that were added.
    pub(crate) fn words(&self) -> u64 {
        self.census.words
    }
}

impl Digest {
    /// The hash of a state.
    pub fn of(state: &(impl State + ?Sized)) -> Self {
        let mut digest = Self::default();
        state.digest(&mut digest);
        digest
    }

    /// Adds one word. Not inlined: states have hundreds of fields, and hashing them is no hot path.
    #[inline(never)]
    pub fn word(&mut self, word: u64) {
        let mixed = (self.hash ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        self.hash = mixed ^ (mixed >> 32);
        #[cfg(not(target_arch = "wasm32"))]
        {
            self.census.words += 1;
        }
    }

    /// Adds the state of a stream of random numbers.
    pub(super) fn stream(&mut self, words: [u64; 4]) {
        self.random = true;
        #[cfg(not(target_arch = "wasm32"))]
        if self.census.leaves_streams_out {
            return;
        }
        words.digest(self);
    }

    /// Whether a stream of random numbers is part of what was added. A planner that draws only when it starts keeps its stream,
    /// so that its runs are not taken for deterministic.
    pub fn is_random(&self) -> bool {
        self.random
    }

    /// Adds how many bytes there are, and each as a word.
    pub fn bytes(&mut self, bytes: &[u8]) {
        bytes.digest(self);
    }

    /// Adds how many numbers there are, and their bits.
    pub fn numbers(&mut self, numbers: &[f64]) {
        numbers.digest(self);
    }

    /// The hash as sixteen hexadecimal digits.
    pub fn hex(&self) -> String {
        format!("{:016x}", self.hash)
    }
}

/// Numbers that are their own word.
macro_rules! words {
    ($($number:ty),*) => { $(
        impl State for $number {
            #[inline]
            fn digest(&self, out: &mut Digest) {
                out.word(u64::from(*self));
            }
            #[inline]
            fn heap_size(&self) -> usize {
                0
            }
        }
    )* };
}
words!(bool, u8, u16, u32, u64, char);

/// Numbers that have a word by their bits.
macro_rules! bits {
    ($($number:ty => $word:ty),*) => { $(
        impl State for $number {
            #[inline]
            fn digest(&self, out: &mut Digest) {
                out.word(u64::from(<$word>::from_ne_bytes(self.to_ne_bytes())));
            }
            #[inline]
            fn heap_size(&self) -> usize {
                0
            }
        }
    )* };
}
bits!(i8 => u8, i16 => u16, i32 => u32, i64 => u64, f32 => u32, f64 => u64);

impl State for usize {
    #[inline]
    fn digest(&self, out: &mut Digest) {
        out.word(*self as u64);
    }
    #[inline]
    fn heap_size(&self) -> usize {
        0
    }
}

impl State for str {
    fn digest(&self, out: &mut Digest) {
        out.bytes(self.as_bytes());
    }
    fn heap_size(&self) -> usize {
        0
    }
}

impl State for &'static str {
    fn digest(&self, out: &mut Digest) {
        out.bytes(self.as_bytes());
    }
    fn heap_size(&self) -> usize {
        0
    }
}

impl State for String {
    fn digest(&self, out: &mut Digest) {
        out.bytes(self.as_bytes());
    }
    fn heap_size(&self) -> usize {
        self.capacity()
    }
}

impl<T: State> State for Option<T> {
    fn digest(&self, out: &mut Digest) {
        out.word(u64::from(self.is_some()));
        self.iter().for_each(|inner| inner.digest(out));
    }
    fn heap_size(&self) -> usize {
        self.as_ref().map_or(0, T::heap_size)
    }
}

impl<T: State> State for [T] {
    fn digest(&self, out: &mut Digest) {
        out.word(self.len() as u64);
        self.iter().for_each(|one| one.digest(out));
    }
    fn heap_size(&self) -> usize {
        self.iter().map(T::heap_size).sum()
    }
}

impl<T: State, const N: usize> State for [T; N] {
    fn digest(&self, out: &mut Digest) {
        self.iter().for_each(|one| one.digest(out));
    }
    fn heap_size(&self) -> usize {
        self.iter().map(T::heap_size).sum()
    }
}

impl<T: State> State for Vec<T> {
    fn digest(&self, out: &mut Digest) {
        self.as_slice().digest(out);
    }
    fn heap_size(&self) -> usize {
        self.capacity() * size_of::<T>() + self.as_slice().heap_size()
    }
}

impl<T: State + ?Sized> State for Box<T> {
    fn digest(&self, out: &mut Digest) {
        (**self).digest(out);
    }
    fn heap_size(&self) -> usize {
        size_of_val(&**self) + (**self).heap_size()
    }
}

/// What copies share is counted once: before the first copy is made.
impl<T: State + ?Sized> State for Arc<T> {
    fn digest(&self, out: &mut Digest) {
        (**self).digest(out);
    }
    fn heap_size(&self) -> usize {
        if Self::strong_count(self) > 1 { 0 } else { size_of_val(&**self) + (**self).heap_size() }
    }
}

impl<T: State> State for VecDeque<T> {
    fn digest(&self, out: &mut Digest) {
        out.word(self.len() as u64);
        self.iter().for_each(|one| one.digest(out));
    }
    fn heap_size(&self) -> usize {
        self.capacity() * size_of::<T>() + self.iter().map(T::heap_size).sum::<usize>()
    }
}

impl<T: State + Copy> State for Cell<T> {
    fn digest(&self, out: &mut Digest) {
        self.get().digest(out);
    }
    fn heap_size(&self) -> usize {
        self.get().heap_size()
    }
}

/// A cache: counted, but no part of a hash, which must not depend on who has looked.
impl<T: State> State for OnceLock<T> {
    fn digest(&self, _out: &mut Digest) {}
    fn heap_size(&self) -> usize {
        self.get().map_or(0, T::heap_size)
    }
}

impl<K: State, V: State> State for BTreeMap<K, V> {
    fn digest(&self, out: &mut Digest) {
        out.word(self.len() as u64);
        for (key, value) in self {
            key.digest(out);
            value.digest(out);
        }
    }
    fn heap_size(&self) -> usize {
        self.len() * size_of::<(K, V)>() + self.iter().map(|(key, value)| key.heap_size() + value.heap_size()).sum::<usize>()
    }
}

impl<T: State> State for BTreeSet<T> {
    fn digest(&self, out: &mut Digest) {
        out.word(self.len() as u64);
        self.iter().for_each(|one| one.digest(out));
    }
    fn heap_size(&self) -> usize {
        self.len() * size_of::<T>() + self.iter().map(T::heap_size).sum::<usize>()
    }
}

impl<A: State, B: State, C: State> State for (A, B, C) {
    fn digest(&self, out: &mut Digest) {
        self.0.digest(out);
        self.1.digest(out);
        self.2.digest(out);
    }
    fn heap_size(&self) -> usize {
        self.0.heap_size() + self.1.heap_size() + self.2.heap_size()
    }
}

impl<A: State, B: State> State for (A, B) {
    fn digest(&self, out: &mut Digest) {
        self.0.digest(out);
        self.1.digest(out);
    }
    fn heap_size(&self) -> usize {
        self.0.heap_size() + self.1.heap_size()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_that_of_all_entries_and_of_what_they_own() {
        let owned = size_of::<f64>() * 3;
        let map = BTreeMap::from([(1_u64, vec![1.0; 3]), (2, vec![2.0; 3]), (3, Vec::new())]);
        assert_eq!(map.heap_size(), 3 * size_of::<(u64, Vec<f64>)>() + 2 * owned);
        assert_eq!(BTreeSet::from([1_u64, 2, 3]).heap_size(), 3 * size_of::<u64>());
        assert_eq!((vec![1.0; 3], vec![1.0; 3]).heap_size(), 2 * owned);
    }

    #[test]
    fn every_bit_and_the_order_count() {
        let hash = |words: &[u64]| {
            let mut digest = Digest::default();
            words.iter().for_each(|&w| digest.word(w));
            digest.hex()
        };
        assert_eq!(hash(&[1, 2]), hash(&[1, 2]));
        assert_ne!(hash(&[1, 2]), hash(&[2, 1]));
        assert_ne!(hash(&[1 << 63]), hash(&[0]));
        assert_ne!(Digest::of(&0.0).hex(), Digest::of(&-0.0).hex());
        let bytes = |bytes: &[u8]| Digest::of(std::str::from_utf8(bytes).unwrap()).hex();
        assert_ne!(bytes(b"a"), bytes(b"a\0"));
        assert_ne!(bytes(b"12345678"), bytes(b"12345679"));
    }

    #[derive(State, Clone)]
    enum Phase {
        Idle,
        Walking(u32),
        Standing { since: f64 },
    }

    /// A field of every form that planners have.
    #[derive(State, Clone)]
    struct Planted<T> {
        number: f64,
        words: Vec<u16>,
        nested: Vec<Option<(usize, Phase)>>,
        boxed: Box<[[f64; 2]]>,
        phase: Phase,
        text: String,
        generic: T,
        #[state(skip)]
        scratch: Vec<f64>,
        #[state(shared)]
        setup: Arc<[u8]>,
    }

    fn planted() -> Planted<bool> {
        Planted {
            number: 1.0,
            words: vec![1, 2],
            nested: vec![None, Some((3, Phase::Idle))],
            boxed: [[0.0, 1.0]].into(),
            phase: Phase::Walking(4),
            text: "five".to_owned(),
            generic: true,
            scratch: vec![6.0; 8],
            setup: [7; 100].into(),
        }
    }

    type Change = fn(&mut Planted<bool>);

    #[test]
    fn a_change_of_any_field_changes_the_hash_unless_the_field_is_marked() {
        let seen: [Change; 11] = [
            |p| p.number = -1.0,
            |p| p.words[1] = 3,
            |p| p.words.push(0),
            |p| p.nested[0] = Some((0, Phase::Idle)),
            |p| p.nested[1] = Some((3, Phase::Standing { since: 0.0 })),
            |p| p.boxed[0][1] = 2.0,
            |p| p.phase = Phase::Walking(5),
            |p| p.phase = Phase::Standing { since: 4.0 },
            |p| p.phase = Phase::Idle,
            |p| p.text.push('!'),
            |p| p.generic = false,
        ];
        let hashes: std::collections::BTreeSet<_> = seen
            .iter()
            .map(|change| {
                let mut changed = planted();
                change(&mut changed);
                Digest::of(&changed).hex()
            })
            .chain([Digest::of(&planted()).hex()])
            .collect();
        assert_eq!(hashes.len(), seen.len() + 1, "each change has a hash of its own");
        let unseen: [Change; 2] = [|p| p.scratch[0] = 7.0, |p| p.setup = [8; 3].into()];
        for change in unseen {
            let mut changed = planted();
            change(&mut changed);
            assert_eq!(Digest::of(&changed).hex(), Digest::of(&planted()).hex());
        }
    }

    #[test]
    fn the_size_is_that_of_all_memory_that_is_not_shared() {
        let mut state = planted();
        state.words = Vec::with_capacity(10);
        state.text = String::with_capacity(30);
        state.nested = Vec::with_capacity(2);
        assert_eq!(state.heap_size(), 10 * 2 + 30 + 2 * size_of::<Option<(usize, Phase)>>() + 16 + 8 * 8);
        assert_eq!(vec![vec![0_u8; 3]; 2].heap_size(), 2 * size_of::<Vec<u8>>() + 6);
        assert_eq!(Box::new(vec![0.0]).heap_size(), size_of::<Vec<f64>>() + 8);
    }
}
