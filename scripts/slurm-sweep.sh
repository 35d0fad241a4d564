#!/usr/bin/env bash
#SBATCH --job-name=forage-sweep
#SBATCH --array=1-64
#SBATCH --cpus-per-task=4
#SBATCH --time=04:00:00
#SBATCH --requeue
#
# A sweep as a Slurm array, a shard a task:
#
#   job=$(sbatch --parsable scripts/slurm-sweep.sh sweep.toml)
#   sbatch --dependency=afterok:$job --wrap "forage experiment sweep.toml --merge sweep.*-of-64.csv"
#
# A task that was killed goes on where it stopped when it is queued again (sbatch --array=7,12 …). SHARDS must be the
# array's last number in all of them.
set -euo pipefail
"${FORAGE:-forage}" experiment "${1:?the sweep’s file}" --shard "$SLURM_ARRAY_TASK_ID/${SHARDS:-64}" --jobs "${SLURM_CPUS_PER_TASK:-1}"
