#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# One image in N parts, and a job that joins them when all are there:
#
#   parts.sh N in.exr 800% out.exr [OPTIONS OF ddt resize]
#
# Prints the number of the joining job.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
parts=$(sbatch --parsable --array="1-$1" "$here/part.sbatch" "$@")
sbatch --parsable --requeue --job-name=ddt-join --dependency="afterok:$parts" "$here/join.sbatch" "$1" "$4"
