#!/usr/bin/env bash
# Builds everything with the address and undefined behaviour sanitizers and runs all tests but the benchmarks and those of
# the package, under a virtual display of their own. Takes hours. Arguments go to ctest: scripts/check-asan.sh -R Reload
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"
cd "$root"

installMissing build test
say "Building with the sanitizers"
cmake --preset asan >&2
cmake --build --preset asan >&2
# What Qt, VTK and the OpenGL driver keep to the end is theirs, so leaks are not looked for.
env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb ASAN_OPTIONS=detect_leaks=0 \
  xvfb-run --auto-servernum --server-args="-screen 0 1920x1080x24" \
  ctest --preset asan --timeout 1500 --parallel "$(nproc)" "$@"
