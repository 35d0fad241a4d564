//! An interpreter with an author's code in it.

#![expect(clippy::disallowed_types, reason = "a step that takes too long is stopped; a run that is stopped says so")]

use std::{
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, Ordering::Relaxed},
    },
    thread::{self, ThreadId},
    time::{Duration, Instant},
};

use forage::{kernel::Message, message};
use forage_script::{Tools, mathematics, not_lent};
use rquickjs::{
    ArrayBuffer, CaughtError, Context, Ctx, Exception, Function, JsLifetime, Module, Object, Result, Runtime, Value,
    context::intrinsic::{Eval, Json, MapSet, Promise, Proxy, RegExp, RegExpCompiler, TypedArrays},
    function::Args,
    loader::{ImportAttributes, Loader, Resolver},
    module::Declared,
};

const INSIDE: &str = include_str!("js/inside.js");
/// What the inside consists of, by name.
const PARTS: [(&str, &str); 4] = [
    ("./describe.js", include_str!("js/describe.js")),
    ("./host.js", include_str!("js/host.js")),
    ("./powers.js", include_str!("js/powers.js")),
    ("./shown.js", include_str!("js/shown.js")),
];
/// What an author may import.
const FORAGE: (&str, &str) = ("forage-lab", "export const register = globalThis.register");

/// In MB.
const MEMORY: usize = 64;
/// In bytes.
const STACK: usize = 256 * 1024;
/// How long a step may take.
pub(crate) const STEP: Duration = Duration::from_millis(900);
/// For our own code, which has an end: on a machine that is busy its first steps are slow.
const READ: Duration = Duration::from_secs(10);
/// How long it may take to show something.
pub(crate) const LOOK: Duration = Duration::from_millis(300);
/// The longest message of an error, in characters.
const LONGEST_MESSAGE: usize = 500;
const FILE: &str = "planner.js";
/// By how much a call may be late: the clock is looked at between instructions, not within what is built in.
const GRACE: Duration = Duration::from_secs(3);
/// Threads that run a code now, and until when they may.
static BUSY: Mutex<Vec<(ThreadId, Instant)>> = Mutex::new(Vec::new());

/// Looks whether code runs on after its time, because something built in takes that long; calls `stuck` once: such code ends only with
/// the program.
pub fn watch(stuck: impl Fn() + Send + 'static) {
    thread::spawn(move || {
        loop {
            thread::sleep(GRACE / 10);
            if locked(&BUSY).iter().any(|(_, end)| Instant::now() > *end + GRACE) {
                return stuck();
            }
        }
    });
}

type Intrinsics = (Eval, RegExpCompiler, RegExp, Json, Proxy, MapSet, TypedArrays, Promise);

/// Something that runs code. It is used by one thread at a time.
pub(crate) struct Interpreter {
    context: Context,
    // After all that lives in it.
    _runtime: Runtime,
    deadline: Arc<Mutex<Option<Instant>>>,
    tools: Arc<Mutex<Option<Tools>>>,
}

/// The functions of the inside, where no code finds them.
#[derive(JsLifetime)]
struct Inside<'js>(Object<'js>);

/// An argument of a call.
pub(crate) enum Given {
    Number(f64),
    Text(String),
    Numbers(Vec<f64>),
}

/// What may be imported: the parts of the inside while it is put together, then one thing.
#[derive(Clone)]
struct Modules {
    complete: Arc<AtomicBool>,
}

impl Modules {
    fn find(&self, name: &str) -> Option<&'static str> {
        let parts = if self.complete.load(Relaxed) { std::slice::from_ref(&FORAGE) } else { &PARTS[..] };
        parts.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
    }
}

impl Resolver for Modules {
    fn resolve<'js>(&mut self, ctx: &Ctx<'js>, _base: &str, name: &str, _attributes: Option<ImportAttributes<'js>>) -> Result<String> {
        match self.find(name) {
            Some(_) => Ok(name.to_owned()),
            None => Err(Exception::throw_message(ctx, &format!("`{name}` can't be imported: only forage-lab is here"))),
        }
    }
}

impl Loader for Modules {
    fn load<'js>(&mut self, ctx: &Ctx<'js>, name: &str, _attributes: Option<ImportAttributes<'js>>) -> Result<Module<'js, Declared>> {
        Module::declare(ctx.clone(), name, self.find(name).unwrap_or_default())
    }
}

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The numbers of a buffer.
#[expect(unsafe_code, reason = "a buffer’s bytes are lent by the interpreter")]
fn numbers(value: &Value) -> Vec<f64> {
    let bytes = value.as_object().and_then(|object| ArrayBuffer::from_object(object.clone()));
    // SAFETY: no code runs until they are copied.
    let bytes = bytes.as_ref().and_then(|buffer| unsafe { buffer.as_bytes() }).unwrap_or_default();
    bytes.as_chunks::<8>().0.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect()
}

impl Interpreter {
    /// Runs a code in a new one.
    pub(crate) fn new(code: &str) -> std::result::Result<Self, Message> {
        let broken = |error: rquickjs::Error| Message::verbatim(error.to_string());
        let runtime = Runtime::new().map_err(broken)?;
        runtime.set_memory_limit(MEMORY * 1024 * 1024);
        runtime.set_max_stack_size(STACK);
        let deadline = Arc::new(Mutex::new(None));
        let clock = Arc::clone(&deadline);
        runtime.set_interrupt_handler(Some(Box::new(move || locked(&clock).is_some_and(|end: Instant| Instant::now() > end))));
        let modules = Modules { complete: Arc::new(AtomicBool::new(false)) };
        let complete = Arc::clone(&modules.complete);
        runtime.set_loader(modules.clone(), modules);
        let context = Context::custom::<Intrinsics>(&runtime).map_err(broken)?;
        let tools = Arc::new(Mutex::new(None));
        let interpreter = Self { context, _runtime: runtime, deadline, tools };
        interpreter.lend()?;
        interpreter.within(READ, |ctx| {
            Module::evaluate(ctx.clone(), "inside.js", INSIDE)?.finish::<()>()?;
            let inside: Object = ctx.globals().get("inside")?;
            ctx.globals().remove("inside")?;
            ctx.store_userdata(Inside(inside)).map(drop).map_err(|_| rquickjs::Error::Unknown)
        })?;
        complete.store(true, Relaxed);
        let portable = interpreter.call("portable", READ, [Given::Text(code.to_owned())], |value| value.get::<String>().ok())?;
        interpreter.within(STEP, |ctx| Module::evaluate(ctx.clone(), FILE, portable.unwrap_or_default())?.finish::<()>())?;
        Ok(interpreter)
    }

    /// What the inside may call.
    fn lend(&self) -> std::result::Result<(), Message> {
        let (scalar, list) = (Arc::clone(&self.tools), Arc::clone(&self.tools));
        self.within(READ, |ctx| {
            let outside = Object::new(ctx.clone())?;
            let thrown = |ctx: &Ctx<'_>, error: &forage::Error| Exception::throw_message(ctx, &error.to_string());
            outside.set(
                "lent",
                Function::new(ctx.clone(), move |ctx: Ctx<'_>, what: f64, a: f64, b: f64| match mathematics(what as u32, a, b) {
                    Some(found) => Ok(found),
                    None => match locked(&scalar).as_mut() {
                        Some(tools) => tools.scalar(what as u32, a, b).map_err(|error| thrown(&ctx, &error)),
                        None => Err(thrown(&ctx, &not_lent())),
                    },
                })?,
            )?;
            outside.set(
                "list",
                Function::new(ctx.clone(), move |ctx: Ctx<'_>, what: f64, buffer: Value<'_>| match locked(&list).as_mut() {
                    Some(tools) => tools.list(what as u32, &numbers(&buffer)).map_err(|error| thrown(&ctx, &error)),
                    None => Err(thrown(&ctx, &not_lent())),
                })?,
            )?;
            outside.set("print", Function::new(ctx.clone(), |_line: Value<'_>| ())?)?;
            ctx.globals().set("outside", outside)
        })
    }

    /// Carries something out in so much time.
    fn within<T>(&self, limit: Duration, work: impl for<'js> FnOnce(&Ctx<'js>) -> Result<T>) -> std::result::Result<T, Message> {
        let end = Instant::now() + limit;
        *locked(&self.deadline) = Some(end);
        let thread = thread::current().id();
        locked(&BUSY).push((thread, end));
        let result = self.context.with(|ctx| work(&ctx).map_err(|error| fault(&ctx, error, limit, Instant::now() > end)));
        locked(&BUSY).retain(|(busy, _)| *busy != thread);
        *locked(&self.deadline) = None;
        result
    }

    /// Calls a function of the inside; `read` makes of its result what may leave.
    pub(crate) fn call<T>(
        &self,
        name: &str,
        limit: Duration,
        given: impl IntoIterator<Item = Given>,
        read: impl for<'js> FnOnce(&Value<'js>) -> T,
    ) -> std::result::Result<T, Message> {
        let given: Vec<_> = given.into_iter().collect();
        self.within(limit, |ctx| {
            let inside = ctx.userdata::<Inside>().ok_or(rquickjs::Error::Unknown)?.0.clone();
            let called: Function = inside.get(name)?;
            let mut arguments = Args::new(ctx.clone(), given.len());
            for one in given {
                match one {
                    Given::Number(number) => arguments.push_arg(number)?,
                    Given::Text(text) => arguments.push_arg(text)?,
                    Given::Numbers(numbers) => arguments.push_arg(ArrayBuffer::new(ctx.clone(), numbers)?)?,
                }
            }
            let found: Value = called.call_arg(arguments)?;
            Ok(read(&found))
        })
    }

    /// Lends tools for the time of a call, and takes them back.
    pub(crate) fn lending<T>(&self, tools: Tools, call: impl FnOnce() -> std::result::Result<T, Message>) -> forage_script::Call<T> {
        *locked(&self.tools) = Some(tools);
        let result = call();
        forage_script::Call { tools: locked(&self.tools).take(), result }
    }
}

/// Numbers of a result that is a buffer.
pub(crate) fn list(value: &Value) -> Option<Vec<f64>> {
    value.is_object().then(|| numbers(value))
}

/// What went wrong, in words, with the line of the code where it did. `late`: it was stopped, whatever it says.
fn fault(ctx: &Ctx<'_>, error: rquickjs::Error, limit: Duration, late: bool) -> Message {
    let waits = matches!(error, rquickjs::Error::WouldBlock);
    let (name, text, stack) = match CaughtError::from_error(ctx, error) {
        CaughtError::Exception(exception) => {
            let name = exception.as_object().get::<_, String>("name").unwrap_or_else(|_| "Error".to_owned());
            (name, exception.message().unwrap_or_default(), exception.stack().unwrap_or_default())
        }
        CaughtError::Value(value) => {
            ("Error".to_owned(), value.get::<String>().unwrap_or_else(|_| format!("{:?}", value.type_of())), String::new())
        }
        CaughtError::Error(error) => ("Error".to_owned(), error.to_string(), String::new()),
    };
    let text: String = text.chars().take(LONGEST_MESSAGE).collect();
    let line = stack.split_once(&format!("{FILE}:")).map(|(_, rest)| rest.chars().take_while(char::is_ascii_digit).collect::<String>());
    let at = line.map_or(Message::default(), |line| message!("isolate-line", "(line {line})", line));
    let said = match &*text {
        // Without memory there is no object for an error.
        "Null" if stack.is_empty() && !late => {
            message!("isolate-null", "it throws null, or it needs more than {memory} MB", memory = MEMORY)
        }
        // Without memory a promise is never kept.
        _ if waits && !late => {
            message!("isolate-waits", "it awaits what never comes, or it needs more than {memory} MB", memory = MEMORY)
        }
        text if late || text == "interrupted" => {
            message!("isolate-time", "it took longer than {limit} ms and was stopped", limit = limit.as_millis() as f64)
        }
        "out of memory" => message!("isolate-memory", "it needs more than {memory} MB", memory = MEMORY),
        "stack overflow" | "Maximum call stack size exceeded" => message!("isolate-deep", "its calls are nested too deeply"),
        _ if name == "Error" => Message::verbatim(text),
        _ => Message::verbatim(format!("{name}: {text}")),
    };
    said.then(at)
}
