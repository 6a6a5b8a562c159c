# What ./run, ./run-tests and other scripts have in common: installing what is missing, configuring, building. To be sourced by bash.
# Everything here speaks on standard error: standard output belongs to the program.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
buildDir=$root/build/release

say() { echo "$*" >&2; }

stop() {
  say "$*"
  exit 1
}

# The packages of a list that are not installed, in one line.
missingPackages() {
  local list=$1 package command installed
  installed=$'\n'$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' 2>/dev/null)$'\n'
  while read -r package command; do
    [[ $package != '#'* && -n $package ]] || continue
    [[ $installed == *$'\n'"installed $package"$'\n'* ]] && continue
    [[ -n $command ]] && command -v "$command" >/dev/null && continue
    echo -n "$package "
  done <"$list"
}

# Installs what is missing of these lists in packages/: build, test, core …
installMissing() {
  command -v dpkg-query >/dev/null || return 0 # no Debian: CMake says what it does not find
  local list missing=
  for list in "$@"; do
    missing+=$(missingPackages "$root/packages/$list.txt")' '
  done
  [[ -n ${missing// /} ]] || return 0

  local -a asRoot=()
  if [[ $EUID != 0 ]]; then
    command -v sudo >/dev/null || stop "Halfspace needs these Debian packages, which only root may install: $missing"
    asRoot=(sudo)
  fi
  say "Installing Debian packages that Halfspace needs: $missing"
  local -a apt=("${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --quiet)
  # shellcheck disable=SC2086 # the packages are separate words
  { "${apt[@]}" update && "${apt[@]}" install --yes --no-install-recommends $missing; } >&2 ||
    stop "These Debian packages could not be installed; install them as root, then start again: $missing"
}

# Builds the given targets (none: all) into build/release. Silent when there is nothing to do.
build() {
  mkdir -p "$buildDir"
  (
    flock 9 # two of us at once would write over each other
    cd "$root"
    if [[ ! -e $buildDir/build.ninja || CMakePresets.json -nt $buildDir/build.ninja ]]; then
      say "Configuring Halfspace in build/release"
      cmake --preset release >&2 || stop "Halfspace could not be configured: see CMake's message above."
    fi
    # Ninja's own remarks go: without work there is nothing to read.
    ninja -C "$buildDir" "$@" 2>&1 | sed --unbuffered '/^ninja: [En]/d; /Re-checking globbed/d' >&2 ||
      stop "Halfspace could not be built: see the message above."
  ) 9>"$buildDir.lock"
}

# Starts a command that fills the cores which what follows leaves idle. Its words are kept for `joined`; it ends with us. A
# process group of its own is ended as a whole; in a session of its own it would take as much of the cores as we do.
beside() {
  besideWords=$(mktemp)
  set -m
  nice -n 19 "$@" >"$besideWords" 2>&1 &
  set +m
  beside=$!
  trap 'kill -- -$beside 2>/dev/null || true; rm -f "$besideWords"' EXIT
}

# Waits for what was started beside us, and says what it said. Fails where it did.
joined() {
  local status=0
  wait "$beside" || status=$?
  cat "$besideWords" >&2
  return $status
}
