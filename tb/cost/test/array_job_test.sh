#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# array_job_test.sh SOURCE BLYSK parallel|slurm: the sweep of docs/examples/sweep.sbatch in four parts, by GNU parallel or as an
# array job of a Slurm of this machine, has the rows of one run, byte for byte; one part is killed and goes on. Exit 77
# where the engine is not installed.
set -euo pipefail
source=$1 blysk=$2 engine=$3
work=$(mktemp -d)
cleanup() {
  if [ -f "$work/node/slurm.conf" ]; then "$source/scripts/slurm" stop "$work/node" || true; fi
  rm -rf "$work"
}
trap cleanup EXIT
cd "$work"
sweep=(explore --cos 8..9 --coefficient 7..8)
# A part that a kill ended: one of its rows is there, the file of another was begun.
"$blysk" "${sweep[@]}" --shard 2/4 --output part2 >killed
rm part2/coefficient_*.json
case $engine in
  parallel)
    command -v parallel >/dev/null || { echo 'GNU parallel is not installed' && exit 77; }
    parallel "$blysk" "${sweep[@]}" --shard '{}/4' --output 'part{}' ::: 1 2 3 4 >rows
    ;;
  slurm)
    PATH=$PATH:/usr/sbin
    settings=$("$source/scripts/slurm" start "$work/node") || exit $?
    eval "$settings"
    BLYSK=$blysk sbatch --wait "$source/docs/examples/sweep.sbatch"
    ;;
esac
"$blysk" explore merge part1 part2 part3 part4 --output merged >rows
"$blysk" "${sweep[@]}" --output one >rows
diff -r one merged
[ "$(find merged -name 'coefficient_*.json' | wc -l)" = 4 ] || { echo 'expected four rows' && exit 1; }
