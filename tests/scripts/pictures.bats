# Formats, comparisons and sheets, with a povray that only pretends.

bats_require_minimum_version 1.5.0

setup() {
  load common
  begin_with_a_film
}

tag() { ffprobe -v error -show_entries "format_tags=$1" -of csv=p=0 "file:$2"; }
size_of() { ffprobe -v error -select_streams v:0 -show_entries stream=width,height -of csv=p=0 "file:$1"; }
color() { ffmpeg -nostdin -loglevel error -f lavfi -i "color=$1:s=${3:-64x48},format=rgb24" -frames:v 1 -update 1 -y "$2"; }

@test "a film may be MP4, WebM, GIF or WebP, has its frames, and title and seed in its metadata" {
  for format in mp4 webm gif; do
    "$RENDER" film.json --format "$format" --set '/title=A $(title): "x"'
    [ "$(frames_of "out/film/film.$format")" -eq 6 ]
  done
  [ "$(count_rendered)" -eq 6 ]
  for film in out/film/film.mp4 out/film/film.webm; do
    [ "$(tag title "$film")" = '"A $(title): ""x"""' ]
  done
  [ "$(tag comment out/film/film.mp4)" = "seed 3" ]
  [ "$(tag COMMENT out/film/film.webm)" = "seed 3" ]
  [ "$(tag comment out/film/film.gif)" = '"A $(title): ""x""; seed 3"' ]
  # The program of the library says what is in a WebP, which ffmpeg does not read.
  "$RENDER" film.json --format webp --set '/title=A $(title): "x"'
  webpinfo -quiet out/film/film.webp
  webpmux -info out/film/film.webp >info
  [ "$(awk '/^ +[0-9]+:/ {sum += $7} END {print sum}' info)" -eq 1000 ]  # 6 frames, 6 a second
  grep -q "Loop Count : 0" info
  webpmux -get xmp out/film/film.webp -o xmp
  grep -q '>A $(title): &quot;x&quot;<.*>seed 3<' xmp
  run "$RENDER" film.json --format webp --set '/title=A $(title): "x"'
  [[ $output == *"Nothing to render"* ]]
  run "$FROND_BIN" compare out/film/film.webp out/film/film.mp4
  [ "$status" -eq 2 ]
  [[ $output == *"expected .png, .mp4, .mov, .webm or .gif"* ]]
  sha256sum out/film/film.* >before
  rm out/film/film.*
  for format in mp4 webm gif webp; do "$RENDER" film.json --format "$format" --set '/title=A $(title): "x"'; done
  sha256sum -c before
  run "$RENDER" film.json --format avi
  [ "$status" -eq 2 ]
  [[ $output == *"--format needs mp4, webm, gif, webp or mov, not 'avi'"* ]]
}

@test "no film of other frames is left beside the new one" {
  "$RENDER" film.json
  "$RENDER" film.json --format gif
  [ -s out/film/film.mp4 ]
  "$RENDER" film.json --format webm --frames 1-3
  run ls out/film
  [ "$output" = $'build.ninja\ncontact.png\nfilm.webm\nframes\nmanifest.json' ]
}

@test "two pictures are shown side by side with their difference, in figures too" {
  color 0x202020 "a 'b.png"
  color 0x302020 'b;c.png'
  run "$RENDER" --compare "a 'b.png" 'b;c.png' both.png
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"They differ by 9.24 of 255 (RMSE), at most by 16, and by more than 8 in 100 % of the pixels."* ]]  # 16 in one of three
  [ "$(size_of both.png)" = 192,94 ]
  # The last third is four times the difference.
  ffmpeg -nostdin -loglevel error -i both.png -vf crop=1:1:160:20,format=rgb24 -f rawvideo pixel
  [ "$(od -An -tu1 pixel | tr -s " ")" = " 64 0 0" ]
  run "$RENDER" --compare "a 'b.png" "a 'b.png" both.png
  [[ $output == *"No pixel differs."* ]]
  run --separate-stderr "$FROND_BIN" compare "a 'b.png" 'b;c.png' --json
  echo "$output"
  [ "$output" = '{"error": 9.237604, "maximum": 16, "share_beyond_8": 1}' ]
  [ ! -e out/compare.png ]
  "$FROND_BIN" compare "a 'b.png" 'b;c.png'
  [ "$(size_of out/compare.png)" = 192,94 ]
}

@test "two films are compared frame by frame" {
  mkdir one two
  for n in 1 2 3 4; do color gray "$n.png"; done
  printf '%s.png\n' 1 2 3 4 >list
  "$FROND_BIN" film list one/film.mp4 --fps 12
  color white 3.png
  "$FROND_BIN" film list two/film.mp4
  run "$RENDER" --compare one two
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"of 4 frames differ, most of all frame 3: by 1"* ]]
  [ "$(frames_of out/compare.mp4)" -eq 4 ]
  run "$RENDER" --compare one one
  [[ $output == *"No pixel differs."* ]]
  printf '%s.png\n' 1 2 4 >list
  "$FROND_BIN" film list two/film.mp4
  run --separate-stderr "$FROND_BIN" compare one two/film.mp4 --json
  echo "$output"
  [[ $output == *'"frames": 3, "frames_that_differ": 0, "frames_left_out": 1, "worst_frame": 0'* ]]
}

@test "folders of frames are compared picture by picture, as they flicker too" {
  mkdir -p one/frames two three/frames four/frames five
  for n in 1 2 3 4; do
    color 0x646464 "one/frames/frame_000$n.png"
    color 0x6e6e6e "two/frame_000$n.png"  # 10 brighter throughout
    color "$( ((n % 2)) && echo 0x6e6e6e || echo 0x5a5a5a)" "three/frames/frame_000$n.png"  # by turns
    color 0x646464 "four/frames/frame_000$n.png" "$( ((n == 3)) && echo 32x32 || echo 64x48)"
  done
  run --separate-stderr "$FROND_BIN" compare one two --json
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$output" = '{"error": 10, "maximum": 10, "share_beyond_8": 1, "flicker": 0, "frames": 4, "frames_that_differ": 4, "frames_left_out": 0, "worst_frame": 1, "worst_error": 10}' ]
  cp two/frame_0003.png two/frame_0004_s2.png  # of an exposure: no frame
  rm two/frame_0001.png two/frame_0002.png
  color 0x808080 two/frame_0007.png
  run --separate-stderr "$FROND_BIN" compare one/frames three --json
  echo "$output"
  [[ $output == '{"error": 10, "maximum": 10, "share_beyond_8": 1, "flicker": 10, '* ]]
  run "$RENDER" --compare one two
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"2 of 2 frames differ, most of all frame 3: by 10 of 255 (RMSE)."*"the difference flickers by 0 of 255. Not counted: frames that only one has, 3."* ]]
  [[ $output == *"one: a folder without film or still"* ]]
  [ ! -e out ]
  run --separate-stderr "$FROND_BIN" compare one four --json
  [ "$status" -eq 2 ]
  [ -z "$output" ]
  [ "$stderr" = "error: four/frames/frame_0003.png is of 32x32 pixels, one/frames/frame_0003.png of 64x48; expected one size" ]
  color 0x646464 five/frame_0009.png
  run "$FROND_BIN" compare one five --json
  [ "$status" -eq 2 ]
  [ "$output" = "error: one/frames and five have no frame of one number" ]
  run "$FROND_BIN" compare one three both.mp4
  [ "$status" -eq 2 ]
  [[ $output == *"one: a folder without film or still" ]]
  truncate -s -9 four/frames/frame_0002.png
  run "$FROND_BIN" compare one four
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == "error: four/frames/frame_0002.png"* ]]
}

@test "what cannot be compared is told" {
  color gray a.png
  color gray b.png 32x32
  mkdir empty
  echo a.png >list
  "$FROND_BIN" film list a.mp4 --fps 12
  for row in "a.png b.png|a.png is of 64,48 pixels, b.png of 32,32" "a.png a.mp4|expected two films or two pictures" \
    "a.png empty|empty: a folder without film or still" "a.png none|none: no such film" "a.png list|expected .png" \
    "a.png a.png c.mp4|c.mp4: expected a name that ends in .png" "a.png|expected A B"; do
    # shellcheck disable=SC2086
    run "$RENDER" --compare ${row%|*}
    echo "$row: $output"
    [ "$status" -eq 2 ]
    [[ $output == *"${row#*|}"* ]]
  done
  run "$FROND_BIN" compare a.png b.png --json
  [ "$status" -eq 2 ]
  [ "$output" = "error: a.png is of 64,48 pixels, b.png of 32,32; expected one size" ]
  echo no >damaged.mp4
  run "$RENDER" --compare a.mp4 damaged.mp4
  [ "$status" -eq 1 ]
  [ ! -e out/compare.mp4 ]
}

@test "a sweep is a sheet of labelled pictures, and a longer one renders only the new ones" {
  run "$RENDER" film.json --sweep /organisms/0/pitch=10:30:3 --size 80x60
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"Picture 2 of 3: pitch 20"* ]]
  [ "${lines[-1]}" = "$PWD/out/film-sheet/sheet.png" ]
  [ "$(size_of out/film-sheet/sheet.png)" = 172,188 ]  # 2 by 2, each 80 by 60 and 28
  [ "$(sort -u "$RENDERED")" = frames/frame_0006.pov ]
  "$RENDER" film.json --sweep=/organisms/0/pitch=10:30:5 --size=80x60
  [ "$(count_rendered)" -eq 5 ]
  [ "$(cat out/film-sheet/pictures/*/manifest.json | grep preset_hash | sort -u | wc -l)" -eq 5 ]
}

@test "two sweeps make a grid, and seeds are one of them" {
  run "$FROND_BIN" sheet film.json --contact-seeds 2 --sweep /organisms/0/pitch=1e1:30:3 --frames 2-2 -o grid
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"Picture 3 of 6: seed 1   pitch 20"* ]]
  [ "$(size_of grid/sheet.png)" = 140,298 ]  # 2 by 3, with labels of two lines
  [ "$(sort -u "$RENDERED")" = frames/frame_0002.pov ]
  [ "$(cat grid/pictures/*/manifest.json | grep -c ".seed.: 2,")" -eq 3 ]
}

@test "no label of small pictures is cut" {
  local row size tile column
  for row in "160x90 46" "96x64 64"; do  # two lines, three
    size=${row% *}
    "$RENDER" film.json --sweep /organisms/0/angle_jitter=10.125:30.875:2 --sweep /organisms/0/pitch=11.125:12.375:2 --size "$size" -o "out/$size"
    local width=${size%x*} height=${size#*x} whole
    whole=$(size_of "out/$size/sheet.png")
    local below=$(((${whole#*,} - 12) / 2 - height))
    echo "$size: $below pixels below each"
    [ "$below" -eq "${row#* }" ]
    for tile in 0 1; do
      ffmpeg -nostdin -loglevel error -y -i "out/$size/sheet.png" -vf "crop=$width:$below:$((4 + tile * (width + 4))):$((4 + height)),format=gray" -f rawvideo label
      # Nothing stands at either edge, much between them.
      for column in 0 1 $((width - 2)) $((width - 1)); do
        [ "$(od -An -v -tu1 -w"$width" label | awk -v at=$((column + 1)) '$at != 32' | wc -l)" -eq 0 ]
      done
      [ "$(od -An -v -tu1 -w1 label | awk '$1 > 200' | wc -l)" -gt 60 ]
    done
  done
}

@test "what no sheet can be made of is told" {
  for row in "--sweep /seed|--sweep needs POINTER=FROM:TO:COUNT" "--sweep seed=1:2:3|--sweep needs" \
    "--contact-seeds 0|--contact-seeds needs" "--contact-seeds 2 --frames 1-2|--frames needs one frame" \
    "--sweep /seed=1:2:2 --sweep /a=1:2:2 --sweep /b=1:2:2|two directions" \
    "--sweep /organisms/0/pitch=10:1000:2|picture 2 of 2 (pitch 1000) could not be made" \
    "--sweep /organisms/7/pitch=10:20:2|--set /organisms/7/pitch"; do
    # shellcheck disable=SC2086
    run "$RENDER" film.json ${row%|*} -o none
    echo "$row: $output"
    [ "$status" -eq 2 ]
    [[ $output == *"${row#*|}"* ]]
    [ ! -e none/sheet.png ]
  done
  run "$RENDER" oka --contact-seeds 4
  [ "$status" -eq 2 ]
  [[ $output == *"oka: no such preset; did you mean "* ]]
}

@test "each K-th frame comes first, and the film can be seen meanwhile" {
  make_preset film.json 9
  # Notes how many frames each film that is made holds.
  printf '#!/bin/sh\nfor last; do :; done\nffmpeg "$@" || exit 1\ncase $last in *.part) echo "$last" >>made ;; esac\n' >ffmpeg
  sed -i "s|>>made|>>$PWD/made|" ffmpeg
  chmod +x ffmpeg
  FROND_FFMPEG=$PWD/ffmpeg run "$RENDER" film.json --every 4 --jobs 1
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(sed 's/[^0-9]//g; s/^0*//' "$RENDERED" | paste -sd ' ')" = "1 5 9 3 7 2 4 6 8" ]
  [ "$(grep -c preview made)" -eq 2 ]
  [[ $output == *"out/film/preview.mp4"*"frame 6 of 9"* ]]
  [[ $output == *" s of processor; the slowest frames: "* ]]
  [ ! -e out/film/preview.mp4 ]
  "$RENDER" film.json -o other
  cmp other/film.mp4 out/film/film.mp4
}

@test "a frame that fails stops no other, and shows what POV-Ray says" {
  cat >frond <<SH
#!/usr/bin/env bash
"$FROND_BIN" "\$@" || exit
[[ \$1 == generate ]] || exit 0
for n in 2 5; do echo broken >out/film/frames/frame_000\$n.pov; done
SH
  chmod +x frond
  for every in 1 3; do
    rm -rf out
    : >"$RENDERED"
    FROND_BIN=$PWD/frond run "$RENDER" film.json --every "$every"
    echo "$output"
    [ "$status" -eq 1 ]
    [ "$(count_rendered)" -eq 4 ]
    [ "$(grep -c "Expected 'object'" <<<"$output")" -eq 2 ]
    [ "${lines[-1]}" = "error: of out/film these frames could not be rendered: 2, 5; those that are finished are kept" ]
  done
}

@test "a run says why a frame is out of date" {
  run "$RENDER" film.json --why 2
  [[ $output == *"frame 2 is rendered again: there is no picture of it"* ]]
  "$RENDER" film.json
  run "$RENDER" film.json --why 2
  [[ $output == *"frame 2 is up to date" ]]
  run "$RENDER" film.json --why 2 --size 80x60
  [[ $output == *"frame 2 is rendered again: "* ]]
  run "$RENDER" film.json --why 2 --quality good
  [[ $output == *"frame 2 is rendered again: "* ]]
  "$RENDER" film.json
  run "$RENDER" film.json --why 2 --set '/scene/camera/look_at=[0, 0.4, 0]'
  echo "$output"
  [[ $output == *"frame 2 is rendered again: its scene is newer than its picture"*"its scene has changed, from line "*"was: "*"is: "* ]]
  "$RENDER" film.json
  truncate -s -5 out/film/frames/frame_0002.png
  run "$RENDER" film.json --why 2
  [[ $output == *"frame_0002.png is damaged"*"there is no picture of it" ]]
  run "$RENDER" film.json --why 7
  [ "$status" -eq 2 ]
  [[ $output == *"--why: 7 is no frame of this film; expected 1-6" ]]
  [ "$(count_rendered)" -le 18 ]
}

@test "a plot shows nodes, bytes and seconds of each frame" {
  run "$RENDER" film.json --plot "a 'plot.svg"
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"/a 'plot.svg"* ]]
  for title in nodes "bytes of the scene" "seconds of processor"; do grep -q ">$title</text>" "a 'plot.svg"; done
  [ "$(grep -c 'class="line" d="M60.0 .*L620.0 ' "a 'plot.svg")" -eq 3 ]
  [ "$(wc -l <out/film/.times)" -eq 6 ]
  run "$RENDER" film.json --plot plot.png
  [ "$status" -eq 2 ]
}

@test "what a run takes is estimated from what the last one took" {
  reckoned() { "$FROND_BIN" info film.json --json "$@" | sed 's/.*"render_seconds": \([0-9.]*\).*/\1/'; }
  export XDG_CACHE_HOME=$BATS_TEST_TMPDIR/another
  run "$FROND_BIN" info film.json
  [[ $output == *" to render (reckoned on no run of this machine)" ]]
  local first
  first=$(reckoned)
  mkdir -p another/frond
  echo "machine 2 6" >another/frond/pace  # three times as slow
  [ "$(awk -v a="$first" -v b="$(reckoned)" 'BEGIN { print (b > 2.8 * a && b < 3.2 * a) }')" = 1 ]
  run "$RENDER" film.json
  [[ $output == *"estimate: "*" of disk, "*" of processor to render (reckoned on other runs of this machine)"* ]]
  # The fake povray takes no more than a moment, whatever is estimated of the real one; the next estimate knows.
  local taken
  taken=$(awk '{ all += $2 } END { print all / 1000 }' out/film/.times)
  echo "$taken $(reckoned)"
  [ "$(awk -v a="$taken" -v b="$(reckoned)" 'BEGIN { print (b > a / 2 - 0.1 && b < a * 2 + 0.1) }')" = 1 ]
  run "$FROND_BIN" info film.json
  [[ $output == *"(reckoned on its last run)" ]]
  "$RENDER" film.json  # renders nothing, and so measures nothing
  [ "$(wc -l <another/frond/pace)" -eq 2 ]
}

@test "a machine that nothing is known of is measured by a small picture" {
  export XDG_CACHE_HOME=$BATS_TEST_TMPDIR/another
  use_real_povray
  "$RENDER" film.json --frames 1-1
  [[ $(head -n 1 another/frond/pace) =~ ^machine\ 2\ [0-9.]+$ ]]
  [ "$(awk '$1 == "machine" { print ($3 > 0.1) }' another/frond/pace)" = 1 ]
}
