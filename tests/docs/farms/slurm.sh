#!/bin/sh
# SPDX-License-Identifier: MIT
#
# slurm.sh CHECKOUT PROGRAM: docs/farms/slurm.sh makes the film of a single run, on a Slurm cluster of
# this machine alone, which is started for it and ended afterwards. Exit code 77: it is not installed.
. "$(dirname "$0")/check.sh"
for tool in sbatch slurmctld slurmd munged mungekey; do
    PATH=$PATH:/usr/sbin command -v $tool >/dev/null || skip "$tool is not installed (slurm-wlm, munge)"
done
[ "$(id -u)" -eq 0 ] || skip 'only root can start the daemons of Slurm for others'
PATH=$PATH:/usr/sbin

daemons=''
stop_daemons() {
    for daemon in $daemons; do
        kill "$daemon" 2>/dev/null || continue
        wait "$daemon" 2>/dev/null || true
    done
}

# port N: one that nobody listens at, from N on
port() {
    candidate=$1
    while grep -qi ":$(printf '%04X' "$candidate") " /proc/net/tcp /proc/net/tcp6; do
        candidate=$((candidate + 1))
    done
    echo "$candidate"
}

chmod 755 "$work"
mkdir -m 755 munge state spool
mungekey --create --keyfile="$work/munge/key"
munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
    --pid-file="$work/munge/pid" --log-file="$work/munge/log" --seed-file="$work/munge/seed" \
    >munge/output 2>&1 &
daemons="$!"

host=$(hostname -s)
cat >slurm.conf <<CONF
ClusterName=check
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(port 16817)
SlurmdPort=$(port 26818)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$work/slurm.conf"
for _ in 1 2 3 4 5 6 7 8 9 10; do
    [ ! -S munge/socket ] || break
    sleep 1
done
slurmctld -D -f "$SLURM_CONF" >slurmctld.log 2>&1 &
daemons="$! $daemons"
slurmd -D -f "$SLURM_CONF" -N "$host" >slurmd.log 2>&1 &
daemons="$! $daemons"
for _ in $(seq 60); do
    [ "$(sinfo -h -o %t 2>/dev/null)" != idle ] || break
    sleep 1
done
if [ "$(sinfo -h -o %t 2>/dev/null)" != idle ]; then
    tail -n 20 munge/output slurmctld.log slurmd.log >&2
    fail 'the cluster did not come up'
fi

# wait_for JOB: until nothing of it is waiting or running
wait_for() {
    for _ in $(seq 300); do
        [ -n "$(squeue -h -j "$1" 2>/dev/null)" ] || return 0
        sleep 1
    done
    squeue >&2
    tail -n 20 part-*.log slurmctld.log slurmd.log >&2
    fail "job $1 did not end"
}

export FOLDER="$work/parts"
fails_once 75 100-149
merge=$("$checkout/docs/farms/slurm.sh" "$work/film.mkv")
wait_for "$merge"
[ -f film.mkv ] || { tail -n 20 ./*.log >&2; fail 'there is no film'; }
expect_whole film.mkv
[ "$(wc -l <attempts)" -eq 2 ] || fail 'the part that was stopped was not tried again'

# What would fail again is tried once, and nothing is joined.
rm -f part-*.log
merge=$(FILM='tumbler --colour blue' FOLDER="$work/others" "$checkout/docs/farms/slurm.sh" "$work/other.mkv")
wait_for "$merge"
[ ! -f other.mkv ] || fail 'a film was made of nothing'
for log in part-*.log; do
    [ "$(grep -c -e '--colour' "$log")" -eq 1 ] || { cat "$log" >&2; fail 'it was tried again'; }
done
