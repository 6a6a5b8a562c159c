#!/usr/bin/env bash
# Builds all that needs neither Qt, VTK, Embree nor GMP, with clang and the address and undefined behaviour sanitizers, and
# runs its tests with fewer inputs: both compilers check us, each step is watched, and nothing of it leans on the program.
# Not optimized: that would take longer to build than it saves. Arguments go to ctest.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"
cd "$root"

installMissing build core
say "Building the core with clang and the sanitizers"
cmake --preset core >&2
cmake --build --preset core >&2
# Remembering where each piece of memory came from, thirty calls deep, would take an eighth of the time.
ASAN_OPTIONS=malloc_context_size=3 ctest --preset core --timeout 1500 --parallel "$(nproc)" "$@"
