//! Chinese: everything that is printed for people, and nothing that is written into files or read by programs.

use std::{fs, path::Path, process::Output};

use crate::support::{command, empty_folder, forage, text};

const COMMANDS: [&str; 20] = [
    "list",
    "run",
    "suggest",
    "exact",
    "convert",
    "generate",
    "grade",
    "reproduce",
    "study",
    "experiment",
    "bench",
    "bench barn",
    "bench bbob",
    "bench centre-bias",
    "bench movingai",
    "bench trees",
    "bench tsplib",
    "completions",
    "man",
    "licenses",
];

/// A call under a locale, in a folder.
fn under(locale: &str, folder: &Path, args: &[&str]) -> Output {
    command(args).current_dir(folder).envs([("LC_ALL", ""), ("LC_MESSAGES", ""), ("LANG", locale)]).output().unwrap()
}

/// What a call prints in Chinese at so many columns: standard output, and standard error behind it.
fn chinese(folder: &Path, columns: &str, args: &[&str]) -> String {
    let output = command(&[&["--lang", "zh-CN"], args].concat()).current_dir(folder).env("COLUMNS", columns).output().unwrap();
    text(&output.stdout) + &text(&output.stderr)
}

fn is_han(c: char) -> bool {
    matches!(c, '\u{4e00}'..='\u{9fff}')
}

/// Lines with an English sentence: three words of lower-case letters one after the other, outside code.
fn english(printed: &str) -> Vec<&str> {
    let is_word = |word: &str| word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_lowercase());
    let has_sentence = |line: &&str| {
        let plain = without_command(line).split('`').step_by(2).collect::<Vec<_>>().join(" | ");
        let words: Vec<&str> = plain.split([' ', '。', '，', '；', '：', '（', '）']).collect();
        words.windows(3).any(|three| three.iter().all(|word| is_word(word)))
    };
    printed.lines().filter(has_sentence).collect()
}

/// What is said next to a command, in examples, usage lines, headings and sources of scenes.
fn without_command(line: &str) -> String {
    let begin = ["forage ", "ompl_", "python3 "].iter().filter_map(|begin| line.find(begin)).min();
    let Some(begin) = begin else { return line.trim_start_matches("forage: ").to_owned() };
    let said = line[begin..].find(|c: char| !c.is_ascii()).map_or("", |at| &line[begin + at..]);
    format!("{} {said}", &line[..begin])
}

fn assert_chinese(args: &[&str], printed: &str) {
    assert_eq!(english(printed), [""; 0], "{args:?}: {printed}");
    assert!(printed.contains(is_han), "{args:?}: {printed}");
}

fn wide(line: &str) -> usize {
    let double = |c: char| matches!(c, '\u{2e80}'..='\u{9fff}' | '\u{ff00}'..='\u{ff60}');
    line.chars().map(|c| if double(c) { 2 } else { 1 }).sum()
}

#[test]
fn help_of_every_command_is_chinese_and_fits() {
    let folder = empty_folder("languages/help");
    let of = |name: &str, how: &[&str]| [&name.split(' ').collect::<Vec<_>>(), how].concat().join(" ");
    let calls = COMMANDS.iter().flat_map(|name| [of(name, &["-h"]), of(name, &["--help"]), format!("help {name}")]);
    for call in calls.chain(["-h", "--help", "help"].map(str::to_owned)) {
        let args: Vec<&str> = call.split(' ').collect();
        for columns in ["80", "100"] {
            let help = chinese(&folder, columns, &args);
            assert_chinese(&args, &help);
            let most = columns.parse().unwrap();
            assert!(help.lines().all(|line| wide(line) <= most), "{args:?}, {columns}: {help}");
            assert!(help.contains("用法：forage") && help.contains("选项：\n") && !help.contains('\u{1b}'), "{args:?}: {help}");
            assert!(!help.contains("[default") && !help.contains("[possible"), "{args:?}: {help}");
        }
    }
    assert_chinese(&["help", "help"], &chinese(&folder, "100", &["help", "help"]));
    let [short, long] = ["-h", "--help"].map(|how| chinese(&folder, "100", &["run", how]));
    assert!(long.contains("退出码 0") && !short.contains("退出码 0："), "{short}\n{long}");
    assert_eq!(chinese(&folder, "100", &["help", "run"]), long);
    assert_eq!(chinese(&folder, "100", &["help", "bench", "trees"]), chinese(&folder, "100", &["bench", "trees", "--help"]));
    let bare = under("zh_CN.UTF-8", &folder, &[]);
    assert_eq!((bare.status.code(), bare.stdout.len()), (Some(2), 0));
    assert!(text(&bare.stderr).contains("快速入门："));
}

#[test]
fn the_overview_and_every_page_are_chinese_and_fit() {
    let folder = empty_folder("languages/list");
    let catalogue: serde_json::Value = serde_json::from_slice(&forage(&["list", "--json"]).stdout).unwrap();
    let lists = ["planners", "generators", "scenes"].iter().flat_map(|list| catalogue[list].as_array().unwrap());
    let names: Vec<&str> = lists.map(|entry| entry["name"].as_str().unwrap()).chain(["drive", "motion"]).collect();
    for columns in ["80", "100"] {
        let overview = chinese(&folder, columns, &["list"]);
        assert_chinese(&["list"], &overview);
        assert!(overview.lines().all(|line| wide(line) <= columns.parse().unwrap()), "{overview}");
        assert!(names.iter().all(|name| overview.contains(&format!("\n  {name} "))), "{overview}");
    }
    for name in names {
        let page = chinese(&folder, "80", &["list", name]);
        assert_chinese(&["list", name], &page);
        assert!(page.starts_with(&format!("{name}：")) && page.lines().all(|line| wide(line) <= 80), "{page}");
    }
}

#[test]
fn results_notes_and_errors_are_chinese() {
    let folder = empty_folder("languages/results");
    fs::write(folder.join("bad.toml"), "scenes = ['sphere']\nsedes = [1]\n").unwrap();
    fs::write(folder.join("name.toml"), "scenes = ['sphere']\nseeds = [1]\n[[planner]]\nname = 'wcspo'\n").unwrap();
    fs::write(
        folder.join("good.toml"),
        "scenes = ['sphere-2', 'qpso-10m']\nseeds = [1, 2]\niterations = 3\n[[planner]]\nname = 'pso'\n[[planner]]\nname = 'wpso'\n",
    )
    .unwrap();
    for call in [
        "run wcpso --scene wcpso-discs --iterations 5",
        "run ltqpso --scene qpso-10m --iterations 5 --drive d.csv",
        "run rrt-guided --scene arm-cuboid --motion m.csv",
        "run a-star-drive --scene crossing",
        "run bat --scene ant-bat-30 --iterations 3 --tour t.tour",
        "run pso --scene sphere --iterations 2",
        "run #v=1&planner=wcpso&scene=wcpso-discs&seed=7&at=3&hash=00ff",
        "suggest ltqpso --scene qpso-10m",
        "exact --scene wcpso-discs",
        "exact --scene ant-bat-30",
        "exact --scene arm-cuboid",
        "exact --scene sphere",
        "generate rooms --set stops=9 --seed 3 --out rooms.json",
        "generate random --set share=0.9 --set columns=20 --set rows=20 --out full.json",
        "convert qpso-10m q.map",
        "convert q.scen q.json",
        "convert sphere s.map",
        "convert sphere",
        "convert sphere a.xyz",
        "experiment good.toml",
        "experiment bad.toml",
        "experiment name.toml",
        "experiment none.toml",
        "experiment good.toml --shard 9/2",
        "experiment good.toml --jobs 0",
        "bench centre-bias --planners pso --dimension 2 --instances 2 --budget 20 --out bias",
        "bench bbob --functions 99",
        "run wcspo --scene sphere",
        "run waldo --scene sphere",
        "run pso --scene spere",
        "run pso --scene sphere --set populaton=9",
        "run pso --scene sphere --set waypoints=9",
        "run pso --scene sphere --set w=9",
        "run pso --scene sphere --set w=",
        "run pso --scene sphere --preset paper",
        "run pso --scene sphere --seed x",
        "run pso --scene sphere --svg no/x.svg",
        "run pso --scene sphere --drive x.csv",
        "run pso --scene sphere --svg a --trace a",
        "run bat --scene sphere",
        "run pso",
        "run",
        "exact",
        "rnu",
        "help rnu",
        "run --scen sphere",
        "completions bashh",
        "reproduce --runs 1",
        "reproduce wcpso-path",
        "study forensic",
        "list waldo",
    ] {
        let args: Vec<&str> = call.split(' ').collect();
        assert_chinese(&args, &chinese(&folder, "100", &args));
    }
    for (call, said) in [
        ("run pso --scene sphere --set w=9", "`w` 为 9；应为 0 至 1.5 的数值"),
        ("run wcspo --scene sphere", "没有规划器 `wcspo`；是否指 `wcpso`？`forage list` 列出所有规划器"),
        ("run pso --scene sphere --svg no/x.svg", "无法写入 `no/x.svg`：文件夹 `no` 不存在"),
        ("experiment bad.toml", "第 2 行第 1 列：没有字段 `sedes`；是否指 `seeds`？"),
    ] {
        let found = chinese(&folder, "100", &call.split(' ').collect::<Vec<_>>());
        assert!(found.contains(said), "{call}: {found}");
    }
}

#[test]
fn the_option_counts_before_the_environment_and_an_unknown_language_is_refused() {
    let folder = empty_folder("languages/choice");
    for args in [&["list"] as &[&str], &["run", "--help"], &["run", "waldo", "--scene", "sphere"]] {
        let option = under("C", &folder, &[&["--lang", "zh-CN"], args].concat());
        let locale = under("zh_CN.UTF-8", &folder, args);
        assert_eq!((text(&option.stdout), text(&option.stderr)), (text(&locale.stdout), text(&locale.stderr)));
        let english = under("C", &folder, args);
        for same in [
            under("de_DE.UTF-8", &folder, args),
            under("zh_CN.UTF-8", &folder, &[&["--lang", "en"], args].concat()),
            command(args).envs([("LC_ALL", "C"), ("LANG", "zh_CN.UTF-8")]).output().unwrap(),
        ] {
            assert_eq!((text(&same.stdout), text(&same.stderr)), (text(&english.stdout), text(&english.stderr)));
        }
        assert_ne!((locale.stdout, locale.stderr), (english.stdout, english.stderr));
    }
    let wrong = forage(&["--lang", "xx", "list"]);
    assert_eq!((wrong.status.code(), wrong.stdout.len()), (Some(2), 0));
    assert!(text(&wrong.stderr).contains("`--lang` is xx; it must be one of en, zh-CN"), "{}", text(&wrong.stderr));
}

/// Every file of a folder with its content, by name.
fn files(folder: &Path) -> Vec<(String, String)> {
    let mut all: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), text(&fs::read(&path).unwrap())))
        .collect();
    all.sort();
    all
}

#[test]
fn files_and_json_are_the_same_in_every_language() {
    let sweep = "scenes = ['sphere-2', 'qpso-10m']\nseeds = [1, 2]\niterations = 3\n[[planner]]\nname = 'pso'\n[[planner]]\nname = 'a'\n";
    let links = "Ann #v=1&planner=wcpso&scene=wcpso-discs&seed=7&at=12\nBob #v=1&planner=wcspo&scene=wcpso-discs\nhello\n";
    let found = ["C", "zh_CN.UTF-8"].map(|locale| {
        let folder = empty_folder(&format!("languages/files-{locale}"));
        fs::write(folder.join("sweep.toml"), sweep.replace("'a'", "'wpso'")).unwrap();
        fs::write(folder.join("task.json"), r#"{"goal": {"gap": 0.01}, "budget": {"evaluations": 5000}, "scene": "wcpso-discs"}"#).unwrap();
        fs::write(folder.join("links.txt"), links).unwrap();
        let mut printed = Vec::new();
        for call in [
            "run ltqpso --scene qpso-10m --iterations 5 --json --svg run.svg --trace run.csv --drive drive.csv",
            "run a-star-drive --scene crossing --json",
            "run rrt --scene arm-free --seed 3 --json --motion motion.csv",
            "exact --scene ant-bat-30 --json",
            "suggest ltqpso --scene qpso-10m --json",
            "list --json",
            "list wcpso --json",
            "list --messages",
            "generate random --set share=0.9 --set columns=20 --set rows=20",
            "grade links.txt --task task.json",
            "experiment --example",
            "experiment sweep.toml --jobs 1 --report report.md --curves curves.csv --json",
            "completions zsh",
        ] {
            let output = under(locale, &folder, &call.split(' ').collect::<Vec<_>>());
            let lines = text(&output.stdout);
            // What a run took is another number each time.
            printed.push((call, lines.lines().filter(|line| !line.contains("elapsed_ms")).collect::<Vec<_>>().join("\n")));
        }
        for call in [
            "convert qpso-10m q.map",
            "convert q.scen q.json",
            "bench centre-bias --planners pso --dimension 2 --instances 2 --budget 20 --out bias",
        ] {
            under(locale, &folder, &call.split(' ').collect::<Vec<_>>());
        }
        (printed, files(&folder), files(&folder.join("bias")))
    });
    let [english, chinese] = found;
    for (one, other) in english.0.iter().zip(&chinese.0) {
        assert_eq!(one, other);
        assert!(!one.1.is_empty() && !one.1.contains(is_han), "{one:?}");
    }
    for (one, other) in [(english.1, chinese.1), (english.2, chinese.2)] {
        assert!(one.len() > 3, "{one:?}");
        for (a, b) in one.iter().zip(&other) {
            assert_eq!(a, b);
        }
        assert_eq!(one.len(), other.len());
    }
}
