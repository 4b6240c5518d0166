//! Days of seeding, harvest and summer, in days of growth.

use time::{Date, Month};

use crate::RenderError;
use crate::spec::nacre::GrowthSpec;

/// Any year that is not a leap year stands for "every year".
const EVERY_YEAR: i32 = 2001;

/// When the nacre grows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Calendar {
    /// Days from seeding to harvest, on each of which nacre grows.
    pub days: u32,
    /// Days from seeding to the summer of the year of seeding; negative where that is over.
    pub peak_day: i32,
}

impl Calendar {
    /// Of a growth's days. A harvest without a year is the first such day after seeding; summer comes back
    /// every year.
    ///
    /// # Errors
    /// [`RenderError::OutOfRange`] for what is no day, or a harvest that is not after seeding.
    ///
    /// ```
    /// use nacreous_render::{Calendar, spec::{from_json, nacre::GrowthSpec}};
    /// let growth: GrowthSpec = from_json(
    ///     r#"{"protein_nm": 20, "aragonite": 1.53, "protein": 1.43, "preset": "paper", "seed": 1,
    ///         "seeding": "04-15", "harvest": "02-01", "peak": "08-01", "season_days": 45,
    ///         "thickness_winter_nm": 400, "thickness_summer_nm": 700, "layers_winter": 1,
    ///         "layers_summer": 3, "thickness_noise_nm": 20, "layers_noise": 0.5}"#,
    /// )?;
    /// assert_eq!(Calendar::of(&growth)?, Calendar { days: 292, peak_day: 108 });
    /// # Ok::<(), nacreous_render::RenderError>(())
    /// ```
    pub fn of(growth: &GrowthSpec) -> Result<Self, RenderError> {
        let seeding = date("nacre.seeding", &growth.seeding, EVERY_YEAR)?;
        let mut harvest = date("nacre.harvest", &growth.harvest, EVERY_YEAR)?;
        if growth.harvest.len() == MONTH_DAY && harvest <= seeding {
            harvest = date("nacre.harvest", &growth.harvest, EVERY_YEAR + 1)?;
        }
        let peak = date("nacre.peak", &growth.peak, seeding.year())?;
        let since = |day: Date| day.to_julian_day() - seeding.to_julian_day();
        let days = u32::try_from(since(harvest)).map_err(|_| {
            let allowed = format!("a day after nacre.seeding, which is {:?}", growth.seeding);
            RenderError::out_of_range("nacre.harvest", &growth.harvest, allowed)
        })?;
        Ok(Self { days, peak_day: since(peak) })
    }
}

/// Lengths of `MM-DD` and `YYYY-MM-DD`.
const MONTH_DAY: usize = 5;
const YEAR_MONTH_DAY: usize = 10;

/// `YYYY-MM-DD`, or `MM-DD` of a year.
fn date(key: &str, text: &str, year: i32) -> Result<Date, RenderError> {
    let parsed = || {
        let (year, day) = match text.len() {
            MONTH_DAY => (year, text),
            YEAR_MONTH_DAY => (text.get(..4)?.parse().ok()?, text.get(4..)?.strip_prefix('-')?),
            _ => return None,
        };
        let (month, day) = (day.get(..2)?, day.get(2..)?.strip_prefix('-')?);
        let month = Month::try_from(month.parse::<u8>().ok()?).ok()?;
        Date::from_calendar_date(year, month, day.parse().ok()?).ok()
    };
    parsed().ok_or_else(|| RenderError::out_of_range(key, text, "MM-DD or YYYY-MM-DD"))
}
