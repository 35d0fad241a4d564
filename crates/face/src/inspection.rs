//! What is told of an item, as it crosses to JavaScript.

use serde::Serialize;

use forage::kernel::{Inspection, Item, Label, Mark, Message, Quantity};

#[derive(Serialize)]
pub(crate) struct ItemView {
    role: &'static str,
    index: usize,
}

impl From<Item> for ItemView {
    fn from(item: Item) -> Self {
        Self { role: item.layer.0, index: item.index }
    }
}

#[derive(Serialize)]
pub(crate) struct InspectionView {
    item: ItemView,
    title: Message,
    event: &'static str,
    summary: Message,
    values: Vec<Quantity>,
    formulas: Vec<&'static str>,
    table: Table,
    layers: Vec<Mark>,
}

#[derive(Serialize)]
struct Table {
    columns: Vec<Label>,
    labels: Vec<Message>,
    rows: Vec<Vec<f64>>,
}

impl From<Inspection> for InspectionView {
    fn from(told: Inspection) -> Self {
        let Inspection { item, title, event, summary, values, formulas, columns, labels, rows, marks } = told;
        Self { item: item.into(), title, event, summary, values, formulas, table: Table { columns, labels, rows }, layers: marks }
    }
}
