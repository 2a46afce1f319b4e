#!/usr/bin/env bash
# From a preset to a film: installs what is missing, builds, and calls `frond render`, which has these options.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
call_frond render "$@"
