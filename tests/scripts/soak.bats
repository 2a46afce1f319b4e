# Many seeds of many presets: what a soak tries, finds, notes and goes on with.

setup() {
  load common
  cd "$BATS_TEST_TMPDIR"
  SOAK=$ROOT/scripts/soak.sh
  # It fails for seed 2 of the spruce.
  cat >frond <<'SH'
#!/bin/sh
echo "$*" >>"$CALLS"
case $* in *spruce*/seed=2*) echo "SUMMARY: AddressSanitizer: heap-buffer-overflow shading.cpp:1" >&2; exit 134 ;; esac
SH
  chmod +x frond
  export CALLS=$PWD/calls
}

@test "a finding is told with the command that repeats it, and the soak goes on" {
  run "$SOAK" --program frond --presets 'trees/s[ep]*' --seeds 1-3
  echo "$output"
  [ "$status" -eq 1 ]
  grep -qE 'frond generate presets/trees/spruce.json --set /seed=2 .*# ended with 134: SUMMARY: .*shading.cpp:1$' <<<"$output"
  grep -qE '^12 runs, 0 more that had ended well before; 2 did not end well; [0-9.]+ hours of processor$' <<<"$output"
  [ "$(grep -c 'look presets/trees/seasons.json' calls)" -eq 3 ]
}

@test "what ended well is not done again, a finding is" {
  run "$SOAK" --program frond --presets 'trees/s[ep]*' --seeds 1-2
  sed -i '/^case/d' frond
  : >calls
  run "$SOAK" --program frond --presets 'trees/s[ep]*' --seeds 1-2
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(grep -c 'spruce.json --set /seed=2' calls)" -eq 2 ]
  [[ $output == *"2 runs, 6 more that had ended well before; 0 did not end well"* ]]
}

@test "a soak ends when its hours are over" {
  run "$SOAK" --program frond --presets 'trees/s[ep]*' --hours 0
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == "0 runs, "* ]]
}

@test "a soak refuses what it cannot do" {
  for row in "--seeds|7|'7' is no range of seeds; expected A-B" "--presets|no*such|no preset is called no*such" \
    "--hours|x|'x' is no number of hours" "--program|none|$PWD/none: no such program" "--what|x|unknown option '--what'"; do
    IFS='|' read -r option value message <<<"$row"
    run "$SOAK" --program frond "$option" "$value"
    echo "$output"
    [ "$status" -eq 2 ]
    [[ $output == *"$message"* ]]
  done
}
