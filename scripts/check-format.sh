#!/usr/bin/env bash
# Fails where a C++ file is not formatted as .clang-format says. With --fix, formats it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Each version breaks some lines elsewhere.
if [[ $(clang-format --version) != *' version 14.'* ]]; then
  echo "The formatting is clang-format 14's, which is not here: it is not checked." >&2
  exit 0
fi

how=(--dry-run --Werror)
[[ ${1-} == --fix ]] && how=(-i)
find app eval geometry lessons tests widgets \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 clang-format "${how[@]}"
