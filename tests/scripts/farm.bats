# scripts/farm.sh, with real farms: Slurm, sshd and GNU parallel on this machine. POV-Ray renders.

setup_file() {
  load farm
  for program in slurmctld slurmd sbatch; do
    command -v "$program" >/dev/null || return 0
  done
  start_cluster "$BATS_FILE_TMPDIR/cluster"
  export cluster SLURM_CONF
}

teardown_file() {
  load farm
  if [ -n "${cluster:-}" ]; then stop_cluster; fi
}

setup() {
  load common
  load farm
  need_frond
  FARM=$ROOT/scripts/farm.sh
  cd "$BATS_TEST_TMPDIR"
  make_preset film.json 6
}

teardown() { if [ -s sshd.pid ]; then kill "$(cat sshd.pid)"; fi; }

need_slurm() { [ -n "${cluster:-}" ] || skip "Slurm is not installed: scripts/setup.sh --all"; }

# A povray that waits for the file `go` before each picture, and says in `waits` that it does.
make_gate() {
  printf '#!/bin/bash\necho >>"%s/waits"\nuntil [ -e "%s/go" ]; do sleep 0.05; done\nexec /usr/bin/povray "$@"\n' "$PWD" "$PWD" >povray
  chmod +x povray
  export FROND_POVRAY=$PWD/povray FROND_UNCONFINED=1
}

same_film() {  # FARM LOCAL
  local frame
  cmp "$1/film.mp4" "$2/film.mp4"
  cmp "$1/contact.png" "$2/contact.png"
  for frame in "$2"/frames/*.png; do cmp "$frame" "$1/farm/latest/frames/${frame##*/}"; done
}

both_nodes_wait() { [ "$(squeue -h -r -t R | wc -l)" -eq 2 ] && [ "$(cat waits 2>/dev/null | wc -l)" -ge 2 ]; }
is_pending() { [ "$(squeue -h -j "$1" -o %T)" = PENDING ]; }

@test "a film by Slurm has the bytes of the local one, though a node dies" {
  need_slurm
  make_gate
  echo '{"partition": "render", "minutes": 10, "memory": 500}' >site.json
  "$FARM" film.json --site site.json --chunk 2
  until_true 300 both_nodes_wait
  run "$FARM" film.json --chunk 1
  echo "$output"
  [ "$status" -eq 2 ]
  [[ $output == *"a farm is at work there"* ]]
  task=$(squeue -h -t R -w n2 -o %i)
  crash_node n2
  touch go
  until_true 300 is_pending "$task"
  run "$FARM" film.json --status
  echo "$output"
  [[ $output == *"of 6 pictures are rendered"*"tasks are pending"* ]]
  scontrol update JobId="$task" StartTime=now  # else Slurm waits for two minutes
  start_node n2
  scontrol update NodeName=n2 State=RESUME 2>/dev/null || true
  until_true 300 queue_is_empty
  "$FARM" film.json --logs
  unset FROND_POVRAY FROND_UNCONFINED
  "$RENDER" film.json -o local
  same_film out/film local
  [ -z "$(find out/film -name '*.part')" ]

  # What is finished is not rendered again; a frame that is lost or damaged is.
  stat -c '%n %y' out/film/farm/latest/frames/*.png >before
  rm out/film/farm/latest/frames/frame_0002.png
  truncate -s 300 out/film/farm/latest/frames/frame_0005.png
  : >waits
  make_gate
  run "$FARM" film.json --site site.json --chunk 2
  echo "$output"
  [[ $output == *"frame_0005.png is damaged; it is made again"*"Submitted 2 of 3 chunks"* ]]
  until_true 300 queue_is_empty
  [ "$(wc -l <waits)" -eq 2 ]
  same_film out/film local
  stat -c '%n %y' out/film/farm/latest/frames/*.png >after
  [ "$(grep -cxFf before after)" -eq 4 ]
}

@test "a still is rendered in bands that leave no seam" {
  need_slurm
  make_preset still.json 1
  "$FARM" still.json --size 80x150 --bands 4
  "$RENDER" still.json --size 80x150 -o local
  until_true 300 queue_is_empty
  "$FARM" still.json --logs
  [ "$(find out/still/farm/latest/frames -name 'band_*_of_4.png' | wc -l)" -eq 4 ]
  for still in out/still/still.png local/still.png; do
    ffmpeg -nostdin -loglevel error -i "$still" -f rawvideo "${still%%/*}.raw"
    head -c 100 "$still" | od -An -tx1 | head -n 5 >"${still%%/*}.head"
  done
  [ "$(stat -c %s local.raw)" -eq $((80 * 150 * 3)) ]
  cmp out.raw local.raw
  cmp out.head local.head  # size and colour space
  # A band that the disk has damaged is found when they are joined.
  folder=$(realpath out/still/farm/latest)
  rm "$folder/frames/frame_0001.png"
  printf x | dd of="$folder/frames/band_2_of_4.png" bs=1 seek=200 conv=notrunc status=none
  run "$folder/tool/scripts/farm_task.sh" "$folder" 1 film
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"band_2_of_4.png is damaged"* ]]
  "$folder/tool/scripts/farm_task.sh" "$folder" 1 bands 4 2
  "$folder/tool/scripts/farm_task.sh" "$folder" 1 film
  ffmpeg -nostdin -loglevel error -y -i out/still/still.png -f rawvideo out.raw
  cmp out.raw local.raw

  "$FARM" still.json --size 40x30  # too small for two
  "$RENDER" still.json --size 40x30 -o local
  until_true 300 queue_is_empty
  cmp out/still/still.png local/still.png
}

@test "a frame that fails is told, and its film is not made" {
  need_slurm
  printf '#!/bin/bash\n[[ $* == *frame_0003* ]] && kill -9 $$\nexec /usr/bin/povray "$@"\n' >povray
  chmod +x povray
  FROND_POVRAY=$PWD/povray FROND_UNCONFINED=1 "$FARM" film.json --partition render --frames 1-4
  until_true 300 queue_is_empty
  run "$FARM" film.json --status
  echo "$output"
  [[ $output == *"3 of 4 pictures are rendered"*"frame_0003 failed: "*"ended by signal 9"* ]]
  [ ! -e out/film/film.mp4 ]
  "$FARM" film.json --partition render --frames 1-4
  until_true 300 queue_is_empty
  [ "$(frames_of out/film/film.mp4)" -eq 4 ]
}

a_task_waits() { [ -s waits ]; }

@test "a farm is ended by --cancel" {
  need_slurm
  make_gate
  run "$FARM" film.json --chunk 1
  [[ $output == *"takes 4 tasks at most: each renders 2 frames"*"Submitted 3 of 3 chunks of 2 frames"* ]]
  until_true 300 a_task_waits
  "$FARM" film.json --cancel
  until_true 300 queue_is_empty
}

@test "what Slurm does not know is told" {
  need_slurm
  run "$FARM" film.json --partition nosuch
  echo "$output"
  [ "$status" -eq 2 ]
  [ "$output" = "error: --partition: there is no 'nosuch'; there is render" ]
  echo '{"account": "x", "options": ["--nosuchoption=3"]}' >site.json
  run "$FARM" film.json --site site.json
  echo "$output"
  [ "$status" -eq 1 ]
  [[ $output == *"error: sbatch: "*nosuchoption* ]]
}

@test "wrong input is told before anything is begun" {
  run "$FARM" film.json --hosts 'a;b'
  [ "$status" -eq 2 ]
  [[ $output == *"--hosts needs names"* ]]
  for row in "--chunk 0|--chunk needs a number" "--hosts a|--hosts does not go with --openjd" "--size 3|--size" \
    "--frames 5-9|--frames" "--nonsense|no such option of frond farm" "--site nosuch.json|nosuch.json" \
    "--status|no film was handed"; do
    # shellcheck disable=SC2086
    run "$FARM" film.json --openjd job.json ${row%|*}
    echo "$row: $status $output"
    [ "$status" -eq 2 ]
    [[ $output == *"${row#*|}"* ]]
    rm -rf out
  done
  echo '{"partion": "x", "cpus": 0, "modules": ["-x"]}' >site.json
  run "$FARM" film.json --openjd job.json --site site.json
  echo "$output"
  [ "$status" -eq 2 ]
  [[ $output == *'site.json:1:2: /partion'*'did you mean "partition"'* ]]
  [ ! -e job.json ]
}

@test "job files keep to their rules, and what they call makes the film" {
  odd="o'dd \$(touch oops) \"{{x}}\" <&é"
  mkdir "$odd"
  cp film.json "$odd"
  echo '{"cpus": 2, "memory": 900, "minutes": 7, "show": "a<b"}' >site.json
  "$FARM" "$odd/film.json" -o "$odd/out" --site site.json --frames 2-4 --chunk 2 --openjd job.json --opencue job.xml
  python3 "$ROOT/tests/scripts/job_files.py" job.json job.xml
  "$RENDER" film.json --frames 2-4 -o local
  same_film "$odd/out" local
  [ ! -e oops ]
}

@test "a film that is resolved has the bytes of the local one" {
  "$FARM" film.json --quality good --frames 2-3 --chunk 3 --openjd job.json
  folder=$(realpath out/film/farm/latest)
  task=$folder/tool/scripts/farm_task.sh
  run "$FARM" film.json --status
  echo "$output"
  [[ $output == *"0 of 6 pictures are rendered"* ]]
  "$task" "$folder" 2 frames 1 6 3 1
  "$task" "$folder" 2 frames 1 6 3 2
  "$task" "$folder" 2 film
  "$RENDER" film.json --quality good --frames 2-3 -o local
  same_film out/film local
  for raw in local/raw/*.png; do cmp "$raw" "$folder/raw/${raw##*/}"; done
}

@test "the files of a preset are kept as they were; another preset is another folder" {
  mkdir -p a/b
  sed 's/"title"/"base": "..\/base.json", &/' film.json >a/b/film.json
  cp film.json a/base.json
  echo '{"modules": ["povray/3.7", "a; touch oops"]}' >site.json
  module() { echo "$*" >>"$BATS_TEST_TMPDIR/loaded"; }
  export -f module
  "$FARM" a/b/film.json --site site.json --openjd one.json -o out
  first=$(readlink out/farm/latest)
  rm a/base.json
  "out/farm/$first/tool/scripts/farm_task.sh" "$PWD/out/farm/$first" 1 frames 1 1 1 1
  [ -s "out/farm/$first/frames/frame_0001.png" ]
  [ "$(cat loaded)" = $'load povray/3.7\nload a; touch oops' ]
  cp film.json a/base.json
  "$FARM" a/b/film.json --openjd one.json -o out --frames 2-3
  [ "$(readlink out/farm/latest)" = "$first" ]
  "$FARM" a/b/film.json --openjd one.json -o out --set /seed=9
  [ "$(readlink out/farm/latest)" != "$first" ]
}

# A server that only lets in who has a key made for this test.
start_sshd() {
  ssh-keygen -q -t ed25519 -N '' -f host
  ssh-keygen -q -t ed25519 -N '' -f mine
  port=$((25000 + $$ % 5000))
  if [ "$(id -u)" = 0 ]; then mkdir -p /run/sshd; fi
  printf '%s\n' "Port $port" "ListenAddress 127.0.0.1" "HostKey $PWD/host" "AuthorizedKeysFile $PWD/mine.pub" \
    "PidFile $PWD/sshd.pid" "StrictModes no" "UsePAM no" >sshd_config
  /usr/sbin/sshd -f "$PWD/sshd_config" 3>&-
  printf '%s\n' "Host anna berta" " Port $port" "Host gone" " Port 1" "Host *" " HostName 127.0.0.1" " IdentityFile $PWD/mine" \
    " StrictHostKeyChecking no" " UserKnownHostsFile /dev/null" " LogLevel ERROR" >ssh_config
  export PARALLEL_SSH="ssh -F $PWD/ssh_config"
  until_true 60 test -s sshd.pid
}

@test "a film over ssh has the bytes of the local one, though a machine does not answer" {
  for program in parallel ssh sshd; do
    command -v "$program" >/dev/null || skip "$program is not installed: scripts/setup.sh --all"
  done
  start_sshd
  run "$FARM" film.json --hosts anna,gone,berta --frames 1-3 --chunk 1
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"/film.mp4"* ]]
  "$RENDER" film.json --frames 1-3 -o local
  same_film out/film local
}
