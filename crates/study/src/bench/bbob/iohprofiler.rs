//! Files as IOHprofiler’s logger writes them: IOHanalyzer and `iohinspector` read them.

use std::{collections::BTreeMap, fmt::Write as _, path::Path};

use serde_json::{Value, json};

use super::{
    super::{
        super::disk,
        super::failure::{Failure, at},
        suite::safe_file_name,
    },
    row::{Row, TITLES},
};

/// The version of the format.
const VERSION: &str = "0.4.2";

/// Writes a folder for each planner.
pub(super) fn write(rows: &[Row], folder: &Path) -> Result<(), Failure> {
    let mut functions: BTreeMap<(String, usize), BTreeMap<usize, Vec<&Row>>> = BTreeMap::new();
    for row in rows {
        functions.entry((row.contender(), row.function)).or_default().entry(row.dimension).or_default().push(row);
    }
    for ((contender, function), dimensions) in functions {
        let own = folder.join(safe_file_name(&contender));
        let title = TITLES[function - 1];
        let data = format!("data_f{function}_{title}");
        disk::make_folder(&own.join(&data)).map_err(at(&own))?;
        let mut scenarios = Vec::new();
        for (dimension, rows) in dimensions {
            let name = format!("{data}/IOHprofiler_f{function}_DIM{dimension}.dat");
            let mut text = String::new();
            let mut runs = Vec::new();
            for row in rows {
                let improvements = row.improvements();
                text.push_str("evaluations raw_y\n");
                for (at, gap) in &improvements {
                    // Writing to a text cannot fail.
                    let _ = writeln!(text, "{at} {gap:.10}");
                }
                let (best, gap) = improvements.last().copied().unwrap_or((0, row.gap));
                if best < row.evaluations {
                    let _ = writeln!(text, "{} {gap:.10}", row.evaluations);
                }
                runs.push(json!({ "instance": row.instance, "evals": row.evaluations, "best": { "evals": best, "y": gap, "x": Value::Array(Vec::new()) } }));
            }
            let path = own.join(&name);
            disk::write(&path, text).map_err(at(&path))?;
            scenarios.push(json!({ "dimension": dimension, "path": name, "runs": runs }));
        }
        let description = json!({
            "version": VERSION,
            "suite": "bbob",
            "function_id": function,
            "function_name": title,
            "maximization": false,
            "algorithm": { "name": contender, "info": format!("forage {}", env!("CARGO_PKG_VERSION")) },
            "attributes": ["evaluations", "raw_y"],
            "scenarios": scenarios,
        });
        let path = own.join(format!("IOHprofiler_f{function}_{title}.json"));
        let text = serde_json::to_string_pretty(&description).unwrap_or_default();
        disk::write(&path, text + "\n").map_err(at(&path))?;
    }
    Ok(())
}
