# tests/layers.py finds what it is there to find.

setup() {
  load common
  cd "$BATS_TEST_TMPDIR"
  mkdir -p gen/base/core gen/form/model gen/apps/cli
  printf 'gen_group(base)\ngen_module(core LIBRARIES TBB::tbb)\ngen_group(form)\ngen_module(model DEPENDS core)\n' >gen/CMakeLists.txt
  printf '#include "core/text.h"\n#include <vector>\n' >gen/form/model/fine.cpp
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
  printf '// rand() in words, and\n/* unordered_map */ auto time = birth_time(node), x = grand(3), t = film.time(0);\n' >gen/base/core/fine.h
  printf '#include "model/fine.h"\n#include <CLI/CLI.hpp>\n' >gen/apps/cli/main.cpp
  run "$ROOT/tests/layers.py" .
  echo "$output"
  [ "$status" -eq 0 ]
}

@test "layers" {
  finds gen/base/core/a.h '#include "model/fine.h"' "gen/base/core/a.h:1: core must not include model"
  finds gen/base/core/a.h '#include "fine.h"' 'not in a module'
  finds gen/form/model/a.h '#include "cli/fine.h"' 'model must not include cli'
  finds gen/form/model/a.cpp '#include <nlohmann/json.hpp>' 'not for this file'
  finds gen/form/model/a.cpp '#include <tbb/parallel_for.h>' 'not for this file'
  mkdir gen/base/other gen/form/core
  finds gen/form/core/a.h '' 'core is no module of form'
  finds gen/base/a.h '' 'three levels'
  finds gen/base/other/a.h '' 'other is no module of base'
}

@test "what is banned" {
  finds gen/base/core/a.cpp 'int x = rand();' 'rand('
  finds gen/base/core/a.cpp 'int x = std::rand();' 'rand('
  finds gen/base/core/a.cpp 'std::random_device d;' 'random_device'
  finds gen/base/core/a.cpp 'std::normal_distribution<double> d;' 'normal_distribution'
  finds gen/base/core/a.cpp 'auto x = std::chrono::steady_clock::now();' 'steady_clock'
  finds gen/base/core/a.cpp 'auto x = time(nullptr);' 'time('
  finds gen/base/core/a.cpp 'std::unordered_map<int, int> x;' 'unordered_map'
  finds gen/base/core/a.cpp '// TO''DO: later' 'left behind'
  finds gen/base/core/a.cpp "$(seq 401)" 'at most 400'
}

@test "modules in a circle, and groups that stand on what is above them" {
  for lists in 'gen_module(core DEPENDS model)\ngen_module(model DEPENDS core)\n' \
    'gen_group(base)\ngen_module(core DEPENDS model)\ngen_group(form)\ngen_module(model)\n'; do
    # shellcheck disable=SC2059
    printf "$lists" >gen/CMakeLists.txt
    run "$ROOT/tests/layers.py" .
    [ "$status" -eq 1 ]
    [[ $output == *"core depends on model, which does not stand above it"* ]]
  done
}
