//! The list of all studies.

use super::{
    antbat, antbat_time, antbat_tours, arm_rrt, claims, forensics, ltqpso, regression, robustness, study::Study, wcpso, wolf, wolf_dynamic,
};

/// Every published experiment that is repeated here, in the order in which they are carried out.
pub const REPRODUCTIONS: &[Study] = &[
    wcpso::FUNCTIONS,
    wcpso::FITTED,
    wcpso::PATHS,
    ltqpso::REPRODUCTION,
    regression::REPRODUCTION,
    antbat::REPRODUCTION,
    antbat_tours::REPRODUCTION,
    antbat_time::REPRODUCTION,
    wolf::REPRODUCTION,
    wolf_dynamic::REPRODUCTION,
    arm_rrt::REPRODUCTION,
    claims::STUDIES[0],
    claims::STUDIES[1],
    claims::STUDIES[2],
    claims::STUDIES[3],
    claims::STUDIES[4],
];

/// Studies of our own, on what no paper has.
pub const STUDIES: &[Study] = &[forensics::STUDY, robustness::STUDY];

/// All of both, in the order in which they are carried out.
pub fn all() -> Vec<Study> {
    [REPRODUCTIONS, STUDIES].concat()
}
