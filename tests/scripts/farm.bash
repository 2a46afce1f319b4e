# shellcheck shell=bash
# A cluster of Slurm on this machine, for the tests: one that rules and two nodes, as whoever runs it, without systemd, cgroups or munge.

PATH=$PATH:/usr/sbin  # where daemons are

# start_cluster FOLDER: two nodes of one processor each.
start_cluster() {
  cluster=$1
  local host user port
  host=$(hostname -s) user=$(id -un) port=$((10000 + $$ % 5000 * 3))  # three of its own, not handed out
  mkdir -p "$cluster"/{state,log,spool/n1,spool/n2}
  export SLURM_CONF=$cluster/slurm.conf
  cat >"$SLURM_CONF" <<CONF
ClusterName=frond
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/none
CredType=cred/none
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool/%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd-%n.pid
SlurmctldLogFile=$cluster/log/slurmctld.log
SlurmdLogFile=$cluster/log/slurmd-%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,bf_interval=1
SlurmdParameters=config_overrides
ReturnToService=2
KillWait=2
MaxArraySize=5
NodeName=n[1-2] NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1))-$((port + 2)) CPUs=1 RealMemory=2000
PartitionName=render Nodes=n[1-2] Default=YES MaxTime=60 State=UP
CONF
  echo 'CgroupPlugin=cgroup/v1' >"$cluster/cgroup.conf"  # or slurmd looks for cgroups where none are mounted
  slurmctld -i 3>&-
  start_node n1
  start_node n2
  until_true 300 nodes_are "idle 2"
}

start_node() { slurmd -N "$1" 3>&-; }
nodes_are() { [ "$(sinfo -h -o '%T %D')" = "$1" ]; }

# until_true SECONDS COMMAND...: waits for it
until_true() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    if ((SECONDS > end)); then
      echo "waited in vain: $*"
      return 1
    fi
    sleep 0.1
  done
}

# Process ids of a process and all that it has started, itself first.
tree_of() {
  local child
  echo "$1"
  for child in $(ps -o pid= --ppid "$1"); do tree_of "$child"; done
}

# crash_node NAME: all its processes at once, as when its plug is pulled. Parents die first: one that saw its child
# die would still report the task as failed, and Slurm would not put it back into the queue.
crash_node() {
  local node pid pids
  node=$(cat "$cluster/slurmd-$1.pid")
  pids=$node
  for pid in $(squeue -h -t R -w "$1" -o %A); do
    pids+=" $(pgrep -f "^slurmstepd: \[$pid\." | while read -r pid; do tree_of "$pid"; done | tr '\n' ' ')"
  done
  # shellcheck disable=SC2086
  kill -KILL $pids 2>/dev/null || true
  scontrol update NodeName="$1" State=DOWN Reason=crash  # which Slurm finds itself after half a minute
}

queue_is_empty() { [ -z "$(squeue -h)" ]; }

stop_cluster() {
  local file
  scancel --user="$(id -un)" 2>/dev/null || true
  until_true 10 queue_is_empty || true
  for file in "$cluster"/slurmd-*.pid "$cluster/slurmctld.pid"; do
    if [ -f "$file" ]; then kill "$(cat "$file")" 2>/dev/null || true; fi
  done
  until_true 10 eval '! ls "$cluster"/*.pid >/dev/null 2>&1' || true  # each removes its own
}
