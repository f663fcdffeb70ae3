#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# One image in N parts, and a job that joins them when all are there:
#
#   [CPUS=8] [GPUS=1] parts.sh N in.exr 800% out.exr [OPTIONS OF ddt resize]
#
# Prints the number of the joining job, which is cancelled where a part fails. CPUS: of each part, which
# then has as many threads; without it Slurm gives one, and ddt takes all that it may run on. GPUS: of each
# part.
set -euo pipefail
[[ $# -ge 4 && $1 =~ ^[1-9][0-9]*$ ]] || { echo "usage: parts.sh N IN SIZE OUT [OPTIONS OF ddt resize]" >&2; exit 2; }
rm -f -- "$4.joined-of-$1" # the mark of a join before, see join.sbatch
here=$(dirname "$(readlink -f "$0")")
parts=$(sbatch --parsable --array="1-$1" ${CPUS:+--cpus-per-task="$CPUS"} ${GPUS:+--gpus="$GPUS"} "$here/part.sbatch" "$@")
sbatch --parsable --requeue --job-name=ddt-join --dependency="afterok:$parts" \
    --kill-on-invalid-dep=yes "$here/join.sbatch" "$1" "$4"
