//! What robustness costs: the plain form of each computation, and ours.
#![allow(missing_docs)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use halfdisk::experiment::robustness::{CALLS, pairs};

fn forms(c: &mut Criterion) {
    for pair in pairs() {
        let mut group = c.benchmark_group(pair.name);
        group.throughput(Throughput::Elements(CALLS as u64));
        group.bench_function(format!("plain: {}", pair.plain_form), |b| {
            b.iter(&pair.plain)
        });
        group.bench_function(format!("ours: {}", pair.robust_form), |b| {
            b.iter(&pair.robust)
        });
        group.finish();
    }
}

criterion_group!(all, forms);
criterion_main!(all);
