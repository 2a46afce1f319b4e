# shellcheck shell=bash
# What the tests of the scripts share.

export ROOT=${BATS_TEST_DIRNAME%/tests/scripts}
export RENDER=$ROOT/scripts/render.sh
export NO_COLOR=1
# So that no run is measured against the user's own, nor begins with measuring the machine.
export XDG_CACHE_HOME=$BATS_FILE_TMPDIR/cache
mkdir -p "$XDG_CACHE_HOME/frond"
echo "machine 2 2" >"$XDG_CACHE_HOME/frond/pace"

# A stand-in for povray: writes a picture of the size asked for, notes the scene in $RENDERED and takes $FRAME_TIME.
# A scene that holds the word "broken" is a parse error. It notes half a picture before that time, as POV-Ray notes blocks;
# $RENDERED.continued names the scenes it found such notes of, $RENDERED.threads the threads it was given.
make_fake_povray() {
  export RENDERED=$BATS_TEST_TMPDIR/rendered FROND_POVRAY=$BATS_TEST_TMPDIR/fake-povray
  export FROND_UNCONFINED=1  # it takes its notes elsewhere
  : >"$RENDERED"
  cat >"$FROND_POVRAY" <<'SH'
#!/usr/bin/env bash
set -eu
for argument in "$@"; do
  case $argument in
    +I*) scene=${argument#+I} ;;
    +O*) picture=${argument#+O} ;;
    +WT*) echo "${argument#+WT}" >>"$RENDERED.threads" ;;
    +W*) width=${argument#+W} ;;
    +H*) height=${argument#+H} ;;
  esac
done
state=${picture%.png}.pov-state
if [[ -s $state ]]; then echo "$scene" >>"$RENDERED.continued"; fi
head -c $((width * height * 10)) /dev/zero >"$state"
sleep "${FRAME_TIME:-0}"
if grep -q broken "$scene"; then
  printf "File '%s' line 1: Parse Error: Expected 'object',\n undeclared identifier 'broken' found\nFatal error in parser: Cannot parse input.\nRender failed\n" "$scene" >&2
  exit 1
fi
ffmpeg -nostdin -loglevel error -f lavfi -i "color=gray:s=64x64,format=rgb24,scale=$width:$height" -frames:v 1 -update 1 -y "$picture"
rm "$state"
echo "$scene" >>"$RENDERED"
SH
  chmod +x "$FROND_POVRAY"
}

use_real_povray() { unset FROND_POVRAY FROND_UNCONFINED; }

# A preset in the folder of the test: make_preset NAME FRAMES
make_preset() {
  sed "s/\"frames\": 6/\"frames\": $2/" "$ROOT/tests/presets/tiny_film.json" >"$BATS_TEST_TMPDIR/$1"
}

# A fake povray and film.json, of six frames, in the folder of the test, which is gone to.
begin_with_a_film() {
  need_frond
  make_fake_povray
  cd "$BATS_TEST_TMPDIR" || return
  make_preset film.json 6
}

count_rendered() { grep -c '' "$RENDERED" || true; }
frames_of() { ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "file:$1"; }

need_frond() {
  [[ -x ${FROND_BIN:=$ROOT/build/frond} ]] || skip "build/frond is not built"
  export FROND_BIN
}
