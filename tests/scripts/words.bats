# What people may say to the program: names of presets, words to look for, numbers of frames.

bats_require_minimum_version 1.5.0

setup() {
  load common
  need_frond
  frond=$FROND_BIN
  cd "$BATS_TEST_TMPDIR" || return
}

@test "every command opens a preset by its name, as new does" {
  for name in oak trees/oak presets/trees/oak.json; do
    run --separate-stderr "$frond" files "$name"
    [ "$status" -eq 0 ]
    [[ $output == *presets/trees/oak.json* ]]
  done
  "$frond" check oak reef
  run "$frond" info vase
  [ "$status" -eq 0 ]
  run "$frond" derive koch_curve --steps 1
  [ "$status" -eq 0 ]
  "$frond" new mine --from vase -q
  "$frond" check mine  # with or without its .json
  # One's own goes before one of Frond's.
  echo '{"title": "no oak", "organisms": []}' >oak.json
  run --separate-stderr "$frond" files oak
  [[ $output == oak.json* ]]
  run "$frond" check oaak
  [ "$status" -eq 2 ]
  [[ $output == *'did you mean'*oak.json* ]]
}

@test "a new preset is of today's version, and one that begins as another of that one's" {
  "$frond" new mine --from vase -q
  grep -q '"version": 2' mine.json
  "$frond" new other --from reef -q
  run ! grep -q '"version"' other.json
}

@test "check takes --set" {
  "$frond" new mine --from vase -q
  "$frond" check mine.json --set /film/frames=3
  run "$frond" check mine.json --set /film/frames=-3
  [ "$status" -eq 2 ]
  [[ $output == *"/film/frames"* ]]
}

@test "check of a grammar says that it is one, and what is for that" {
  cp "$ROOT/presets/grammars/koch_curve.json" .
  run "$frond" check koch_curve.json
  [ "$status" -eq 0 ]
  [[ $output == *"koch_curve.json: a grammar, no preset"*"frond turtle koch_curve.json"* ]]
  sed 's/"axiom"/"axoim": "F", "axiom"/' koch_curve.json >wrong.json
  run "$frond" check wrong.json
  [ "$status" -eq 2 ]
  [[ $output == *'did you mean "axiom"?'* ]]
  run "$frond" look koch_curve.json
  [ "$status" -eq 2 ]
  [[ $output == *"koch_curve.json: is a grammar, no preset; "* ]]
}

@test "a film is as long as --seconds says, at --fps" {
  "$frond" new mine --from vase -q
  run "$frond" info mine.json --seconds 2 --fps 10 --json
  [[ $output == *'"frames": 20,'* ]]
  run "$frond" info mine.json --seconds 0.01 --json
  [[ $output == *'"frames": 1,'* ]]
  run "$frond" info mine.json --seconds 0
  [ "$status" -eq 2 ]
  [[ $output == "--seconds: "* ]]
}

@test "frames of a still are told to be none" {
  "$frond" new mine --from vase -q
  run "$frond" generate mine.json --frames 1-24
  [ "$status" -eq 2 ]
  [ "$output" = "--frames: found 1-24, but this preset is a still, which has frame 1 alone; expected 1, or a film, as by --seconds 4" ]
  run "$frond" generate mine.json --frames 9-4 --seconds 1
  [[ $output == '--frames: "9-4" is no range of frames; expected A-B, as in 1-24, or one number; the film has frames 1-24' ]]
}

@test "what cannot be made is refused before anything is" {
  make_fake_povray
  make_preset film.json 6
  run "$frond" render film.json --transparent --format mp4
  [ "$status" -eq 2 ]
  [[ $output == *"an mp4 has no opacity"* ]]
  [ ! -e out ]
  touch taken
  run "$frond" render film.json -o taken/out
  [ "$status" -eq 1 ]
  [[ $output == *"taken/out: the folder cannot be made: $PWD/taken is a file; expected a folder, or none"* ]]
  run "$frond" render film.json --sweep /film/fps=10:-10:2
  [ "$status" -eq 2 ]
  [[ $output == *"picture 2 of 2 (fps -10) could not be made; none has been begun" ]]
  [ ! -e out ]
  run "$frond" render film.json --why 7
  [ "$status" -eq 2 ]
  [[ $output == *"--why: 7 is no frame of this film; expected 1-6" ]]
  [ ! -e out ]
  run "$frond" resolve film.json --frames 2
  [ "$status" -eq 1 ]
  [[ $output == "out/film/raw/frame_0002.png: is not there; "* ]]
}

@test "two presets of one name have each their own pace" {
  make_fake_povray
  mkdir -p a b
  make_preset a/film.json 2
  make_preset b/film.json 2
  FRAME_TIME=0 "$frond" render a/film.json -o made
  run "$frond" info a/film.json
  [[ $output == *"(reckoned on its last run)" ]]
  run "$frond" info b/film.json
  [[ $output == *"(reckoned on other runs of this machine)" ]]
  cd b
  run "$frond" info ../a/film.json  # from elsewhere it is the same
  [[ $output == *"(reckoned on its last run)" ]]
}

@test "describe leads with what is called so, and offers sense in place of letters" {
  run "$frond" describe wind
  [ "$status" -eq 0 ]
  [[ ${lines[0]} == "scene/wind  "* ]]
  [[ $output != *"window"* ]]
  for word in rose tulip winter crocus; do
    run "$frond" describe "$word"
    echo "$output"
    [ "$status" -eq 0 ]
    [[ $output != *"did you mean"* ]]
  done
  run "$frond" describe crocus
  [[ $output == *"presets/lsystems/crocus"* ]]
  run "$frond" describe tulip
  [[ $output == *"What comes near in sense: crocus, flower"*"presets/lsystems/crocus"* ]]
  run "$frond" describe winter
  [[ $output == *"presets/garden/winter.json"* ]]
}

@test "resolve tells that it is still at work" {
  make_preset film.json 1
  # A raw still is drawn twice as wide and high. Its light is nothing.
  mkdir -p out/film/raw
  python3 - out/film/raw/frame_0001.png 4800 3600 <<'PNG'
import struct, sys, zlib
name, wide, high = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", wide, high, 8, 2, 0, 0, 0))
                       + chunk(b"IDAT", zlib.compress(bytes((1 + 3 * wide) * high))) + chunk(b"IEND", b""))
PNG
  mkfifo told
  "$frond" resolve film.json --size 2400x1800 --side 16 2>told 3>&- &
  while read -r line; do
    [[ $line != "still resolving frames ("*" s)" ]] || break
  done <told
  kill $! 2>/dev/null || true
  echo "$line"
  [[ $line == "still resolving frames ("*" s)" ]]
}

@test "render tells that it is still at work while it resolves" {
  make_fake_povray
  make_preset film.json 1
  # A ninja whose resolving waits until it may go on.
  mkfifo told goes_on
  mkdir bin
  cat >bin/ninja <<SH
#!/usr/bin/env bash
[[ ! -e build.ninja ]] || sed -i 's|= exec \$frond resolve|= cat $PWD/goes_on; exec \$frond resolve|' build.ninja
exec $(command -v ninja) "\$@"
SH
  chmod +x bin/ninja
  PATH=$PWD/bin:$PATH "$frond" render film.json --resolve --size 80x60 2>told >/dev/null 3>&- &
  local running=$! heard=""
  while read -r line; do
    heard+=$line$'\n'
    if [[ $line == "still resolving frames ("*" s)" && -p goes_on ]]; then echo >goes_on && rm goes_on; fi
  done <told
  echo "$heard"
  wait "$running"
  [[ $heard == *$'\nResolving frames\nstill resolving frames ('*" s)"* ]]
}
