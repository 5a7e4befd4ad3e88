#!/bin/sh
# Slurm on this machine alone, for as long as a command and the jobs that it submits last; to try a job script before it
# goes to a cluster. Nothing is left of it afterwards, nothing of the system is changed, and any user may do it.
#
#   apt install slurmctld slurmd slurm-client munge
#   CPUS=1 sh one-node-slurm.sh sh slurm.sh project.toml results 10
set -eu
PATH=$PATH:/usr/sbin:/sbin
folder=$(mktemp -d)
chmod 755 "$folder"
mkdir "$folder/state" "$folder/spool"
host=$(hostname -s)
socket=$folder/munge.socket

cat > "$folder/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$folder/slurm.conf"

processes=""
end() {
  for process in $processes; do kill "$process" 2>/dev/null || true; done
  for process in $processes; do wait "$process" 2>/dev/null || true; done
  rm -rf "$folder"
}
trap end EXIT
trap 'exit 130' INT TERM

failed() {
  echo "one-node-slurm: $1 does not start:" >&2
  tail -n 5 "$folder/$2.log" >&2 || true
  exit 1
}

# until_is SECONDS COMMAND...: waits until the command says yes.
until_is() {
  tries=$(($1 * 10))
  shift
  while ! "$@" >/dev/null 2>&1; do
    tries=$((tries - 1))
    [ "$tries" -gt 0 ] || return 1
    sleep 0.1
  done
}

dd if=/dev/urandom of="$folder/munge.key" bs=1024 count=1 2>/dev/null
chmod 400 "$folder/munge.key"
munged --foreground --key-file="$folder/munge.key" --socket="$socket" --pid-file="$folder/munged.pid" \
  --seed-file="$folder/munge.seed" --log-file="$folder/munged.log" 2>"$folder/munged.log" &
processes="$!"
until_is 10 test -S "$socket" || failed munged munged
slurmctld -D 2>"$folder/slurmctld.err" &
processes="$! $processes"
slurmd -D -N "$host" 2>"$folder/slurmd.err" &
processes="$! $processes"
is_idle() { sinfo --noheader --format=%t | grep -q '^idle'; }
until_is 30 is_idle || failed slurmd slurmd

"$@"
is_done() { jobs=$(squeue --noheader) && [ -z "$jobs" ]; }
until is_done; do sleep 0.5; done
