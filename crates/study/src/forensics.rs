//! The study of what printed figures can rest on: a table of all [`findings`].

use super::{
    failure::Failure,
    findings::{Finding, findings},
    options::Options,
    report::Report,
    runner::Control,
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const STUDY: Study = Study {
    name: "forensics",
    title: "what the printed figures can rest on",
    source: "our own",
    repeatable: true,
    jobs: |_| Ok(Vec::new()),
    run,
};

fn run(options: &Options, _control: &Control) -> Result<Report, Failure> {
    let mut report = STUDY.report(0, 0);
    let mut table = Table::new("findings", "What the printed figures can rest on", &["where", "printed", "source", "why"]);
    for Finding { place, figure, source, because, .. } in findings()? {
        table.rows.push(vec![Cell::Text(place), Cell::Text(figure), source.name().into(), Cell::Text(because)]);
    }
    report.tables.push(table);
    report.notes = vec![
        "*consistent*: it can be what the paper says it is. *doubtful*: it can be, but of something else than the paper says. *impossible as printed*: no numbers give it.".to_owned(),
    ];
    report.write(options)?;
    Ok(report)
}
