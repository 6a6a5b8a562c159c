#!/usr/bin/env bash
# Runs clang-tidy on sources built into build/release whose object files are newer than their last clean check: an
# object is made anew exactly when its source or a header of it has changed.
# Arguments are folders; without one, those where a hidden mistake costs most. Ten seconds a file: the rest is checked
# by the preset `tidy`, at leisure.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Each version finds other things.
if [[ $(clang-tidy --version) != *' version 14.'* ]]; then
  echo "The checks are clang-tidy 14's, which is not here: they are left out." >&2
  exit 0
fi

[[ $# != 0 ]] || set -- geometry eval lessons widgets/formula widgets/picture
checked=build/release/checked
mkdir -p "$checked"
# The compiler's precompiled headers are not clang's.
sed -E 's/ -Winvalid-pch -include [^ ]+cmake_pch\.hxx//' build/release/compile_commands.json >"$checked/compile_commands.json"
outdated=()
for folder in "$@"; do
  [[ -d build/release/$folder ]] || continue
  while read -r object; do
    # build/release/lessons/CMakeFiles/halfspace_lessons.dir/scene/scene.cpp.o is made of lessons/scene/scene.cpp.
    source=$(sed -E 's|^build/release/(.*)/CMakeFiles/[^/]*\.dir/(.*)\.o$|\1/\2|' <<<"$object")
    [[ -e $source ]] || continue # generated
    [[ $checked/$source -nt $object && $checked/$source -nt .clang-tidy ]] || outdated+=("$source")
  done < <(find "build/release/$folder" -name '*.cpp.o')
done
[[ ${#outdated[@]} != 0 ]] || exit 0

# shellcheck disable=SC2016 # the inner shell expands
printf '%s\0' "${outdated[@]}" | xargs -0 --max-args=1 --max-procs="$(nproc)" bash -c '
  findings=$(clang-tidy --quiet -p "$0" "$1" 2>&1) || { echo "$findings" >&2; exit 1; }
  mkdir -p "$0/${1%/*}"
  touch "$0/$1"' "$checked"
