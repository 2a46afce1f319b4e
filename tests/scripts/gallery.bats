# scripts/gallery.sh in a folder of its own, which holds two small presets. POV-Ray only pretends.

bats_require_minimum_version 1.5.0

setup() {
  load common
  need_frond
  make_fake_povray
  cd "$BATS_TEST_TMPDIR"
  export FROND_HOME=$PWD/home
  mkdir -p home/docs/{gallery,examples} home/presets/grammars
  ln -s "$ROOT"/{povinc,templates} home
  make_preset film.json 6
  mv film.json home/presets
  sed 's/"seed": *[0-9]*/"seed": 12/' home/presets/film.json >home/presets/other.json
  cp "$ROOT/docs/gallery/grammar.txt" home/docs/gallery
  cp "$ROOT/presets/grammars/koch_curve.json" home/presets/grammars
  printf '# a list\nlarge: film\nfilm 32x24 1 film@2\nboth 20x16 2 film@3 other,/film/fps=12 film\n' >home/docs/gallery/pictures.txt
  GALLERY=$ROOT/scripts/gallery.sh
}

size_of() { ffprobe -v error -show_entries stream=width,height -of csv=p=0 "$1"; }

@test "only what has changed is rendered, and all of it listed" {
  run "$GALLERY" -o work
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(count_rendered)" -eq 5 ]  # a picture of one part, one of three, a grammar
  [ "$(size_of home/docs/gallery/both.jpg)" = 44,36 ]
  [ "$(grep -c '^| <img' home/docs/gallery.md)" -eq 2 ]
  grep -qE '"gallery/film.jpg" width="200"> \| presets/film.json \| 32x24 \| [0-9]+ \| [0-9]+ \| [0-9]+ \|$' home/docs/gallery.md
  grep -qF '| presets/film.json, presets/other.json | 20x16 |' home/docs/gallery.md
  stat -c %Y home/docs/gallery/*.jpg home/docs/gallery.md >before
  "$GALLERY" -o work
  [ "$(count_rendered)" -eq 5 ]
  sed -i 's/"seed": *12/"seed": 13/' home/presets/other.json
  "$GALLERY" -o work film both
  [ "$(count_rendered)" -eq 6 ]
  # Elsewhere, what is not rendered keeps its row, also where its preset has changed since.
  cp home/docs/gallery.md listed
  "$GALLERY" -o elsewhere film
  [ "$(count_rendered)" -eq 7 ]
  diff <(grep both listed) <(grep both home/docs/gallery.md)
}

@test "a picture that fails is told, and what is finished is kept" {
  printf 'film 32x24 1 film\nnone 32x24 1 nosuch\n' >home/docs/gallery/pictures.txt
  run "$GALLERY" -o work film none
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"error: none could not be rendered" ]]
  [ -s home/docs/gallery/film.jpg ]
  echo 'film 32 1 film' >home/docs/gallery/pictures.txt
  run "$GALLERY" -o work
  [ "$status" -eq 1 ]
  [[ $output == "error: docs/gallery/pictures.txt:1: no picture; expected "* ]]
}

@test "large pictures lie beside, and are led to" {
  "$GALLERY" -o work film
  run "$GALLERY" -o work --large
  echo "$output"
  [ "$status" -eq 0 ]
  [ "$(size_of home/docs/gallery/large/film.jpg)" = 1280,960 ]
  ! grep -q large home/docs/gallery.md
  "$GALLERY" -o work film
  grep -qF '| <a href="gallery/large/film.jpg"><img src="gallery/film.jpg" width="200"></a> | presets/film.json |' home/docs/gallery.md
  run "$GALLERY" -o work nosuch
  [ "$status" -eq 2 ]
  [[ $output == "error: nosuch: no picture of "* ]]
}

@test "pictures older than what they show are named, and no others" {
  "$GALLERY" -o work
  [ "$(cut -d' ' -f1 home/docs/gallery/scenes.txt | grep -v '#')" = "$(printf '%s\n' both film grammars)" ]
  rm home/docs/gallery/film.jpg
  touch home/docs/gallery/studio.jpg
  run --separate-stderr "$GALLERY" -o work --stale
  echo "$output $stderr"
  [ "$status" -eq 0 ]
  [ "$output" = "$(printf '%s\n' film large/film)" ]
  [[ $stderr == *"film: there is no such picture"*"large/film: there is no such picture"* ]]
  [[ $stderr == *"whose age is not known: studio.jpg" ]]
  "$GALLERY" -o work film large/film
  # A property that the scene does not show changes no picture, another does.
  sed -i 's/"title": *"[^"]*"/"title": "another"/' home/presets/*.json
  run --separate-stderr "$GALLERY" -o work --stale
  [ "$output" = "" ]
  sed -i 's/"seed": *12/"seed": 13/' home/presets/other.json
  run --separate-stderr "$GALLERY" -o work --stale
  [ "$output" = both ]
  [[ $stderr == *"both: its scene is another now"* ]]
  [ "$(ls work/scenes)" = "$(printf '%s\n' both film grammars large)" ]  # no scene is kept
  # So does a macro, of those that reach it alone.
  rm home/povinc
  cp -r "$ROOT/povinc" home
  sed -i 's/^#macro Studio_Globals.*/&\n#declare Of_This = 1;/' home/povinc/frond_studio.inc
  sed -i 's/^#macro Bridge_.*/&\n#declare Of_That = 1;/' home/povinc/*.inc
  run --separate-stderr "$GALLERY" -o work --stale film grammars
  echo "$output"
  sed -i '/^both/d' home/docs/gallery/scenes.txt
  run --separate-stderr "$GALLERY" -o work --stale both
  [ "$output" = both ]
  [[ $stderr == *"both: what it shows is not noted"* ]]
  # What is known of the same sources is not asked again.
  touch -d '2001-01-01' work/scenes/film
  "$GALLERY" -o work --stale film
  [ "$(stat -c %Y work/scenes/film)" -lt 1000000000 ]
}
