# POV-Ray opens nothing but what is in the folders of the film and of the includes.

setup() {
  load common
  cd "$BATS_TEST_TMPDIR"
  mkdir -p film/frames
  echo '"secret"' >secret.txt
  ffmpeg -nostdin -loglevel error -f lavfi -i color=red:s=8x8 -frames:v 1 -update 1 secret.png
  need_frond
  "$FROND_BIN" confine -- true || skip "this kernel has no Landlock"
  export HOME=$BATS_TEST_TMPDIR/home
}

# frame TEXT: renders a scene of that text, in the folder of the film
frame() {
  printf '%s\n' '#version 3.7;' "$1" >film/frames/frame_0001.pov
  cd film
  run "$FROND_BIN" frame frames/frame_0001.pov frames/frame_0001.png 32x24 -- -J
  cd ..
  echo "$1: $status $output"
}

@test "a scene reads no file elsewhere" {
  for path in /etc/hostname /etc/passwd /proc/self/environ "$BATS_TEST_TMPDIR/secret.txt" ../secret.txt; do
    frame "#fopen F \"$path\" read #read (F, A) #debug A"
    [ "$status" -eq 1 ]
    [[ $output == *"Cannot open user file"* ]]
  done
  frame "box { 0, 1 pigment { image_map { png \"$BATS_TEST_TMPDIR/secret.png\" } } }"
  [ "$status" -eq 1 ]
  frame '#include "../secret.txt"'
  [ "$status" -eq 1 ]
  ln -s "$BATS_TEST_TMPDIR/secret.txt" film/frames/link.txt
  frame '#fopen F "frames/link.txt" read'
  [ "$status" -eq 1 ]
}

@test "a scene writes no file elsewhere" {
  for path in "$BATS_TEST_TMPDIR/written" /tmp/frond_written ../written written "$ROOT/povinc/written.inc"; do
    frame "#fopen F \"$path\" write #write (F, 1)"
    [ "$status" -eq 1 ]
    [[ $output == *"Cannot open user file"* ]]
    [ ! -e "$path" ]
  done
  frame '#fopen F "../secret.txt" append #write (F, 1)'
  [ "$status" -eq 1 ]
  [ "$(cat secret.txt)" = '"secret"' ]
}

@test "a scene reads what lies beside it and the includes" {
  cp secret.png film/frames/leaf.png
  echo '#declare Beside = 1;' >film/frames/beside.inc
  frame '#include "frond_water.inc" #include "beside.inc" camera { location -3*z look_at 0 } light_source { <3, 5, -4>, 1 }
    box { -1, 1 pigment { image_map { png "leaf.png" } } }'
  [ "$status" -eq 0 ]
  [ -s film/frames/frame_0001.png ]
}

@test "no setting of the system or the user changes a picture" {
  scene='camera { location -3*z look_at 0 } light_source { <3, 5, -4>, 1 } sphere { 0, 1 pigment { rgb 1 } }'
  frame "$scene"
  [ "$status" -eq 0 ]
  mv film/frames/frame_0001.png plain.png
  mkdir -p home/.povray/3.7
  printf 'Antialias=On\nQuality=1\nPost_Frame_Command=touch frames/shell\n' | tee film/povray.ini >home/.povray/3.7/povray.ini
  printf '[File I/O Security]\nnone\n[Shellout Security]\nallowed\n' >home/.povray/3.7/povray.conf
  frame "$scene"
  cmp plain.png film/frames/frame_0001.png
  [ ! -e film/frames/shell ]
  FROND_UNCONFINED=1 frame "$scene"
  cmp plain.png film/frames/frame_0001.png
}

@test "the pixels of a large picture find room, and go" {
  frame 'sphere { 0, 1 }'  # a picture beyond 128 MB of pixels is kept in a file
  cd film
  run "$FROND_BIN" frame frames/frame_0001.pov frames/large.png 3000x2400 -- -J +MI1
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(ls -A frames)" = $'frame_0001.png\nframe_0001.pov\nlarge.png' ]
}
