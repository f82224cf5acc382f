//! Arbitrary bytes as choices and numbers. When they are used up, all that follows is 0.

/// What is left of the bytes.
pub struct Bytes<'a>(pub &'a [u8]);

impl Bytes<'_> {
    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else {
            return 0;
        };
        self.0 = rest;
        *first
    }

    fn bytes<const N: usize>(&mut self) -> [u8; N] {
        std::array::from_fn(|_| self.byte())
    }

    /// Below `count`, which is at most 256.
    pub fn index(&mut self, count: usize) -> usize {
        usize::from(self.byte()) % count
    }

    /// Any number.
    pub fn bits(&mut self) -> f32 {
        f32::from_le_bytes(self.bytes())
    }

    pub fn word(&mut self) -> u64 {
        u64::from_le_bytes(self.bytes())
    }

    /// One of 65,536 numbers from `min` to `max`.
    pub fn within(&mut self, min: f32, max: f32) -> f32 {
        let part = f32::from(u16::from_le_bytes(self.bytes())) / 65535.0;
        min + (max - min) * part
    }

    /// A number of that range, or, one time in eight, any number.
    pub fn number(&mut self, min: f32, max: f32) -> f32 {
        if self.byte() % 8 == 7 {
            self.bits()
        } else {
            self.within(min, max)
        }
    }

    /// A direction above a surface, below it, or three numbers of any kind.
    pub fn direction(&mut self) -> [f32; 3] {
        let kind = self.byte();
        if kind % 8 == 7 {
            return std::array::from_fn(|_| self.bits());
        }
        let w: [f32; 3] = std::array::from_fn(|_| self.within(-1.0, 1.0));
        let z = if kind % 8 == 6 { w[2].powi(9) } else { w[2] };
        let w = glam::Vec3::new(w[0], w[1], if kind < 192 { z.abs() } else { z });
        w.normalize_or(glam::Vec3::Z).to_array()
    }

    /// Three numbers of [0, 1), or of any kind.
    pub fn uniforms(&mut self) -> [f32; 3] {
        if self.byte() % 8 == 7 {
            return std::array::from_fn(|_| self.bits());
        }
        std::array::from_fn(|_| self.within(0.0, 0.999_999_94))
    }
}
