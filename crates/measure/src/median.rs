//! The running median of a plane with holes.

/// The median over the square of `2 reach + 1` around each pixel, pixels that are not held left out; of a
/// pixel with none around it, its own value.
///
/// Huang's sliding histogram (Huang, Yang and Tang 1979).
pub fn running(plane: &[u8], held: &[bool], width: usize, reach: usize) -> Vec<u8> {
    let height = plane.len() / width;
    let mut result = plane.to_vec();
    for row in 0..height {
        let rows = row.saturating_sub(reach)..(row + reach + 1).min(height);
        let mut window = Window::new();
        for column in 0..width + reach {
            for one in rows.clone() {
                let at = one * width;
                if column < width && held[at + column] {
                    window.add(plane[at + column]);
                }
                if let Some(old) = column.checked_sub(2 * reach + 1)
                    && held[at + old]
                {
                    window.remove(plane[at + old]);
                }
            }
            if let Some(middle) = column.checked_sub(reach)
                && held[row * width + middle]
            {
                result[row * width + middle] = window.median();
            }
        }
    }
    result
}

struct Window {
    counts: [u32; 256],
    total: u32,
    /// The last median, and how many lie below it.
    level: usize,
    below: u32,
}

impl Window {
    fn new() -> Self {
        Self { counts: [0; 256], total: 0, level: 0, below: 0 }
    }

    fn add(&mut self, value: u8) {
        self.counts[usize::from(value)] += 1;
        self.total += 1;
        self.below += u32::from(usize::from(value) < self.level);
    }

    fn remove(&mut self, value: u8) {
        self.counts[usize::from(value)] -= 1;
        self.total -= 1;
        self.below -= u32::from(usize::from(value) < self.level);
    }

    /// The least value with half of all, or more, at it or below.
    fn median(&mut self) -> u8 {
        let half = self.total.div_ceil(2);
        while self.below >= half && self.level > 0 {
            self.level -= 1;
            self.below -= self.counts[self.level];
        }
        while self.below + self.counts[self.level] < half && self.level < 255 {
            self.below += self.counts[self.level];
            self.level += 1;
        }
        self.level as u8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_running_median_is_that_of_each_window_sorted() {
        let (width, height, reach) = (17_usize, 11_usize, 3_usize);
        let plane: Vec<u8> = (0..width * height).map(|at| (at * at * 37 % 251) as u8).collect();
        let held: Vec<bool> = (0..width * height).map(|at| at % 5 != 2).collect();
        let found = running(&plane, &held, width, reach);
        for row in 0..height {
            for column in 0..width {
                let mut window = Vec::new();
                for r in row.saturating_sub(reach)..(row + reach + 1).min(height) {
                    for c in column.saturating_sub(reach)..(column + reach + 1).min(width) {
                        if held[r * width + c] {
                            window.push(plane[r * width + c]);
                        }
                    }
                }
                window.sort_unstable();
                if held[row * width + column] {
                    assert_eq!(found[row * width + column], window[window.len().div_ceil(2) - 1]);
                }
            }
        }
    }
}
