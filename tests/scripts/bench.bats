# What bench/ asks of the program is still understood by it.

setup() {
  load common
  need_frond
}

@test "the comparison with peers has help, does Frond's share of its jobs and sums up" {
  run "$ROOT/bench/peers/run.py" --help
  [ "$status" -eq 0 ]
  [[ $output == *"Usage: bench/peers/run.py"* ]]
  run "$ROOT/bench/peers/run.py" --self-test
  echo "$output"
  [ "$status" -eq 0 ]
  [ "${lines[-1]}" = ok ]
  FROND_BIN=/nowhere/frond run "$ROOT/bench/peers/run.py" --self-test
  [ "$status" -eq 1 ]
  [ "$output" = "error: /nowhere/frond: no such program; scripts/build.sh makes it, or FROND_BIN says where it is" ]
}
