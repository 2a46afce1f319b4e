# The time that is left, by a clock that stands where the test puts it.

setup() {
  load common
  cd "$BATS_TEST_TMPDIR"
  mkdir frames
  # shellcheck source=../../scripts/lib_progress.sh
  . "$ROOT/scripts/lib_progress.sh"
  unset SECONDS  # no longer the clock of the shell
  SECONDS=100
}

scene() { head -c "$2" /dev/zero >"$(printf 'frames/frame_%04d.pov' "$1")"; }
# traced NUMBER PERCENT: of a picture of 10x10, as POV-Ray notes it
traced() { head -c $(($2 * 20)) /dev/zero >"$(printf 'frames/.frame_%04d.abc.kept' "$1")"; }
about() { echo "$1, expected $2"; (($1 >= $2 * 95 / 100 && $1 <= $2 * 105 / 100)); }

@test "of a still nothing is said while it is read, and then what tracing takes" {
  scene 1 5000
  begin_progress 10x10 2 <<<1
  look_at_notes
  SECONDS=120
  look_at_notes
  [ -z "$(seconds_left)" ]
  [ "$(percent_done)" -eq 0 ]
  SECONDS=130
  traced 1 1
  look_at_notes
  SECONDS=150
  traced 1 20
  look_at_notes
  [ "$(percent_done)" -eq 20 ]
  about "$(seconds_left)" 80
}

@test "of a film reading is reckoned for every frame" {
  for n in {1..20}; do scene "$n" 1000; done
  begin_progress 10x10 2 < <(seq 20)
  look_at_notes
  SECONDS=110  # 10 s of reading, 40 s of tracing
  traced 1 1
  traced 2 1
  look_at_notes
  SECONDS=120
  traced 1 25
  traced 2 25
  look_at_notes
  about "$(seconds_left)" 480  # 20 frames of 50 s by two, but for 20 s
  SECONDS=150
  rm frames/.frame*
  frame_done 1
  frame_done 2
  look_at_notes
  about "$(seconds_left)" 450
}

@test "larger scenes count for more, and what an earlier run has traced is no speed" {
  scene 1 1000
  scene 2 3000
  traced 1 50
  begin_progress 10x10 1 < <(seq 2)
  look_at_notes
  SECONDS=110
  traced 1 99
  look_at_notes
  frame_done 1
  rm frames/.frame*
  look_at_notes
  # Half of a picture of weight 750 took 10 s, one of 1250 is left.
  about "$(seconds_left)" 33
}
