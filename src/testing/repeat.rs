//! The same setup gives the same bits: side by side, on the way back, and opened by a link.

use std::{collections::BTreeMap, sync::Arc};

use crate::{
    describe::Start,
    kernel::{Digest, Frame, Header, Readings, Scene, State, Stepped, Stepper, part::with_parts_of},
    params::Parameters,
    run::{Link, Run, Setup, run_subtasks},
};

use super::{
    fault::{Checked, Fault, ensure, refusal},
    findings::Findings,
    subject::{SMALL, Subject, goes_on},
};

const RANDOM: &str = "Take random numbers only from a `Stream` made from `start.seed` and kept in the state; read no clock and no `static`, \
                      and keep nothing whose order varies.";
const PARTS: &str = "Let a step in parts do what the whole step does: draw no random number between two parts, and let nothing depend on \
                     how many pieces of work `Part::take` gives.";
const REWIND: &str = "Keep all that a step reads in the state, so that a clone of it goes on alike; share only what never changes.";
const LINK: &str = "Let `start` depend on scene, parameters and seed alone.";
const SEED: &str = "Keep the `Stream` in the state, neither skipped nor shared: only so is the run known to be random.";
const SKIPPED: &str = "Let `State` hash every field that results depend on: `#[state(skip)]` is for scratch memory and caches, \
                       `#[state(shared)]` for what follows from the setup.";
const SIZE: &str = "Derive `State`, so that the size counts every field.";

/// So many parts of a step are looked at.
const LOOKS: u32 = 20;

/// What can be seen of a run at an iteration, bit by bit.
#[derive(PartialEq)]
struct Snapshot {
    hash: String,
    best: Option<u64>,
    readings: Vec<(&'static str, u64)>,
    drawing: Vec<u32>,
}

impl Snapshot {
    fn of(run: &mut Run) -> Self {
        let mut frame = Frame::default();
        run.draw(&mut frame, Frame::BUDGET);
        let readings = bits(run.readings());
        Self { hash: run.hash(), best: run.best().map(|best| best.cost.to_bits()), readings, drawing: drawing(&frame) }
    }

    /// Names what differs.
    fn compare(&self, other: &Self, remedy: &'static str, how: &str, iteration: u64) -> Checked {
        let what = match self {
            _ if self.best != other.best => "the best cost differs",
            _ if self.readings != other.readings => "the readings differ",
            _ if self.drawing != other.drawing => "the drawing differs",
            _ if self.hash != other.hash => "the hash differs",
            _ => return Ok(()),
        };
        Err(Fault::new(remedy, format!("{what} {how}")).at(iteration))
    }
}

fn bits(readings: &Readings) -> Vec<(&'static str, u64)> {
    readings.iter().map(|(name, value)| (name, value.to_bits())).collect()
}

fn drawing(frame: &Frame) -> Vec<u32> {
    frame.vertices().iter().map(|vertex| vertex.to_bits()).chain(frame.table().iter().copied()).collect()
}

pub fn same_bits(subject: &Subject, findings: &mut Findings) {
    findings.watch_random(subject, 30, |setup, _| {
        let (mut first, mut second, mut in_parts) = (subject.start(setup)?, subject.start(setup)?, subject.start(setup)?);
        loop {
            let iteration = first.iteration();
            let snapshot = Snapshot::of(&mut first);
            snapshot.compare(&Snapshot::of(&mut second), RANDOM, "between two runs of the same setup", iteration)?;
            snapshot.compare(&Snapshot::of(&mut in_parts), PARTS, "between whole steps and steps in parts", iteration)?;
            if !goes_on(&first) {
                return Ok(());
            }
            first.step(1);
            // Subtasks may be run elsewhere.
            let subtasks = second.subtasks();
            if !subtasks.is_empty() {
                let found = run_subtasks(subject.registry, &setup.scene, &subtasks);
                let provided = found.and_then(|found| in_parts.provide(found.clone()).and_then(|()| second.provide(found)));
                provided.map_err(|error| Fault::new(LINK, format!("a subtask is refused: {error}")).at(iteration))?;
            }
            second.step(1);
            // A step in parts can be looked at in between. The smallest parts are many: looking at the first of them is enough.
            let mut looks = 0;
            while with_parts_of(1, || in_parts.part()) == Stepped::Partly {
                if looks < LOOKS {
                    looks += 1;
                    Snapshot::of(&mut in_parts);
                }
            }
        }
    });
}

pub fn rewinding(subject: &Subject, findings: &mut Findings) {
    const ITERATIONS: u64 = 60;
    findings.watch_random(subject, ITERATIONS, |setup, stream| {
        let mut forward = subject.start(setup)?;
        let mut seen = vec![Snapshot::of(&mut forward)];
        while goes_on(&forward) {
            forward.step(1);
            seen.push(Snapshot::of(&mut forward));
        }
        let mut replayed = subject.start_with_keyframes(setup, if setup.seed % 2 == 0 { 0 } else { 20_000 })?;
        for _ in 0..6 {
            let to = stream.below(seen.len());
            for run in [&mut forward, &mut replayed] {
                run.seek(to as u64);
                ensure(run.iteration() == to as u64, REWIND, || format!("seeking {to} ends at {}", run.iteration()))?;
                seen[to].compare(&Snapshot::of(run), REWIND, "after a way back", to as u64)?;
            }
        }
        Ok(())
    });
}

pub fn links(subject: &Subject, findings: &mut Findings) {
    findings.watch_random(subject, 40, |setup, stream| {
        // A scene with another title is no shipped one: the link carries it.
        let scene = if stream.unit() < 0.5 { edited(&setup.scene)? } else { Arc::clone(&setup.scene) };
        let mut run = subject.start(&Setup { scene, ..setup.clone() })?;
        run.seek(stream.below(30) as u64);
        let at = run.iteration();
        let fault = |found: String| Fault::new(LINK, found).at(at);
        let text = run.link().ok_or_else(|| fault("it has no link".to_owned()))?;
        let link = Link::parse(subject.registry, &text).map_err(|error| fault(format!("its link cannot be opened: {error}")))?;
        let mut opened = subject.start(&link.setup)?;
        opened.seek(link.iteration);
        ensure(link.iteration == at && link.hash == Some(opened.hash()), LINK, || "the run that a link opens has another hash".to_owned())
            .and_then(|()| ensure(opened.link() == Some(text), LINK, || "the run that a link opens has another link".to_owned()))
            .map_err(|fault| fault.at(at))
    });
}

fn edited(scene: &Arc<Scene>) -> Result<Arc<Scene>, Fault> {
    let header = Header { title: "edited & <named> 5 % \u{2713}".to_owned(), ..scene.header().clone() };
    scene.with_header(header).map(Arc::new).map_err(|error| Fault::new(LINK, error.to_string()))
}

pub fn seeds(subject: &Subject, findings: &mut Findings) {
    for scene in &subject.scenes {
        let setup = subject.setup(scene, 1, 30, &subject.sizes(scene.kind(), SMALL));
        findings.watch(&setup, || {
            let end = |seed| {
                let mut run = subject.start(&Setup { seed, ..setup.clone() })?;
                run.step(run.limit());
                Ok((run.digest().is_random(), Snapshot::of(&mut run), run.iteration()))
            };
            let ((random, first, at), (_, second, _)) = (end(1)?, end(2)?);
            ensure(first.hash != second.hash, SEED, || "two seeds have the same hash".to_owned())?;
            if random {
                return Ok(());
            }
            let other = Snapshot { hash: first.hash.clone(), ..second };
            first.compare(&other, SEED, "with another seed, and the run calls itself deterministic", at)
        });
    }
}

/// Within a run, states that differ in nothing but their random streams look the same. And a copy is no larger.
pub fn hashes(subject: &Subject, findings: &mut Findings) {
    findings.watch_random(subject, 30, |setup, _| {
        let parameters = Parameters::new(subject.entry.parameters, setup.scene.kind(), &setup.params);
        let parameters = parameters.map_err(|error| refusal(&error))?;
        let start =
            Start { entry: subject.entry, scene: &setup.scene, parameters: &parameters, seed: setup.seed, entries: &**subject.registry };
        let started = (subject.entry.start)(&start).map_err(|error| refusal(&error))?;
        let limit = started.limit;
        let mut state = Stepper::from(started);
        let mut seen = BTreeMap::new();
        loop {
            let at = state.iteration;
            let mut digest = Digest::without_streams();
            state.planner.digest(&mut digest);
            let shown = shown(subject, &state);
            let same = seen.insert(digest.hex(), shown.clone()).is_none_or(|earlier| earlier == shown);
            ensure(same, SKIPPED, || "its readings, best or drawing change, and its hash sees at most its random stream change".to_owned())
                .and_then(|()| sized(&state, digest.words()))
                .map_err(|fault| fault.at(at))?;
            if at == limit || !state.step(|subtasks| run_subtasks(subject.registry, &setup.scene, &subtasks).unwrap_or_default()) {
                return Ok(());
            }
        }
    });
}

/// A digest of what can be seen of a state.
fn shown(subject: &Subject, state: &Stepper) -> String {
    let mut frame = Frame::default();
    frame.clear(Frame::BUDGET, subject.entry.drawn_and_marked().0.iter().map(|layer| layer.key));
    state.planner.draw(&mut frame);
    let mut readings = Readings::default();
    state.planner.read(&mut readings);
    let mut digest = Digest::default();
    drawing(&frame).digest(&mut digest);
    bits(&readings).digest(&mut digest);
    state.planner.best().map(|best| best.cost).digest(&mut digest);
    digest.hex()
}

fn sized(state: &Stepper, words: u64) -> Checked {
    // What copies share counts once: before there is a copy.
    let own = state.planner.heap_size();
    let copied = state.clone().planner.heap_size();
    ensure(copied <= own, SIZE, || format!("a copy has {copied} bytes, more than the {own} bytes of its original"))?;
    // Each word of a hash comes from a byte at least.
    let bytes = (size_of_val(&*state.planner) + own) as u64;
    ensure(words <= bytes, SIZE, || format!("its hash sees {words} numbers, and its size is {bytes} bytes"))
}
