# What people do with folders, names and files that nobody here has chosen: tests/cases holds their files.

bats_require_minimum_version 1.5.0

setup() {
  load common
  need_frond
  frond=$FROND_BIN
}

# A garden whose files and organisms are called as a French gardener calls them.
make_garden() {
  garden="$BATS_TEST_TMPDIR/Jardin d'été & mur (v2) [x]"
  mkdir -p "$garden/mes maillages"
  cp "$ROOT/tests/cases/25-odd-names/house.obj" "$garden/mes maillages/maison n°1.obj"
  cat >"$garden/lierre #1.json" <<'JSON'
{"version": 2, "film": {"frames": 2, "size": [64, 48]},
 "scene": {"setting": "meadow", "camera": {"location": [-4, 2, 10], "look_at": [0, 1.6, 0]},
           "meadow": {"extent": 6, "blades": 10}},
 "organisms": [{"kind": "mesh", "name": "maison d'été", "file": "mes maillages/maison n°1.obj", "size": 4, "place": {"at": [[0, 0]]}},
  {"kind": "ivy", "on": ["maison d'été"], "count": 1, "crawl": {"max_age": 20}, "growth": {"duration": 0}},
  {"kind": "weber_penn", "name": "bouleau \"blanc\"", "place": {"at": [[4, 0]]},
   "tree": {"levels": 2, "branches": {"branches": 8}, "leaves": 5}, "coat": {"pattern": "banded"}}]}
JSON
}

@test "a folder with blanks, quotes, brackets and accents is rendered from and exported to" {
  make_garden
  make_fake_povray
  "$frond" check "$garden/lierre #1.json"
  run "$RENDER" "$garden/lierre #1.json" -o "$garden/out put"
  echo "$output"
  [ "$status" -eq 0 ]
  [ -s "$garden/out put/film.mp4" ]
  for kind in obj glb ply; do
    "$frond" export "$garden/lierre #1.json" -o "$garden/sortie é.$kind" --texture 16 --detail 2000 -q
    [ -s "$garden/sortie é.$kind" ]
  done
  # Programs that split lines at blanks find the materials and their pictures, too.
  library=$(sed -n 's/^mtllib //p' "$garden/sortie é.obj")
  [ -f "$garden/$library" ]
  [[ $library != *" "* ]]
  while read -r picture; do
    [ -f "$garden/$picture" ]
    [[ $picture != *" "* ]]
  done < <(sed -n 's/^map_[^ ]* \(-imfchan g \)\{0,1\}//p' "$garden/$library")
  while read -r name; do grep -qx "newmtl $name" "$garden/$library"; done < <(sed -n 's/^usemtl //p' "$garden/sortie é.obj" | sort -u)
}

@test "the include of an odd name holds a macro of a name that POV-Ray takes, or is refused with the reason" {
  make_garden
  run "$frond" export "$garden/lierre #1.json" -o "$garden/sortie é.inc"
  [ "$status" -eq 2 ]
  [[ $output == *"letters"*"English"* ]]
  run "$frond" export "$garden/lierre #1.json" -o "$garden/2 (new) [x].inc"
  echo "$output"
  [ "$status" -eq 0 ]
  name=$(sed -n 's/^#macro \([A-Za-z_0-9]*\)(.*/\1/p' "$garden/2 (new) [x].inc" | tail -n 1)
  [[ $output == *"object { $name("* ]]
}

@test "a series of one OBJ a frame goes on where nothing has grown yet" {
  cd "$BATS_TEST_TMPDIR"
  cp "$ROOT/tests/cases/26-obj-series/shoot.json" .
  for frame in 1 2 7 12; do
    code=0
    "$frond" export shoot.json --frame "$frame" --texture 0 -o "f_$frame.obj" 2>said || code=$?
    cat said
    # Either an object that is empty, or a code of its own with words that say so.
    if [ "$frame" -gt 1 ]; then [ "$code" -eq 0 ]; fi
    [ "$code" -ne 1 ] && [ "$code" -ne 2 ]
    if [ ! -e "f_$frame.obj" ]; then grep -q "nothing" said; fi
  done
  [ "$(grep -c '^v ' f_12.obj)" -gt "$(grep -c '^v ' f_2.obj)" ]
}
