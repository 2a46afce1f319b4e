# scripts/setup.sh with a dpkg-query, an apt-get and a sudo that only pretend.

setup() {
  load common
  fakes=$BATS_TEST_TMPDIR/fakes
  mkdir "$fakes"
  export APT_LOG=$BATS_TEST_TMPDIR/apt.log MISSING=''
  : >"$APT_LOG"
  # All packages are there but $MISSING.
  fake dpkg-query 'for package in "${@:3}"; do [[ " $MISSING " == *" $package "* ]] && continue; echo "ii  $package"; done'
  fake apt-get '[[ $* == *--simulate* ]] && exit ${APT_UNKNOWN:-0}; echo "$DEBIAN_FRONTEND $*" >>"$APT_LOG"; echo words of apt; [[ $* != *" install "* ]] || exit ${APT_FAILS:-0}'
  fake sudo 'echo sudo >>"$APT_LOG"; "$@"'
  fake id 'echo ${FAKE_USER:-0}'
  PATH=$fakes:$PATH
}

fake() {
  printf '#!/bin/bash\n%s\n' "$2" >"$fakes/$1"
  chmod +x "$fakes/$1"
}

@test "nothing missing: nothing is done, without root" {
  FAKE_USER=1000 run "$ROOT/scripts/setup.sh" --tests
  [ "$status" -eq 0 ]
  [[ $output == "Nothing to install"* ]]
  [ ! -s "$APT_LOG" ]
  FAKE_USER=1000 run "$ROOT/scripts/setup.sh" --quiet
  [ "$status" -eq 0 ]
  [ -z "$output" ]
}

@test "just what is missing is installed, and said" {
  MISSING="g++ povray bats" run "$ROOT/scripts/setup.sh" --quiet
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == "Installing 2 packages: g++ povray"* ]]
  [[ $output != *"words of apt"* ]]
  run cat "$APT_LOG"
  [ "${#lines[@]}" -eq 1 ]
  [[ $output == "noninteractive "*"DPkg::Lock::Timeout=500"*"install --no-install-recommends g++ povray" ]]
}

@test "lists of packages are fetched where they are not known" {
  MISSING=ffmpeg APT_UNKNOWN=100 run "$ROOT/scripts/setup.sh"
  [ "$status" -eq 0 ]
  [[ $output == *"words of apt"* ]]
  run cat "$APT_LOG"
  [[ ${lines[0]} == *update ]]
  [[ ${lines[1]} == *"install --no-install-recommends ffmpeg" ]]
}

@test "an ordinary user goes through sudo" {
  FAKE_USER=1000 MISSING=ffmpeg run "$ROOT/scripts/setup.sh" --quiet
  [ "$status" -eq 0 ]
  grep -qx sudo "$APT_LOG"
}

@test "a failure shows the words of apt" {
  MISSING=ffmpeg APT_FAILS=100 run "$ROOT/scripts/setup.sh" --quiet
  [ "$status" -eq 1 ]
  [[ $output == *"words of apt"*"could not install: ffmpeg"* ]]
}

@test "unknown arguments are exit code 2" {
  run "$ROOT/scripts/setup.sh" --test
  [ "$status" -eq 2 ]
}

@test "every module that Python imports in tests and scripts is installed" {
  cd "$ROOT"
  python3 - <<'PY'
import pathlib, re, sys
packages = pathlib.Path("scripts/setup.sh").read_text()
there = sys.stdlib_module_names | {"bpy", "addon_utils", "mathutils", "frond", "frond_blender"}  # of Blender itself, and our own
for file in [*pathlib.Path("tests").rglob("*.py"), *pathlib.Path("scripts").glob("*.py")]:
    for name in re.findall(r"^\s*(?:import (?=\w+$)|from (?=[\w.]+ import ))(\w+)", file.read_text(), re.M):
        if name not in there and f"python3-{name} " not in packages:
            sys.exit(f"{file} imports {name}, which scripts/setup.sh does not install")
PY
}

# What setup.sh reads, in $clone, as it is when it has just been cloned, and an npm that only pretends: what setup.sh
# installs and builds with it goes there, and nothing into the sources.
fresh_clone() {
  clone=$BATS_TEST_TMPDIR/clone
  local folder
  for folder in tests/gltf tests/studio gen/apps/studio/page; do
    mkdir -p "$clone/$folder"
    cp "$ROOT/$folder"/package*.json "$clone/$folder"
  done
  cp -r "$ROOT/scripts" "$clone"
}
pretend_npm='case $3 in ci) mkdir -p "$2/node_modules" ;; run) mkdir -p "$2/dist" && : >"$2/dist/index.html" ;; esac'

@test "what large tests need is only installed for them, and node not where it is there from elsewhere" {
  fresh_clone
  fake node :
  fake npm "echo \"npm \$*\" >>\"\$APT_LOG\"; $pretend_npm"
  MISSING="nodejs npm" run "$clone/scripts/setup.sh" --tests --quiet
  [ "$status" -eq 0 ]
  [ ! -s "$APT_LOG" ]
  MISSING="nodejs npm" run "$clone/scripts/setup.sh" --all --quiet
  echo "$output"
  [ "$status" -eq 0 ]
  grep -qx "npm --prefix $clone/build/gltf ci .*" "$APT_LOG"
  ! grep -q nodejs "$APT_LOG"
  # The same pinned packages are not asked for again, nor is the page built again.
  : >"$APT_LOG"
  run "$clone/scripts/setup.sh" --all --quiet
  [ "$status" -eq 0 ]
  [ ! -s "$APT_LOG" ]
}

@test "what makes packages is installed for that, and not for a film" {
  fresh_clone
  MISSING="file dpkg-dev" run "$clone/scripts/setup.sh" --quiet
  [ "$status" -eq 0 ]
  [ ! -s "$APT_LOG" ]
  MISSING="file dpkg-dev" run "$clone/scripts/setup.sh" --package --quiet
  [ "$status" -eq 0 ]
  grep -q "install --no-install-recommends file dpkg-dev" "$APT_LOG"
  grep -q 'setup.sh" --package --quiet' "$ROOT/scripts/package.sh"
}

@test "node and npm come from apt where they are missing" {
  fresh_clone
  tools=$BATS_TEST_TMPDIR/tools
  mkdir "$tools"
  for tool in bash dirname grep sed mktemp rm cat env cmp mkdir cp tail find; do ln -s "$(command -v "$tool")" "$tools/"; done
  printf '#!/bin/bash\n%s\n' "$pretend_npm" >"$BATS_TEST_TMPDIR/npm"
  chmod +x "$BATS_TEST_TMPDIR/npm"
  fake apt-get "echo \"\$*\" >>\"\$APT_LOG\"; cp '$BATS_TEST_TMPDIR/npm' '$fakes/npm'"
  MISSING="nodejs npm" PATH=$fakes:$tools run "$clone/scripts/setup.sh" --all --quiet
  echo "$output"
  [ "$status" -eq 0 ]
  grep -q "install --no-install-recommends nodejs npm" "$APT_LOG"
  [ -s "$clone/build/gltf/node_modules/installed-lock.json" ]
}

@test "--try builds the page to try things on with emscripten, or says why it cannot" {
  fresh_clone
  fake npm "$pretend_npm"
  fake cmake 'echo "cmake $*" >>"$APT_LOG"'
  fake emcmake 'echo "$*" >>"$APT_LOG"'
  MISSING=emscripten run "$clone/scripts/setup.sh" --try --quiet
  echo "$output"
  [ "$status" -eq 0 ]
  grep -q "install --no-install-recommends emscripten" "$APT_LOG"
  grep -qx "cmake -S $clone/docs/try -B $clone/build/try -G Ninja" "$APT_LOG"
  grep -qx "cmake --build $clone/build/try" "$APT_LOG"
  fake emcmake 'echo words of cmake; exit 1'
  run "$clone/scripts/setup.sh" --try --quiet
  [ "$status" -eq 1 ]
  [[ $output == *"words of cmake"*"could not be built"* ]]
}
