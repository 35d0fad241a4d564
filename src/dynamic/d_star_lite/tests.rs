//! D* Lite beside values found by hand, beside A*, and beside lengths found in a third way.

use super::{super::a_star::AStar, *};
use crate::{
    kernel::{Digest, rng::Stream},
    scene::{GridScene, Robot},
};

/// An open field, or walls by chance.
fn field(columns: usize, rows: usize, walls: f64, rng: &mut Stream) -> Arc<Cells> {
    let blocked = (0..columns * rows).map(|_| rng.unit() < walls).collect();
    Arc::clone(GridScene::new(1.0, columns, blocked).cells())
}

/// The length of a shortest way by Bellman and Ford's method: all steps, again and again, until nothing gets shorter.
fn exact(cells: &Cells, occupied: &[bool], from: usize, to: usize) -> Option<Steps> {
    let mut best: Vec<Option<Steps>> = vec![None; cells.len()];
    best[from] = Some(Steps::default());
    let mut changed = true;
    while changed {
        changed = false;
        for cell in 0..cells.len() {
            let Some(so_far) = best[cell] else { continue };
            for d in (0..8).filter(|d| cells.moves(cell) >> d & 1 != 0) {
                let (next, way) = (cells.next(cell, d), so_far.and(d));
                if !occupied[next] && best[next].is_none_or(|best| way.length() < best.length()) {
                    best[next] = Some(way);
                    changed = true;
                }
            }
        }
    }
    best[to]
}

/// A way's length, after its steps were looked at one by one.
fn checked(cells: &Cells, occupied: &[bool], from: usize, to: usize, way: &[usize]) -> Steps {
    assert_eq!((way.first(), way.last()), (Some(&from), Some(&to)));
    way.windows(2).fold(Steps::default(), |steps, pair| {
        let d = (0..8).find(|&d| cells.moves(pair[0]) >> d & 1 != 0 && cells.next(pair[0], d) == pair[1]);
        assert!(!occupied[pair[1]], "{way:?} enters {}", pair[1]);
        steps.and(d.expect("a step that the cells allow"))
    })
}

/// What every cell is, by its definition, after a search: rhs is one step's look-ahead, and the inconsistent cells are in
/// the queue, under keys that are lower bounds.
fn check_invariants(search: &DStarLite) {
    for cell in (0..search.cells.len()).filter(|&cell| cell != search.goal) {
        assert_eq!(search.rhs[cell], search.look_ahead(cell));
    }
    let mut open = search.open.clone();
    let mut inside = vec![false; search.cells.len()];
    while let Some((key, cell)) = open.first() {
        open.remove(cell);
        inside[cell] = true;
        assert!(key <= search.key(cell));
    }
    assert!((0..search.cells.len()).all(|cell| inside[cell] == (search.g[cell] != search.rhs[cell])));
}

/// Three by three cells, the robot at 3, the goal at 5:
///
/// ```text
/// 0 1 2
/// R 4 G
/// 6 7 8
/// ```
#[test]
fn a_small_field_by_hand() {
    let steps = |straight, diagonal| Steps { straight, diagonal };
    let cells = field(3, 3, 0.0, &mut Stream::new(1, 0));
    let mut search = DStarLite::new(&cells, 3, 5);
    let mut occupied = [false; 9];

    // U = {5: (2, 0)}. 5 is settled: rhs of 2, 4, 8 becomes 1, of 1 and 7 √2. Least key: 4, (1 + 1, 1), which gives 3
    // rhs 2 and 0 and 6 rhs 1 + √2. Now the robot's key is (2, 2) and 1 and 7 have (2√2, √2): the end.
    assert_eq!(search.way(3), Some(vec![3, 4, 5]));
    assert_eq!(search.expanded(), 2);
    assert_eq!([5, 4, 3, 1].map(|cell| search.g[cell]), [steps(0, 0), steps(1, 0), NEVER, NEVER]);
    let diagonal = [steps(1, 1), steps(0, 1), steps(1, 0)];
    assert_eq!(search.rhs, [diagonal, [steps(2, 0), steps(1, 0), steps(0, 0)], diagonal].concat());

    // 4 becomes occupied. 0, 3 and 6 saw their ways through it and see none now; 1, 2, 7 and 8 see others.
    occupied[4] = true;
    search.occupy(&occupied);
    assert_eq!([0, 3, 6].map(|cell| search.rhs[cell]), [NEVER; 3]);
    assert_eq!([1, 2, 7, 8].map(|cell| search.rhs[cell]), [steps(0, 1), steps(1, 0), steps(0, 1), steps(1, 0)]);
    // 1 and 7 are settled in turn, both (2√2, √2): 3 gets rhs 2√2, and (2√2, 2√2) is the least key.
    assert_eq!(search.way(3), Some(vec![3, 7, 5]), "of the two, the direction with the smaller number");
    assert_eq!(search.expanded(), 4);
    assert_eq!([1, 7, 2, 8].map(|cell| search.g[cell]), [steps(0, 1), steps(0, 1), NEVER, NEVER]);
    assert_eq!([3, 0, 6].map(|cell| search.rhs[cell]), [steps(0, 2), steps(1, 1), steps(1, 1)]);

    // 4 becomes free: its g of 1 was never forgotten, so 3 sees 2 at once.
    occupied[4] = false;
    search.occupy(&occupied);
    assert_eq!(search.way(3), Some(vec![3, 4, 5]));
    assert_eq!(search.expanded(), 4, "nothing had to be settled");

    // The robot is at 4 and 4 is occupied under it: it leaves. k_m has grown by its step.
    occupied[4] = true;
    search.occupy(&occupied);
    assert_eq!(search.way(4), Some(vec![4, 5]));
    assert_eq!((search.k_m, search.expanded()), (steps(1, 0), 4));
    check_invariants(&search);
}

/// A way that grows: the cells behind what became occupied are underconsistent, and lose their g before they get a new one.
#[test]
fn what_was_known_through_an_occupied_cell_is_taken_back() {
    // ```text
    // R 1 2 3 G
    // # # # . #
    // # # # . #      the only way to the goal is along the top
    // ```
    let rows = [".....", "###.#", "###.#"].concat();
    let cells = Arc::clone(GridScene::new(1.0, 5, rows.chars().map(|c| c == '#').collect()).cells());
    let mut search = DStarLite::new(&cells, 0, 4);
    assert_eq!(search.way(0), Some(vec![0, 1, 2, 3, 4]));
    assert_eq!(search.expanded(), 4, "4, 3, 2, 1");
    let mut occupied = vec![false; 15];
    occupied[3] = true;
    search.occupy(&occupied);
    // 2 saw its way of length 2 through 3; now it sees one back through 1, which is 3 from the goal as far as it knows, but
    // knows that through 2. Each is raised before it can deceive the other.
    assert_eq!((search.g[2], search.rhs[2]), (Steps { straight: 2, diagonal: 0 }, Steps { straight: 4, diagonal: 0 }));
    assert_eq!(search.way(0), None);
    assert_eq!([0, 1, 2].map(|cell| search.g[cell]), [NEVER; 3]);
    check_invariants(&search);
    occupied[3] = false;
    search.occupy(&occupied);
    assert_eq!(search.way(0), Some(vec![0, 1, 2, 3, 4]));
    assert_eq!(search.way(13), Some(vec![13, 8, 3, 4]), "from anywhere");
}

/// One drive by chance: cells become occupied and free, the robot goes on along its way or is put elsewhere. After each
/// change, D* Lite, A* and Bellman and Ford agree.
fn drive(cells: &Arc<Cells>, rng: &mut Stream, ticks: usize) -> (usize, usize) {
    let n = cells.len();
    let (mut robot, goal, mut occupied) = (rng.below(n), rng.below(n), vec![false; n]);
    let (mut d_star, mut a_star) = (DStarLite::new(cells, robot, goal), AStar::new(cells));
    let (mut found, mut none) = (0, 0);
    let changes = [1, 4, n / 4][rng.below(3)].max(1);
    for _ in 0..ticks {
        for _ in 0..rng.below(changes + 1) {
            let cell = rng.below(n);
            // Both the goal's cell and the robot's are among them.
            occupied[cell] = rng.unit() < 0.4;
        }
        d_star.occupy(&occupied);
        let way = d_star.way(robot);
        let other = a_star.way(&occupied, robot, goal);
        let length = exact(cells, &occupied, robot, goal);
        assert_eq!(way.as_ref().map(|way| checked(cells, &occupied, robot, goal, way)), length);
        assert_eq!(other.as_ref().map(|way| checked(cells, &occupied, robot, goal, way)), length);
        check_invariants(&d_star);
        *(if way.is_some() { &mut found } else { &mut none }) += 1;
        robot = match (rng.below(12), way) {
            (0, _) => rng.below(n),
            (1..3, _) | (_, None) => robot,
            (by, Some(way)) => way[(by / 4).min(way.len() - 1)],
        };
    }
    (found, none)
}

#[test]
fn it_is_as_short_as_a_search_from_scratch_whatever_changes() {
    let (mut found, mut none) = (0, 0);
    for seed in 0..240 {
        let mut rng = Stream::new(seed, 0);
        let (columns, rows) = (1 + rng.below(14), 1 + rng.below(14));
        let walls = [0.0, 0.1, 0.3][rng.below(3)];
        let cells = field(columns, rows, walls, &mut rng);
        let (with, without) = drive(&cells, &mut rng, 40);
        (found, none) = (found + with, none + without);
    }
    assert!(found > 2000 && none > 2000, "{found} and {none}: both happen often");
}

/// Corners that may be cut, and a robot so wide that some steps along walls are not allowed.
#[test]
fn other_rules_for_steps_are_kept_too() {
    let wide = Robot { length: Some(0.7), width: Some(0.7), ..Robot::default() };
    for seed in 0..30 {
        let mut rng = Stream::new(seed, 1);
        let blocked = (0..90).map(|_| rng.unit() < 0.2).collect();
        let grid = GridScene { corner_cutting: true, robot: [None, Some(wide)][seed as usize % 2], ..GridScene::new(1.0, 10, blocked) };
        drive(&Arc::clone(grid.cells()), &mut rng, 40);
    }
}

/// So a way with few turns can be chosen from all of them.
#[test]
fn every_cell_on_any_shortest_way_is_known_exactly() {
    let mut seen = 0;
    for seed in 0..30 {
        let mut rng = Stream::new(seed, 4);
        let cells = field(9, 7, 0.1, &mut rng);
        let (goal, mut occupied) = (rng.below(63), vec![false; 63]);
        let mut search = DStarLite::new(&cells, rng.below(63), goal);
        for _ in 0..12 {
            (0..4).for_each(|_| occupied[rng.below(63)] = rng.unit() < 0.3);
            let robot = rng.below(63);
            search.occupy(&occupied);
            let Some(length) = search.way(robot).map(|way| cells.steps(&way)) else { continue };
            for cell in (0..63).filter(|&cell| cell != robot) {
                let [to, on] = [(robot, cell), (cell, goal)].map(|(a, b)| exact(&cells, &occupied, a, b));
                if let (Some(to), Some(on)) = (to, on)
                    && sum(to, on) == length
                {
                    assert_eq!((search.g[cell], search.rhs[cell]), (on, on));
                    seen += 1;
                }
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}

#[test]
fn the_same_calls_give_the_same_ways_and_the_same_state() {
    let run = |copied: bool| {
        let mut rng = Stream::new(77, 0);
        let cells = field(30, 20, 0.15, &mut rng);
        let (mut search, mut a_star) = (DStarLite::new(&cells, 0, 599), AStar::new(&cells));
        let mut ways = Vec::new();
        for _ in 0..60 {
            let occupied: Vec<_> = (0..600).map(|_| rng.unit() < 0.1).collect();
            if copied {
                (search, a_star) = (search.clone(), a_star.clone());
            }
            search.occupy(&occupied);
            let from = rng.below(600);
            ways.push((search.way(from), a_star.way(&occupied, from, 599), search.expanded(), a_star.expanded()));
        }
        (ways, Digest::of(&search).hex())
    };
    assert_eq!(run(false), run(false));
    assert_eq!(run(false), run(true));
}

#[test]
fn the_way_goes_on_while_it_is_a_shortest_one() {
    for seed in 0..20 {
        let mut rng = Stream::new(seed, 2);
        let cells = field(40, 40, 0.2, &mut rng);
        let mut search = DStarLite::new(&cells, 0, 1599);
        let Some(way) = search.way(0) else { continue };
        let expanded = search.expanded();
        for at in 1..way.len() {
            search.occupy(&vec![false; 1600]);
            assert_eq!(search.way(way[at]).as_deref(), Some(&way[at..]));
        }
        assert_eq!(search.expanded(), expanded, "and costs nothing");
    }
}

/// A robot that sees a few cells ahead change, on a map of walls by chance.
#[test]
fn small_changes_on_a_drive_cost_it_less_than_searches_from_scratch() {
    let (mut repaired, mut anew) = (0, 0);
    for seed in 1..7 {
        let mut rng = Stream::new(seed, 3);
        let cells = field(100, 100, 0.2, &mut rng);
        let (goal, mut robot) = (9898, 101);
        let (mut d_star, mut a_star) = (DStarLite::new(&cells, robot, goal), AStar::new(&cells));
        let mut occupied = vec![false; cells.len()];
        let mut ticks = 0;
        while robot != goal && ticks < 400 {
            ticks += 1;
            d_star.occupy(&occupied);
            let (way, other) = (d_star.way(robot), a_star.way(&occupied, robot, goal));
            assert_eq!(way.as_ref().map(|way| cells.steps(way)), other.map(|way| cells.steps(&way)));
            robot = way.map_or(robot, |way| way[1]);
            for _ in 0..3 {
                let [x, y] = cells.place(robot).map(|c| (c + rng.below(11)).saturating_sub(5).min(99));
                occupied[y * 100 + x] = rng.unit() < 0.3 && y * 100 + x != goal;
            }
        }
        repaired += d_star.expanded();
        anew += a_star.expanded();
    }
    assert!(5 * repaired < anew, "{repaired} beside {anew}");
}

#[test]
fn an_occupied_goal_is_not_searched_for() {
    let mut rng = Stream::new(5, 0);
    let cells = field(50, 50, 0.0, &mut rng);
    let mut search = DStarLite::new(&cells, 0, 2499);
    let way = search.way(0).unwrap();
    let expanded = search.expanded();
    let mut occupied = vec![false; 2500];
    occupied[2499] = true;
    search.occupy(&occupied);
    assert_eq!(search.way(0), None);
    assert_eq!(search.way(2499), Some(vec![2499]), "unless it is there");
    occupied[2499] = false;
    search.occupy(&occupied);
    assert_eq!(search.way(0).map(|way| cells.steps(&way)), Some(cells.steps(&way)));
    assert_eq!(search.expanded(), expanded, "and nothing of what was known was lost meanwhile");
}

#[test]
fn start_and_goal_may_be_one_cell_and_the_start_may_be_occupied() {
    let cells = field(4, 1, 0.0, &mut Stream::new(6, 0));
    let mut search = DStarLite::new(&cells, 2, 2);
    assert_eq!(search.way(2), Some(vec![2]));
    search.occupy(&[true, false, true, false]);
    assert_eq!(search.way(2), Some(vec![2]));
    assert_eq!(search.way(0), None);
    search.occupy(&[true, false, false, false]);
    assert_eq!(search.way(0), Some(vec![0, 1, 2]));
}

/// A serpentine over the largest grid's width, and a robot that is put from end to end of a corridor until k_m has to
/// begin anew.
#[test]
fn long_corridors_and_long_drives_overflow_nothing() {
    let columns = crate::scene::MAX_SIDE;
    let wall = |row: usize, column: usize| row % 2 == 1 && column != if row % 4 == 1 { columns - 1 } else { 0 };
    let blocked = (0..9 * columns).map(|i| wall(i / columns, i % columns)).collect();
    let cells = Arc::clone(GridScene::new(1.0, columns, blocked).cells());
    let goal = 9 * columns - 1;
    let (mut d_star, mut a_star) = (DStarLite::new(&cells, 0, goal), AStar::new(&cells));
    let length = Some(Steps { straight: 5 * (columns as u32 - 1) + 8, diagonal: 0 });
    assert_eq!(d_star.way(0).map(|way| cells.steps(&way)), length);
    assert_eq!(a_star.way(&vec![false; cells.len()], 0, goal).map(|way| cells.steps(&way)), length);

    let cells = field(columns, 1, 0.0, &mut Stream::new(7, 0));
    let mut search = DStarLite::new(&cells, 0, columns - 1);
    let mut before = 0.0;
    let mut anew = 0;
    for drive in 0..2200 {
        let from = [0, columns - 1][drive % 2];
        assert_eq!(search.way(from).map(|way| way.len()), Some(columns - from));
        anew += usize::from(search.k_m.length() < before);
        before = search.k_m.length();
    }
    assert_eq!(anew, 1);
    check_invariants(&search);
}
