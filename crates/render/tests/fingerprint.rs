//! The renderer alone, with no Python, gives the pictures whose fingerprints are on file.

#[allow(dead_code)] // each file of tests takes what it needs
mod common;

use nacreous_image::{CHANNELS, PARTS, Progress};
use nacreous_render::{Job, Resources};
use sha2::{Digest, Sha256};

/// (first digits of the hash, mean of each part) that `tests/golden/pictures.csv` has.
fn golden(pearl: &str, scene: &str) -> (String, Vec<f64>) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/pictures.csv");
    let table = std::fs::read_to_string(path).expect("the golden file");
    let begins = format!("{pearl},{scene},");
    let row = table.lines().find_map(|line| line.strip_prefix(&begins)).expect("a row");
    let mut cells = row.split(',').map(str::to_owned);
    let digest = cells.next().expect("a hash");
    (digest, cells.map(|cell| cell.parse().expect("a number")).collect())
}

/// Processors that multiply and add in one step round the film's sums once, others twice.
fn fuses() -> bool {
    #[cfg(target_arch = "x86_64")]
    return is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    return cfg!(target_arch = "aarch64");
}

#[test]
fn pictures_have_the_bytes_on_file_and_elsewhere_their_means() {
    for (pearl, scene) in
        [("paper", "paper"), ("akoya-rg", "north-window-white"), ("tahitian", "north-window-black")]
    {
        let recipe = common::recipe(&format!("{pearl}-{scene}"), &[]);
        let (mut job, progress) =
            (Job::new(recipe, Resources::default()).unwrap(), Progress::default());
        let pixels = job.view(&progress).unwrap().unwrap().picture(&progress).unwrap();
        let linear = pixels.chunks_exact(CHANNELS).flat_map(|pixel| {
            [0, 1, 2].map(|i| pixel[i] + pixel[i + 3] + pixel[i + 6] + pixel[i + 9])
        });
        let bytes: Vec<u8> = linear.flat_map(f32::to_le_bytes).collect();
        let digest = Sha256::digest(&bytes);
        let digest = digest[..8].iter().fold(0_u64, |sum, byte| sum << 8 | u64::from(*byte));
        let (expected, means) = golden(pearl, scene);
        if fuses() {
            assert_eq!(format!("{digest:016x}"), expected, "{pearl} in {scene}");
        }
        for ((name, part), mean) in PARTS.iter().zip(means) {
            let values = pixels.chunks_exact(CHANNELS).flat_map(|pixel| &pixel[part.clone()]);
            let sum: f64 = values.map(|value| f64::from(*value)).sum();
            let found = sum / (pixels.len() / CHANNELS * part.len()) as f64;
            assert!((found - mean).abs() <= 1e-6 + 1e-6 * mean.abs(), "{name}: {found} {mean}");
        }
    }
}
