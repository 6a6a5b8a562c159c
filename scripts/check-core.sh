#!/usr/bin/env bash
# Builds all that needs neither Qt, VTK, Embree nor GMP, with clang, and runs its tests: both compilers
# check us, and nothing of it leans on the program. Arguments go to ctest.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"
cd "$root"

installMissing build core
say "Building the core with clang"
cmake --preset core >&2
cmake --build --preset core >&2
ctest --preset core --timeout 300 --parallel "$(nproc)" "$@"
