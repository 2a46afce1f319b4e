#!/usr/bin/env bash
# Builds the wheel, installs it into a folder and uses it from there, without the sources.
#
#     tests/python/wheel_test.sh SCRATCH
set -euo pipefail
scratch=$1
rm -rf -- "$scratch"
mkdir -p -- "$scratch"
export PIP_ROOT_USER_ACTION=ignore
pip=(/usr/bin/python3 -m pip --disable-pip-version-check --quiet)
"${pip[@]}" wheel --no-deps --no-build-isolation --wheel-dir "$scratch" gen/apps/python
"${pip[@]}" install --no-deps --no-index --target "$scratch/site" "$scratch"/frond-*.whl
cd -- "$scratch"
PYTHONPATH=$scratch/site /usr/bin/python3 - <<'TEXT'
import pathlib
import frond

assert pathlib.Path(frond.__file__).parent == pathlib.Path("site/frond").resolve(), frond.__file__
assert frond.Preset({"organisms": [{"species": "bush.json"}]}).grow().nodes > 100
preset = frond.Preset({"film": {"frames": 2, "size": [64, 36]}, "organisms": [{"kind": "coral"}]})
assert preset.grow().organisms[0].skeleton.position.shape[1] == 3
assert frond.render(preset, "film", quality="draft").wait().stat().st_size > 0
TEXT
