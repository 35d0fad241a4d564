//! A step allocates nothing: counted by an allocator of the test's own.
#![cfg(not(target_arch = "wasm32"))]
#![expect(unsafe_code, reason = "an allocator can only be written with it")]

use std::{
    alloc::{GlobalAlloc, Layout, System},
    cell::Cell,
};

use forage::{
    catalogue::PLANNERS,
    params::{Given, Settings},
    shipped,
};

struct Counting;

thread_local!(static COUNT: Cell<u64> = const { Cell::new(0) });

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn no_step_of_any_swarm_allocates() {
    for entry in PLANNERS.iter().filter(|entry| entry.family == "swarm") {
        for name in ["wcpso-discs", "qpso-10m", "ackley"] {
            let scene = shipped(name).unwrap();
            let settings = Settings::new(entry.parameters, scene.kind(), &Given::new()).unwrap();
            let mut planner = (entry.start)(&scene, &settings, 1).unwrap();
            let before = COUNT.with(Cell::get);
            assert!(before > 0, "the counter counts");
            for _ in 0..300 {
                planner.step_taken();
            }
            assert_eq!(COUNT.with(Cell::get) - before, 0, "{} on {name}", entry.name);
        }
    }
}
