#!/usr/bin/env bash
# The pictures of docs/gallery: installs what is missing, builds, and calls `frond gallery`, which has these options.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
call_frond gallery "$@"
