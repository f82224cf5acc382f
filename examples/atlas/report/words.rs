//! Numbers and names in tables.

/// Two digits, or nothing worth a number.
pub fn number(value: f64) -> String {
    if value == 0.0 {
        "0".into()
    } else {
        format!("{value:.1e}")
    }
}

/// A share in whole percent, downwards, so that only all is 100.
pub fn percent(share: f64) -> String {
    format!("{:.0} %", (100.0 * share).floor())
}

/// How many of single precision's seven digits an error takes, from 2^-24.
pub fn digits_lost(error: f64) -> String {
    let lost = (error / f64::from(f32::EPSILON / 2.0)).log10().max(0.0);
    format!("{lost:.1}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([0.0, 0.25].map(number), ["0", "2.5e-1"]);
        assert_eq!([1.0, 0.999].map(percent), ["100 %", "99 %"]);
        assert_eq!([6e-8, 6e-5, 0.0].map(digits_lost), ["0.0", "3.0", "0.0"]);
    }
}
