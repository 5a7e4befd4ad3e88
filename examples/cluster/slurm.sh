#!/bin/sh
# A sweep by a job array of Slurm: each job solves a share of the points into a folder of its own, and a last one makes one
# folder of them, the same to the byte as that of one machine. Nothing but a shared disk joins the jobs.
#
#   sh slurm.sh project.toml results 100                                       # 100 shares, then the merge
#   sbatch --array=17 --cpus-per-task=4 slurm.sh project.toml results 100 solve  # one that failed, again alone
#   sbatch slurm.sh project.toml results 100 merge
#
# A share goes on where it was stopped. With another number of shares what is done is taken where it fits.
set -eu
project=$1 out=$2 shares=$3

case ${4:-submit} in
  submit)
    array=$(sbatch --parsable --array="1-$shares" --cpus-per-task="${CPUS:-4}" "$0" "$1" "$2" "$3" solve)
    sbatch --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes "$0" "$1" "$2" "$3" merge
    ;;
  solve)
    share=$out.shares/$SLURM_ARRAY_TASK_ID-of-$shares
    resume=""
    [ -d "$share" ] && resume=--resume
    exec loadpath sweep "$project" --shard "$SLURM_ARRAY_TASK_ID/$shares" --out "$share" $resume \
      --jobs "${SLURM_CPUS_PER_TASK:-1}" --quiet
    ;;
  merge) exec loadpath sweep "$project" --out "$out" --merge "$out.shares"/* ;;
esac
