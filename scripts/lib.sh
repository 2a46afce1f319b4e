# shellcheck shell=bash
# What the scripts share: messages, and files put in their place. Sourced, never run.

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
