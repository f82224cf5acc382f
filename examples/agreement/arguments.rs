//! The command line.

use crate::agreement::run::Settings;

const USAGE: &str = "\
usage: agreement [arguments]

  --evaluations N   random elements, 1e8
  --seed N          of the random numbers, 1";

/// What to check, or why the arguments are wrong.
pub fn parse(mut arguments: impl Iterator<Item = String>) -> Result<Settings, String> {
    let mut settings = Settings {
        seed: 1,
        evaluations: 100_000_000,
    };
    while let Some(name) = arguments.next() {
        let value = arguments
            .next()
            .ok_or_else(|| format!("{name} needs a value\n\n{USAGE}"))?;
        let number = match value.parse::<f64>() {
            Ok(number) if number >= 0.0 && number.fract() == 0.0 => number as u64,
            _ => return Err(format!("{name} = {value} is not a whole number")),
        };
        match name.as_str() {
            "--evaluations" => settings.evaluations = number,
            "--seed" => settings.seed = number,
            _ => return Err(format!("unknown argument '{name}'\n\n{USAGE}")),
        }
    }
    Ok(settings)
}
