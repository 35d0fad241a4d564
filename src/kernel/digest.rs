//! The hash that golden runs and links carry.

/// FNV-1a over 64-bit words, each multiplication followed by a fold so that high bits reach low ones.
#[derive(Debug, Clone)]
pub struct Digest(u64);

impl Default for Digest {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Digest {
    /// Adds one word.
    #[inline]
    pub fn word(&mut self, word: u64) {
        let mixed = (self.0 ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        self.0 = mixed ^ (mixed >> 32);
    }

    /// Adds a number's bits.
    #[inline]
    pub fn number(&mut self, number: f64) {
        self.word(number.to_bits());
    }

    /// Adds the bits of many numbers.
    pub fn numbers(&mut self, numbers: &[f64]) {
        self.word(numbers.len() as u64);
        numbers.iter().for_each(|&n| self.number(n));
    }

    /// Adds bytes, each as a word.
    pub fn bytes(&mut self, bytes: &[u8]) {
        self.word(bytes.len() as u64);
        bytes.iter().for_each(|&b| self.word(u64::from(b)));
    }

    /// Sixteen hexadecimal digits.
    pub fn hex(&self) -> String {
        format!("{:016x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_bit_and_the_order_count() {
        let hash = |words: &[u64]| {
            let mut digest = Digest::default();
            words.iter().for_each(|&w| digest.word(w));
            digest.hex()
        };
        assert_eq!(hash(&[1, 2]), hash(&[1, 2]));
        assert_ne!(hash(&[1, 2]), hash(&[2, 1]));
        assert_ne!(hash(&[1 << 63]), hash(&[0]));
        let mut zero = Digest::default();
        let mut minus = Digest::default();
        zero.number(0.0);
        minus.number(-0.0);
        assert_ne!(zero.hex(), minus.hex());
    }
}
