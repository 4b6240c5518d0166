/// What one answer says about a pair that was shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// The one on the left was chosen.
    Left,
    /// The one on the right was chosen.
    Right,
    /// Neither was.
    Tie,
}

impl Outcome {
    /// All of them, in the order of every table of three.
    pub const ALL: [Self; 3] = [Self::Left, Self::Right, Self::Tie];

    /// The same answer, had left and right changed places.
    #[must_use]
    pub fn mirrored(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
            Self::Tie => Self::Tie,
        }
    }
}

impl From<i8> for Outcome {
    /// 1 left, -1 right, 0 tie.
    fn from(sign: i8) -> Self {
        match sign.signum() {
            1 => Self::Left,
            -1 => Self::Right,
            _ => Self::Tie,
        }
    }
}
