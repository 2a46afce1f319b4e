#!/usr/bin/env bash
# One task of a film on a farm, which `frond task` does: in the environment that was there when the film was handed over,
# with the modules that the site loads. Queues run a copy of this file from elsewhere: its folder is told, not found.
set -euo pipefail
case ${1:-} in '' | -h | --help)
  printf 'Usage: farm_task.sh FOLDER CPUS frames|bands|film [NUMBER...]\n\nDoes one task of the job in FOLDER, which frond farm has made; queues call it. See frond task --help.\n'
  exit 0 ;;
esac
folder=$1
while IFS= read -r line; do export "${line?}"; done <"$folder/environment"
if [[ -s $folder/modules ]]; then
  set +u  # what sites write does not hold to it
  for file in /etc/profile.d/{modules,lmod,z00_lmod}.sh; do
    # shellcheck disable=SC1090
    if ! declare -F module >/dev/null && [[ -r $file ]]; then . "$file"; fi
  done
  while IFS= read -r module <&3; do
    module load "$module" || { printf 'error: module %s could not be loaded on %s\n' "$module" "$HOSTNAME" >&2 && exit 1; }
  done 3<"$folder/modules"
  set -u
fi
FROND_HOME=$folder/tool exec "$folder/tool/frond" task "$@"
