#!/usr/bin/env bash
# Makes a Debian package of the program for systems like this one, and prints its name.
set -euo pipefail
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/setup.sh"

installMissing build package
build halfspace_app halfspace_manual
say "Making the package"
umask 022 # files within the package keep it; with another one its bytes are others
(cd "$buildDir" && cpack >&2) || stop "The package could not be made: see the message above."
ls "$buildDir"/halfspace_*.deb
