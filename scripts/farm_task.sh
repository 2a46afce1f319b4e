#!/usr/bin/env bash
# One task of a film on a farm. It may be run again, anywhere, at any time, also twice at once: what is finished is skipped,
# and a picture comes into the shared folder whole or not at all.
#
# Frame n is a pure function of the preset, so a task generates what it renders, on a disk of its own machine. Queues run a
# copy of this file from elsewhere: its folder is told, not found.
set -euo pipefail

usage() {
  cat <<TEXT
Usage: farm_task.sh FOLDER CPUS frames FIRST LAST CHUNK [TASK]
       farm_task.sh FOLDER CPUS bands N [TASK]
       farm_task.sh FOLDER CPUS film

Does one task of the job in FOLDER, which scripts/farm.sh has made: renders the TASK-th CHUNK of frames FIRST to LAST, or
the TASK-th of N bands of a still, or makes the film of what is rendered. Queues call it. Without TASK it is
\$SLURM_ARRAY_TASK_ID; CPUS is how many processors to use, 0 all.
TEXT
}
case ${1:-} in '' | -h | --help) usage; exit 0 ;; esac

folder=$1 cpus=$2 work=$3
shift 3
tool=$folder/tool
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$tool/scripts/lib.sh"
if ((cpus == 0)); then cpus=$(nproc); fi
while IFS= read -r line; do export "${line?}"; done <"$folder/environment"

load_modules() {
  local file module
  if [[ ! -s $folder/modules ]]; then return; fi
  set +u  # what sites write does not hold to it
  for file in /etc/profile.d/{modules,lmod,z00_lmod}.sh; do
    # shellcheck disable=SC1090
    if ! declare -F module >/dev/null && [[ -r $file ]]; then . "$file"; fi
  done
  while IFS= read -r module <&3; do
    module load "$module" || fail 1 "module $module could not be loaded on $HOSTNAME"
  done 3<"$folder/modules"
  set -u
}

# A folder of this task's own on this machine; what killed tasks have left goes.
make_local() {
  local near=${SLURM_TMPDIR:-${TMPDIR:-/tmp}} left lock
  while IFS= read -r -d '' left; do
    { exec {lock}<"$left"; } 2>/dev/null || continue
    if flock --nonblock "$lock"; then rm -rf -- "$left"; fi
    exec {lock}<&-
  done < <(find "$near" -maxdepth 1 -name "frond-farm.$UID.*" -mmin +1 -print0 2>/dev/null)
  local=$(mktemp -d -- "$near/frond-farm.$UID.XXXXXX") || fail 1 "$near: no folder can be made there on $HOSTNAME"
  trap 'rm -rf -- "$local"' EXIT
  exec {lock}<"$local"
  flock "$lock"
}

# generate FOLDER OPTION...: calls frond as the film was asked for.
generate() {
  local call out=$1
  shift
  mapfile -d '' -t call <"$folder/call"
  (cd -- "$folder/files${call[0]}" &&
    FROND_HOME=$tool tied "$tool/frond" generate "$folder/files${call[1]}" ${call[2]:+"--assets=$folder/files${call[2]}"} \
      "${call[@]:3}" "--out=$out" -q "$@")
}

# prepare NAME OPTION...: generates in the task's own folder. Files beside frames bear the name of what is in them: what
# one task has grown serves all, and only one brings it.
prepare() {
  local file said=$local/said name=$1 status=0
  shift
  mkdir -p -- "$local/frames"
  find "$folder/models" -type f ! -name '.*' -exec cp -t "$local/frames" -- {} +
  generate "$local" "--threads=$cpus" "$@" 2>"$said" || status=$?
  cat -- "$said" >&2
  if ((status != 0)); then
    cp --remove-destination -T -- "$said" "$folder/failed/$name" || true
    exit "$status"
  fi
  rm -f -- "$folder/failed/$name"
  for file in "$local"/frames/*; do
    if [[ $file == */frame_* || -e $folder/models/${file##*/} ]]; then continue; fi
    (set -o noclobber && : >"$folder/models/.${file##*/}.claim") 2>/dev/null || continue
    deliver "$file" "$folder/models/${file##*/}"
  done
  cd -- "$local"
}

# deliver FILE PLACE: copies it there, whole or not at all; a shared disk may be away for a while.
deliver() {
  local part said wait
  part=${2%/*}/.${2##*/}.$HOSTNAME.$BASHPID.part
  for wait in 1 2 4 8 16 0; do
    if said=$(cp --remove-destination -T -- "$1" "$part" 2>&1 && sync -- "$part" 2>&1 && mv -fT -- "$part" "$2" 2>&1); then return; fi
    rm -f -- "$part" 2>/dev/null || true
    if full_disk "$said"; then fail 1 "$2 could not be written: $no_room"; fi
    if ((wait > 0)); then sleep "$wait"; fi
  done
  fail 1 "$2 could not be written: $said"
}

# render SCENE NAME FLAG...: a picture, into the shared folder. What is said of one that fails is kept there, too.
render() {
  local scene=$1 name=$2 flags said=$local/$2.said status=0
  shift 2
  read -r -a flags <<<"$(sed -n 's/^flags = //p' build.ninja)"
  "$tool/scripts/render_frame.sh" "frames/$scene.pov" "frames/$name.png" "$(sed -n 's/^size = //p' build.ninja)" \
    "${flags[@]}" "$@" 2>"$said" || status=$?
  cat -- "$said" >&2
  if ((status != 0)); then
    cp --remove-destination -T -- "$said" "$folder/failed/$name" || true
    return 1
  fi
  deliver "frames/$name.png" "$folder/frames/$name.png"
  rm -f -- "frames/$name.png" "$folder/failed/$name"
  say "$name.png is done, on $HOSTNAME"
}

# render_frames FIRST LAST CHUNK TASK
render_frames() {
  local from=$(($1 + ($4 - 1) * $3)) to number name missing=() failed=0 running=0
  to=$((from + $3 - 1 < $2 ? from + $3 - 1 : $2))
  for ((number = from; number <= to; ++number)); do
    printf -v name 'frame_%04d' "$number"
    if ! whole_png "$folder/frames/$name.png"; then missing+=("$number"); fi
  done
  if ((${#missing[@]} == 0)); then
    say "Frames $from to $to are done already"
    return
  fi
  prepare "frames_$from-$to" "--frames=${missing[0]}-${missing[-1]}"
  export FROND_THREADS=$((cpus > ${#missing[@]} ? cpus / ${#missing[@]} : 1))
  for number in "${missing[@]}"; do
    if ((running == cpus)); then
      wait -n || failed=$((failed + 1))
      running=$((running - 1))
    fi
    printf -v name 'frame_%04d' "$number"
    render "$name" "$name" &
    running=$((running + 1))
  done
  for ((; running > 0; --running)); do wait -n || failed=$((failed + 1)); done
  if ((failed > 0)); then fail 1 "$failed of ${#missing[@]} frames could not be rendered on $HOSTNAME"; fi
}

# rows N BAND HEIGHT: sets `top` and `below`. Anti-aliasing looks at neighbours within POV-Ray's blocks of 32 rows and not
# beyond, so bands that end where blocks do have the pixels of the whole picture.
rows() {
  local blocks=$((($3 + 31) / 32))
  top=$(((($2 - 1) * blocks / $1) << 5)) below=$((($2 * blocks / $1) << 5))
  if ((below > $3)); then below=$3; fi
}

# render_band N BAND
render_band() {
  local name=band_$2_of_$1 size top below
  if whole_png "$folder/frames/$name.png"; then
    say "Band $2 is done already"
    return
  fi
  prepare "$name"
  size=$(sed -n 's/^size = //p' build.ninja)
  rows "$1" "$2" "${size#*x}"
  export FROND_THREADS=$cpus
  render frame_0001 "$name" "+SR$((top + 1))" "+ER$below" || fail 1 "band $2 could not be rendered on $HOSTNAME"
}

# Where the pixels of a PNG begin.
pixels_at() {
  local at=8 b
  while read -r -a b < <(od -An -v -tu1 -j "$at" -N 8 -- "$1") && ((${#b[@]} == 8)); do
    if ((b[4] == 73 && b[5] == 68 && b[6] == 65 && b[7] == 84)); then break; fi  # IDAT
    at=$((at + ((b[0] * 256 + b[1]) * 256 + b[2]) * 256 + b[3] + 12))
  done
  echo "$at"
}

# remove_damaged N: bands that cannot be read, so that they are rendered again.
remove_damaged() {
  local band
  for band in frames/band_*_of_"$1".png; do
    "${FROND_FFMPEG:-ffmpeg}" -nostdin -loglevel quiet -xerror -err_detect crccheck+explode -i "file:$band" -f null - && continue
    say "$band is damaged; the same call of farm.sh makes it again"
    rm -f -- "$band"
  done
}

# join_bands N SIZE: the rows of the bands as one picture, with what POV-Ray says of its colours.
join_bands() {
  local n=$1 band inputs=() filter='' stacked='' top below first=frames/band_1_of_$1.png
  for ((band = 1; band <= n; ++band)); do
    whole_png "frames/band_${band}_of_$n.png" "$2" || fail 1 "band $band of $n is missing; the same call of farm.sh renders it"
    rows "$n" "$band" "${2#*x}"
    inputs+=(-i "file:frames/band_${band}_of_$n.png")
    filter+="[$((band - 1))]crop=iw:$((below - top)):0:${top}[b$band];" stacked+="[b$band]"
  done
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -xerror -y -err_detect crccheck+explode "${inputs[@]}" \
    -filter_complex "$filter${stacked}vstack=$n" -frames:v 1 -update 1 -c:v png -pix_fmt rgb24 -f image2 \
    "file:$local/joined.png" || { remove_damaged "$n" && fail 1 "the bands could not be joined"; }
  { head -c "$(pixels_at "$first")" -- "$first" &&
    tail -c "+$(($(pixels_at "$local/joined.png") + 1))" -- "$local/joined.png"; } >"$local/whole.png"
  whole_png "$local/whole.png" "$2" || fail 1 "the bands could not be joined"
  deliver "$local/whole.png" "$folder/frames/frame_0001.png"
}

make_film() {
  local result results=(film.mp4 contact.png) name lost=''
  cd -- "$folder"
  if grep -q '^rule still$' build.ninja; then
    results=(still.png)
    if [[ ! -e frames/frame_0001.png ]]; then join_bands "$(<bands)" "$(sed -n 's/^size = //p' build.ninja)"; fi
  fi
  while IFS= read -r name; do
    if ! whole_png "$name"; then lost+=" $((10#${name//[!0-9]/}))"; fi
  done < <(sed -n 's/.*"file": "\(.*\)\.pov".*/\1.png/p' manifest.json)
  if [[ -n $lost ]]; then fail 1 "frames$lost are missing; the same call of farm.sh renders them"; fi
  NINJA_STATUS='' ninja >&2 || fail 1 "$folder: the film could not be made; its frames are kept"
  for result in "${results[@]}"; do deliver "$result" "../../$result"; done
  rm -f -- frames/.*.part models/.*.{part,claim}
  say "${results[*]}: done, on $HOSTNAME"
}

if [[ $work != plan ]]; then load_modules; fi
make_local
trap 'kill $(jobs -p) 2>/dev/null; exit 143' TERM INT HUP  # what they have started ends with them
case $work in
  frames) render_frames "$1" "$2" "$3" "${4:-$SLURM_ARRAY_TASK_ID}" ;;
  bands) render_band "$1" "${2:-$SLURM_ARRAY_TASK_ID}" ;;
  film) make_film ;;
  plan) generate "$folder" --film-only "$@" ;;
  *) usage >&2; exit 2 ;;
esac
