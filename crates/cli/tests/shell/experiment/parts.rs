//! Parts, and runs as numbers.

use std::fs;

use forage::shipped;
use forage_study::sweep::{Part, read};

use super::support::{SMALL, carry_out, folder, refused};

#[test]
fn merged_parts_are_the_single_run_byte_for_byte() {
    let folder = folder("parts", SMALL);
    carry_out(&folder, &[]);
    let whole = fs::read(folder.join("sweep.csv")).unwrap();
    let merged = folder.join("merged.csv");
    let part = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    let parts = [3, 1, 4, 2].map(|i| {
        let printed = carry_out(&folder, &["--shard", &format!("{i}/4")]);
        assert!(printed.contains(&format!("part {i}/4")) && printed.contains("of 18 runs"), "{printed}");
        part(&format!("sweep.{i}-of-4.csv"))
    });
    let heads = parts.iter().map(|path| fs::read_to_string(path).unwrap().lines().count() - 1);
    assert_eq!(heads.collect::<Vec<_>>(), [4, 5, 4, 5]);

    let merge = |parts: &[&str]| {
        [&["--out", merged.to_str().unwrap(), "--merge"], parts].concat().iter().map(|s| (*s).to_owned()).collect::<Vec<_>>()
    };
    let few = merge(&[&parts[0], &parts[2], &parts[1]]);
    let message = refused(&folder, &few.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(message.contains("13 of 18 runs") && message.contains("5 are missing, the first is that of pso on sphere"), "{message}");
    assert!(message.contains("seed 2") && !merged.exists(), "{message}");

    // A part that was cut off in the middle of a row.
    let last = fs::read_to_string(&parts[3]).unwrap();
    fs::write(&parts[3], &last[..last.len() - 9]).unwrap();
    let all = merge(&parts.each_ref().map(String::as_str));
    let all: Vec<&str> = all.iter().map(String::as_str).collect();
    assert!(refused(&folder, &all).contains("the last one, is incomplete"));
    carry_out(&folder, &["--shard", "2/4"]);

    let printed = carry_out(&folder, &all);
    assert_eq!(fs::read(&merged).unwrap(), whole);
    assert!(printed.contains("Friedman"), "the statistics are those of all: {printed}");
    // Once more, with what is there already, and a part named twice.
    carry_out(&folder, &[&all[..], &[&parts[1]]].concat());
    assert_eq!(fs::read(&merged).unwrap(), whole);

    // More than can be open at once.
    #[cfg(target_os = "linux")]
    {
        let limited = format!("ulimit -n 24; exec \"$0\" experiment \"$1\" --out \"$2\" --merge {}", "\"$1\".*.csv");
        let all = fs::read_to_string(&merged).unwrap();
        let (heading, rows) = all.split_once('\n').unwrap();
        for (i, line) in rows.lines().enumerate() {
            for copy in ["a", "b"] {
                fs::write(folder.join(format!("sweep.toml.{i}{copy}.csv")), format!("{heading}\n{line}\n")).unwrap();
            }
        }
        let file = folder.join("sweep.toml");
        let again = folder.join("again.csv");
        let ended = std::process::Command::new("sh")
            .args(["-c", &limited, env!("CARGO_BIN_EXE_forage"), file.to_str().unwrap(), again.to_str().unwrap()])
            .output()
            .unwrap();
        assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
        assert_eq!(fs::read(&again).unwrap(), whole);
    }

    let lines = part("merged.jsonl");
    assert!(refused(&folder, &["--out", &lines, "--merge", &parts[0]]).contains("with the ending of"));
    fs::write(&parts[0], "a,b\n1,2\n").unwrap();
    assert!(refused(&folder, &all).contains("belongs to another experiment"));
}

/// A million runs are numbers: each leads to its setup, and what its row says leads back.
#[test]
fn a_million_runs_are_found_without_a_list() {
    let text = "scenes = ['sphere', 'matyas', 'ackley', 'rastrigin']\nseeds = { from = 5, count = 10000 }\n[[planner]]\nname = 'pso'\n\
                params = { w = [0.1, 0.2, 0.3], c1 = [1, 1.5, 2, 2.5] }\n[[planner]]\nname = 'pso'\n\
                params = { w = [0.1, 0.2, 0.3, 0.4], c2 = [1, 1.5, 2] }\n[[planner]]\nname = 'cpso'\n";
    let sweep = read::read(forage::standard(), "sweep.toml", "sweep", text, &|name: &str| Ok(shipped(name)?)).unwrap().sweep;
    assert_eq!((sweep.len(), sweep.cells(), sweep.groups()), (1_000_000, 100, 25));
    assert_eq!(sweep.parameters, ["w", "c1", "c2"]);
    for job in (0..sweep.len()).step_by(101).chain([999_999]) {
        let setup = sweep.setup(job);
        let texts: Vec<String> =
            sweep.parameters.iter().map(|name| setup.params.get(name).map_or(String::new(), ToString::to_string)).collect();
        let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
        assert_eq!(sweep.find(setup.scene.name(), &setup.planner, &setup.seed.to_string(), &texts), Some(job));
    }
    let described: Vec<String> = [0, 9_999, 10_000, 120_000, 480_000, 999_999].map(|job| sweep.describe(job)).into();
    assert_eq!(
        described,
        [
            "pso on sphere, c1=1, w=0.1, seed 5",
            "pso on sphere, c1=1, w=0.1, seed 10004",
            "pso on sphere, c1=1.5, w=0.1, seed 5",
            "pso on matyas, c1=1, w=0.1, seed 5",
            "pso on sphere, c2=1, w=0.1, seed 5",
            "cpso on rastrigin, seed 10004",
        ]
    );
    // Parts are disjoint, as even as can be, and together all.
    let parts: Vec<Part> = (1..=7).map(|i| format!("{i}/7").parse().unwrap()).collect();
    assert_eq!(parts.iter().map(|part| part.len(sweep.len())).sum::<usize>(), sweep.len());
    assert!((0..100).all(|job| parts.iter().filter(|part| part.find(job).is_some()).count() == 1));
    assert!(parts.iter().all(|part| part.jobs(sweep.len()).count() == part.len(sweep.len())));
}

/// docs/sweeps.md says how much memory a sweep takes: rows that were all held would take more.
#[cfg(target_os = "linux")]
#[test]
fn memory_is_bounded_by_the_number_of_runs() {
    let (runs, kilobytes) = (60_000, 12_000 + 60_000 * 170 / 1024);
    let plan = "scenes = ['sphere']\nseeds = { from = 1, count = 60000 }\niterations = 1\n[[planner]]\nname = 'pso'\nparams = { population = 2 }\n";
    let folder = folder("memory", plan);
    let limited = format!("ulimit -d {kilobytes}; exec \"$0\" experiment \"$1\" --jobs 1");
    // Runs, and then what is there.
    for _ in 0..2 {
        let args = [env!("CARGO_BIN_EXE_forage"), folder.join("sweep.toml").to_str().unwrap()].map(str::to_owned);
        let ended = std::process::Command::new("sh").args(["-c", &limited]).args(args).output().unwrap();
        assert!(ended.status.success(), "{}", String::from_utf8_lossy(&ended.stderr));
        assert!(String::from_utf8_lossy(&ended.stdout).contains(&format!("{runs} runs")));
    }
}
