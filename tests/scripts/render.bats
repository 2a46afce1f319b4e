# scripts/render.sh with a povray that only pretends, but for the last test.

setup() {
  load common
  begin_with_a_film
}

@test "a film has its frames, and a second run renders nothing" {
  run "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"frame 6 of 6"* ]]
  [[ $output == *$'\nout/film/film.mp4\nout/film/contact.png' ]]
  [ "$(count_rendered)" -eq 6 ]
  [ "$(frames_of out/film/film.mp4)" -eq 6 ]
  [ -s out/film/contact.png ]

  run "$RENDER" film.json
  [ "$status" -eq 0 ]
  [[ $output == *"Nothing to render"* ]]
  [ "$(count_rendered)" -eq 6 ]
}

@test "nothing but the results and what ninja needs is left" {
  "$RENDER" film.json
  run ls -A out/film
  [ "$output" = $'.lock\n.ninja_log\n.times\nbuild.ninja\ncontact.png\nfilm.mp4\nframes\nmanifest.json' ]
  [ "$(find out/film/frames -name '.*' -type f | wc -l)" -eq 0 ]
}

@test "the film is BT.709, 4:2:0, of even size, with its header in front" {
  "$RENDER" film.json --size 63x47 --frames 1-2
  run ffprobe -v error -show_entries stream=width,height,pix_fmt,color_space,color_range -of csv=p=0 out/film/film.mp4
  echo "$output"
  [ "$output" = "64,48,yuv420p,tv,bt709" ]
  [ "$(grep -abo moov out/film/film.mp4 | head -n 1 | cut -d: -f1)" -lt "$(grep -abo mdat out/film/film.mp4 | head -n 1 | cut -d: -f1)" ]
}

@test "colours come back as they were" {
  mkdir colours
  ffmpeg -nostdin -loglevel error -f lavfi -i "color=0xff7f6a:s=64x48" -frames:v 1 -update 1 colours/a.png
  echo colours/a.png >colours/list
  "$FROND_BIN" film colours/list colours/film.mp4 --title "it's \$(a) \"title\""
  ffmpeg -nostdin -loglevel error -i colours/film.mp4 -vf scale=in_color_matrix=bt709,format=rgb24 -f rawvideo colours/raw
  read -r r g b <<<"$(od -An -tu1 -N3 colours/raw)"
  echo "$r $g $b"
  ((r > 250 && g > 121 && g < 133 && b > 100 && b < 112))
  [ "$(ffprobe -v error -show_entries format_tags=title -of csv=p=0 colours/film.mp4)" = "\"it's \$(a) \"\"title\"\"\"" ]
}

@test "a changed camera renders all frames again, a changed size, too" {
  "$RENDER" film.json
  "$RENDER" film.json --set '/scene/camera/look_at=[0, 0.4, 0]'
  [ "$(count_rendered)" -eq 12 ]
  "$RENDER" film.json --set='/scene/camera/look_at=[0, 0.4, 0]' --size=80x60
  [ "$(count_rendered)" -eq 18 ]
  run ffprobe -v error -show_entries stream=width,height -of csv=p=0 out/film/film.mp4
  [ "$output" = 80,60 ]
}

@test "a shorter film holds no frame of the longer one before" {
  "$RENDER" film.json
  run "$RENDER" film.json --frames 2-4
  [ "$status" -eq 0 ]
  [ "$(count_rendered)" -eq 6 ]
  [ "$(frames_of out/film/film.mp4)" -eq 3 ]
  "$RENDER" film.json
  [ "$(count_rendered)" -eq 6 ]
  [ "$(frames_of out/film/film.mp4)" -eq 6 ]
}

@test "a still has a picture and no film, and a film no still" {
  "$RENDER" film.json -o both
  "$RENDER" film.json -o both --set /film/frames=1
  [ -s both/still.png ]
  [ ! -e both/film.mp4 ]
  "$RENDER" film.json -o both
  [ ! -e both/still.png ]
  [ -s both/film.mp4 ]
}

# kill_and_resume SIGNAL EXIT_CODE: in a film of 12 frames
kill_and_resume() {
  make_preset long.json 12
  FRAME_TIME=0.6 "$RENDER" long.json --jobs 2 >log 2>&1 3>&- &
  local running=$! status=0
  for _ in $(seq 200); do
    # Two of them may not be in their place yet.
    if [ "$(count_rendered)" -ge 5 ]; then break; fi
    sleep 0.05
  done
  kill "-$1" "$running"
  wait "$running" || status=$?
  [ "$status" -eq "$2" ]
  for _ in $(seq 600); do  # until no one is left that renders
    if ! readlink /proc/[0-9]*/cwd 2>/dev/null | grep -qxF "$PWD/out/long"; then break; fi
    sleep 0.05
  done
  # A kill may fall between a picture's coming into its place and its being noted as done; two are rendered at once.
  local finished placed
  finished=$(grep -c 'frames/frame_[0-9]*\.png' out/long/.ninja_log)
  placed=$(find out/long/frames -name 'frame_*.png' | wc -l)
  ((placed >= finished && placed <= finished + 2))
  ((finished >= 3 && finished < 12))
  stat -c '%n %y' out/long/frames/*.png >before
  sleep 1
  [ "$(find out/long/frames -name 'frame_*.png' | wc -l)" -eq "$placed" ]

  : >"$RENDERED"
  run "$RENDER" long.json
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"Rendering $((12 - finished)) of 12 frames"* ]]
  [ "$(count_rendered)" -eq $((12 - finished)) ]
  stat -c '%n %y' out/long/frames/*.png >after
  [ "$(grep -cxFf before after)" -eq "$finished" ]
  [ "$(frames_of out/long/film.mp4)" -eq 12 ]
  [ "$(find out/long/frames -name '.*' -type f | wc -l)" -eq 0 ]
}

@test "killed in the middle, the next run renders only the rest" {
  kill_and_resume KILL 137
}

@test "stopped in the middle, the next run renders only the rest" {
  kill_and_resume TERM 130
  grep -q "goes on from there" log
}

# A still whose rendering is killed when half of it is done.
kill_still() {
  FRAME_TIME=3 "$RENDER" still.json >log 2>&1 3>&- &
  local running=$! status=0
  for _ in $(seq 100); do
    if grep -q "50 % of the picture" log; then break; fi
    sleep 0.1
  done
  kill -KILL "$running"
  wait "$running" || status=$?
  [ "$status" -eq 137 ]
  grep -q "50 % of the picture" log
}

@test "a killed still goes on, and begins anew where scene, size or quality changed" {
  make_preset still.json 1
  for change in "--set=/scene/camera/look_at=[0, 0.4, 0]" "--size=80x60" "--quality=good"; do
    kill_still
    "$RENDER" still.json "$change"
    [ ! -e "$RENDERED.continued" ]
  done
  kill_still
  "$RENDER" still.json
  [ "$(cat "$RENDERED.continued")" = frames/frame_0001.pov ]
  [ -s out/still/still.png ]
  [ "$(find out/still/frames -name '.*' -type f | wc -l)" -eq 0 ]
}

@test "with a shutter a frame is made of exposures; without it they are gone" {
  run "$RENDER" film.json --set /scene/camera/shutter=0.5 --set /scene/camera/shutter_samples=3
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(sort -u "$RENDERED" | wc -l)" -eq 18 ]
  [ "$(count_rendered)" -eq 18 ]
  [ "$(frames_of out/film/film.mp4)" -eq 6 ]
  [ "$(find out/film/frames -name '.*' -type f | wc -l)" -eq 0 ]
  [ "$(wc -l <out/film/.times)" -eq 6 ]
  "$RENDER" film.json
  [ "$(count_rendered)" -eq 24 ]
  [ -z "$(find out/film/frames -name '*_s*')" ]
}

@test "a frame of several exposures that is killed goes on behind the last whole one" {
  make_preset blur.json 2
  FRAME_TIME=0.7 "$RENDER" blur.json --jobs 1 --frames 1-1 --set /scene/camera/shutter=0.5 --set /scene/camera/shutter_samples=5 >log 2>&1 3>&- &
  local running=$!
  for _ in $(seq 200); do
    if [ "$(count_rendered)" -ge 2 ]; then break; fi
    sleep 0.05
  done
  sleep 0.3
  kill -KILL "$running"
  wait "$running" || true
  sleep 1
  local before
  before=$(count_rendered)
  ((before >= 2 && before < 5))
  "$RENDER" blur.json --frames 1-1 --set /scene/camera/shutter=0.5 --set /scene/camera/shutter_samples=5
  cat "$RENDERED"
  (($(count_rendered) <= 6))
  [ "$(sort -u "$RENDERED" | wc -l)" -eq 5 ]
  [ -s out/blur/film.mp4 ]
  [ "$(find out/blur/frames -name '.*' -type f | wc -l)" -eq 0 ]
}

@test "an exposure that is gone is named" {
  local shutter=(--set /scene/camera/shutter=0.5 --set /scene/camera/shutter_samples=2)
  "$FROND_BIN" generate film.json -o out/film -q "${shutter[@]}"
  rm out/film/frames/frame_0002_s2.pov
  cd out/film
  run "$FROND_BIN" frame frames/frame_0002.pov frames/frame_0002.png 64x48
  [ "$status" -eq 1 ]
  [[ $output == *"frame_0002.pov could not be rendered: its exposure frames/frame_0002_s2.pov is gone" ]]
}

@test "the times of a picture that was stopped and taken up again add up" {
  make_preset still.json 1
  "$FROND_BIN" generate still.json -o out/still -q
  cat >slow-povray <<SH
#!/usr/bin/env bash
python3 -c 'while __import__("time").process_time() < 0.6: pass'
: >"$BATS_TEST_TMPDIR/worked"
exec "$FROND_POVRAY" "\$@"
SH
  chmod +x slow-povray
  cd out/still
  FROND_POVRAY=$BATS_TEST_TMPDIR/slow-povray FRAME_TIME=30 "$FROND_BIN" frame frames/frame_0001.pov frames/frame_0001.png 64x48 3>&- &
  local running=$!
  until [ -e "$BATS_TEST_TMPDIR/worked" ]; do sleep 0.05; done
  kill -TERM "$running"
  wait "$running" || true
  FROND_POVRAY=$BATS_TEST_TMPDIR/slow-povray "$FROND_BIN" frame frames/frame_0001.pov frames/frame_0001.png 64x48
  cat .times
  read -r _ took _ <.times
  ((took > 1000))
}

@test "a still takes all processors, the frames of a film one each" {
  make_preset still.json 1
  "$RENDER" still.json --jobs 3
  "$RENDER" film.json --jobs 3
  [ "$(uniq -c "$RENDERED.threads" | tr -s ' \n' ' ')" = " 1 3 6 1 " ]
}

@test "a scale multiplies the size" {
  make_preset still.json 1
  "$RENDER" still.json --scale 2.5
  [ "$(ffprobe -v error -show_entries stream=width,height -of csv=p=0 out/still/still.png)" = 160,120 ]
  "$RENDER" still.json --scale=2 --size 50x40
  [ "$(ffprobe -v error -show_entries stream=width,height -of csv=p=0 out/still/still.png)" = 100,80 ]
  run "$RENDER" still.json --scale 16 --size 1100x40
  [ "$status" -eq 2 ]
  [ "$output" = "--scale: pictures of 1100x40 would be 17600x640 pixels; expected 16384 at most" ]
}

@test "a frame that fails is shown with file, line and reason" {
  cat >frond <<SH
#!/usr/bin/env bash
"$FROND_BIN" "\$@" || exit
[[ \$1 == generate ]] || exit 0
echo broken >out/film/frames/frame_0003.pov
SH
  chmod +x frond
  FROND_BIN=$PWD/frond run "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"File 'frames/frame_0003.pov' line 1: Parse Error: Expected 'object',"*"'broken' found"* ]]
  [[ $output != *"/frond' frame"* ]]
  [ ! -e out/film/film.mp4 ]
  run "$RENDER" film.json
  [ "$status" -eq 0 ]
  [ "$(frames_of out/film/film.mp4)" -eq 6 ]
}

@test "wrong input is exit code 2" {
  for arguments in "nothing.json" "film.json --nonsense" "film.json film.json" "film.json --jobs 0" \
    "film.json --frames" "film.json --frames x" "film.json --size 0x0" "film.json --scale" "film.json --scale 0.5" "film.json --scale 17" "film.json --scale big" "film.json --quality grand" "film.json --set /film=3"; do
    # shellcheck disable=SC2086
    run "$RENDER" $arguments
    echo "$arguments: $status $output"
    [ "$status" -eq 2 ]
    [ -n "$output" ]
  done
  echo '{"film": {"framse": 3}}' >wrong.json
  run "$RENDER" wrong.json
  [ "$status" -eq 2 ]
  [[ $output == *wrong.json:1:*framse* ]]
  run "$RENDER" reff.json
  [ "$status" -eq 2 ]
  [[ $output == *presets/reef.json* ]]
}

@test "a folder that cannot be made is exit code 1" {
  : >file
  run "$RENDER" film.json -o file/out
  [ "$status" -eq 1 ]
  [[ $output == *file/out* ]]
}

@test "names may hold blanks, quotes, dollars, a leading dash and more" {
  odd="-o 'dd \"\$(touch oops)\$x \`touch oops\`;é|:%d"
  mkdir -- "./$odd"
  cp film.json "./$odd/-pre'set \$1.json"
  cd -- "./$odd"
  run "$RENDER" -o "-o'ut \$x:|%04d" --set "/title=\$(touch oops) 'title' : \"x\"" --frames 1-3 -- "-pre'set \$1.json"
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(frames_of "./-o'ut \$x:|%04d/film.mp4")" -eq 3 ]
  [ -z "$(find "$BATS_TEST_TMPDIR" -name oops)" ]
  run "$RENDER" --frames=1-3 -o "-o'ut \$x:|%04d" --set "/title=\$(touch oops) 'title' : \"x\"" -- "-pre'set \$1.json"
  [[ $output == *"Nothing to render"* ]]
  "$RENDER" --frames=1-2 -- "-pre'set \$1.json"
  [ -s "out/-pre'set \$1/film.mp4" ]
}

@test "two runs at once into one folder wait for each other" {
  FRAME_TIME=0.2 "$RENDER" film.json >log1 2>&1 3>&- &
  first=$!
  FRAME_TIME=0.2 "$RENDER" film.json >log2 2>&1 3>&- &
  wait "$first"
  wait $!
  cat log1 log2 "$RENDERED"
  [ "$(count_rendered)" -eq 6 ]
  cat log1 log2 | grep -q "waiting for it"
}

@test "help has examples" {
  run "$RENDER" --help
  [ "$status" -eq 0 ]
  [[ $output == *"Examples:"* ]]
}

@test "a clone in a folder with an odd name renders" {
  copy="cl'one \$x \"é:|"
  mkdir -p "$copy"
  cp -r "$ROOT/scripts" "$ROOT/povinc" "$ROOT/templates" "$copy"
  use_real_povray
  run "$copy/scripts/render.sh" film.json --frames 6-6 --size 32x24
  echo "$output"
  [ "$status" -eq 0 ]
  [ -s out/film/film.mp4 ]
}

@test "POV-Ray itself renders frames that are not blank and differ" {
  use_real_povray
  run "$RENDER" film.json
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(frames_of out/film/film.mp4)" -eq 6 ]
  for frame in 1 6; do
    ffmpeg -nostdin -loglevel error -i "out/film/frames/frame_000$frame.png" -f rawvideo -pix_fmt gray "$frame.gray"
    [ "$(stat -c %s "$frame.gray")" -eq $((64 * 48)) ]
    # More than a few shades of grey.
    [ "$(od -An -v -tu1 -w1 "$frame.gray" | sort -u | wc -l)" -gt 16 ]
  done
  run cmp -s 1.gray 6.gray
  [ "$status" -eq 1 ]
}

@test "a preset whose name is not UTF-8 is rendered as any other" {
  name=$(printf 'b\xe4um')
  mv film.json "$name.json"
  run "$RENDER" "$name.json" --frames 1-2
  echo "$output"
  [ "$status" -eq 0 ]
  [ -s "out/$name/film.mp4" ]
  python3 -c 'import json,sys; json.loads(open(b"out/b\xe4um/manifest.json", encoding="utf-8").read())'
}
