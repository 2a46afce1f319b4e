# shellcheck shell=bash
# How far the rendering of frames is, and how long it will take. Sourced by scripts/render.sh, never run; in the folder
# of the film.
#
# A frame counts by a weight: half of it is the picture, as large in all frames, half the scene, by its bytes. Of frames
# that are being traced counts the share that POV-Ray has noted, 20 bytes a pixel; scripts/povray.ini spreads what is
# noted over the picture, so that a plain sky says nothing wrong of the rest.

declare -gA _weight=() _exposures=()
_all=0 _at_once=1 _done=0 _noted=0 _noted_before='' _picture_bytes=1 _began=0 _read=''
frames_now=0  # finished in this run

# begin_progress WIDTHxHEIGHT AT_ONCE: the numbers of the frames that are to do come from stdin
begin_progress() {
  local number name bytes mean=0
  local -A scene=()
  _picture_bytes=$((${1%x*} * ${1#*x} * 20)) _at_once=$2 _began=$SECONDS
  while read -r name bytes; do
    scene[$name]=$bytes name=${name%.pov}
    _exposures[${name%_s*}]=$((${_exposures[${name%_s*}]:-0} + 1))
  done < <(find frames -maxdepth 1 -name 'frame_*.pov' -printf '%f %s\n')
  while read -r number; do
    printf -v name 'frame_%04d' "$number"
    _weight[$name]=${scene[$name.pov]:-1}
    mean=$((mean + ${scene[$name.pov]:-1}))
  done
  mean=$((1 + mean / (${#_weight[@]} > 0 ? ${#_weight[@]} : 1)))
  for name in "${!_weight[@]}"; do  # so that they are about 1000 on the average
    _weight[$name]=$((500 + _weight[$name] * 500 / mean))
    _all=$((_all + _weight[$name]))
  done
  if ((_at_once > ${#_weight[@]})); then _at_once=${#_weight[@]}; fi
}

# frame_done NUMBER
frame_done() {
  local name
  printf -v name 'frame_%04d' "$1"
  _done=$((_done + ${_weight[$name]:-0})) frames_now=$((frames_now + 1))
}

# Looks at what POV-Ray has noted of unfinished pictures.
look_at_notes() {
  local name bytes file
  _noted=0
  while read -r file bytes; do
    name=${file#.} name=${name%%.*}
    if ((bytes > _picture_bytes)) || [[ $file == *.exposed ]]; then bytes=$_picture_bytes; fi
    _noted=$((_noted + ${_weight[$name]:-0} * bytes / _picture_bytes / ${_exposures[$name]:-1}))
  done < <(find frames -maxdepth 1 \( -name '.frame_*.kept' -o -name '.frame_*.exposed' \) -printf '%f %s\n' 2>/dev/null)
  if [[ -z $_noted_before ]]; then _noted_before=$_noted; fi
  if ((_noted > _noted_before)) && [[ -z $_read ]]; then _read=$SECONDS; fi
}

percent_done() { printf '%d' $((((_done + _noted) * 100 + _all / 2) / (_all > 0 ? _all : 1))); }

seconds_taken() { printf '%d' $((SECONDS - _began)); }

# The seconds that are left; nothing while there is no telling, as where all scenes are still read.
seconds_left() {
  local now=$SECONDS far=$((_done + _noted - ${_noted_before:-0})) frame left
  if ((far <= 0)); then return; fi
  if ((frames_now > 0)); then
    left=$(((now - _began) * (_all - _done - _noted) / far))
  else  # each frame takes the time of reading, and then that of tracing
    if ((now - _read < 2)); then return; fi
    frame=$((_read - _began + (now - _read) * _at_once * 1000 / far))
    left=$((frame * (_all - _noted_before) / 1000 / _at_once - (now - _began)))
  fi
  printf '%d' "$((left > 0 ? left : 0))"
}
