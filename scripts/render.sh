#!/usr/bin/env bash
# From a preset to a film: installs what is missing, builds, and calls `frond render`, which has these options.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
frond=${FROND_BIN:-$root/build/frond}
if [[ " $* " == *" --help "* && ! -x $frond ]]; then
  printf 'Usage: scripts/render.sh PRESET [options]\n\nOnce it is built (scripts/build.sh), this names all options.\n'
  exit 0
fi
"$root/scripts/setup.sh" --quiet
if [[ -z ${FROND_BIN:-} ]]; then (tied "$root/scripts/build.sh"); fi
FROND_HOME=${FROND_HOME:-$root} exec "$frond" render "$@"
