#!/bin/sh
# A sweep by MPI: the ranks share its points, the first hands them out and writes one folder. It is the same folder, to the
# byte, as that of `loadpath sweep` on one machine.
#
#   sh mpi.sh project.toml results 8       # 8 ranks that solve, on this machine
#   salloc -n 257 sh mpi.sh project.toml results 256
#
# Where a rank is lost, mpirun ends all of them. What the folder holds by then stays: run the same line again.
set -eu
project=$1 out=$2 ranks=$3

resume=""
[ -d "$out" ] && resume=--resume

# One rank more than solve: the first sleeps most of the time, hence --oversubscribe. The project is read by every rank:
# it stands on a disk that all machines share. Elsewhere: mpirun --hostfile machines.
mpirun --oversubscribe -n $((ranks + 1)) loadpath-mpi sweep "$project" --out "$out" $resume
