#!/usr/bin/env bash
# Fails where docs/reliability.md names a test that is not there. It names them as `Suite.Test`, those of Qt as
# `file_test.slot`, and files and folders below `tests/`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
promises=docs/reliability.md

# What stands in backticks and looks like this, once each.
named() { grep --only-matching --extended-regexp "$1" "$promises" | tr --delete '`' | sort --unique; }

isThere() {
  local suite=${1%%.*} test=${1#*.}
  case $suite in
  *_test) find tests -name "$suite.cpp" -exec cat {} + | grep --quiet --extended-regexp "void $test\(\)" ;;
  *) grep --quiet --recursive --extended-regexp "TEST(_[FP])?\($suite, *$test\)" tests ;;
  esac
}

missing=0
for test in $(named '`[A-Za-z]\w*\.\w*_\w*`|`[A-Z]\w*\.[A-Z]\w*`|`\w+_test\.[a-z]\w{4,}`'); do
  isThere "$test" || { echo "$promises: there is no test $test"; missing=1; }
done
for path in $(named '`tests/[^`]*`'); do
  [[ -e $path ]] || { echo "$promises: there is no $path"; missing=1; }
done
exit $missing
