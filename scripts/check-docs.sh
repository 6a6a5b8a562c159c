#!/usr/bin/env bash
# Fails where documentation names a file or a folder of ours that is not there, and where docs/reliability.md names a test that
# is not there. It names them as `Suite.Test`, those of Qt as `file_test.slot`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
promises=docs/reliability.md

# What stands in backticks in these files and looks like this, once each.
named() { grep --no-filename --only-matching --extended-regexp "$@" | tr --delete '`' | sort --unique; }

isThere() {
  local suite=${1%%.*} test=${1#*.}
  case $suite in
  *_test) find tests -name "$suite.cpp" -exec cat {} + | grep --quiet --extended-regexp "void $test\(\)" ;;
  *) grep --quiet --recursive --extended-regexp "TEST(_[FP])?\($suite, *$test\)" tests ;;
  esac
}

missing=0
for test in $(named '`[A-Za-z]\w*\.\w*_\w*`|`[A-Z]\w*\.[A-Z]\w*`|`\w+_test\.[a-z]\w{4,}`' "$promises"); do
  isThere "$test" || { echo "$promises: there is no test $test"; missing=1; }
done
for path in $(named '`(app|cmake|docs|eval|examples|geometry|lessons|packages|resources|scripts|tests|widgets)/[A-Za-z0-9_./-]*`' \
  README.md docs/*.md docs/decisions/*.md); do
  [[ -e $path ]] || { echo "The documentation names $path, which is not there."; missing=1; }
done
exit $missing
