//! `forage grade`.

use std::{fs, path::Path};

use forage::{Overrides, Run, Setup, shipped, standard};

use crate::support::{empty_folder, forage, text as words};

fn link(planner: &str, scene: &str, seed: u64, at: u64) -> String {
    let setup = Setup { planner: planner.into(), scene: shipped(scene).unwrap(), params: Overrides::new(), seed };
    let mut run = Run::new(standard(), setup).unwrap();
    run.step(at);
    format!("https://example.org/forage/{}", run.link().unwrap())
}

fn graded(folder: &Path, links: &str, task: &str) -> (Option<i32>, Vec<csv::StringRecord>, String) {
    let [list, goal] = ["links.txt", "task.json"].map(|name| folder.join(name));
    fs::write(&list, links).unwrap();
    fs::write(&goal, task).unwrap();
    let output = forage(&["grade", list.to_str().unwrap(), "--task", goal.to_str().unwrap()]);
    let mut rows = csv::ReaderBuilder::new().has_headers(false).from_reader(&output.stdout[..]);
    (output.status.code(), rows.records().collect::<Result<_, _>>().unwrap(), words(&output.stderr))
}

const TASK: &str = r#"{"goal": {"gap": 0.2}, "budget": {"evaluations": 100000}, "scene": "wcpso-discs"}"#;

#[test]
fn each_link_gets_a_row_with_whose_it_is_and_what_is_wrong() {
    let folder = empty_folder("grade");
    let good = link("pso", "wcpso-discs", 3, 300);
    let other = good.replace("&seed=3", "&seed=4");
    let elsewhere = link("pso", "discs-gate", 1, 20);
    // What the page adds has commas, too.
    let seen = format!("{good}&page.camera=5,4,2&page.layers=best,-particles");
    let links = format!("# Group 2\n\n\"Lovelace, Ada\";\"{seen}\";4 July\nBo:\t{other}\n{elsewhere}\n\"Cy\";no link at all\n");
    let (code, rows, stderr) = graded(&folder, &links, TASK);
    assert_eq!(code, Some(1), "{stderr}");
    let header: Vec<_> = rows[0].iter().take(6).collect();
    assert_eq!(header, ["reached", "evaluations", "verified", "reason", "line", "name"]);
    let row = |k: usize| -> Vec<&str> { [0, 2, 4, 5, 6, 7].map(|column| &rows[k][column]).to_vec() };
    assert_eq!(row(1), ["true", "true", "3", "Lovelace, Ada", "pso", "wcpso-discs"]);
    assert!(rows[1][1].parse::<u64>().unwrap() > 0 && rows[1][3].is_empty());
    assert_eq!(row(2)[1..], ["false", "4", "Bo", "pso", "wcpso-discs"]);
    assert!(rows[2][3].contains("give the hash"), "{}", &rows[2][3]);
    assert_eq!(row(3), ["false", "true", "5", "", "pso", "discs-gate"]);
    assert!(rows[3][3].contains("The scene is discs-gate"), "{}", &rows[3][3]);
    assert_eq!(row(4)[..3], ["false", "false", "6"]);
    assert!(rows[4][3].contains("link"), "{}", &rows[4][3]);
    assert_eq!(rows.len(), 5);
    assert!(stderr.contains("1 of 4"), "{stderr}");

    let (code, rows, _) = graded(&folder, &format!("{good}\n"), TASK);
    assert_eq!((code, rows.len()), (Some(0), 2));
}

#[test]
fn what_cannot_be_graded_is_refused() {
    let folder = empty_folder("grade-refused");
    for (links, task, said) in [
        ("\n# nobody\n", TASK, "no link"),
        ("x\n", r#"{"goal": {"gap": "small"}}"#, "goal"),
        ("x\n", "goal", "not JSON"),
        ("x\n", r#"{"goal": {"gap": 0.1}, "planner": "pso", "params": {"w_max": 0.1}}"#, "w_max"),
        ("x\n", r#"{"goal": {"gap": 0.1}, "scene": "wcpso-disc"}"#, "wcpso-discs"),
    ] {
        let (code, rows, stderr) = graded(&folder, links, task);
        assert_eq!((code, rows.len()), (Some(2), 0), "{stderr}");
        assert!(stderr.contains(said), "{stderr}");
    }
    let missing = forage(&["grade", "nowhere.txt", "--task", "nowhere.json"]);
    assert_eq!(missing.status.code(), Some(2));
}

/// Whatever the number of threads, the rows are those of one.
#[test]
fn many_links_are_graded_in_their_order() {
    let folder = empty_folder("grade-many");
    let links: Vec<_> = (1..=40).map(|seed| link(["pso", "wpso"][seed as usize % 2], "wcpso-discs", seed, 40)).collect();
    let [list, goal] = ["links.txt", "task.json"].map(|name| folder.join(name));
    fs::write(&list, links.join("\n")).unwrap();
    fs::write(&goal, r#"{"goal": {"gap": 0.15}}"#).unwrap();
    let with = |jobs: &str| forage(&["grade", list.to_str().unwrap(), "--task", goal.to_str().unwrap(), "--jobs", jobs]).stdout;
    let rows = with("1");
    assert_eq!(rows, with("4"));
    assert_eq!(words(&rows).lines().filter(|line| line.contains(",true,")).count(), 40, "all hashes come out again");
}
