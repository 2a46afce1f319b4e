#!/usr/bin/env bash
# Renders a film on many machines: installs what is missing, builds, and calls `frond farm`, which has these options.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
if [[ " $* " =~ \ --(status|cancel|logs)\  && -x $frond ]]; then FROND_BIN=$frond; fi  # a look at it builds nothing
call_frond farm "$@"
