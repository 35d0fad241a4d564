//! The papers: their titles, authors and journals as they print them, and what shows each of their pictures.

use serde::Serialize;

/// A paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Paper {
    /// As it is cited here: `WCPSO`.
    pub tag: &'static str,
    /// Its Chinese title; `None`: not printed in the text that we have.
    pub title: Option<&'static str>,
    /// The English title.
    pub english: &'static str,
    /// Whether the paper prints the English title; otherwise it is our translation.
    pub english_printed: bool,
    /// The authors, in Chinese and in Latin letters.
    pub authors: Option<[&'static str; 2]>,
    /// Where they work.
    pub affiliation: Option<&'static str>,
    /// The journal, as far as it is printed.
    pub journal: Option<&'static str>,
    /// The year, if it is printed.
    pub year: Option<u16>,
    /// What identifies it for good, or why nothing does.
    pub reference: &'static str,
    /// Its pictures without numbers: which claim stands for them, or why none does.
    pub pictures: &'static [Picture],
}

/// A picture of a paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Picture {
    /// `Figs 1 to 3`.
    pub name: &'static str,
    /// What it shows.
    pub shows: &'static str,
    /// The claims that rest on it.
    pub claims: &'static [&'static str],
    /// What else there is to say: why there is no claim, or where it is shown here.
    pub remark: &'static str,
}

const fn picture(name: &'static str, shows: &'static str, claims: &'static [&'static str], remark: &'static str) -> Picture {
    Picture { name, shows, claims, remark }
}

const NO_DOI: &str = "No DOI is printed, and none was found.";

/// All, in the order of the document.
pub const PAPERS: [Paper; 5] = [
    Paper {
        tag: "WCPSO",
        title: Some("基于改进粒子群算法的路径规划"),
        english: "Path Planning Based on Improved Particle Swarm Optimization Algorithm",
        english_printed: true,
        authors: Some(["贾会群 等", "Jia Huiqun et al."]),
        affiliation: None,
        journal: Some(
            "农业机械学报 (Transactions of the Chinese Society for Agricultural Machinery), 2018, no. 12, pp. 376, 377 and before",
        ),
        year: Some(2018),
        reference: NO_DOI,
        pictures: &[
            picture("Figs 1 to 3", "how ω, c1 and c2 change over the iterations", &["W5"], ""),
            picture("Fig. 4", "the seven discs", &[], "It is the scene wcpso-discs; the text prints its numbers."),
            picture("Figs 5 to 7", "ten paths of WCPSO and WPSO", &["W3a", "W3b"], ""),
        ],
    },
    Paper {
        tag: "LTQPSO",
        title: Some("一种改进量子行为粒子群优化算法的移动机器人路径规划"),
        english: "Path planning of mobile robots with an improved quantum-behaved particle swarm optimization",
        english_printed: false,
        authors: Some(["刘洁, 赵海方, 周德廉", "Liu Jie, Zhao Haifang, Zhou Delian"]),
        affiliation: Some("宿迁学院机电工程学院, 宿迁 223800"),
        journal: Some("no. 11A, with page 125; the journal is not printed"),
        year: None,
        reference: NO_DOI,
        pictures: &[
            picture("Fig. 1", "evolution speed ip and dispersion gs over the iterations", &["L3"], ""),
            picture("Fig. 2", "the flow chart", &[], "It shows the algorithm, no result."),
            picture("Figs 3 and 4", "N and M over D", &["L4"], ""),
            picture("Fig. 5", "how a path is tested in polar and Cartesian coordinates", &[], "It shows the method, no result."),
            picture("Figs 6 and 7", "paths for D = 8 and D = 16", &["L1a", "L5a"], ""),
            picture("Fig. 8", "the robot’s drive", &[], "It shows the robot, no result."),
            picture(
                "Figs 9 to 11",
                "the paths of a robot, and how both planners converge",
                &["L5b"],
                "Layout, start and goal are not printed, so the paths cannot be repeated.",
            ),
        ],
    },
    Paper {
        tag: "ANTBAT",
        title: Some("基于蚁群算法和蝙蝠算法的多点路径规划"),
        english: "Multi-point path planning based on the ant colony and bat algorithms",
        english_printed: false,
        authors: Some(["方敏, 金世俊", "Fang Min, Jin Shijun"]),
        affiliation: Some("东南大学仪器科学与工程学院, 南京 210096"),
        journal: Some("no. 18, pp. 52, 53 among others; the journal is not printed"),
        year: None,
        reference: NO_DOI,
        pictures: &[
            picture("Fig. 1", "a grid", &[], "It shows the model, no result."),
            picture("Fig. 2", "the flow chart of the bats", &[], "It shows the algorithm, no result."),
            picture(
                "Fig. 3",
                "the 30 × 30 grid and its stops",
                &[],
                "It cannot be read in the scan; the scene ant-bat-30 is a reconstruction.",
            ),
            picture("Fig. 4", "the paths of three colonies", &["A1a", "A1b", "A1c"], ""),
            picture("Figs 5 and 6", "the network of paths, and the bats’ tour", &["A4a"], ""),
            picture("Fig. 7", "how five planners converge", &["A4d"], "The caption says five, the text four."),
            picture("Fig. 8", "computing times of three methods", &["A5"], ""),
        ],
    },
    Paper {
        tag: "ARM-RRT",
        title: Some("基于RRT搜索算法的六自由度机械臂避障路径规划"),
        english: "The Mechanical Arm of Six-Dof Obstacle Avoidance Path Planning Based on Rapid-Exploring Random Trees",
        english_printed: true,
        authors: Some(["代彦辉, 梁艳阳, 谢□", "Dai Yanhui, Liang Yanyang, Xie Gang"]),
        affiliation: Some("西南科技大学信息工程学院, 四川绵阳 621010"),
        journal: Some("Techniques of Automation & Applications, 2012, no. 10, p. 31"),
        year: Some(2012),
        reference: "Article ID 1003-7241(2012)10-0031-07; no DOI is printed, and none was found.",
        pictures: &[
            picture(
                "Figs 1 and 2",
                "the arm and its joints",
                &[],
                "They show the model; its Denavit–Hartenberg parameters are in the scene.",
            ),
            picture("Fig. 3", "five cases of a segment and a face", &[], "It shows the method, no result."),
            picture("Figs 4 and 5", "how a tree grows", &["R1a"], ""),
            picture("Fig. 6", "the arm’s path without an obstacle", &["R2"], ""),
            picture("Figs 7 and 8", "the arm’s path past the cuboid", &["R3a", "R3b"], ""),
        ],
    },
    Paper {
        tag: "WOLF-ANT",
        title: None,
        english: "A dynamic path planning method for mobile robots based on an improved ant colony algorithm",
        english_printed: false,
        authors: None,
        affiliation: None,
        journal: None,
        year: None,
        reference: "The text that we have begins with the abstract: title, authors, journal and year are missing. The English title is a phrase of the abstract.",
        pictures: &[
            picture("Fig. 1", "the neighbours of a cell and their weights", &[], "It shows the method; a test compares the weights."),
            picture(
                "Figs 2 and 3",
                "the paths, and the drive past the moving obstacle",
                &["O1a", "O5"],
                "The improved ants’ path is printed cell by cell.",
            ),
        ],
    },
];

/// The paper of a tag.
pub fn find(tag: &str) -> Option<&'static Paper> {
    PAPERS.iter().find(|paper| paper.tag == tag)
}

/// The tag of a source: `WCPSO` of `[WCPSO] Table 2`.
pub fn tag(source: &'static str) -> &'static str {
    source.trim_start_matches('[').split(']').next().unwrap_or(source)
}

impl Paper {
    /// Authors, title and journal in a line of Markdown.
    pub fn citation(&self) -> String {
        let authors = self.authors.map_or(String::new(), |[chinese, latin]| format!("{latin} ({chinese}), "));
        let title = self.title.map_or(String::new(), |title| format!("{title}, "));
        let kind = if self.english_printed { "" } else { " (our translation)" };
        let journal = self.journal.map_or(String::new(), |journal| format!(", {journal}"));
        let affiliation = self.affiliation.map_or(String::new(), |affiliation| format!(". {affiliation}"));
        format!("{authors}{title}*{}*{kind}{journal}{affiliation}. {}", self.english, self.reference)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_picture_has_a_claim_or_a_reason() {
        for paper in &PAPERS {
            for picture in paper.pictures {
                assert!(!picture.claims.is_empty() || !picture.remark.is_empty(), "[{}] {}", paper.tag, picture.name);
            }
        }
    }
}
