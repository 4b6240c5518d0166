//! Wavelengths side by side: every inner loop of the kernels runs over them, and the compiler turns it
//! into the vector instructions of the processor it finds.

/// Wavelengths computed side by side, a multiple of every processor's vector length; enough of them that
/// one layer's arithmetic hides the latency of another's.
pub(crate) const LANES: usize = 32;

/// One number for each lane.
pub(crate) type Lanes<T> = [T; LANES];

/// Whether the function that asks was compiled for a processor that multiplies and adds in one step.
/// Elsewhere `mul_add` would be a slow call.
macro_rules! fused {
    () => {
        cfg!(target_arch = "aarch64") || multiversion::target::target_cfg_f!(target_feature = "fma")
    };
}
pub(crate) use fused;
