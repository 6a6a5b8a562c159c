#!/usr/bin/env bash
# Writes every text that can be translated to build/halfspace.ts, for Qt's Linguist: those of windows (`tr`) and all other sentences
# (`words`). Needs lupdate: the package qttools5-dev-tools, or qt6-l10n-tools.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

for lupdate in lupdate /usr/lib/qt6/bin/lupdate; do
  command -v "$lupdate" >/dev/null && break
done
command -v "$lupdate" >/dev/null || { echo "lupdate is missing: install qttools5-dev-tools or qt6-l10n-tools." >&2; exit 1; }
mkdir -p build
# It complains of functions that are no class of Qt: their sentences are found all the same.
"$lupdate" -silent -recursive app eval geometry lessons widgets -no-obsolete -tr-function-alias tr+=words,tr+=says -ts build/halfspace.ts 2>/dev/null
echo "build/halfspace.ts has $(grep --count '<source>' build/halfspace.ts) texts."
