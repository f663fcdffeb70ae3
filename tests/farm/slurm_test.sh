#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The scripts of docs/slurm on a Slurm of two nodes, both on this machine's loopback, started and
# ended here. A frame fails and is tried again, a node is lost in the middle; what comes out is what
# one run makes.
#
#   slurm_test.sh SOURCE_DIR BIN_DIR
#
# Skipped (status 77) where there is no Slurm, where this is not run by root, which needs no keys, or
# where Slurm's daemons cannot run.
set -euo pipefail
source_dir=$1 bin=$2
here=$source_dir/tests/farm scripts=$source_dir/docs/slurm
for program in slurmctld slurmd sbatch; do
    command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: not root"; exit 77; }

work=$(mktemp -d)
daemons=()
# What belongs to this Slurm and no other: tasks outlive a node that was killed.
ours() { grep -lsFz "SLURM_CONF=$work/" /proc/[0-9]*/environ | cut -d/ -f3 | grep -vx -e $$ -e $BASHPID; }
finish() {
    local status=$?
    trap - EXIT
    case $status in 0 | 77) ;; *) tail -n 20 "$work"/*.log "$work"/*.out || true ;; esac
    for pid in "${daemons[@]}"; do kill "$pid" 2>/dev/null || true; done
    for ((i = 0; i < 50; ++i)); do
        [ -n "$(ours)" ] || break
        # shellcheck disable=SC2046 # numbers
        [ $i != 25 ] || kill -KILL $(ours) 2>/dev/null || true
        sleep 0.1
    done
    wait
    rm -rf "$work"
    exit $status
}
trap finish EXIT
trap 'exit 1' INT TERM

mkdir -p "$work/state" "$work/spool" "$work/bin" "$work/files"
export SLURM_CONF=$work/slurm.conf
# Ports below those that the system gives out, others than those of a second run.
port=$((20000 + $$ % 4000 * 3))
sed -e "s,@WORK@,$work,g" -e "s,@USER@,$(id -un),g" -e "s,@PORT0@,$port,g" \
    -e "s,@PORT1@,$((port + 1)),g" -e "s,@PORT2@,$((port + 2)),g" "$here/slurm.conf.in" >"$SLURM_CONF"
echo "NodeName=n1 Name=gpu File=/dev/null" >"$work/gres.conf"
slurmctld -D >"$work/ctld.out" 2>&1 &
daemons+=($!)
for node in n1 n2; do
    slurmd -D -N $node >"$work/$node.out" 2>&1 &
    daemons+=($!)
done
node2=$!
up() { [ "$(timeout -s KILL 5 sinfo -h -t idle -o %D 2>/dev/null)" = 2 ]; }
begin=$SECONDS
while ((SECONDS < begin + 30)) && kill -0 "${daemons[0]}" 2>/dev/null && ! up; do sleep 0.5; done
up || { echo "skipped: Slurm does not start here: $(cat "$work"/*.out | grep -m 1 -i error || true)"; exit 77; }

# ddt, but for frame 3, whose first run finds a disk with room for one block, and for what runs first
# on n2, which would take long. Leaves the device that it was told.
cat >"$work/bin/ddt" <<END
#!/bin/bash
echo "\${DDT_DEVICE:-any}" >>"$work/devices"
if [[ "\$*" = *"--frames 3 "* ]] && mkdir "$work/tried" 2>/dev/null; then
    ulimit -f 1
elif [ "\$SLURMD_NODENAME" = n2 ] && mkdir "$work/lost" 2>/dev/null; then
    echo \$\$ >"$work/lost/number"
    exec sleep 600
fi
exec "$bin/ddt" "\$@"
END
chmod +x "$work/bin/ddt"
export PATH=$work/bin:$PATH

cd "$work/files"
for i in 1 2 3 4 5 6; do
    oiiotool "$source_dir/testimages/scene.png" --addc 0.0$i -o in.000$i.png
done
"$bin/ddt" resize in.#.png 300% one.#.png --threads 1 >/dev/null

timeout 90 sbatch --wait --array=1-6 --output="$work/frame-%a.log" "$scripts/frames.sbatch" in.#.png 300% \
    out.#.png --threads 1 &
array=$!
for ((i = 0; i < 300; ++i)); do
    [ -s "$work/lost/number" ] && break
    sleep 0.1
done
# The node's daemon, and the task with what runs it: a machine that is switched off.
parent() { ps -o ppid= -p "$1" | tr -d ' '; }
task=$(cat "$work/lost/number") || { echo "FAILED: nothing ran on n2"; exit 1; }
script=$(parent "$task")
lost=$(squeue -h -t running -w n2 -o %K)
kill -KILL "$node2" "$(parent "$script")" "$script" "$task"
scontrol update NodeName=n2 State=DOWN Reason="taken down by the test"
wait "$array" || { echo "FAILED: the array"; exit 1; }
[ -d "$work/tried" ] || { echo "FAILED: frame 3 did not fail"; exit 1; }
for i in 1 2 3 4 5 6; do
    cmp "one.000$i.png" "out.000$i.png" || { echo "FAILED: frame $i"; exit 1; }
done
[ "$(sort -u "$work/devices")" = cpu ] || { echo "FAILED: frames without a GPU on $(sort -u "$work/devices")"; exit 1; }
echo "six frames, one tried again, one node lost with frame $lost on it: the same bytes"

slurmd -D -N n2 >"$work/n2.out" 2>&1 &
daemons+=($!)
scontrol update NodeName=n2 State=RESUME || true
oiiotool "$source_dir/testimages/scene.png" --resize 700x520 -d half -o whole.exr
"$bin/ddt" resize whole.exr 200% one.exr --threads 1
# Left over from another command.
"$bin/ddt" resize whole.exr 200% out.exr.part-2-of-4.exr --part 2/4 --filter ddt-linear
ln -s "$scripts/parts.sh" parts
join=$(./parts 4 whole.exr 200% out.exr --threads 1)
for ((i = 0; i < 40; ++i)); do
    [ -z "$(squeue -h -j "$join" 2>/dev/null)" ] && break
    sleep 1
done
idiff -q one.exr out.exr || { echo "FAILED: four parts joined"; cat slurm-*.out; exit 1; }
[ ! -e out.exr.part-1-of-4.exr ] || { echo "FAILED: parts are left over"; exit 1; }
echo "four parts, joined after they were done: the same pixels"

rm "$work/devices"
ln -s in.0001.png in.0011.png
FIRST=010 timeout 60 sbatch --wait --array=1 --gpus=1 "$scripts/frames.sbatch" in.#.png 300% given.#.png --threads 1
[ "$(cat "$work/devices")" = any ] || { echo "FAILED: a frame with a GPU on $(cat "$work/devices")"; exit 1; }
cmp one.0001.png given.0011.png || { echo "FAILED: the frame with a GPU"; exit 1; }
echo "a frame with a GPU, the eleventh: not kept from it"

ln -s in.0001.png in.-003.png
FIRST=-004 timeout 60 sbatch --wait --array=1 "$scripts/frames.sbatch" in.#.png 300% given.#.png --threads 1
cmp one.0001.png given.-003.png || { echo "FAILED: the frame before the first"; exit 1; }
echo "frame -3, which no task is called"

# Of parts that fail: the join does not wait for ever.
join=$(CPUS=1 "$scripts/parts.sh" 2 whole.exr 100% out.exr --filter none)
for ((i = 0; i < 40; ++i)); do
    [ -z "$(squeue -h -j "$join" 2>/dev/null)" ] && break
    sleep 1
done
[ -z "$(squeue -h -j "$join" 2>/dev/null)" ] || { echo "FAILED: the join of failed parts waits"; exit 1; }
echo "two parts that failed: no join"
