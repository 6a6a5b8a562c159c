#!/usr/bin/env bash
# Fails where a file includes what its room must not know: docs/architecture.md draws the house, this is its law.
# A folder without a line of its own belongs to the room around it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# A room, the rooms that it may include besides itself, and of Qt and VTK what it may include.
rooms='
geometry             :
eval                 : geometry
lessons              :
lessons/term         : geometry lessons
lessons/figure       : lessons
lessons/reading      : geometry lessons
lessons/files        : lessons lessons/reading
lessons/object       : geometry lessons lessons/term lessons/figure
lessons/construction : geometry lessons lessons/term lessons/figure lessons/object
lessons/scene        : geometry lessons lessons/term lessons/figure lessons/object lessons/construction lessons/reading lessons/files
lessons/lesson       : geometry lessons lessons/term lessons/figure lessons/object lessons/construction lessons/scene lessons/reading lessons/files
widgets/picture      : geometry lessons
widgets/scene        : geometry lessons widgets/picture : VTK
widgets              : geometry lessons widgets/picture : Qt
widgets/view         : geometry lessons widgets widgets/picture widgets/scene : Qt VTK
app                  : geometry eval lessons widgets widgets/picture widgets/scene widgets/view : Qt
'

grep --recursive --only-matching --extended-regexp '^#include [<"][^>"]+' \
  --include='*.h' --include='*.cpp' --include='*.in' app eval geometry lessons widgets |
  awk -v rooms="$rooms" '
    BEGIN {
      split(rooms, lines, "\n")
      for (i in lines) {
        split(lines[i], parts, ":")
        room = parts[1]
        gsub(/ /, "", room)
        if (room == "")
          continue
        isRoom[room] = 1
        mayInclude[room, room] = 1
        split(parts[2], others, " ")
        for (j in others)
          mayInclude[room, others[j]] = 1
        split(parts[3], libraries, " ")
        for (j in libraries)
          mayInclude[room, libraries[j]] = 1
      }
    }
    # The innermost room of a file; "" for what is generated or from elsewhere.
    function roomOf(path) {
      while (sub(/\/[^\/]*$/, "", path))
        if (path in isRoom)
          return path
      return ""
    }
    # Rooms with rooms inside, as lessons and widgets/picture, are known whole to those outside.
    function knows(room, other,    outer) {
      for (outer = other; outer != ""; outer = index(outer, "/") ? substr(outer, 1, match(outer, /\/[^\/]*$/) - 1) : "")
        if ((room, outer) in mayInclude && (outer == other || index(room "/", outer "/") != 1))
          return 1
      return 0
    }
    {
      split($0, parts, ":#include ")
      file = parts[1]
      included = substr(parts[2], 2)
      room = roomOf(file)
      if (substr(parts[2], 1, 1) == "\"") {
        other = roomOf(included)
        if (other != "" && !knows(room, other))
          complain(file, included)
      } else if (included ~ /^vtk/ && !((room, "VTK") in mayInclude) || included ~ /^Q/ && !((room, "Qt") in mayInclude)) {
        complain(file, included)
      }
    }
    function complain(file, included) {
      print file ": must not include " included
      failed = 1
    }
    END { exit failed }' >&2
