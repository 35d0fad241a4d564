//! A drive as a planner: how it starts, steps, and what it reports.

use std::sync::Arc;

use crate::{
    describe::Start,
    exact,
    geometry::{self},
    kernel::{
        Candidate, Error, Event, Explain, Facets, Failure, Frame, Inspection, Item, Message, Planner, Progress, Readings, ReferenceOptimum,
        Solution, Stage, Started, Status, Timeline,
    },
    message,
};

use super::{
    draw,
    drive::Dynamic,
    explain,
    ground::Ground,
    parameters::{ITERATIONS, TIME_LIMIT},
    route::Route,
};

/// Starts a drive on ways of this kind.
pub(super) fn start(start: &Start, route: impl FnOnce(&Arc<Ground>) -> Result<Box<dyn Route>, Error>) -> Result<Started, Error> {
    let settings = start.parameters;
    let ground = Arc::new(Ground::new(start.scene, settings)?);
    let route = route(&ground)?;
    let most = match settings[TIME_LIMIT] {
        0.0 => {
            let (cells, endpoints) = (&ground.cells, &ground.endpoints);
            let way = exact::shortest_way(cells, endpoints.start, endpoints.goal).unwrap_or_default();
            let path = endpoints.path(cells, way);
            // As long as the shortest way takes four times over, and a minute.
            60.0 + 4.0 * (geometry::length(&path) / ground.body.speed + geometry::turns(&path) as f64 * ground.body.turn_time)
        }
        seconds => seconds,
    };
    let planning = route.steps();
    let driving = (most / ground.period).ceil() as u64;
    // Where there are planning steps the parameter `iterations` counts these; otherwise it counts driving periods.
    let limit = if planning > 0 { planning + driving } else { driving.min(settings[ITERATIONS]) };
    let mut dynamic = Dynamic { ground, route, journey: None, found: Vec::new(), waits: None, lost: false, iteration: 0, most };
    let drive = Stage { name: "drive", title: message!("drive-stage", "Drive"), end: None };
    let mut stages = vec![drive];
    if planning == 0 {
        dynamic.set_out();
    } else {
        stages.insert(0, Stage { name: "plan", title: message!("drive-stage-plan", "Plan"), end: Some(planning) });
    }
    let progress = dynamic.progress();
    let started = Started::new(dynamic, limit).open_ended().measured_by(ReferenceOptimum::Cells).in_stages(stages);
    Ok(Started { progress, ..started })
}

impl Planner for Dynamic {
    fn advance(&mut self) -> Progress {
        let plans = self.journey.is_none();
        let progress = if plans { self.route.step() } else { self.drive() };
        if progress == Progress::Partly {
            return Progress::Partly;
        }
        self.iteration += 1;
        if plans && self.iteration >= self.route.steps() {
            self.set_out();
        }
        self.progress()
    }

    fn evaluations(&self) -> u64 {
        self.route.evaluations()
    }

    /// There is a result when the robot is at the goal; it costs the time that it took.
    fn best(&self) -> Option<Candidate> {
        let journey = self.journey.as_ref().filter(|journey| journey.arrived)?;
        Some(Candidate { cost: journey.now, solution: Solution::Drive(self.track(journey)) })
    }

    fn read(&self, out: &mut Readings) {
        explain::read(self, out);
    }

    fn draw(&self, frame: &mut Frame) {
        draw::draw(self, frame);
    }

    fn facets(&self) -> Facets<'_> {
        Facets::default().explain(self).timeline(self).failure(self)
    }
}

impl Explain for Dynamic {
    fn inspect(&self, item: Item) -> Option<Inspection> {
        explain::inspect(self, item)
    }

    fn suppose_now(&self, item: Item, supposition: &str) -> Option<Inspection> {
        explain::suppose(self, item, supposition)
    }
}

impl Timeline for Dynamic {
    fn events(&self) -> &[Event] {
        self.journey.as_ref().map_or(&[], |journey| &journey.events)
    }
}

impl Failure for Dynamic {
    fn failure(&self, status: Status) -> Option<Message> {
        match &self.journey {
            _ if self.lost => Some(message!("drive-no-way", "No way to the goal was found to drive on")),
            Some(journey) if status == Status::Exhausted => {
                Some(explain::why_not(journey, if journey.now >= self.most { TIME_LIMIT.name() } else { ITERATIONS.name() }))
            }
            _ => None,
        }
    }
}
