/// The mean length of a Gregorian year, after which the seasons come again.
const YEAR_DAYS: f64 = 365.2425;

/// The growing season: a bell curve over the year with its top in summer.
///
/// The paper takes the shape of a normal density "after the growth curve of the pearl layer"
/// (section 3.2.1) and gives no width; top and width are parameters **(ours)**.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Season {
    /// Days from seeding to a top of the bell; tops come again every year.
    pub peak_day: f64,
    /// Standard deviation of the bell in days.
    pub width_days: f64,
}

impl Season {
    /// How summery the day is: 1 at the top of the bell, towards 0 in winter.
    ///
    /// ```
    /// let season = nacreous_nacre::Season { peak_day: 100.0, width_days: 45.0 };
    /// assert_eq!(season.warmth(100.0), 1.0);
    /// assert!(season.warmth(282.0) < 1e-3);
    /// ```
    pub fn warmth(self, day: f64) -> f64 {
        let turns = (day - self.peak_day) / YEAR_DAYS;
        let from_peak_days = (turns - libm::rint(turns)) * YEAR_DAYS;
        let z = from_peak_days / self.width_days;
        libm::exp(-0.5 * z * z)
    }
}
