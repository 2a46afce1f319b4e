#!/usr/bin/env bash
# Renders a film on many machines: by Slurm, over ssh, or on a farm that reads job files.
#
# All that its pictures depend on, this tool among it, is copied to DIR/farm/HASH, which is named by it: a preset that is
# edited or a tool that is built anew while the film renders changes nothing, and another film is another folder.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<'TEXT'
Usage: scripts/farm.sh PRESET [options]

Hands a film to Slurm: a job array renders its frames, a job that waits for them leaves DIR/film.mp4 and DIR/contact.png,
or DIR/still.png, which is rendered in bands. DIR must be on a disk that all machines see under one name. The same call
again goes on where a farm was stopped: what is finished is not rendered again. See docs/farm.md.

  -o DIR              where to (out/<preset name>)
  --partition P       where the jobs go
  --site FILE         what this site's farm needs, JSON: partition, account, qos, cpus, memory, minutes, modules, options
  --chunk N           frames a task (4)
  --bands N           tasks of a still (8)
  --frames A-B, --size WxH, --scale N, --quality Q, --set POINTER=VALUE, --assets DIR
                      as for scripts/render.sh

  --hosts A,B,...     renders over ssh on these machines instead, by GNU parallel, and waits
  --openjd FILE       writes an Open Job Description template instead ("jobtemplate-2023-09")
  --opencue FILE      writes a job for OpenCue instead (CJSL 1.15)

  --status            says how far the film is
  --cancel            ends its jobs
  --logs              prints the ends of their logs
  -h, --help          this text

Examples:
  scripts/farm.sh presets/reef.json --partition render --size 1920x1080 --quality good
  scripts/farm.sh presets/reef.json --hosts anna,berta,clara --frames 1-48
  scripts/farm.sh presets/reef.json --status

Exit codes: 0 done, 1 could not (disk, Slurm, POV-Ray), 2 wrong input.
FROND_BIN, FROND_POVRAY, FROND_FFMPEG and FROND_UNCONFINED are handed on to the tasks.
TEXT
}

preset='' out='' site='' partition='' chunk=4 bands=8 hosts='' openjd='' opencue='' action=submit frames='' assets='' pass=()
take() {  # OPTION VALUE
  case $1 in
    -o | --out) out=$2 ;;
    --site) site=$2 ;;
    --partition) partition=$2 ;;
    --hosts) hosts=$2 ;;
    --openjd) openjd=$2 ;;
    --opencue) opencue=$2 ;;
    --frames) frames=$2 ;;
    --assets) assets=$2 ;;
    --chunk | --bands)
      [[ $2 =~ ^[1-9][0-9]{0,4}$ ]] || bad_usage "$1 needs a number from 1 on, not '$2'"
      if [[ $1 == --chunk ]]; then chunk=$2; else bands=$2; fi
      ;;
    *) pass+=("$1=$2") ;;  # frond knows what is right
  esac
  [[ -n $2 ]] || bad_usage "$1 needs a value"
}
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --status | --cancel | --logs) action=${1#--} ;;
    --*=*) set -- "${1%%=*}" "${1#*=}" "${@:2}"; continue ;;
    -o | --out | --site | --partition | --hosts | --openjd | --opencue | --frames | --assets | --chunk | --bands | --size | --scale | --quality | --set)
      (($# > 1)) || bad_usage "$1 needs a value"
      take "$1" "$2"
      shift
      ;;
    -?*) unknown_option "$1" ;;
    *)
      [[ -z $preset ]] || bad_usage "one preset at a time: '$preset', and then '$1'"
      preset=$1
      ;;
  esac
  shift
done

[[ -n $preset ]] || bad_usage "which preset?"
[[ -f $preset ]] || fail 2 "$preset: no such preset"
if [[ -n $hosts && ! $hosts =~ ^[A-Za-z0-9][A-Za-z0-9@._:-]*(,[A-Za-z0-9][A-Za-z0-9@._:-]*)*$ ]]; then
  bad_usage "--hosts needs names of machines with commas between them, not '$hosts'"
fi
farm=$(realpath -m -- "${out:-out/$(basename -- "$preset" .json)}")/farm
[[ $farm != *[[:cntrl:]]* ]] || fail 2 "the name of the folder holds a line break, which farms cannot bear"
frond=${FROND_BIN:-$root/build/frond}

needs() { command -v "$1" >/dev/null || fail 1 "$1: no such program; $2"; }

# jobs_of STATES: how many tasks of the film are in the queue, by state.
jobs_of() {
  local ids
  ids=$(cat -- "$farm/latest/jobs" 2>/dev/null) || return 0
  squeue --noheader --array --jobs="$ids" --states="$1" --format=%T 2>/dev/null | sort | uniq -c || true
}

show_status() {
  local failed
  "$farm/latest/tool/scripts/farm_task.sh" "$farm/latest" 1 status
  if command -v squeue >/dev/null; then
    jobs_of all | awk '$2 ~ /RUNNING|PENDING|COMPLETING/ { print $1 " tasks are " tolower($2) }'
  fi
  for failed in "$farm"/latest/failed/*; do
    if [[ -f $failed ]]; then printf '%s failed: %s\n' "${failed##*/}" "$(head -n 3 -- "$failed" | tr '\n' ' ')"; fi
  done
  find "$farm/.." -maxdepth 1 \( -name film.mp4 -o -name still.png \) -newer "$farm/latest/manifest.json" -printf '%f is there\n'
}

if [[ $action != submit ]]; then
  [[ -d $farm/latest ]] || fail 2 "$farm: no film was handed to a farm there"
  case $action in
    status) show_status ;;
    cancel)
      needs scancel "this machine is no part of a Slurm cluster"
      if [[ -f $farm/latest/jobs ]]; then
        IFS=, read -r -a ids <"$farm/latest/jobs"
        said=$(scancel "${ids[@]}" 2>&1) || fail 1 "the jobs could not be ended: $said"
      fi
      ;;
    logs) find "$farm/latest/log" -type f -size +0 -print0 | sort -z | xargs -0r tail -n 20 ;;
  esac
  exit 0
fi

if [[ -z ${FROND_BIN:-} ]]; then
  "$root/scripts/setup.sh" --quiet
  (tied "$root/scripts/build.sh")
fi
frond=$(command -v "$frond") || fail 1 "$frond: no such program"
options=()
if [[ -n $site ]]; then options+=("--site=$site"); fi
cpus=$("$frond" farm cpus / "${options[@]}")  # and so the file is read, before all else
if [[ -n $hosts ]]; then
  cpus=0
  needs parallel "--hosts needs GNU parallel: apt-get install parallel"
elif [[ -z $openjd$opencue ]]; then
  needs sbatch "this machine is no part of a Slurm cluster; --hosts and --openjd need none"
  if [[ -n $partition && -z $(sinfo --noheader --partition="$partition" --format=%P 2>/dev/null) ]]; then
    there=$(sinfo --noheader --format=%R) || fail 1 "Slurm does not answer"
    fail 2 "--partition: there is no '$partition'; there is $(sort -u <<<"$there" | paste -sd ' ')"
  fi
  waiting=$(jobs_of PENDING,RUNNING,COMPLETING)
  [[ -z $waiting ]] || fail 2 "$farm: a farm is at work there; see --status, or end it with --cancel"
fi

# All that pictures depend on, in a folder that is named by it.
no_link "$farm"
mkdir -p -- "$farm" 2>/dev/null || fail 1 "$farm: the folder cannot be made"
new=$farm/.new.$HOSTNAME.$$
mkdir -- "$new" 2>/dev/null || fail 1 "$farm: cannot be written to"
trap 'rm -rf -- "$new"' EXIT
here=$(realpath -s -- .)
preset=$(realpath -s -- "$preset")
"$frond" files "$preset" "${pass[@]}" ${assets:+"--assets=$assets"} >"$new/list" || exit $?
if [[ -n $assets ]]; then assets=$(realpath -s -- "$assets"); fi
mkdir -p -- "$new/tool/scripts" "$new"/{frames,models,log,failed} "$new/files$here" "$new/files$assets"
if ! said=$({ cp -- "$root"/scripts/*.{sh,ini} "$new/tool/scripts" && cp -r -- "$root/povinc" "$root/templates" "$new/tool" &&
  cp -- "$frond" "$new/tool/frond" && xargs -0 realpath -sz -- <"$new/list" | xargs -0 cp --parents -t "$new/files" --; } 2>&1); then
  fail 1 "$farm could not be written: $said"
fi
rm -- "$new/list"
printf '%s\0' "$here" "$preset" "$assets" "${pass[@]}" >"$new/call"
key=$({
  printf '%s\0' "$preset" "$assets" "${pass[@]}"
  cd -- "$new" && find tool files -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum
} | sha256sum | cut -c-16)
folder=$farm/$key
no_link "$folder" "$folder"/* "$folder"/{failed,log}/*
if [[ ! -d $folder ]]; then mv -T -- "$new" "$folder"; fi
ln -sfnT -- "$key" "$farm/latest"
rm -f -- "$folder"/failed/* "$folder/bands"
"$frond" farm modules "$folder" "${options[@]}" >"$folder/modules"
for name in FROND_POVRAY FROND_FFMPEG FROND_UNCONFINED; do
  if [[ -n ${!name:-} ]]; then printf '%s=%s\n' "$name" "${!name}"; fi
done >"$folder/environment"

# What is to be done. Pictures that are damaged go here, and so are made again.
task=$folder/tool/scripts/farm_task.sh most=100000
if [[ -z $hosts$openjd$opencue ]]; then
  largest=$(scontrol show config 2>/dev/null | sed -n 's/^MaxArraySize *= *//p')
  most=$((${largest:-1001} - 1))
fi
plan=$("$task" "$folder" 1 plan "$chunk" "$bands" "$most" ${frames:+"--frames=$frames"}) || exit $?
{ read -r -a work && read -r tasks && read -r -a list && read -r what; } <<<"$plan"

if [[ -n $openjd$opencue ]]; then
  write() {  # FORMAT FILE
    "$frond" farm "$1" "$folder" "${work[@]}" --out="$2" --name="$(basename -- "$preset" .json)" --tasks="${tasks:-1}" \
      "${options[@]}" || fail 1 "$2 could not be written"
  }
  if [[ -n $openjd ]]; then write openjd "$openjd"; fi
  if [[ -n $opencue ]]; then write opencue "$opencue"; fi
  exit 0
fi

if [[ -n $hosts ]]; then
  say "Rendering $what on ${hosts//,/, }"
  # Lines that parallel reads are commands of a shell, which the words are quoted for.
  for number in "${list[@]}"; do
    words=("$task" "$folder" 0 "${work[@]}" "$number")
    printf '%s\0' "exec ${words[*]@Q}"
  done | parallel -0 --will-cite --sshlogin "1/${hosts//,/,1/}" --retries 3 --joblog "$folder/log/hosts" >&2 ||
    fail 1 "not all frames could be rendered; those that are finished are kept"
  "$task" "$folder" 0 film || exit $?
  find "$farm/.." -maxdepth 1 \( -name film.mp4 -o -name contact.png -o -name still.png \) -newer "$folder/manifest.json"
  exit 0
fi

mapfile -d '' -t words < <("$frond" farm sbatch "$folder" --name="$(basename -- "$preset" .json)" "${options[@]}")
if [[ -n $partition ]]; then words+=("--partition=$partition"); fi
words+=(--parsable --requeue --open-mode=append "--chdir=$folder")
submit() {  # WORD...
  local said
  said=$(sbatch "${words[@]}" "$@" 2>&1) || fail 1 "sbatch: $said"
  said=$(tail -n 1 <<<"$said")
  printf '%s\n' "${said%%;*}"
}
after=() array=''
if [[ -n $tasks ]]; then
  array=$(submit "--array=$tasks" --output=log/%A_%a.log "$task" "$folder" "$cpus" "${work[@]}")
  printf '%s\n' "$array" >"$folder/jobs"
  after=("--dependency=afterok:$array" --kill-on-invalid-dep=yes)
fi
film=$(submit "${after[@]}" --output=log/film_%j.log "$task" "$folder" "$cpus" film)
printf '%s\n' "${array:+$array,}$film" >"$folder/jobs"
if [[ -n $array ]]; then say "Submitted $what as job $array"; else say "Nothing to render: all frames are there"; fi
say "Submitted the film as job $film; see --status"
