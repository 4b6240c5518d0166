//! stub until the grain branch lands
/// stub
#[derive(Debug, Clone)]
pub struct Texture;
impl Texture {
    /// stub
    pub fn at(&self, _: glam::DVec3, _: f64) -> [f32; 3] {
        [0.0; 3]
    }
}
