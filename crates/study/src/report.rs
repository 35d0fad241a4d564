//! What a reproduction has to say: tables, claims, what was chosen where the paper is silent, and how to repeat it.

mod figures;
mod show;

use std::path::PathBuf;

use serde::Serialize;

use super::{claims::Judged, compared::ComparedFigure, escape::serialize_paths, marking, papers, table::Table};

pub(super) use figures::figures;

/// A reproduction's result.
#[derive(Debug, Clone, Serialize)]
pub struct Report {
    /// The reproduction's name.
    pub name: &'static str,
    /// A line for people.
    pub title: &'static str,
    /// Where it was published.
    pub source: &'static str,
    /// Whether all of it comes out the same again.
    pub repeatable: bool,
    /// Runs a cell, where they are fewer or more than published.
    pub shortened: Option<String>,
    /// The published figures and the computed ones.
    #[serde(serialize_with = "marking::serialize_figures")]
    pub figures: Vec<ComparedFigure>,
    /// The tables.
    pub tables: Vec<Table>,
    /// What the paper claims, and whether it holds.
    pub claims: Vec<Judged>,
    /// What was chosen where the paper is silent, and what should be known when reading the tables.
    pub notes: Vec<String>,
    /// Command lines that repeat single runs.
    pub commands: Vec<String>,
    /// What was written.
    #[serde(serialize_with = "serialize_paths")]
    pub files: Vec<PathBuf>,
}

impl Report {
    /// The tag of its paper: `WCPSO` of `[WCPSO] Table 2`.
    pub fn paper(&self) -> &'static str {
        papers::tag(self.source)
    }
}
