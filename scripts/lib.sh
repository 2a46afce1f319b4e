# shellcheck shell=bash
# What the scripts share: messages, files put in their place and the progress of a run of ninja. Sourced, never run.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
export root
export LC_ALL=C.UTF-8  # so that what programs say can be read

# A colour is for a terminal, and only where nobody asked for none.
_error_mark='error:'
if [[ -t 2 && -z ${NO_COLOR:-} && ${TERM:-dumb} != dumb ]]; then _error_mark=$'\e[31merror:\e[0m'; fi

_drawn=''  # a progress bar stands on the current line of the terminal

say() { end_bar; printf '%s\n' "$*" >&2; }
fail() { local code=$1; shift; end_bar; printf '%s %s\n' "$_error_mark" "$*" >&2; exit "$code"; }
bad_usage() { end_bar; printf '%s %s\nSee %s --help\n' "$_error_mark" "$*" "$(basename -- "$0")" >&2; exit 2; }

# nearest NAME: of the lines `KEY<tab>TEXT` on stdin the texts whose key is the name or, where there is none, nearest to
# it, by Levenshtein's distance; ` and ` between them.
nearest() {
  awk -F '\t' -v name="$1" '
    function least(a, b) { return a < b ? a : b }
    function distance(a, b,   i, j, row, last, up) {
      for (j = 0; j <= length(b); ++j) row[j] = j
      for (i = 1; i <= length(a); ++i) {
        last = row[0]
        row[0] = i
        for (j = 1; j <= length(b); ++j) {
          up = row[j]
          row[j] = least(least(up, row[j - 1]) + 1, last + (substr(a, i, 1) != substr(b, j, 1)))
          last = up
        }
      }
      return row[length(b)]
    }
    BEGIN { best = 1 + int(length(name) / 3) }
    {
      d = distance(tolower(name), $1)
      if (d < best) { best = d; found = "" }
      if (d == best) found = found (found ? " and " : "") $2
    }
    END { print found }'
}

# unknown_option OPTION: says so, with the nearest that `usage` names.
unknown_option() {
  local near
  near=$(usage | grep -oE -e '--[a-z-]+' | LC_ALL=C sort -u | sed 's/.*/&\t&/' | nearest "${1%%=*}")
  bad_usage "unknown option '$1'${near:+; did you mean ${near// and / or }?}"
}

on_terminal() { [[ -t 2 && ${TERM:-dumb} != dumb ]]; }

end_bar() {
  if [[ -n $_drawn ]]; then printf '\r\e[K' >&2; fi
  _drawn=''
}

# draw_bar DONE ALL TEXT
draw_bar() {
  local width=30 filled bar
  filled=$(($1 * width / ($2 > 0 ? $2 : 1)))
  printf -v bar '%*s' "$filled" ''
  printf -v bar '%-*s' "$width" "${bar// /#}"
  printf '\r\e[K[%s] %s' "$bar" "$3" >&2
  _drawn=yes
}

# clock SECONDS: 3:07
clock() { printf '%d:%02d' $(($1 / 60)) $(($1 % 60)); }

# tied PROGRAM...: in place of this process, a program that is ended when the one that started it is, however that ends.
tied() { exec setpriv --pdeathsig TERM -- "$@"; }

# help_where_asked ARGUMENT...: prints what `usage` says and ends where the first of them asks for it.
help_where_asked() { case ${1:-} in -h | --help) usage; exit 0 ;; esac; }

# full_disk TEXT: whether a program's words are those of a full disk. Each has its own, this is what we say.
full_disk() { [[ $1 == *'No space left on device'* || $1 == *'Disk quota exceeded'* ]]; }
no_room='no room on the disk'

# part_of FILE: the name of what is to become it, beside it. Nothing is there: a link would be written through.
part_of() {
  local part
  part=$(dirname -- "$1")/.$(basename -- "$1").part
  rm -f -- "$part"
  printf '%s\n' "$part"
}

# no_link PATH...: fails where one of them is a link, and so something else would be written to.
no_link() {
  local path
  for path in "$@"; do
    if [[ -L $path ]]; then fail 1 "$path: is a link, and what it points to would be written to; expected none"; fi
  done
}

# put_in_place PART FILE: renames a finished file once it lies on the disk, so that not even a crash leaves half of it.
put_in_place() {
  local said
  if [[ -d $2 ]]; then fail 1 "$2 is a folder; expected a file, or none"; fi
  if ! said=$(sync -- "$1" 2>&1 && mv -fT -- "$1" "$2" 2>&1); then
    full_disk "$said" && said=$no_room
    fail 1 "$2 could not be written: $said"
  fi
}

# whole_png FILE [WIDTHxHEIGHT]: whether it begins as a PNG, of that size, and ends as one.
whole_png() {
  local begin end size='.{16}'
  begin=$(od -An -v -tx1 -N 24 -- "$1" 2>/dev/null | tr -d ' \n')
  end=$(tail -c 12 -- "$1" 2>/dev/null | od -An -v -tx1 | tr -d ' \n')
  if [[ -n ${2:-} ]]; then printf -v size '%08x%08x' "${2%x*}" "${2#*x}"; fi
  [[ $begin =~ ^89504e470d0a1a0a0000000d49484452$size$ && $end == 0000000049454e44ae426082 ]]
}

# label NAME TEXT WIDTH: notes in the files NAME1, NAME2 ... the lines of what is to stand below a picture, and in
# $label_lines the most that one of them has. A character is at most 0.64 of its size wide; three blanks part a text.
label_lines=1
label() {
  local text=${2//[[:cntrl:]]/ } most line count=0
  most=$(($3 > 224 ? $3 * 100 / 1024 : $3 > 112 ? 21 : $3 > 16 ? $3 * 100 / 512 : 3))
  if ((${#text} > most)); then text=${text//   /$'\n'}; fi
  while IFS= read -r line; do
    count=$((count + 1))
    printf '%s' "$line" >"$1$count"
  done < <(fold -s -w "$most" <<<"$text")
  if ((count > label_lines)); then label_lines=$count; fi
}
# labelled NAME: the filter of ffmpeg that puts them there. So no text is ever part of a filter.
labelled() {
  local line
  printf 'pad=iw:ih+%d:0:0:0x202020' $((10 + 18 * label_lines))
  for ((line = 1; line <= label_lines; ++line)); do
    if [[ ! -e $1$line ]]; then return; fi
    printf ",drawtext=textfile=%s%d:expansion=none:fontcolor=white:fontsize='clip(w/14,8,16)'" "$1" "$line"
    printf ":x='max(0,(w-tw)/2)':y=h-%d" $((2 + 18 * (label_lines - line + 1)))
  done
}

# frames_in FILM: how many pictures a film holds, by what is there of them and not by its header.
frames_in() {
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel quiet -nostats -i "file:$1" -map 0:v -c copy -progress pipe:1 \
    -f null - 2>/dev/null | sed -n 's/^frame= *//p' | tail -n 1
}

# Marks the progress lines of ninja, so that they are told from what failing commands print.
ninja_status=$'\001%f %t %e '

# start_ninja ARGUMENTS...: ninja as a child that ends when this script does, however it ends, its output on $ninja_out.
start_ninja() {
  export NINJA_STATUS=$ninja_status
  exec {ninja_out}< <(tied ninja "$@" 2>&1)
  ninja_pid=$!
}

# follow_ninja STEP TELL [IDLE]: calls `STEP finished all seconds description` for each command that ended well,
# `TELL line` for each line that a failing command prints, and IDLE after each second without a line. Returns ninja's
# exit code; $failed then holds the files that could not be made.
follow_ninja() {
  local line step=$1 tell=$2 idle=${3:-:} skip='' pending='' finished all elapsed what begun='' status
  failed=''
  told() {  # a command is counted when the next line shows that it did not fail
    [[ -n $pending ]] || return 0
    IFS=' ' read -r finished all elapsed what <<<"$pending"
    pending=''
    "$step" "$finished" "$all" "${elapsed%%.*}" "$what"
  }
  while true; do
    status=0
    IFS= read -t 1 -r line <&"$ninja_out" || status=$?
    line=$begun$line
    begun=''
    if ((status > 128)); then  # not a whole line yet
      begun=$line
      "$idle"
      continue
    fi
    if ((status > 0)); then break; fi
    if [[ -n $skip ]]; then  # the command that failed
      skip=''
      continue
    fi
    case $line in
      $'\001'*)
        told
        pending=${line#?}
        ;;
      'FAILED: '*)
        pending=''
        failed+=" ${line#FAILED: }"
        skip=yes
        ;;
      'ninja: no work to do.' | 'ninja: build stopped'* | 'ninja: Entering directory'*) ;;
      *) "$tell" "$line" ;;
    esac
  done
  told
  end_bar
  exec {ninja_out}<&-
  wait "$ninja_pid"
}
