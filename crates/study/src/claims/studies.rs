//! The studies of the papers' claims.

use super::{super::study::Study, antbat, arm_rrt, ltqpso, wcpso, wolf_ant};

/// A study of one paper's claims.
macro_rules! study {
    ($study:ident, $name:literal, $source:literal, $claims:ident) => {
        const $study: Study = Study {
            name: $name,
            title: "what the paper claims",
            source: $source,
            repeatable: true,
            jobs: |options| $claims::CLAIMS.jobs(options),
            run: |options, control| $claims::CLAIMS.carry_out(&$study, options, control),
        };
    };
}

study!(WCPSO, "wcpso-claims", "[WCPSO]", wcpso);
study!(LTQPSO, "ltqpso-claims", "[LTQPSO]", ltqpso);
study!(ANTBAT, "antbat-claims", "[ANTBAT]", antbat);
study!(ARM_RRT, "arm-rrt-claims", "[ARM-RRT]", arm_rrt);
study!(WOLF_ANT, "wolf-ant-claims", "[WOLF-ANT]", wolf_ant);

/// The claims' studies, in the order of the papers.
pub const STUDIES: [Study; 5] = [WCPSO, LTQPSO, ANTBAT, ARM_RRT, WOLF_ANT];
