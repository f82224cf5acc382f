//! The report, in Markdown.

use super::Tally;
use crate::shared::markdown::table;

pub fn print(tally: &Tally) {
    println!("# Random evaluations within their bounds\n");
    let calls = tally.evaluated.iter();
    let calls = calls.map(|(call, elements)| vec![(*call).to_owned(), elements.to_string()]);
    println!("{}", table("call | >elements", calls));
    let weights = tally.weights.iter().map(|(model, (ratio, place))| {
        let varied = tally.varied.iter().filter(|((of, _), _)| of == model);
        let varied: Vec<String> = varied.map(|((_, name), n)| format!("{name} {n}")).collect();
        let draws = tally.draws.get(model).copied().unwrap_or(0);
        vec![
            (*model).to_owned(),
            draws.to_string(),
            varied.join(", "),
            format!("{ratio:.3}"),
            place.clone(),
        ]
    });
    let headings = "model | >draws | varied in | >greatest weight over its bound | where";
    println!("{}", table(headings, weights));
    println!(
        "{} elements of {} descriptions, {} failures.",
        tally.total(),
        tally.units,
        tally.failures.len()
    );
}
