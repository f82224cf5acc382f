//! What is evaluated, one row of the table each: every model of the registry in its variants.

use pellicle::bsdf::{ParamKind, RegisteredModel, models};

/// So many combinations of a model's choices have a row each.
const MOST_COMBINATIONS: usize = 32;

/// A model with some of its choices made.
pub struct Variant {
    pub entry: &'static RegisteredModel,
    /// Model and choices.
    pub name: String,
    /// What is chosen for each parameter: that, or anything.
    pub choices: Vec<Option<usize>>,
}

/// All combinations of a model's first choices, the others at their defaults; and each of these others with
/// whatever comes before it, and those after it at their defaults.
pub fn variants() -> Vec<Variant> {
    models().iter().flat_map(of).collect()
}

fn of(entry: &'static RegisteredModel) -> Vec<Variant> {
    let params = entry.info.params;
    let count = |param: usize| match params[param].kind {
        ParamKind::Choice { choices } => choices.len(),
        _ => 1,
    };
    let mut combined = 0;
    let mut product = 1;
    while combined < params.len() && product * count(combined) <= MOST_COMBINATIONS {
        product *= count(combined);
        combined += 1;
    }
    let mut all = Vec::new();
    for combination in 0..product {
        let mut rest = combination;
        let mut choices = vec![Some(0); params.len()];
        for (param, choice) in choices.iter_mut().enumerate().take(combined) {
            *choice = Some(rest % count(param));
            rest /= count(param);
        }
        let named = (0..combined).filter(|param| count(*param) > 1);
        all.push(Variant::new(entry, choices, named));
    }
    for param in combined..params.len() {
        for choice in 0..if count(param) > 1 { count(param) } else { 0 } {
            let mut choices = vec![None; params.len()];
            choices[param..].fill(Some(0));
            choices[param] = Some(choice);
            all.push(Variant::new(entry, choices, [param].into_iter()));
        }
    }
    all
}

impl Variant {
    fn new(
        entry: &'static RegisteredModel,
        choices: Vec<Option<usize>>,
        named: impl Iterator<Item = usize>,
    ) -> Self {
        let mut name = entry.name().to_owned();
        for param in named {
            let param_info = &entry.info.params[param];
            if let (ParamKind::Choice { choices: all }, Some(choice)) =
                (&param_info.kind, choices[param])
            {
                let choice = all[choice];
                let is_switch = ["on", "off", "none"].contains(&choice);
                let shown = match (is_switch, name.len() == entry.name().len()) {
                    (true, _) => format!(" {} {choice}", param_info.name()),
                    (false, true) => format!(" {choice}"),
                    (false, false) => format!("/{choice}"),
                };
                name += &shown;
            }
        }
        Self {
            entry,
            name,
            choices,
        }
    }
}
