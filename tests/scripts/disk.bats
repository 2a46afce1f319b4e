# What lies on the disk: damaged, full, in the way, or left by a script that was killed.

setup() {
  load common
  begin_with_a_film
  frames=out/film/frames
}

# The ways a picture may be damaged: damage HOW FILE
damage() {
  case $1 in
    empty) : >"$2" ;;
    short) truncate -s -20 "$2" ;;
    long) echo more >>"$2" ;;
    wrong) printf x | dd of="$2" bs=1 seek=60 conv=notrunc status=none ;;
    zeros) head -c "$(stat -c %s "$2")" /dev/zero >"$2.zeros" && mv "$2.zeros" "$2" ;;
    other) ffmpeg -nostdin -loglevel error -f lavfi -i color=red:s=10x10 -frames:v 1 -update 1 -y "$2" ;;
  esac
}

@test "a damaged frame is rendered again, not left out of the film" {
  "$RENDER" film.json
  cp out/film/film.mp4 whole.mp4
  for how in empty short long wrong zeros other; do
    damage "$how" "$frames/frame_0003.png"
    : >"$RENDERED"
    run "$RENDER" film.json
    echo "$how: $output"
    [ "$status" -eq 0 ]
    [ "$(cat "$RENDERED")" = frames/frame_0003.pov ]
    [ "$how" = other ] || [[ $output == *"note: $frames/frame_0003.png is damaged; it is made again"* ]]
    cmp whole.mp4 out/film/film.mp4
  done
}

@test "a damaged result is made again" {
  make_preset still.json 1
  "$RENDER" still.json
  "$RENDER" film.json
  sha256sum out/*/*.png out/*/*.mp4 >before
  damage short out/still/still.png
  damage wrong out/film/contact.png
  truncate -s 800 out/film/film.mp4
  "$RENDER" still.json
  "$RENDER" film.json
  sha256sum out/*/*.png out/*/*.mp4 | diff before -
  [ "$(count_rendered)" -eq 7 ]
}

@test "no film and no sheet is made of damaged pictures" {
  "$RENDER" film.json
  ls "$frames"/*.png >list
  cp out/film/film.mp4 film.mp4
  cp out/film/contact.png contact.png
  for how in empty short wrong zeros; do
    cp "$frames/frame_0003.png" kept.png
    damage "$how" "$frames/frame_0003.png"
    run "$FROND_BIN" film list film.mp4
    echo "$how: $output"
    [ "$status" -eq 1 ]
    [[ $output == *"film.mp4 could not be encoded: "*" of 6 frames"* ]]
    [ "$how" = wrong ] || [[ $output == "$frames/frame_0003.png is damaged, or no PNG"* ]]
    run "$FROND_BIN" film list contact.png --columns 3
    [ "$status" -eq 1 ]
    [[ $output == *"contact.png could not be made: "* ]]
    mv kept.png "$frames/frame_0003.png"
  done
  cmp film.mp4 out/film/film.mp4
  cmp contact.png out/film/contact.png
}

@test "a picture that POV-Ray left half written does not count" {
  sed -i 's/^rm "$state"/truncate -s -9 "$picture"/' "$FROND_POVRAY"
  run "$RENDER" film.json --frames 2-2
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"frames/frame_0002.pov could not be rendered: povray left no whole picture"* ]]
  [ ! -e "$frames/frame_0002.png" ]
}

@test "a folder in the place of a result is told" {
  for name in film.mp4 contact.png frames/frame_0002.png; do
    rm -rf out
    mkdir -p "out/film/$name"
    run "$RENDER" film.json
    echo "$output"
    [ "$status" -eq 1 ]
    [[ $output == *"$name"*" is a folder; expected a "* ]]
    [ -z "$(ls -A "out/film/$name")" ]
  done
  make_preset still.json 1
  mkdir -p out/still/still.png out/still/film.mp4/mine
  run "$RENDER" still.json
  [ "$status" -eq 1 ]
  rmdir out/still/still.png
  "$RENDER" still.json
  [ -s out/still/still.png ]
  [ -d out/still/film.mp4/mine ]
}

@test "nothing is put into a folder in the place of their file" {
  "$RENDER" film.json --frames 1-1
  ls "$frames"/*.png >list
  mkdir folder
  for call in "$FROND_BIN frame $frames/frame_0001.pov folder 64x48" "$FROND_BIN film list folder" \
    "$FROND_BIN film list folder --columns 1"; do
    # shellcheck disable=SC2086
    run $call
    echo "$call: $output"
    [ "$status" -eq 1 ]
    [[ $output == *"folder is a folder; expected a file, or none"* ]]
    [ -z "$(ls -A folder)" ]
  done
}

# What links may point to: a file and a folder of frames, neither of which may change.
precious() {
  rm -rf mine
  mkdir -p mine/folder
  echo precious >mine/file
  echo precious >mine/folder/model_0123456789abcdef.inc
  echo precious >mine/folder/.frame_0001.kept
}
unharmed() { [ "$(cd mine && find . -type f -exec sha256sum {} + | sort)" = "$harmless" ]; }

@test "a link in the place of what is written by its name is refused before anything is written" {
  precious
  harmless=$(cd mine && find . -type f -exec sha256sum {} + | sort)
  local name target
  for name in .lock .ninja_log .ninja_deps .times film.mp4.list preview.mp4.list frames frames/.frame_0001.0.kept; do
    rm -rf out
    mkdir -p "$(dirname "out/film/$name")"
    target=$PWD/mine/file
    if [ "$name" = frames ]; then target=$PWD/mine/folder; fi
    ln -s "$target" "out/film/$name"
    for call in "$FROND_BIN generate film.json -o out/film" "$RENDER film.json" "$RENDER film.json --assets $PWD" "$RENDER film.json --every 4"; do
      # shellcheck disable=SC2086
      run $call
      echo "$name, $call: $output"
      [ "$status" -eq 1 ]
      [ "$(grep -c "out/film/$name: is a link, and what it points to would be written to; expected " <<<"$output")" -eq 1 ]
      unharmed
    done
    rm "out/film/$name"
    find out -type f ! -name .lock -print0 >left
    [ ! -s left ]
  done
}

@test "a link in the place of what is put there whole is replaced, and what it points to is left alone" {
  precious
  harmless=$(cd mine && find . -type f -exec sha256sum {} + | sort)
  mkdir -p out/film/frames
  local name
  for name in film.mp4 contact.png manifest.json build.ninja frames/frame_0001.pov frames/frame_0001.png preview.mp4 .film.mp4.part .mine; do
    ln -s "$PWD/mine/file" "out/film/$name"
  done
  run "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 0 ]
  unharmed
  [ "$(find out -type l)" = out/film/.mine ]  # which is nobody's
}

@test "nothing is written through a link in the place of its unfinished file" {
  precious
  harmless=$(cd mine && find . -type f -exec sha256sum {} + | sort)
  "$RENDER" film.json --frames 1-1
  ls "$frames"/*.png >list
  local name
  for name in .a.mp4.part .a.gif.part .a.gif.part.png .a.png.part .b.png.part .c.png.part .plot.svg.part; do ln -s mine/file "$name"; done
  "$FROND_BIN" film list a.mp4
  "$FROND_BIN" film list a.gif --title title
  "$FROND_BIN" film list a.png --columns 1
  "$FROND_BIN" film list b.png
  "$RENDER" film.json --frames 1-1 --plot plot.svg
  "$RENDER" --compare b.png b.png c.png
  unharmed
  # The same of a frame.
  rm "$frames/frame_0001.png" out/film/.times
  ln -s "$PWD/mine/file" out/film/.times
  cd out/film
  local key
  FRAME_TIME=1 "$FROND_BIN" frame frames/frame_0001.pov frames/frame_0001.png 64x48 3>&- &
  local running=$!
  until compgen -G 'frames/.frame_0001.*.spent' >/dev/null; do sleep 0.05; done
  key=$(compgen -G 'frames/.frame_0001.*.spent')
  wait "$running"
  for name in spent log kept png pov-state plain; do ln -s "$PWD/../../mine/file" "${key%.spent}.$name"; done
  rm frames/frame_0001.png
  "$FROND_BIN" frame frames/frame_0001.pov frames/frame_0001.png 64x48
  [ -s frames/frame_0001.png ]
  cd ../..
  unharmed
}

@test "sheets and farms write into no folder that a link leads to" {
  mkdir -p elsewhere sheet out/film
  ln -s ../elsewhere sheet/pictures
  ln -s ../../elsewhere out/film/farm
  run "$RENDER" film.json --contact-seeds 2 -o sheet
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"sheet/pictures: is a link, and what it points to would be written to; expected none"* ]]
  run "$ROOT/scripts/farm.sh" film.json --openjd job.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"out/film/farm: is a link, "* ]]
  [ -z "$(ls -A elsewhere)" ]
  rm out/film/farm
  echo precious >mine
  ln -s mine .job.json.part
  "$ROOT/scripts/farm.sh" film.json --openjd job.json
  [ "$(cat mine)" = precious ]
  local folder
  folder=$(realpath out/film/farm/latest)
  for name in call modules environment bands log/hosts failed/frames_1-4; do
    ln -sf "$PWD/mine" "$folder/$name"
    run "$ROOT/scripts/farm.sh" film.json --openjd job.json
    echo "$name: $output"
    [ "$status" -eq 1 ]
    [[ $output == *"$name: is a link, "* ]]
    [ "$(cat mine)" = precious ]
    rm "$folder/$name"
  done
}

@test "a failing encoder is told as that" {
  printf '#!/bin/sh\necho no such encoder >&2\nexit 1\n' >ffmpeg
  chmod +x ffmpeg
  FROND_FFMPEG=$PWD/ffmpeg run "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"no such encoder"* ]]
  [[ $output == *"error: the film could not be encoded; the frames of out/film are kept" ]]
  [[ $output != *"not all frames"* ]]
}

# with_disk FOLDER KILOBYTES COMMAND...: runs it with a small disk of its own in place of the folder
with_disk() {
  local folder=$1 size=$2
  shift 2
  mkdir -p "$folder"
  # shellcheck disable=SC2016
  unshare --map-root-user --mount bash -c 'mount -t tmpfs -o "size=$2k" frond "$1" && shift 2 && "$@"' - "$folder" "$size" "$@"
}

@test "a full disk is told in plain words, whatever filled it up" {
  with_disk small 100 true || skip "no disk can be mounted here"
  "$RENDER" film.json -o whole --frames 1-2
  use_real_povray
  local scenes
  scenes=$(du -k -c whole/frames/*.pov | tail -n 1 | cut -f1)
  run with_disk small 8 "$RENDER" film.json -o small/film --frames 1-2
  [ "$status" -ne 0 ]
  [[ $output == *"8.19 kB of the disk are free"* ]]
  # The folder of the frames alone has a small disk: the room that is estimated is that of the film's folder.
  for row in "8 64x48" "$((scenes + 60)) 64x48" "$((scenes + 900)) 320x180"; do  # scenes, notes of blocks, those of a picture
    run with_disk small/film/frames "${row% *}" "$RENDER" film.json -o small/film --frames 1-2 --size "${row#* }"
    echo "$row: $output"
    [ "$status" -eq 1 ]
    [[ $output == *"no room on the disk"* ]]
    [[ $output != *"space left"* ]]
  done
  # Noise makes everything larger than its disk.
  ffmpeg -nostdin -loglevel error -f lavfi -i "nullsrc=s=160x120,geq='random(1)*255:128:128'" -frames:v 1 -update 1 noise.png
  echo noise.png >list
  for call in "list small/film.mp4" "list small/sheet.png --columns 1" "list small/still.png"; do
    # shellcheck disable=SC2086
    run with_disk small 4 "$FROND_BIN" film $call
    echo "$call: $output"
    [ "$status" -eq 1 ]
    [[ $output == *": no room on the disk" ]]
  done
}

# A killed run and what it has started: its pid stands in the file pid.
killed_while_generating() {
  printf '#!/bin/sh\necho $$ >pid\nexec sleep 600\n' >slow
  chmod +x slow
  FROND_BIN=$PWD/slow "$FROND_BIN" render film.json >log 2>&1 3>&- &
  local script=$!
  until [ -s pid ]; do sleep 0.05; done
  kill "-$1" "$script"
  wait "$script" || true
  for _ in $(seq 200); do
    if ! kill -0 "$(cat pid)" 2>/dev/null; then return 0; fi
    sleep 0.05
  done
  kill "$(cat pid)"
  return 1
}

@test "a killed run leaves no generate alive" { killed_while_generating KILL; }
@test "a stopped run waits for no generate" { killed_while_generating TERM; }
