//! The rows of environment.csv.

use super::series::Method;

/// One way to the reflection of one environment at one roughness.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub environment: String,
    pub roughness: f64,
    pub method: Method,
    pub samples: u32,
    /// Root mean square of the differences over that of the truth.
    pub rms: f64,
    /// That of the truth's standard errors.
    pub truth: f64,
    /// Per pixel.
    pub ns: f64,
}

const HEADER: &str = "environment,roughness,method,samples,relative_rms,bias,truth_standard_error,\
                      ns_per_pixel,importance_ns_for_same_error";

/// All rows; the message names a line that is not one.
pub fn parse(text: &str) -> Result<Vec<Row>, String> {
    let mut lines = text.lines();
    if lines.next() != Some(HEADER) {
        return Err(format!("the table does not begin with {HEADER}"));
    }
    lines
        .map(|line| row(line).ok_or_else(|| format!("not a row: {line}")))
        .collect()
}

fn row(line: &str) -> Option<Row> {
    let cells: Vec<&str> = line.split(',').collect();
    let number = |i: usize| cells.get(i)?.parse::<f64>().ok();
    Some(Row {
        environment: cells[0].to_owned(),
        roughness: number(1)?,
        method: Method::named(cells.get(2)?)?,
        samples: cells.get(3)?.parse().ok()?,
        rms: number(4)?,
        truth: number(6)?,
        ns: number(7)?,
    })
}

/// The environments' names in their order.
pub fn environments(rows: &[Row]) -> Vec<String> {
    let mut names: Vec<String> = rows.iter().map(|r| r.environment.clone()).collect();
    names.dedup();
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_rows_and_refuses_others() {
        let text = format!("{HEADER}\nstudio,0.3,filtered,16,1.5e-1,-2e-2,9e-3,7500,4000\n");
        let rows = parse(&text).unwrap();
        assert_eq!(rows.len(), 1);
        assert_eq!((rows[0].samples, rows[0].method), (16, Method::Filtered));
        assert_eq!(
            (rows[0].rms, rows[0].truth, rows[0].ns),
            (0.15, 9e-3, 7500.0)
        );
        assert_eq!(environments(&rows), ["studio"]);
        assert!(parse("roughness\n").is_err());
        assert!(parse(&format!("{HEADER}\nstudio,0.3,guess,1,1,1,1,1,\n")).is_err());
        assert!(parse(&format!("{HEADER}\nstudio\n")).is_err());
    }
}
