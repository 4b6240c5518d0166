//! Multiply-adds that this processor can do in a nanosecond on one core: what the exact kernels are held
//! against (`cargo bench -p nacreous-optics --bench peak`).

use std::{hint::black_box, time::Instant};

use multiversion::multiversion;

const STEPS: u32 = 100_000;

/// `N` sums that do not wait for one another.
#[multiversion(targets("x86_64+avx512f+avx512vl+avx2+fma", "x86_64+avx2+fma"))]
fn multiply_add<const N: usize>(factor: f64, term: f64) -> f64 {
    let mut sums = [1.0; N];
    for _ in 0..STEPS {
        for i in 0..N {
            sums[i] = if cfg!(target_arch = "aarch64")
                || multiversion::target::target_cfg_f!(target_feature = "fma")
            {
                f64::mul_add(sums[i], factor, term)
            } else {
                sums[i] * factor + term
            };
        }
    }
    sums.iter().sum()
}

fn per_ns<const N: usize>() -> f64 {
    let run = || {
        let begin = Instant::now();
        black_box(multiply_add::<N>(black_box(0.999), black_box(0.001)));
        begin.elapsed().as_secs_f64() * 1e9
    };
    let best_ns = (0..50).map(|_| run()).fold(f64::INFINITY, f64::min);
    N as f64 * f64::from(STEPS) / best_ns
}

fn main() {
    // As many sums as hide the latency and fit into the registers, which differ in number and length.
    let widths = [per_ns::<32>(), per_ns::<48>(), per_ns::<64>(), per_ns::<96>(), per_ns::<128>()];
    println!("{:.2}", widths.into_iter().fold(0.0, f64::max));
}
