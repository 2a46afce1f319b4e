# shellcheck shell=bash
# What the scripts share: messages and the progress of a run of ninja. Sourced, never run.

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
export root

# A colour is for a terminal, and only where nobody asked for none.
_error_mark='error:'
if [[ -t 2 && -z ${NO_COLOR:-} && ${TERM:-dumb} != dumb ]]; then _error_mark=$'\e[31merror:\e[0m'; fi

_drawn=''  # a progress bar stands on the current line of the terminal

say() { end_bar; printf '%s\n' "$*" >&2; }
fail() { local code=$1; shift; end_bar; printf '%s %s\n' "$_error_mark" "$*" >&2; exit "$code"; }
bad_usage() { end_bar; printf '%s %s\nSee %s --help\n' "$_error_mark" "$*" "$(basename -- "$0")" >&2; exit 2; }

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

# Marks the progress lines of ninja, so that they are told from what failing commands print.
ninja_status=$'\001%f %t %e '

# start_ninja ARGUMENTS...: ninja as a child that ends when this script does, however it ends, its output on $ninja_out.
start_ninja() {
  export NINJA_STATUS=$ninja_status
  exec {ninja_out}< <(exec setpriv --pdeathsig TERM -- ninja "$@" 2>&1)
  ninja_pid=$!
}

# follow_ninja STEP TELL [IDLE]: calls `STEP finished all seconds description` for each command that ended well,
# `TELL line` for each line that a failing command prints, and IDLE after each second without a line. Returns ninja's
# exit code.
follow_ninja() {
  local line step=$1 tell=$2 idle=${3:-:} skip='' pending='' finished all elapsed what begun='' status
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
