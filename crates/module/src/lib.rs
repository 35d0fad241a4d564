//! The WebAssembly module: swarms among discs and on functions, and parts that are loaded as they are needed.
//!
//! A part is what only its function needs: the tool that splits the module follows the calls from there. A part of its own is
//! worth it for what many users never see, and costs a request.
#![cfg(target_arch = "wasm32")]

use forage::{describe::SceneKind, follow, registry, scene};
use forage_face::{know, offer_arm, offer_code, offer_files, offer_links, offer_pictures, offer_statistics};
use wasm_bindgen::prelude::wasm_bindgen;

/// Where the entries of a part are among all: in the order of the library's own list.
enum Rank {
    Discs,
    Grid,
    Tour,
    Arm,
    Function,
    Swarms,
    Searches,
    Tours,
    Trees,
    Drives,
    Others,
}

/// The kinds without the scenes that ship with them: the host loads those of a part with it.
const fn alone(kind: SceneKind) -> SceneKind {
    SceneKind { shipped: &[], ..kind }
}

static DISCS: SceneKind = alone(scene::discs::KIND);
static FUNCTION: SceneKind = alone(scene::function::NAMED);
static FORMULA: SceneKind = alone(scene::function::KIND);
static GRID: SceneKind = alone(scene::grid::KIND);
static TOUR: SceneKind = alone(scene::tour::KIND);
static ARM: SceneKind = alone(scene::arm::KIND);

#[wasm_bindgen(start)]
fn start() {
    know(Rank::Discs as u8, |registry| registry.with(&DISCS));
    know(Rank::Function as u8, |registry| registry.with(&FUNCTION));
    know(Rank::Swarms as u8, |registry| registry.with_all(registry::SWARMS));
}

/// Parts by name, each with the names by which they are split off and what they add.
macro_rules! parts {
    ($($name:ident, $import:literal, $export:literal, $add:block)*) => {
        /// Adds what a part has; its code must be there. False for a name that means nothing.
        #[wasm_bindgen(skip_typescript)]
        pub fn add(part: &str) -> bool {
            match part {
                $(stringify!($name) => $name::add(),)*
                _ => return false,
            }
            true
        }

        $(
            #[cfg_attr(feature = "split", expect(unsafe_code, reason = "the tool that splits knows a part by the names of two functions"))]
            mod $name {
                use super::*;

                #[cfg(feature = "split")]
                #[link(wasm_import_module = "__wasm_split_placeholder__")]
                unsafe extern "C" {
                    #[link_name = $import]
                    fn apart();
                }

                #[cfg_attr(feature = "split", unsafe(export_name = $export))]
                extern "C" fn here() $add

                pub(super) fn add() {
                    #[cfg(feature = "split")]
                    // SAFETY: it is the function below, with no arguments.
                    unsafe { apart() };
                    #[cfg(not(feature = "split"))]
                    here();
                }
            }
        )*
    };
}

parts! {
    grid, "__wasm_split_00grid00_import_00000000000000000000000000000001_grid", "__wasm_split_00grid00_export_00000000000000000000000000000001_grid", {
        know(Rank::Grid as u8, |registry| registry.with(&GRID));
        know(Rank::Searches as u8, |registry| registry.with_all(registry::SEARCHES));
        know(Rank::Drives as u8, |registry| registry.with_all(registry::DRIVES).with(&follow::drive::ENTRY));
    }
    tour, "__wasm_split_00tour00_import_00000000000000000000000000000002_tour", "__wasm_split_00tour00_export_00000000000000000000000000000002_tour", {
        know(Rank::Tour as u8, |registry| registry.with(&TOUR));
        know(Rank::Tours as u8, |registry| registry.with_all(registry::TOURS));
    }
    arm, "__wasm_split_00arm00_import_00000000000000000000000000000003_arm", "__wasm_split_00arm00_export_00000000000000000000000000000003_arm", {
        know(Rank::Arm as u8, |registry| registry.with(&ARM));
        know(Rank::Trees as u8, |registry| registry.with_all(registry::TREES).with(&follow::motion::ENTRY));
        offer_arm();
    }
    links, "__wasm_split_00links00_import_00000000000000000000000000000008_links", "__wasm_split_00links00_export_00000000000000000000000000000008_links", {
        offer_links();
    }
    files, "__wasm_split_00files00_import_00000000000000000000000000000004_files", "__wasm_split_00files00_export_00000000000000000000000000000004_files", {
        offer_files();
    }
    formulas, "__wasm_split_00formulas00_import_00000000000000000000000000000009_formulas", "__wasm_split_00formulas00_export_00000000000000000000000000000009_formulas", {
        know(Rank::Function as u8, |registry| registry.with(&FORMULA));
    }
    code, "__wasm_split_00code00_import_00000000000000000000000000000010_code", "__wasm_split_00code00_export_00000000000000000000000000000010_code", {
        offer_code();
    }
    generators, "__wasm_split_00generators00_import_00000000000000000000000000000005_generators", "__wasm_split_00generators00_export_00000000000000000000000000000005_generators", {
        know(Rank::Others as u8, |registry| registry.with_all(registry::GENERATORS));
    }
    pictures, "__wasm_split_00pictures00_import_00000000000000000000000000000006_pictures", "__wasm_split_00pictures00_export_00000000000000000000000000000006_pictures", {
        offer_pictures();
    }
    statistics, "__wasm_split_00statistics00_import_00000000000000000000000000000007_statistics", "__wasm_split_00statistics00_export_00000000000000000000000000000007_statistics", {
        offer_statistics();
    }
}
