//! What tours look like: roads, the members' tours, the best one, stops.

use crate::{
    describe::layers,
    kernel::{Frame, LayerKey, Shape},
};

use super::tours::Tours;

impl Tours {
    pub(super) fn draw_layers(&self, frame: &mut Frame) {
        if let Some(network) = &self.network {
            let longest = network.roads.iter().map(|road| road.path.len()).max().unwrap_or(0);
            let every = frame.thin_context(network.roads.len(), longest, true);
            for (number, road) in network.roads.iter().enumerate().step_by(every) {
                // One that was not found is a dot at its first stop, so that the others keep their numbers.
                let nowhere = [self.places[network.pair(number)[0]]; 2];
                line(frame, layers::ROADS.key, if road.path.len() > 1 { &road.path } else { &nowhere }, road.length);
            }
        }
        let mut places = vec![-1.0; self.places.len()];
        if let Some((problem, search)) = &self.search {
            let members = search.members();
            let corners = self.network.as_ref().map_or(1, |network| network.roads.iter().map(|road| road.path.len()).max().unwrap_or(1));
            let every = frame.thin_context(members, corners * (self.places.len() + 1), true);
            for tour in (0..members).step_by(every).filter_map(|i| search.member(i)) {
                line(frame, layers::TOURS.key, &self.path(problem, tour), tour.length);
            }
            if let Some(best) = search.best() {
                line(frame, layers::TOUR.key, &self.path(problem, best), best.length);
                best.order(problem).iter().enumerate().for_each(|(place, &stop)| places[stop] = place as f64);
            }
        }
        frame.begin(layers::STOPS.key, Shape::Points);
        self.places.iter().zip(places).for_each(|(&stop, place)| frame.push(stop, place));
    }
}

fn line(frame: &mut Frame, layer: LayerKey, path: &[[f64; 2]], weight: f64) {
    frame.begin(layer, Shape::Polyline);
    path.iter().for_each(|&point| frame.push(point, weight));
}
