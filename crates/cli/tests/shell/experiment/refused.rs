//! What is refused is named by its field, its value and what is allowed.

use std::fs;

use super::support::{SMALL, folder, forage, refused, text};

/// What is wrong, in which sweep, and what is said.
#[test]
fn what_is_refused_is_named_before_anything_is_run() {
    let planner = "[[planner]]\nname = 'pso'\n";
    let with = |params: &str| format!("scenes = ['sphere']\nseeds = [1]\n{planner}params = {{ {params} }}\n");
    let many = |count: usize| format!("[{}]", (0..count).map(|k| (k as f64 / 1000.0).to_string()).collect::<Vec<_>>().join(", "));
    let seeds = |seeds: &str| format!("scenes = ['sphere']\nseeds = {seeds}\n{planner}");
    let scenes = |scenes: &str| format!("scenes = {scenes}\nseeds = [1]\n{planner}");
    let top = |line: &str| format!("scenes = ['sphere']\nseeds = [1]\n{line}\n{planner}");
    let cases: Vec<(String, &str)> = vec![
        ("scenes = [".into(), "sweep.toml: line 1, column 11: unclosed array"),
        (top("iteration = 5"), "line 3, column 1: `iteration` is not a known field; did you mean `iterations`?"),
        (top("scene = ['sphere']"), "`scene` is not a known field; did you mean `scenes`?"),
        (top("[[planner]]\nparms = {}"), "`parms` is not a known field; did you mean `params`?"),
        (top("iterations = 0"), "`iterations` is 0; it must be a whole number from 1"),
        (top("iterations = [5, 6]"), "`iterations` is a list of 2; it must be one number for all planners"),
        (top("within = -1"), "`within` is -1; it must be a number from 0"),
        (top("within = 'near'"), "`within` is \"near\""),
        (top("name = 3"), "`name` is 3; it must be a text in one line"),
        (top("out = 'rows.xls'"), "`out` is "),
        (top("out = ''"), "`out` is \"\""),
        ("seeds = [1]\n[[planner]]\nname = 'pso'".into(), "`scenes` is missing"),
        (scenes("[]"), "`scenes` is a list of 0"),
        (scenes("'sphere'"), "`scenes` is \"sphere\"; it must be a list"),
        (scenes("['sphere', 7]"), "`scenes[1]` is 7"),
        (scenes("['nowhere']"), "scenes[0]: `nowhere`: no such file (and not a shipped scene; `forage list` shows those)"),
        (scenes("['sphere', 'sphere']"), "`scenes[1]` is `sphere`; it must be a scene of another name than scenes[0]"),
        (scenes("['sweep.toml']"), "sweep.toml`: not JSON"),
        ("scenes = ['sphere']\n[[planner]]\nname = 'pso'".into(), "`seeds` is missing; it must be { from = 1, count = 50 }"),
        (seeds("7"), "`seeds` is 7"),
        (seeds("[]"), "`seeds` is a list of 0"),
        (seeds("[1, -2]"), "`seeds[1]` is -2"),
        (seeds("[1, 2, 1]"), "`seeds[2]` is 1; it must be another seed than seeds[0]"),
        (seeds("{ from = 1 }"), "`seeds.count` is missing"),
        (seeds("{ from = 1, count = 0 }"), "`seeds.count` is 0; it must be a whole number from 1"),
        (seeds("{ from = 1, count = 'ten' }"), "`seeds.count` is \"ten\""),
        (seeds("{ from = 1, to = 9 }"), "`to` is not a field of `seeds`; it must be one of from, count"),
        (seeds("{ from = 9007199254740991, count = 2 }"), "`seeds.count` is 2"),
        (seeds("{ from = 1, count = 100000001 }"), "`seeds.count` is 100000001"),
        ("scenes = ['sphere']\nseeds = [1]".into(), "`planner` is missing; it must be one [[planner]]"),
        (top("[[planner]]\nparams = { w = 0.5 }"), "`planner[0].name` is missing"),
        (top("[[planner]]\nname = 'waldo'"), "planner[0].name: `waldo` is not a planner; it must be one of pso, wpso"),
        (top("[[planner]]\nname = 'wpso'\nseed = 1"), "unknown field `seed`"),
        (top("[[planner]]\nname = 'pso'"), "`planner[1].name` is pso; it must be a planner with other parameters than planner[0]"),
        (
            top("[[planner]]\nname = 'a-star'"),
            "`planner[0].name` is a-star; it must be a planner for scenes[0], sphere, which is of kind function; a-star runs on: \
             grid; leave one of them out",
        ),
        (with(&format!("w = {0}, c1 = {0}", many(1001))), "`planner` is a sweep of 1002001; it must be at most 1000000 combinations"),
        (with("w = 9"), "`planner[0].params.w` is 9; it must be a number from 0 to 1.5"),
        (with("w = [0.5, 9]"), "`planner[0].params.w[1]` is 9"),
        (with("w = [0.5, inf]"), "`planner[0].params.w[1]` is inf"),
        (with("w = []"), "`planner[0].params.w` is a list of 0"),
        (with("w = [0.5, [0.6]]"), "`planner[0].params.w[1]` is a list of 1"),
        (with("w = [0.5, 0.6, 0.50]"), "`planner[0].params.w[2]` is 0.5; it must be another value than planner[0].params.w[0]"),
        (with("w = 'heavy'"), "`planner[0].params.w` is \"heavy\""),
        (with("v = 0.5"), "planner[0].params: `v` is not a parameter; "),
        (with("population = 2.5"), "`planner[0].params.population` is 2.5"),
        (
            with("waypoints = 3"),
            "planner[0].params: `waypoints` is not a parameter (pso on sphere); it must be one of population, iterations",
        ),
        (with("waypoints = 3"), "(pso on sphere)"),
        (
            "scenes = ['sphere', 'arm-free']\nseeds = [1]\n[[planner]]\nname = 'rrt'".into(),
            "is rrt; it must be a planner for scenes[0], sphere",
        ),
    ];
    let folder = folder("refused", "");
    for (sweep, part) in cases {
        fs::write(folder.join("sweep.toml"), &sweep).unwrap();
        let message = refused(&folder, &[]);
        assert!(message.contains(part), "{sweep}\n{message}");
        assert!(!folder.join("sweep.csv").exists(), "{sweep}");
    }
    fs::write(folder.join("sweep.toml"), SMALL).unwrap();
    for (args, part) in [
        (&["--shard", "0/3"] as &[&str], "`--shard` is 0/3; it must be I/N"),
        (&["--shard", "4/3"], "`--shard` is 4/3"),
        (&["--shard", "half"], "`--shard` is half"),
        (&["--shard", "1/19"], "at most 18 parts"),
        (&["--out", "rows.txt"], "`--out` is rows.txt; it must be a file that ends in .csv"),
        (&["--merge", "nowhere.csv"], "nowhere.csv"),
        (&["--merge", "README.md"], "`--merge` is README.md; it must be a file that ends in .csv"),
        (&["--merge", "a.csv", "--shard", "1/2"], "cannot be used with"),
        (&["--jobs", "0"], "--jobs"),
    ] {
        let message = refused(&folder, args);
        assert!(message.contains(part), "{args:?}: {message}");
    }
    let nowhere = forage(&["experiment", "nowhere.toml"]);
    assert!(nowhere.status.code() == Some(2) && text(&nowhere.stderr).contains("nowhere.toml"));
}

/// A planner that starts only with what its check cannot see is refused before the first run, too.
#[test]
fn what_a_planner_refuses_at_its_start_is_named_before_anything_is_run() {
    let sweep = "scenes = ['wolf-ant-20']\nseeds = [1]\n[[planner]]\nname = 'a-star'\n[[planner]]\nname = 'pso-tuning'\n\
                 params = { colony = 'aco', tune = 'gamma' }\n";
    let folder = folder("start", sweep);
    let message = refused(&folder, &[]);
    assert!(message.contains("`planner[1].params.tune` is gamma; "), "{message}");
}

#[test]
fn a_plan_that_is_no_text_is_refused() {
    let folder = folder("bytes", "");
    fs::write(folder.join("sweep.toml"), b"scenes = ['sphere\xff']\n").unwrap();
    let message = refused(&folder, &[]);
    assert!(message.contains("sweep.toml") && message.contains("utf-8"), "{message}");
}
