//! `forage convert` and `forage generate`.

use std::path::PathBuf;

use forage::{
    kernel::{ReferenceOptimum, TourEnds},
    scene::{GridScene, TourScene},
    standard,
};
use forage_formats::{NamedFile, import};

use crate::support::{forage, text as words};

/// A path in a folder of this test's own.
fn place(test: &str, name: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("formats").join(test);
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name).display().to_string()
}

#[test]
fn a_random_grid_goes_through_every_format_in_the_shell() {
    let at = |name: &str| place("through", name);
    let printed = forage(&["generate", "maze", "--set", "columns=9", "--set", "rows=7", "--seed", "5"]);
    assert_eq!((printed.status.code(), words(&printed.stderr)), (Some(0), String::new()));
    let scene = standard().read_scene(&words(&printed.stdout)).unwrap();
    assert_eq!(scene.name(), "maze-9x7-5");
    std::fs::write(at("m.json"), &printed.stdout).unwrap();
    for (from, to) in [("m.json", "m.scen"), ("m.scen", "n.yaml"), ("n.pgm", "o.map"), ("o.map", "o.yml"), ("o.yml", "p.json")] {
        let output = forage(&["convert", &at(from), &at(to)]);
        assert_eq!((output.status.code(), words(&output.stdout)), (Some(0), String::new()), "{}", words(&output.stderr));
    }
    let last = standard().read_scene(&std::fs::read_to_string(at("p.json")).unwrap()).unwrap();
    assert_eq!(last.get::<GridScene>().unwrap().lines(), scene.get::<GridScene>().unwrap().lines());
    // Every command takes a map, and its partner is found beside it.
    let exact = forage(&["exact", "--scene", &at("m.scen"), "--json"]);
    assert_eq!(exact.status.code(), Some(0), "{}", words(&exact.stderr));
    assert!(words(&exact.stderr).contains("Problem 0 of 1"));
    let length = serde_json::from_slice::<serde_json::Value>(&exact.stdout).unwrap()["cells"]["length"].as_f64();
    assert_eq!(length, scene.exact_by(ReferenceOptimum::Cells).map(|exact| exact.length));
    let run = forage(&["run", "wcpso", "--scene", &at("n.yaml"), "--iterations", "3", "--json"]);
    assert!(run.status.code() < Some(2) && words(&run.stderr).contains("start and no goal"), "{}", words(&run.stderr));
    // A shipped scene by its name; a note says what the format cannot hold.
    let robot = forage(&["convert", "qpso-10m", &at("q.map")]);
    assert!(robot.status.code() == Some(0) && words(&robot.stderr).contains("the robot"));
    let full = forage(&["generate", "random", "--set", "share=1", "--out", &at("full.map")]);
    assert!(full.status.code() == Some(0) && words(&full.stderr).contains("1131 of 1200"), "{}", words(&full.stderr));
}

#[test]
fn the_command_in_a_random_grid_s_source_makes_it_again() {
    for generator in standard().generators_of(forage::scene::GRID) {
        let first = forage(&["generate", generator.name, "--set", "columns=12", "--seed", "9"]);
        let scene = standard().read_scene(&words(&first.stdout)).unwrap();
        let source = scene.header().source.clone().unwrap();
        let args: Vec<_> = source.split_once(' ').expect("a command and its words").1.split(' ').collect();
        assert_eq!(words(&forage(&args).stdout), words(&first.stdout), "{source}");
    }
}

#[test]
fn moving_obstacles_are_asked_for_in_the_shell_and_made_again_by_their_source() {
    let at = |name: &str| place("moving", name);
    for generator in standard().generators_of(forage::scene::GRID) {
        let set = ["--set", "columns=12", "--set", "moving=5", "--set", "moving_speed=0.5", "--seed", "9"];
        let output = forage(&[&["generate", generator.name][..], &set, &["--out", &at("s.json")]].concat());
        let wrote = " cells, 5 moving obstacles) to `";
        assert!(output.status.code() == Some(0) && words(&output.stderr).contains(wrote), "{}", words(&output.stderr));
        let scene = standard().read_scene(&std::fs::read_to_string(at("s.json")).unwrap()).unwrap();
        let grid = scene.get::<GridScene>().unwrap();
        assert_eq!((grid.moving.len(), grid.robot.and_then(|robot| robot.speed)), (5, Some(1.0)));
        let source = scene.header().source.clone().unwrap();
        let args: Vec<_> = source.split_once(' ').expect("a command and its words").1.split(' ').collect();
        assert_eq!(standard().read_scene(&words(&forage(&args).stdout)).unwrap(), scene, "{source}");
        // A map cannot hold them, and a note says so.
        let output = forage(&["convert", &at("s.json"), &at("s.map")]);
        let said = words(&output.stderr);
        assert!(output.status.code() == Some(0) && said.contains("the moving discs") && said.contains("the robot"), "{said}");
    }
    let crowded = ["generate", "random", "--set", "columns=1", "--set", "rows=1", "--set", "moving=2", "--out", &at("none.json")];
    let output = forage(&crowded);
    let note = "There are 0 moving obstacles, not 2: there is no room for more clear of the start.";
    assert!(output.status.code() == Some(0) && words(&output.stderr).contains(note), "{}", words(&output.stderr));
}

#[test]
fn stops_go_through_every_format_of_stops_and_their_shortest_tour_with_them() {
    let at = |name: &str| place("tours", name);
    let run = |args: &[&str]| {
        let output = forage(args);
        assert_eq!(output.status.code(), Some(0), "{args:?}: {}", words(&output.stderr));
        words(&output.stderr)
    };
    let scene = |name: &str| standard().read_scene(&std::fs::read_to_string(at(name)).unwrap()).unwrap();
    run(&["generate", "stops", "--set", "stops=9", "--seed", "4", "--out", &at("a.json")]);
    run(&["convert", &at("a.json"), &at("b.tsp")]);
    let said = run(&["convert", &at("b.tsp"), &at("b.opt.tour"), &at("c.json")]);
    assert!(said.contains("The tour in b.opt.tour has the length"), "{said}");
    let shortest = |name: &str| scene(name).exact_tour(ReferenceOptimum::default(), TourEnds::Closed).map(|exact| exact.length);
    let stored = scene("c.json").header().exact.as_ref().map(|exact| exact["length"].as_f64());
    assert_eq!((stored, shortest("c.json")), (Some(shortest("a.json")), shortest("a.json")));
    // A tour alone finds its instance; its name is the one that was asked for, and the instance goes with it.
    run(&["convert", &at("b.opt.tour"), &at("d.json")]);
    run(&["convert", &at("d.json"), &at("e.tour")]);
    let tour = std::fs::read_to_string(at("e.tour")).unwrap();
    let lines = |text: &str| text.lines().map(str::to_owned).collect::<Vec<_>>().split_off(1);
    assert_eq!(lines(&tour), lines(&std::fs::read_to_string(at("b.opt.tour")).unwrap()));
    let said = run(&["convert", &at("d.json"), &at("f.csv")]);
    assert!(said.contains("how distances are measured") && said.contains("the shortest tour"), "{said}");
    let said = run(&["convert", &at("f.csv"), &at("g.TSP")]);
    assert!(said.contains("EUC_2D rounds"), "{said}");
    assert_eq!(
        scene("a.json").get::<TourScene>().unwrap().points,
        import(standard(), &[NamedFile::new("g.tsp", std::fs::read(at("g.TSP")).unwrap())], None)
            .unwrap()
            .scene
            .get::<TourScene>()
            .unwrap()
            .points
    );
    for name in ["b.tsp", "f.csv", "d.json"] {
        let output = forage(&["run", "wcpso", "--scene", &at(name)]);
        assert_eq!(output.status.code(), Some(2), "no planner of tours");
        assert!(words(&output.stderr).contains("tour"), "{}", words(&output.stderr));
    }
}

#[test]
fn one_of_many_problems_can_be_chosen() {
    let at = |name: &str| place("problems", name);
    std::fs::write(at("a.map"), "type octile\nheight 1\nwidth 4\nmap\n....\n").unwrap();
    std::fs::write(at("a.scen"), "version 1\n0\tmaps/a.map\t4\t1\t0\t0\t1\t0\t1\n0\tmaps/a.map\t4\t1\t0\t0\t3\t0\t3\n").unwrap();
    for (problem, goal) in [(Some("0"), [1.5, 0.5]), (Some("1"), [3.5, 0.5]), (None, [3.5, 0.5])] {
        let mut args = vec!["convert".to_owned(), at("a.scen"), at("a.json")];
        args.extend(problem.map(|problem| format!("--problem={problem}")));
        let output = forage(&args.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(0), "{}", words(&output.stderr));
        let scene = standard().read_scene(&std::fs::read_to_string(at("a.json")).unwrap()).unwrap();
        assert_eq!(scene.ends().unwrap().1, goal);
    }
}

#[test]
fn what_is_refused_exits_with_2_and_writes_nothing() {
    let at = |name: &str| place("refused", name);
    std::fs::write(at("bad.map"), "type octile\nheight 1\nwidth 3\nmap\n.x.\n").unwrap();
    std::fs::write(at("good.map"), "type octile\nheight 1\nwidth 3\nmap\n...\n").unwrap();
    std::fs::write(at("alone.scen"), "version 1\n0\tgone.map\t3\t1\t0\t0\t2\t0\t2\n").unwrap();
    std::fs::write(at("alone.yaml"), "image: gone.pgm\nresolution: 1\n").unwrap();
    let scene = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "a", "title": "A", "cell": 1, "rows": [".#."],"#;
    std::fs::write(at("split.json"), format!(r#"{scene} "start": [0.5, 0.5], "goal": [2.5, 0.5]}}"#)).unwrap();
    std::fs::write(at("bad.tsp"), "NAME : bad\nTYPE : TSP\nDIMENSION : 2\nEDGE_WEIGHT_TYPE : MAN_2D\n").unwrap();
    std::fs::write(at("alone.tour"), "TYPE : TOUR\nTOUR_SECTION\n1 2 -1\n").unwrap();
    std::fs::write(at("many.csv"), "1,2\n3,4\n".repeat(9)).unwrap();
    let [tsp, tour, many] = ["bad.tsp", "alone.tour", "many.csv"].map(at);
    let [bad, good, alone, yaml, split] = ["bad.map", "good.map", "alone.scen", "alone.yaml", "split.json"].map(at);
    let [out, scen] = ["out.json", "out.scen"].map(at);
    for (args, part) in [
        (&["convert", &bad, &out] as &[&str], "bad.map: line 5: found `x`, expected one of . G S @ O T W in column 2"),
        (&["convert", &alone, &out], "alone.scen: the file `gone.map` that belongs to it is missing"),
        (&["convert", &yaml, &out], "alone.yaml: the file `gone.pgm` that belongs to it is missing"),
        (&["convert", &alone, &good, "--problem", "3", &out], "`--problem` is 3; it must be 0: alone.scen has 1 problem, counted from 0"),
        (&["convert", &good, "--problem", "0", &out], "`--problem` is 0"),
        (&["convert", &good, &at("out.png")], "out.png; it must be a file that ends in"),
        (&["convert", &good, "OUT"], "`OUT` is OUT; it must be a file that ends in .json, .map"),
        (&["convert", &good], "`OUT` is missing"),
        (&["convert", &split, &scen], "no way from start to goal"),
        (&["convert", &alone, &good], "gone.map"),
        (&["convert", &good, &at("good.scen")], "good.map; it must be another file than "),
        (&["convert", &split, &split], "split.json; it must be another file"),
        (&["convert", "sphere", &at("out.map")], "`kind` is function"),
        (&["convert", &at("nowhere.map"), &out], "nowhere.map"),
        (&["convert", &good, &at("no/such/folder/a.json")], "a.json"),
        (&["convert", &tsp, &out], "bad.tsp: line 4: found `MAN_2D`, expected for EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D, ATT, GEO or EXPLICIT"),
        (&["convert", &tour, &out], "alone.tour: the file `alone.tsp` that belongs to it is missing"),
        (&["convert", &many, &at("many.tour")], "OUT: the shortest closed tour of this scene is not known"),
        (&["convert", &good, &at("out.tsp")], "`kind` is grid; it must be tour"),
        (&["convert", &many, &at("out.map")], "`kind` is tour; it must be grid"),
        (&["run", "wcpso", "--scene", &tsp], "bad.tsp: line 4"),
        (
            &["run", "wcpso", "--scene", "wcpso-discs", "--tour", &at("out.tour")],
            "--tour needs a planner of tours; `wcpso` looks for a path",
        ),
        (&["run", "wcpso", "--scene", &bad], "bad.map: line 5"),
        (&["exact", "--scene", &alone], "gone.map"),
        (&["suggest", "ltqpso", "--scene", &yaml], "gone.pgm"),
        (&["generate", "sand"], "`sand` is not a generator; it must be one of random, rubble, rooms, maze, stops"),
        (&["generate", "maze", "--set", "columns=0"], "`columns` is 0; it must be a whole number from 1 to 2048"),
        (&["generate", "maze", "--set", "share=0.5"], "`share` is not a parameter of maze"),
        (&["generate", "maze", "--set", "moving=101"], "`moving` is 101; it must be a whole number from 0 to 100"),
        (&["generate", "stops", "--set", "moving=1"], "`moving` is not a parameter of stops"),
        (&["generate", "maze", "--seed", "-1"], "`seed` is -1"),
        (&["generate", "maze", "--out", "a.txt"], "`--out` is a.txt; it must be a file that ends in .json"),
    ] {
        let output = forage(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(output.stdout.is_empty(), "{args:?}");
        let message = words(&output.stderr);
        assert!(message.contains(part), "{args:?}: {message}");
    }
    for never in [out, scen] {
        assert!(!PathBuf::from(&never).exists(), "{never}");
    }
}

#[test]
fn help_and_list_follow_from_the_table_of_generators() {
    let [help, list] = [&["generate", "--help"] as &[&str], &["list"]].map(|args| words(&forage(args).stdout));
    for generator in standard().generators() {
        assert!(help.contains(generator.title) && list.contains(generator.title), "{}", generator.name);
        let page = words(&forage(&["list", generator.name]).stdout);
        assert!(generator.parameters.iter().copied().flatten().all(|p| page.contains(p.name)), "{page}");
    }
    let list: serde_json::Value = serde_json::from_slice(&forage(&["list", "--json"]).stdout).unwrap();
    let names: Vec<_> = list["generators"].as_array().unwrap().iter().map(|g| g["name"].as_str().unwrap()).collect();
    assert_eq!(names, standard().generators().iter().map(|g| g.name).collect::<Vec<_>>());
    assert_eq!(list["generators"][0]["parameters"][3]["default"], 0.3);
}
