//! How planners rank over many problems: mean ranks with the critical difference, and performance profiles.

use std::path::Path;

use forage::statistics::{Friedman, friedman, homogeneous_groups, performance_ratios};

use super::{
    failure::Failure,
    plot::{self, Axis, Curve, Ranked},
    table::{Cell, Table, p_is, significant},
};

/// The letters of the groups that one is in; with more groups than there are letters their numbers, with blanks between.
pub(crate) fn letters(groups: &[Vec<usize>], one: usize) -> String {
    let own = groups.iter().enumerate().filter(|(_, group)| group.contains(&one)).map(|(k, _)| k);
    if groups.len() > LETTERS {
        return own.map(|k| (k + 1).to_string()).collect::<Vec<_>>().join(" ");
    }
    own.filter_map(|k| ('a'..='z').nth(k)).collect()
}

/// How many letters there are.
const LETTERS: usize = 26;

/// What planners cost on problems, the less the better.
pub(crate) struct Ranking {
    pub planners: Vec<String>,
    /// Problem by problem the planners' costs; `None` where one found nothing.
    pub costs: Vec<Vec<Option<f64>>>,
}

impl Ranking {
    /// The planners' mean ranks, one that found nothing being last, and how far apart they must be to differ. `None` for fewer than two
    /// planners, or without problems.
    fn ranks(&self) -> Option<(Friedman, f64)> {
        let numbers = |costs: &Vec<Option<f64>>| costs.iter().map(|cost| cost.unwrap_or(f64::INFINITY)).collect();
        let found = friedman(&self.costs.iter().map(numbers).collect::<Vec<Vec<f64>>>())?;
        let difference = found.critical_difference?;
        Some((found, difference))
    }

    /// Mean ranks, from the best; those with a common group do not differ. `of`: what the problems are.
    pub(crate) fn table(&self, of: &str) -> Option<Table> {
        let (Friedman { ranks, p, .. }, difference) = self.ranks()?;
        let groups = homogeneous_groups(&ranks, difference);
        let p = p.map_or(String::new(), |p| format!(", Friedman’s {}", p_is(p)));
        let title = format!(
            "Mean ranks over {} {of}{p}; they differ significantly from {} on (Nemenyi, 5 %); planners that share a letter do not differ",
            self.costs.len(),
            significant(difference, 3)
        );
        let mut table = Table::new("ranks", title, &["planner", "mean rank", "group"]);
        let mut order: Vec<usize> = (0..ranks.len()).collect();
        order.sort_by(|&a, &b| ranks[a].total_cmp(&ranks[b]));
        for k in order {
            table.rows.push(vec![Cell::Text(self.planners[k].clone()), Cell::Number(ranks[k], 2), letters(&groups, k).into()]);
        }
        Some(table)
    }

    /// Draws the mean ranks with a bar over those that do not differ (Demšar 2006); whether there was something to draw.
    pub(crate) fn draw_ranks(&self, path: &Path) -> Result<bool, Failure> {
        let Some((Friedman { ranks, .. }, difference)) = self.ranks() else {
            plot::remove(path)?;
            return Ok(false);
        };
        let bars = homogeneous_groups(&ranks, difference);
        let ranked: Vec<Ranked> = self.planners.iter().cloned().zip(ranks).map(|(name, rank)| Ranked { name, rank }).collect();
        plot::draw_ranks(path, &ranked, difference, &bars)?;
        Ok(true)
    }

    /// Draws the share of problems that each planner solves with at most so many times the least cost (Dolan and Moré 2002).
    pub(crate) fn draw_profile(&self, path: &Path, cost: &'static str) -> Result<(), Failure> {
        let ratios = performance_ratios(&self.costs);
        let most = ratios.iter().flatten().copied().filter(|ratio| ratio.is_finite()).fold(1.0, f64::max) * 1.05;
        let curve = |(name, ratios): (&String, &Vec<f64>)| Curve::ecdf(name, ratios, self.costs.len(), [1.0, most]);
        let curves: Vec<Curve> = self.planners.iter().zip(&ratios).map(curve).collect();
        let x = Axis { title: cost, range: 1.0..most, log: most >= 10.0 };
        let y = Axis { title: "share of problems", range: 0.0..1.02, log: false };
        plot::draw(path, &x, &y, &curves, plotters::chart::SeriesLabelPosition::LowerRight)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_groups_than_letters_have_numbers() {
        let groups: Vec<Vec<usize>> = (0..30).map(|k| vec![k, k + 1]).collect();
        assert_eq!(letters(&groups, 29), "29 30");
        assert_eq!(letters(&groups[..26], 25), "yz");
    }

    #[test]
    fn ranks_that_do_not_differ_share_a_letter() {
        let planners = ["worst", "good", "better"].map(str::to_owned).to_vec();
        let costs = (0..30).map(|k| vec![None, Some(2.0 + f64::from(k % 2)), Some(2.5)]).collect();
        let ranking = Ranking { planners, costs };
        // The two others win half of the problems each.
        let table = ranking.table("problems").unwrap();
        let rows: Vec<String> = table.rows.iter().map(|row| format!("{:?} {:?}", row[0], row[2])).collect();
        assert_eq!(rows, [r#"Text("good") Text("a")"#, r#"Text("better") Text("a")"#, r#"Text("worst") Text("")"#]);
        let title = table.title.to_string();
        assert!(title.contains("over 30 problems") && title.contains("from 0.605 on"), "{title}");
        assert!(Ranking { planners: vec!["one".into()], costs: vec![vec![Some(1.0)]] }.table("problems").is_none());
    }
}
