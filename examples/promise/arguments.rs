//! The command line.

use crate::promise::run::Settings;
use crate::promise::summary::PROMISES;
use std::str::FromStr;

const USAGE: &str = "\
usage: promise [arguments]

  --stacks N          random stacks, 1000
  --points N          points of each, 10000
  --seed N            of the random numbers, 1
  --stack I           only that stack of the series
  --tolerance X       only that one of 1e-2, 2e-3 and 2e-4
  --truth-cache DIR   keep the reference's colours there and use those kept before; delete the
                      folder when the reference or the media change";

/// What to check, or why the arguments are wrong.
pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Settings, String> {
    let mut settings = Settings {
        seed: 1,
        stacks: 0..1000,
        points: 10_000,
        tolerances: PROMISES.map(|promise| promise.tolerance).to_vec(),
        truth_folder: None,
    };
    while let Some(name) = arguments.next() {
        let value = arguments
            .next()
            .ok_or_else(|| format!("{name} needs a value\n\n{USAGE}"))?;
        match name.as_str() {
            "--stacks" => settings.stacks = 0..number(&name, &value)?,
            "--points" => settings.points = number(&name, &value)?,
            "--seed" => settings.seed = number(&name, &value)?,
            "--stack" => {
                let only = number(&name, &value)?;
                settings.stacks = only..only + 1;
            }
            "--tolerance" => settings.tolerances = vec![tolerance(&value)?],
            "--truth-cache" => settings.truth_folder = Some(value.into()),
            _ => return Err(format!("unknown argument '{name}'\n\n{USAGE}")),
        }
    }
    Ok(settings)
}

fn number<T: FromStr>(name: &str, value: &str) -> Result<T, String> {
    let wrong = |_| format!("{name} = {value} is not a whole number");
    value.parse().map_err(wrong)
}

fn tolerance(value: &str) -> Result<f64, String> {
    let found = value.parse().unwrap_or(f64::NAN);
    PROMISES
        .iter()
        .map(|promise| promise.tolerance)
        .find(|tolerance| *tolerance == found)
        .ok_or_else(|| format!("--tolerance = {value} is none of 1e-2, 2e-3, 2e-4"))
}
