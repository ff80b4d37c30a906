//! What the processor must have.

/// Why this program cannot run on this processor: built for vectors of eight, it would be killed by the
/// first of their instructions, without a word.
///
/// The standard library's own question is answered by the compiler where it may assume the answer, so
/// the processor is asked itself.
#[cfg(all(target_arch = "x86_64", target_feature = "avx2"))]
pub(crate) fn lacks() -> Option<&'static str> {
    let processor = raw_cpuid::CpuId::new();
    let system = processor.get_feature_info();
    let saves = system.is_some_and(|f| f.has_oxsave() && f.has_avx());
    let more = processor.get_extended_feature_info();
    let has = more.is_some_and(|f| f.has_avx2() && f.has_bmi1() && f.has_bmi2());
    sentence(saves && has)
}

/// Programs built for any processor lack nothing.
#[cfg(not(all(target_arch = "x86_64", target_feature = "avx2")))]
pub(crate) fn lacks() -> Option<&'static str> {
    sentence(true)
}

fn sentence(complete: bool) -> Option<&'static str> {
    (!complete).then_some(
        "error: this program was built for processors with AVX2, which this one does not have: build it \
         with the environment variable RUSTFLAGS set, even to nothing (RUSTFLAGS= cargo build --release)",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_runs_lacks_nothing_and_what_lacks_something_is_told_the_cure() {
        assert_eq!(lacks(), None);
        let said = sentence(false).unwrap_or_default();
        assert!(said.contains("AVX2") && said.contains("RUSTFLAGS= cargo build"));
    }
}
