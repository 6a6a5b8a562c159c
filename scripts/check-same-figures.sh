#!/usr/bin/env bash
# Compares the figures of all steps of all lessons as two builds write them, byte for byte: build/release by GCC, optimized and with GMP,
# and build/core by clang, neither. Both must be built.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

figures=$(mktemp --directory)
trap 'rm -rf "$figures"' EXIT
for preset in release core; do
  mkdir "$figures/$preset"
  "build/$preset/bin/write_lesson_figures" "$figures/$preset"
done
diff --recursive --brief "$figures/release" "$figures/core"
