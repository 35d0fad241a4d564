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
        ("scenes = [".into(), "sweep.toml: TOML parse error at line 1"),
        (top("iteration = 5"), "unknown field `iteration`"),
        (top("iterations = 0"), "iterations: 0 is not allowed; it must be a whole number from 1"),
        (top("iterations = [5, 6]"), "iterations: a list of 2 is not allowed; it must be one number for all planners"),
        (top("within = -1"), "within: -1 is not allowed; it must be a number from 0"),
        (top("within = 'near'"), "within: \"near\" is not allowed"),
        (top("name = 3"), "name: 3 is not allowed; it must be a text in one line"),
        (top("out = 'rows.xls'"), "out: "),
        (top("out = ''"), "out: \"\" is not allowed"),
        ("seeds = [1]\n[[planner]]\nname = 'pso'".into(), "scenes: nothing is not allowed"),
        (scenes("[]"), "scenes: a list of 0 is not allowed"),
        (scenes("'sphere'"), "scenes: \"sphere\" is not allowed; it must be a list"),
        (scenes("['sphere', 7]"), "scenes[1]: 7 is not allowed"),
        (scenes("['nowhere']"), "nowhere is not allowed; it must be a file, a link, or one of"),
        (scenes("['sphere', 'sphere']"), "scenes[1]: `sphere` is not allowed; it must be a scene of another name than scenes[0]"),
        (scenes("['sweep.toml']"), "scenes[0]: not JSON"),
        ("scenes = ['sphere']\n[[planner]]\nname = 'pso'".into(), "seeds: nothing is not allowed; it must be { from = 1, count = 50 }"),
        (seeds("7"), "seeds: 7 is not allowed"),
        (seeds("[]"), "seeds: a list of 0"),
        (seeds("[1, -2]"), "seeds[1]: -2 is not allowed"),
        (seeds("[1, 2, 1]"), "seeds[2]: 1 is not allowed; it must be another seed than seeds[0]"),
        (seeds("{ from = 1 }"), "seeds.count: nothing is not allowed"),
        (seeds("{ from = 1, count = 0 }"), "seeds.count: 0 is not allowed; it must be a whole number from 1"),
        (seeds("{ from = 1, count = 'ten' }"), "seeds.count: \"ten\" is not allowed"),
        (seeds("{ from = 1, to = 9 }"), "seeds: there is no `to`; known: from, count"),
        (seeds("{ from = 9007199254740991, count = 2 }"), "seeds.count: 2 is not allowed"),
        (seeds("{ from = 1, count = 100000001 }"), "seeds.count: 100000001 is not allowed"),
        ("scenes = ['sphere']\nseeds = [1]".into(), "planner: nothing is not allowed; it must be one [[planner]]"),
        (top("[[planner]]\nparams = { w = 0.5 }"), "planner[0].name: nothing is not allowed"),
        (top("[[planner]]\nname = 'waldo'"), "planner[0].name: there is no `waldo`; known: wcpso, pso"),
        (top("[[planner]]\nname = 'wpso'\nseed = 1"), "unknown field `seed`"),
        (
            top("[[planner]]\nname = 'pso'"),
            "planner[1].name: pso is not allowed; it must be a planner with other parameters than planner[0]",
        ),
        (
            top("[[planner]]\nname = 'a-star'"),
            "planner[0].name: a-star is not allowed; it must be a planner for scenes[0], sphere, which is of kind function; a-star runs on: \
             grid; leave one of them out",
        ),
        (
            with(&format!("w = {0}, c1 = {0}", many(1001))),
            "planner: a sweep of 1002001 is not allowed; it must be at most 1000000 combinations",
        ),
        (with("w = 9"), "planner[0].params.w: 9 is not allowed; it must be a number from 0 to 1.5"),
        (with("w = [0.5, 9]"), "planner[0].params.w[1]: 9 is not allowed"),
        (with("w = [0.5, inf]"), "planner[0].params.w[1]: inf is not allowed"),
        (with("w = []"), "planner[0].params.w: a list of 0 is not allowed"),
        (with("w = [0.5, [0.6]]"), "planner[0].params.w[1]: a list of 1 is not allowed"),
        (with("w = [0.5, 0.6, 0.50]"), "planner[0].params.w[2]: 0.5 is not allowed; it must be another value than planner[0].params.w[0]"),
        (with("w = 'heavy'"), "planner[0].params.w: \"heavy\" is not allowed"),
        (with("v = 0.5"), "planner[0].params: there is no `v`; known: "),
        (with("population = 2.5"), "planner[0].params.population: 2.5 is not allowed"),
        (with("waypoints = 3"), "planner[0].params: there is no `waypoints`; known: population, iterations"),
        (with("waypoints = 3"), "(pso on sphere)"),
        (
            "scenes = ['sphere', 'arm-free']\nseeds = [1]\n[[planner]]\nname = 'rrt'".into(),
            "rrt is not allowed; it must be a planner for scenes[0], sphere",
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
        (&["--shard", "0/3"] as &[&str], "--shard: 0/3 is not allowed; it must be I/N"),
        (&["--shard", "4/3"], "--shard: 4/3"),
        (&["--shard", "half"], "--shard: half"),
        (&["--shard", "1/19"], "at most 18 parts"),
        (&["--out", "rows.txt"], "out: rows.txt is not allowed; it must be a file that ends in .csv"),
        (&["--merge", "nowhere.csv"], "nowhere.csv"),
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
    assert!(message.contains("planner[1].params.tune: "), "{message}");
}
