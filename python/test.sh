#!/usr/bin/env bash
# Builds the wheel, installs it into a fresh virtual environment, and tests it there: its types, its stubs,
# that its operations are those of the library, and its tests. `VIROTE_PROFILE` is the profile of the build,
# by default that of the command's release, whose library is then not built again.

set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")"
profile=${VIROTE_PROFILE:-release}
studies=$(cd ../docs/studies && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

python3 -m venv "$folder/venv"
python=$folder/venv/bin/python
# What is not imported need not be compiled.
install=("$python" -m pip install --quiet --disable-pip-version-check --no-compile)
"${install[@]}" maturin pytest mypy pandas pyarrow scipy distributed optuna SALib openmdao nbclient ipykernel
PATH=$folder/venv/bin:$PATH maturin build --quiet --profile "$profile" --out "$folder/wheels"
wheel=("$folder"/wheels/*.whl)
echo "${wheel[0]##*/}: $(stat -c %s "${wheel[0]}") bytes"
"${install[@]}" "${wheel[0]}"

# Away from here, so that what is tested is the wheel.
cp -r tests generate.py pyproject.toml "$folder/"
cd "$folder"
installed=$("$python" -c 'import os, virote; print(os.path.dirname(virote.__file__))')
"$python" -m mypy --strict --ignore-missing-imports -p virote
"$python" -m mypy.stubtest virote._virote
"$python" - "$installed" <<'PROGRAM'
import json, pathlib, runpy, sys
from virote import _virote

text = runpy.run_path("generate.py")["module"](json.loads(_virote.operations()))
if pathlib.Path(sys.argv[1], "_operations.py").read_text() != text:
    sys.exit("virote/_operations.py is out of date; `python generate.py` writes it")
PROGRAM
"$folder/venv/bin/virote" --version
export VIROTE_STUDIES=$studies
"$python" -m pytest --quiet tests
"$python" -m pytest --quiet --doctest-modules --pyargs virote --ignore-glob='*_operations.py'
