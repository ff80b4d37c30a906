#!/bin/bash
# A Slurm cluster of this one machine, to try recipes on: starts it, runs a command in it, and ends it.
#
#   bash examples/cluster/one_node.sh COMMAND [ARGUMENTS]
#   bash examples/cluster/one_node.sh sbatch --wait --wrap hostname
#
# Debian's packages, as root:
#   apt-get install --no-install-recommends slurm-wlm slurmd slurmctld munge
# All its files are in a temporary folder; a Slurm that is at work here is left alone. CPUS=8 bash ... says that there are eight
# cores, however many there are.
set -euo pipefail
cpus=${CPUS:-$(nproc)}
folder=$(mktemp -d /tmp/one-node-XXXXXX)
chmod 755 "$folder"
host=$(hostname -s)
user=$(id -un)
export SLURM_CONF=$folder/slurm.conf

dd if=/dev/urandom of="$folder/key" bs=1024 count=1 2> "$folder/dd.log"
chmod 400 "$folder/key"
cat > "$SLURM_CONF" << END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
SlurmUser=$user
SlurmdUser=$user
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SlurmdParameters=config_overrides
SwitchType=switch/none
ReturnToService=2
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SchedulerType=sched/backfill
SchedulerParameters=bf_interval=1,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$cpus State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
mkdir "$folder/state" "$folder/spool"

end() {
    for daemon in slurmd slurmctld munged; do
        [ -f "$folder/$daemon.pid" ] && kill "$(cat "$folder/$daemon.pid")" 2> /dev/null || true
    done
    sleep 0.5
    rm -rf "$folder"
}
trap end EXIT
munged --force --key-file="$folder/key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/seed"
slurmctld -f "$SLURM_CONF" -c
slurmd -f "$SLURM_CONF" -c
for _ in $(seq 60); do
    [ "$(sinfo --noheader --format=%T 2> /dev/null)" = idle ] && break
    sleep 0.25
done
if [ "$(sinfo --noheader --format=%T)" != idle ]; then
    echo "the node is not idle after 15 seconds:" >&2
    tail -n 5 "$folder"/*.log >&2
    exit 1
fi
"$@"
