# tests/layers.py finds what it is there to find.

setup() {
  load common
  cd "$BATS_TEST_TMPDIR"
  mkdir -p gen/core gen/model gen/app
  printf 'gen_module(core LIBRARIES TBB::tbb)\ngen_module(model DEPENDS core)\n' >gen/CMakeLists.txt
  printf '#include "core/text.h"\n#include <vector>\n' >gen/model/fine.cpp
}

# finds FILE TEXT MESSAGE
finds() {
  printf '%s\n' "$2" >"$1"
  run "$ROOT/tests/layers.py" .
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"$3"* ]]
  rm "$1"
}

@test "what is fine passes" {
  printf '// rand() in words, and\n/* unordered_map */ auto time = birth_time(node), x = grand(3), t = film.time(0);\n' >gen/core/fine.h
  printf '#include "model/fine.h"\n#include <CLI/CLI.hpp>\n' >gen/app/main.cpp
  run "$ROOT/tests/layers.py" .
  echo "$output"
  [ "$status" -eq 0 ]
}

@test "layers" {
  finds gen/core/a.h '#include "model/fine.h"' "gen/core/a.h:1: core must not include model"
  finds gen/core/a.h '#include "fine.h"' 'not in a module'
  finds gen/model/a.h '#include "app/fine.h"' 'model must not include app'
  finds gen/model/a.cpp '#include <nlohmann/json.hpp>' 'not for this file'
  finds gen/model/a.cpp '#include <tbb/parallel_for.h>' 'not for this file'
  mkdir gen/other
  finds gen/other/a.h '' 'other is no module'
}

@test "what is banned" {
  finds gen/core/a.cpp 'int x = rand();' 'rand('
  finds gen/core/a.cpp 'int x = std::rand();' 'rand('
  finds gen/core/a.cpp 'std::random_device d;' 'random_device'
  finds gen/core/a.cpp 'std::normal_distribution<double> d;' 'normal_distribution'
  finds gen/core/a.cpp 'auto x = std::chrono::steady_clock::now();' 'steady_clock'
  finds gen/core/a.cpp 'auto x = time(nullptr);' 'time('
  finds gen/core/a.cpp 'std::unordered_map<int, int> x;' 'unordered_map'
  finds gen/core/a.cpp '// TO''DO: later' 'left behind'
  finds gen/core/a.cpp "$(seq 401)" 'at most 400'
}

@test "modules in a circle" {
  printf 'gen_module(core DEPENDS model)\ngen_module(model DEPENDS core)\n' >gen/CMakeLists.txt
  run "$ROOT/tests/layers.py" .
  [ "$status" -eq 1 ]
  [[ $output == *"in a circle"* ]]
}
