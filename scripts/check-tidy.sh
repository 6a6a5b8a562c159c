#!/usr/bin/env bash
# Runs clang-tidy on sources built into build/release whose object files are newer than their last clean check: an
# object is made anew exactly when its source or a header of it has changed.
# Arguments are folders; without one, those where a hidden mistake costs most. Five seconds a file: the rest is checked
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
# Several sources of one folder, whose flags are the same, are checked as if they were one: what they include is then read and
# looked through once, and it takes half the time. Where that finds something, as that two of them have a name in common,
# each is checked by itself, and that counts.
checkTogether() {
  local checked=$1 headers all entry
  shift
  all=$PWD/$checked/together/${1//\//-}
  mkdir -p "$all"
  printf '#include "%s"\n' "${@/#/$PWD/}" >"$all/all.cpp"
  entry=$(grep --fixed-strings -- " -c $PWD/$1\"" "$checked/compile_commands.json" | head -n 1)
  entry=${entry// -c $PWD\/$1/ -c $all\/all.cpp}
  echo "[{\"directory\": \"$PWD/build/release\", $entry \"file\": \"$all/all.cpp\"}]" >"$all/compile_commands.json"
  # Findings in sources count as those in headers do.
  headers=$(sed -n "s/^HeaderFilterRegex: '\(.*\)\\\\.h\\$'/\1\\\\.(h|cpp)$/p" .clang-tidy)
  clang-tidy --quiet --checks=-bugprone-suspicious-include --header-filter="$headers" -p "$all" "$all/all.cpp" >/dev/null 2>&1
}

check() {
  local checked=$1 source findings
  shift
  checkTogether "$checked" "$@" || for source in "$@"; do
    findings=$(clang-tidy --quiet -p "$checked" "$source" 2>&1) || {
      echo "$findings" >&2
      return 1
    }
  done
  for source in "$@"; do
    mkdir -p "$checked/${source%/*}"
    touch "$checked/$source"
  done
}
export -f check checkTogether

# The sources of a folder that are to be checked, one after the other.
outdatedIn() {
  local object source
  while read -r object; do
    # build/release/lessons/CMakeFiles/halfspace_lessons.dir/scene/scene.cpp.o is made of lessons/scene/scene.cpp.
    source=$(sed -E 's|^build/release/(.*)/CMakeFiles/[^/]*\.dir/(.*)\.o$|\1/\2|' <<<"$object")
    [[ -e $source ]] || continue # generated
    [[ $checked/$source -nt $object && $checked/$source -nt .clang-tidy ]] || echo "$source"
  done < <(find "build/release/$1" -name '*.cpp.o' | sort)
}

# Those of a folder in lines of a few. Such as stand side by side are likest to have names in common: they come into
# different lines.
groupsIn() {
  local -r together=4
  local -a outdated group
  local count first i
  mapfile -t outdated < <(outdatedIn "$1")
  count=$(((${#outdated[@]} + together - 1) / together))
  for ((first = 0; first < count; ++first)); do
    group=()
    for ((i = first; i < ${#outdated[@]}; i += count)); do
      group+=("${outdated[i]}")
    done
    echo "${group[*]}"
  done
}

for folder in "$@"; do
  [[ ! -d build/release/$folder ]] || groupsIn "$folder"
done | xargs --no-run-if-empty --max-lines=1 --max-procs="$(nproc)" bash -c 'check "$@"' bash "$checked"
