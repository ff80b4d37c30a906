//! The recipes of `examples/cluster`, by the programs that start them, where these are there.

use super::{complaint, folder, program};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn recipe(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("examples/cluster")
        .join(name)
}

/// Runs a script in `folder`, with `halfdisk` and what administrators use on its path.
fn bash(folder: &Path, script: &str) -> Output {
    let bin = Path::new(env!("CARGO_BIN_EXE_halfdisk")).parent().unwrap();
    let path = std::env::var("PATH").unwrap_or_default();
    let output = Command::new("bash")
        .args(["-euc", script])
        .current_dir(folder)
        .env("PATH", format!("{}:{path}:/usr/sbin", bin.display()))
        .output();
    output.expect("bash starts")
}

/// True where all these programs are installed; else the test says that it was skipped.
fn is_there(folder: &Path, programs: &str) -> bool {
    let there = bash(folder, &format!("command -v {programs}"));
    if !there.status.success() {
        println!(
            "skipped: it takes {programs}, of Debian's packages in examples/cluster/one_node.sh"
        );
    }
    there.status.success()
}

const SETTINGS: &str = "cornell --size 48x40 --spp 4 --seed 2";

/// The picture of one render.
fn whole(folder: &Path) -> Vec<u8> {
    let arguments = format!("render {SETTINGS} --out whole.exr --quiet");
    let done = program(folder).args(arguments.split(' ')).status();
    assert!(done.unwrap().success());
    std::fs::read(folder.join("whole.exr")).unwrap()
}

#[test]
fn a_share_is_finished_once() {
    let folder = folder();
    let folder = folder.path();
    let shard = recipe("shard.sh");
    let shard = shard.display();
    let run = |i: u32| bash(folder, &format!("{shard} {i} 2 parts {SETTINGS}"));
    for i in [1, 2] {
        let output = run(i);
        assert!(output.status.success(), "{}", complaint(&output));
    }
    let file = folder.join("parts/part-1.exr");
    let time = || file.metadata().unwrap().modified().unwrap();
    let before = time();
    assert!(run(1).status.success());
    assert_eq!(time(), before, "nothing was left to do");
    // A part that was interrupted goes on. More samples are asked for than it has, as where it was killed.
    let more = "halfdisk render --resume parts/part-1.exr --spp 9000000 --quiet & sleep 1; kill -INT $!; wait $! || true";
    bash(folder, more);
    let info = || String::from_utf8(bash(folder, "halfdisk info parts/part-1.exr").stdout).unwrap();
    assert!(info().contains("\ninterrupted: "), "{}", info());
    let output = bash(
        folder,
        &format!("timeout -s INT 1 {shard} 1 2 parts {SETTINGS}"),
    );
    assert!(!output.status.success(), "it goes on for long");
    let damaged = std::fs::read(&file).unwrap();
    std::fs::write(&file, &damaged[..damaged.len() / 2]).unwrap();
    let output = run(1);
    assert!(complaint(&output).contains("parts/part-1.exr is no EXR picture"));
    assert!(
        !output.status.success(),
        "a damaged part is not a finished one"
    );
}

#[test]
fn gnu_parallel_makes_the_bytes_of_one_render() {
    let folder = folder();
    let folder = folder.path();
    if !is_there(folder, "parallel") {
        return;
    }
    let whole = whole(folder);
    let script = recipe("parallel.sh");
    let output = bash(folder, &format!("{} 5 a.exr {SETTINGS}", script.display()));
    assert!(output.status.success(), "{}", complaint(&output));
    assert!(std::fs::read(folder.join("a.exr")).unwrap() == whole);
    assert!(!folder.join("a.exr.parts").exists());
    let output = bash(
        folder,
        &format!(
            "BY=seeds {} 3 b.exr cornell --size 48x40 --spp 4",
            script.display()
        ),
    );
    assert!(output.status.success(), "{}", complaint(&output));
    let info = bash(folder, "halfdisk info b.exr").stdout;
    let info = String::from_utf8(info).unwrap();
    assert!(
        info.contains("average of 3 pictures, of the seeds 1-3"),
        "{info}"
    );
}

/// An array whose merge has the bytes of one render, and one that fails for good: its merge is cancelled.
#[test]
fn slurm_makes_the_bytes_of_one_render() {
    let folder = folder();
    let folder = folder.path();
    if !is_there(folder, "slurmctld slurmd munged sbatch") {
        return;
    }
    let whole = whole(folder);
    let [cluster, render] = ["one_node.sh", "render.slurm"].map(recipe);
    let (cluster, render) = (cluster.display(), render.display());
    let script = format!(
        "bash {render} 4 a.exr {SETTINGS}
         bash {render} 2 b.exr {SETTINGS} --integrator nothing
         for _ in $(seq 200); do [ -z \"$(squeue --noheader)\" ] && break; sleep 0.2; done
         scontrol show job"
    );
    std::fs::write(folder.join("jobs.sh"), script).unwrap();
    let output = bash(folder, &format!("CPUS=4 bash {cluster} bash -eu jobs.sh"));
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}\n{}", complaint(&output));
    assert!(
        std::fs::read(folder.join("a.exr")).unwrap() == whole,
        "{said}"
    );
    assert!(
        said.contains("JobState=CANCELLED Reason=DependencyNeverSatisfied"),
        "{said}"
    );
    assert!(
        said.contains("JobState=FAILED Reason=NonZeroExitCode"),
        "{said}"
    );
    assert!(!folder.join("b.exr").exists());
    let log = std::fs::read_to_string(folder.join("b.exr.parts/1.log")).unwrap();
    assert!(
        log.contains("invalid value 'nothing' for '--integrator"),
        "{log}"
    );
    assert!(!log.contains("tried again"), "bad input stays bad: {log}");
}
