#!/bin/sh
# SPDX-License-Identifier: MIT
#
# slurm.sh OUTPUT.mkv
#
# A film made by a Slurm cluster: an array of jobs, one for each part, and a job that joins the parts
# when all are there. FILM, FRAMES, PART and FOLDER as in part.sh; the folder is one that all machines
# see. Prints the number of the job that joins.
set -eu
HERE=$(cd "$(dirname "$0")" && pwd)
OUTPUT=$1
: "${BOXREEL:=boxreel}" "${FRAMES:=600}" "${PART:=100}" "${FOLDER:=parts}"
export HERE OUTPUT BOXREEL FRAMES PART FOLDER
mkdir -p "$FOLDER"

parts=$(sbatch --parsable --array="0-$(((FRAMES - 1) / PART))" <<'SCRIPT'
#!/bin/sh
#SBATCH --job-name=film-part
#SBATCH --ntasks=1
#SBATCH --requeue --open-mode=append --output=part-%a.log
trap : TERM # for boxreel, which then leaves what can be continued
srun --ntasks=1 "$HERE/part.sh" "$SLURM_ARRAY_TASK_ID" && exit 0
code=$?
# 4, 75 and what a signal ended may go better another time, the others never.
case $code in
    4 | 75 | 1[2-9][0-9])
        if [ "${SLURM_RESTART_COUNT:-0}" -lt 3 ]; then
            scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
        fi
        ;;
esac
exit $code
SCRIPT
)
exec sbatch --parsable --dependency="afterok:$parts" --kill-on-invalid-dep=yes <<'SCRIPT'
#!/bin/sh
#SBATCH --job-name=film-merge
#SBATCH --ntasks=1 --output=merge.log
exec "$HERE/merge.sh" "$OUTPUT"
SCRIPT
