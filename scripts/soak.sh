#!/usr/bin/env bash
# Grows the shipped presets with many seeds, by a program that checks itself.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/soak.sh [--presets GLOB]... [--seeds A-B] [--hours H] [--program FILE] [--notes FILE] [--set POINTER=VALUE]...

For each seed and each preset writes a frame, the first, the middle or the last one as the seed has it, and a look of it.
Whatever does not end well is told in one line with the command that repeats it. What ended well is noted and not done
again, so that a soak may be ended at any time and gone on with.

  --presets GLOB  only presets whose path below presets/ it matches, as in 'species/corals/*' (all)
  --seeds A-B     (1-100)
  --hours H       ends after so many hours (when all is done)
  --program FILE  (build-soak/frond, of \`cmake --preset soak && cmake --build --preset soak\`)
  --notes FILE    (soak.txt beside the program); remove it where the program is another
  --set ...       handed on to the program
  --help          this text

Exit codes: 0 all ended well, 1 something did not, 2 wrong option.
TEXT
}

globs=() sets=() seeds=1-100 hours='' program=$root/build-soak/frond notes=''
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --presets | --seeds | --hours | --program | --notes | --set) (($# > 1)) || bad_usage "$1 needs a value" ;;&
    --presets) globs+=("$2") ;;
    --seeds) seeds=$2 ;;
    --hours) hours=$2 ;;
    --program) program=$(realpath -m -- "$2") ;;
    --notes) notes=$(realpath -m -- "$2") ;;
    --set) sets+=(--set "$2") ;;
    *) bad_usage "unknown option '$1'" ;;
  esac
  shift 2
done
[[ $seeds =~ ^([0-9]+)-([0-9]+)$ ]] || bad_usage "'$seeds' is no range of seeds; expected A-B"
first=${BASH_REMATCH[1]} last=${BASH_REMATCH[2]}
[[ $hours =~ ^([0-9]+(\.[0-9]+)?)?$ ]] || bad_usage "'$hours' is no number of hours"
[[ -x $program ]] || fail 2 "$program: no such program; see soak.sh --help"
notes=${notes:-$(dirname -- "$program")/soak.txt}
cd -- "$root"
program=$(realpath --relative-base=. -- "$program")
mapfile -t presets < <(find presets -name '*.json' -not -path 'presets/grammars/*' | LC_ALL=C sort | while read -r preset; do
  for glob in "${globs[@]:-*}"; do
    # shellcheck disable=SC2053  # it is a pattern
    if [[ ${preset#presets/} == $glob ]]; then echo "$preset" && break; fi
  done
done)
((${#presets[@]} > 0)) || bad_usage "no preset is called ${globs[*]}"

export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0} UBSAN_OPTIONS=${UBSAN_OPTIONS:-halt_on_error=1:print_stacktrace=1}
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
declare -A well=()
if [[ -f $notes ]]; then while IFS= read -r line; do well[$line]=yes; done <"$notes"; fi
tried=0 known=0 found=0

end() {
  local spent
  times >"$scratch/times" # not in a pipe, whose end would tell its own
  spent=$(awk -F'[ms ]+' 'NR == 2 { printf "%.2f", (60*($1 + $3) + $2 + $4)/3600 }' "$scratch/times")
  say "$tried runs, $known more that had ended well before; $found did not end well; $spent hours of processor"
  exit $((found > 0))
}

# try COMMAND...: one run, unless it ended well before.
try() {
  local how=0 left=100000000 command said
  command=${*//"$scratch"/out}
  if [[ -n ${well[$command]:-} ]]; then known=$((known + 1)) && return; fi
  if [[ -n $hours ]]; then left=$(awk "BEGIN { print int(3600*$hours) - $SECONDS }"); fi
  if ((left <= 0)); then end; fi
  (tied nice -n 15 timeout "$left" "$@") >"$scratch/said" 2>&1 &
  wait $! || how=$?
  rm -rf -- "$scratch/soak"
  if ((how == 124)); then end; fi
  tried=$((tried + 1))
  if ((how == 0)); then printf '%s\n' "$command" >>"$notes" && return; fi
  said=$(grep -m 1 -aE 'SUMMARY:|runtime error:|Assertion|error:' "$scratch/said" || tail -n 1 "$scratch/said")
  found=$((found + 1))
  printf '%s  # ended with %s: %s\n' "$command" "$how" "$said"
}

for ((seed = first; seed <= last; ++seed)); do
  for preset in "${presets[@]}"; do
    frames=$(sed -n 's/.*"frames": *\([0-9]*\).*/\1/p' "$preset" | head -n 1)
    frame=$((seed % 3 == 0 ? 1 : seed % 3 == 1 ? ${frames:-1} : (${frames:-1} + 1) / 2))
    own=("$preset" --set "/seed=$seed" ${sets[@]+"${sets[@]}"})
    try "$program" generate "${own[@]}" --frames "$frame-$frame" --quiet -o "$scratch/soak"
    try "$program" look "${own[@]}" --frame "$frame" -o "$scratch/soak.png"
  done
done
end
