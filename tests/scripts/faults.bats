# What befalls a run from outside: each ends in a clear message and exit code 1, leaves no half file under a final name,
# and the next run completes with the same film. (Full disks and damaged pictures: disk.bats.)

setup() {
  load common
  begin_with_a_film
  "$RENDER" film.json -o whole >/dev/null 2>&1
  : >"$RENDERED"
}

# povray_does TEXT: what the fake povray does before it traces a frame, while the file `fault` is there; $scene is the frame
povray_does() {
  : >fault
  sed -i "s|^sleep .*|if [[ -e $PWD/fault ]]; then $1; fi|" "$FROND_POVRAY"
}

# it_fails_with MESSAGE [OPTION...]: a run with one processor does, and says so
it_fails_with() {
  local message=$1
  shift
  run "$RENDER" film.json --jobs 1 "$@"
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"error: "*"$message"* ]]
  [[ $output != *": line "[0-9]*": "* ]]  # nothing that bash or a tool stumbles over
  no_half_file
}

no_half_file() {
  local picture
  [ ! -e out/film/film.mp4 ]
  for picture in $(find out -name 'frame_*.png' ! -name '.*' 2>/dev/null); do
    ffmpeg -nostdin -v error -xerror -i "$picture" -f null -
  done
}

the_next_run_completes() {
  rm -f fault
  run "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 0 ]
  cmp whole/film.mp4 out/film/film.mp4
  cmp whole/contact.png out/film/contact.png
}

@test "a missing POV-Ray" {
  FROND_POVRAY=$PWD/none it_fails_with "$PWD/none: no such program"
  the_next_run_completes
}

@test "a POV-Ray that goes in the middle" {
  povray_does 'if [[ $scene == *0003* ]]; then mv "$0" "$0.gone"; fi'
  it_fails_with "fake-povray: no such program"
  [ "$(count_rendered)" -eq 3 ]
  [[ $output == *"these frames could not be rendered: 4, 5, 6; those that are finished are kept" ]]
  mv "$FROND_POVRAY.gone" "$FROND_POVRAY"
  the_next_run_completes
  [ "$(count_rendered)" -eq 6 ]
}

@test "a POV-Ray killed for memory" {
  povray_does 'if [[ $scene == *0003* ]]; then kill -KILL $$; fi'
  it_fails_with "frames/frame_0003.pov could not be rendered: povray was ended by signal 9 (out of memory?)"
  [ "$(count_rendered)" -eq 5 ]
  the_next_run_completes
  [ "$(count_rendered)" -eq 6 ]
}

@test "a scene removed before its turn" {
  povray_does 'rm -f frames/frame_0004.pov'
  it_fails_with "frames/frame_0004.pov could not be rendered: it is gone"
  [ "$(count_rendered)" -eq 5 ]
  the_next_run_completes
}

@test "a scene removed before any frame is rendered" {
  printf '#!/bin/sh\n"%s" "$@" && rm -f out/film/frames/frame_0004.pov\n' "$FROND_BIN" >frond
  chmod +x frond
  FROND_BIN=$PWD/frond it_fails_with "frames/frame_0004.pov is gone"
  the_next_run_completes
}

@test "a folder that vanishes for a while" {
  povray_does 'if [[ $scene == *0003* ]]; then mv frames away; fi'
  it_fails_with "frames/frame_0003.pov could not be rendered: frames has vanished"
  rm -rf out/film/frames
  mv out/film/away out/film/frames
  no_half_file
  the_next_run_completes
  [ "$(count_rendered)" -le 8 ]
}

@test "a whole film's folder that vanishes for a while" {
  povray_does "if [[ \$scene == *0003* ]]; then mv $PWD/out $PWD/away; fi"
  run "$RENDER" film.json --jobs 1
  echo "$output"
  rm -rf out
  mv away out
  the_next_run_completes
}

@test "an unwritable folder" {
  mkdir -p out
  unshare --map-root-user --mount true || skip "no disk can be mounted here"
  # A disk that is read only, which keeps root from writing, too.
  read_only() { unshare --map-root-user --mount bash -c 'mount --bind "$1" "$1" && mount -o remount,bind,ro "$1" && shift && "$@"' - "$@"; }
  run read_only "$PWD/out" "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == "error: out/film: the folder cannot be made: $PWD/out cannot be written to" ]]
  "$RENDER" film.json --frames 1-3
  run read_only "$PWD/out/film" "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == "error: out/film: cannot be written to" ]]
  run read_only "$PWD/out/film/frames" "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"out/film/frames/frame_0004."*": cannot be written: Read-only file system"* ]]
  rm out/film/film.mp4
  the_next_run_completes
}
