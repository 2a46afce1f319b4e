# Films that are resolved from raw frames, and passes, by POV-Ray itself.

bats_require_minimum_version 1.5.0

setup() {
  load common
  begin_with_a_film
  use_real_povray
  # Quality changes lights and shadows, too: all are as fine, but for the samples.
  sed -i 's/"quality": "draft"/"quality": "best"/' film.json
}

# error_of A B: how much two pictures differ, in hundredths of a step of 255
error_of() {
  "$FROND_BIN" compare "$1" "$2" --json | sed -E 's/.*"error": ?([0-9]+)\.?([0-9]?[0-9]?).*/\1 \2/' | {
    read -r whole hundredths
    echo $((100 * whole + 10#${hundredths:-0}))
  }
}

@test "resolved frames are far smoother than raw ones, and a part of a film is as the whole" {
  run "$RENDER" film.json --resolve
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(frames_of out/film/film.mp4)" -eq 6 ]
  "$RENDER" film.json --frames 4-4 --out best
  raw=$(error_of best/frames/frame_0004.png out/film/raw/frame_0004.png)
  resolved=$(error_of best/frames/frame_0004.png out/film/frames/frame_0004.png)
  echo "raw $raw resolved $resolved"
  [ "$raw" -gt 0 ]
  [ $((10 * resolved)) -lt $((7 * raw)) ]

  run "$RENDER" film.json --resolve --frames 4-5 --every 2 --out part
  [[ $output == *"One of 2 frames is there, and a film of them: part/preview.mp4"* ]]
  cmp part/frames/frame_0004.png out/film/frames/frame_0004.png
  [ "$(frames_of part/film.mp4)" -eq 2 ]

  run "$RENDER" film.json --resolve
  [[ $output == *"Nothing to render"* ]]

  rm out/film/raw/frame_0003.png
  cp out/film/frames/frame_0003.png before.png
  run "$RENDER" film.json --resolve
  [ "$status" -eq 0 ]
  cmp before.png out/film/frames/frame_0003.png
}

@test "the quality good is resolved, a still, too, and all its samples are drawn where that is asked for" {
  run "$RENDER" film.json --quality good --set /film/frames=1 -o still
  echo "$output"
  [ "$status" -eq 0 ]
  [ -s still/still.png ]
  "$RENDER" film.json --set /film/frames=1 -o best
  "$RENDER" film.json --quality good --set /film/frames=1 --no-resolve -o plain
  [ ! -e plain/raw ]
  resolved=$(error_of best/still.png still/still.png) plain=$(error_of best/still.png plain/still.png)
  echo "resolved $resolved plain $plain"
  [ $((2 * resolved)) -lt $((3 * plain)) ]  # sand, of four samples rather than nine
  grep -q '^flags = -A -J$' still/build.ninja
  # It is drawn twice as wide and high.
  size=$(sed -n 's/^size = //p' plain/build.ninja)
  grep -q "^size = $((2 * ${size%x*}))x$((2 * ${size#*x}))\$" still/build.ninja
}

@test "raw frames that are not there are named" {
  run "$FROND_BIN" resolve film.json --film nowhere
  [ "$status" -eq 1 ]
  [[ $output == *"nowhere/raw/frame_0001.png"* ]]
}

@test "passes are OpenEXR, a file a frame" {
  run --separate-stderr "$FROND_BIN" passes film.json --frames 2-3 --albedo -o passes
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$output" = $'passes/frame_0002.exr\npasses/frame_0003.exr' ]
  [ "$(head -c 4 passes/frame_0002.exr | od -An -tx1 | tr -d ' ')" = 762f3101 ]
  grep -qa 'CryptoPart00.R' passes/frame_0003.exr
  grep -qa 'albedo.R' passes/frame_0003.exr
  grep -qa 'staghorn' passes/frame_0003.exr
}
