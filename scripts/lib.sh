# shellcheck shell=bash
# What the scripts share, messages above all. Sourced, never run.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
frond=${FROND_BIN:-$root/build/frond}
export root
export LC_ALL=C.UTF-8  # so that what programs say can be read
# What a compiler cache holds of one checkout serves another.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

# A colour is for a terminal, and only where nobody asked for none.
_error_mark='error:'
if [[ -t 2 && -z ${NO_COLOR:-} && ${TERM:-dumb} != dumb ]]; then _error_mark=$'\e[31merror:\e[0m'; fi

_drawn=''  # a progress bar stands on the current line of the terminal

say() { end_bar; printf '%s\n' "$*" >&2; }
fail() { local code=$1; shift; end_bar; printf '%s %s\n' "$_error_mark" "$*" >&2; exit "$code"; }
bad_usage() { end_bar; printf '%s %s\nSee %s --help\n' "$_error_mark" "$*" "$(basename -- "$0")" >&2; exit 2; }

# unknown_option OPTION: says so, with one that `usage` names and that begins alike.
unknown_option() {
  local name=${1%%=*} near=''
  if ((${#name} > 4)); then near=$(usage | grep -oE -e '--[a-z-]+' | grep -m 1 -F -e "${name:0:5}" || true); fi
  bad_usage "unknown option '$1'${near:+; did you mean $near?}"
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

# call_frond COMMAND OPTION...: the program in place of this process, once what is missing is installed and built.
call_frond() {
  if [[ " $* " == *" --help "* && ! -x $frond ]]; then
    printf 'Usage: %s [options]\n\nOnce it is built (scripts/build.sh), this names all options.\n' "$0"
    exit 0
  fi
  if [[ -z ${FROND_BIN:-} || $1 == render ]]; then "$root/scripts/setup.sh" --quiet; fi
  if [[ -z ${FROND_BIN:-} ]]; then (tied "$root/scripts/build.sh"); fi
  FROND_HOME=${FROND_HOME:-$root} exec "$frond" "$@"
}
