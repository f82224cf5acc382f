//! Places for short texts beside their markers, clear of one another.

/// Pixels, from the left upper corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    pub left: i32,
    pub top: i32,
    pub width: i32,
    pub height: i32,
}

impl Rect {
    /// With its middle at a point.
    pub fn around((x, y): (i32, i32), width: i32, height: i32) -> Self {
        Self {
            left: x - width / 2,
            top: y - height / 2,
            width,
            height,
        }
    }

    /// The area that it shares with another.
    fn overlap(&self, other: &Self) -> i32 {
        let shared = |a: i32, a_size: i32, b: i32, b_size: i32| {
            ((a + a_size).min(b + b_size) - a.max(b)).max(0)
        };
        shared(self.left, self.width, other.left, other.width)
            * shared(self.top, self.height, other.top, other.height)
    }
}

/// Directions from the marker in the order of preference.
const DIRECTIONS: [(f64, f64); 12] = [
    (1.0, 0.0),
    (0.7, -0.7),
    (0.7, 0.7),
    (-1.0, 0.0),
    (-0.7, -0.7),
    (-0.7, 0.7),
    (0.0, -1.0),
    (0.0, 1.0),
    (0.95, -0.35),
    (0.95, 0.35),
    (-0.95, -0.35),
    (-0.95, 0.35),
];
/// Distances between marker and text, nearest first.
const DISTANCES: [f64; 3] = [9.0, 15.0, 23.0];
/// Pixels between obstacles along a line.
const STEP: i32 = 4;
/// How often every text may move.
const ROUNDS: usize = 4;
/// What a pixel further away costs, in pixels of overlap.
const DISTANCE_COST: f64 = 0.5;

/// A text that wants a place.
#[derive(Clone, Copy, Debug)]
pub struct Tag {
    /// The middle of what it belongs to.
    pub anchor: (i32, i32),
    pub width: i32,
    pub height: i32,
}

/// Steps of a line as obstacles.
pub fn along(line: &[(i32, i32)]) -> Vec<Rect> {
    let step = |from: (i32, i32), to: (i32, i32)| {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let count = (dx.abs().max(dy.abs()) / STEP).max(1);
        let at = move |i| (from.0 + dx * i / count, from.1 + dy * i / count);
        (0..count).map(move |i| Rect::around(at(i), STEP, STEP))
    };
    line.windows(2)
        .flat_map(|ends| step(ends[0], ends[1]))
        .collect()
}

/// A place for each text near its anchor, inside `bounds`, with little overlap of obstacles and of
/// the other texts: each in turn takes its best, and again when the others have theirs.
pub fn place(tags: &[Tag], obstacles: &[Rect], bounds: &Rect) -> Vec<Rect> {
    let mut placed: Vec<Rect> = Vec::new();
    for _ in 0..ROUNDS {
        for (i, tag) in tags.iter().enumerate() {
            let others = placed.iter().enumerate().filter(|(other, _)| *other != i);
            let taken: Vec<Rect> = others
                .map(|(_, rect)| *rect)
                .chain(obstacles.to_vec())
                .collect();
            let best = best(tag, &taken, bounds);
            match placed.get_mut(i) {
                Some(rect) => *rect = best,
                None => placed.push(best),
            }
        }
    }
    placed
}

/// The best place for one text.
fn best(tag: &Tag, taken: &[Rect], bounds: &Rect) -> Rect {
    let mut best = (f64::INFINITY, beside(tag, DIRECTIONS[0], DISTANCES[0]));
    for distance in DISTANCES {
        for (turn, direction) in DIRECTIONS.into_iter().enumerate() {
            let rect = beside(tag, direction, distance);
            let covered: i32 = taken.iter().map(|other| rect.overlap(other)).sum();
            let outside = rect.width * rect.height - rect.overlap(bounds);
            let away = DISTANCE_COST * distance + 0.1 * turn as f64;
            let cost = f64::from(covered + 10 * outside) + away;
            if cost < best.0 {
                best = (cost, rect);
            }
        }
    }
    best.1
}

/// A rectangle in some direction from a text's anchor.
fn beside(tag: &Tag, (dx, dy): (f64, f64), distance: f64) -> Rect {
    // Its middle is as far out as makes its near edge or corner `distance` away.
    let reach = |d: f64, size: i32| {
        let side = if d.abs() < 0.1 { 0.0 } else { d.signum() };
        (d * distance + side * f64::from(size) / 2.0).round() as i32
    };
    let (x, y) = tag.anchor;
    let middle = (x + reach(dx, tag.width), y + reach(dy, tag.height));
    Rect::around(middle, tag.width, tag.height)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_do_not_overlap() {
        let bounds = Rect {
            left: 0,
            top: 0,
            width: 300,
            height: 200,
        };
        let tag = |i| Tag {
            anchor: (290 - 16 * i, 100 + 3 * i),
            width: 40,
            height: 12,
        };
        let tags: Vec<Tag> = (0..6).map(tag).collect();
        let markers: Vec<Rect> = tags
            .iter()
            .map(|t| Rect::around(t.anchor, 10, 10))
            .collect();
        let placed = place(&tags, &markers, &bounds);
        for (i, rect) in placed.iter().enumerate() {
            assert_eq!(rect.overlap(&bounds), rect.width * rect.height);
            assert!(
                placed[..i]
                    .iter()
                    .chain(&markers)
                    .all(|other| rect.overlap(other) == 0)
            );
        }
    }
}
