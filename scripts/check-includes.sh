#!/usr/bin/env bash
# Fails where a file includes what its room must not know: docs/architecture.md draws the house, this is its law.
# A folder without a line of its own belongs to the room around it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# A room, the rooms that it may include besides itself (`lessons/*`: all of them), and the libraries that are not
# everyone's.
rooms='
geometry             : : GMP
geometry/search      : geometry : Embree
eval                 : geometry
lessons              :
lessons/term         : geometry lessons
lessons/figure       : lessons
lessons/reading      : geometry lessons lessons/term : JSON YAML MD4C
lessons/files        : lessons lessons/reading
lessons/object       : geometry geometry/search lessons lessons/term lessons/figure lessons/reading
lessons/formula      : geometry lessons lessons/object lessons/reading
lessons/construction : geometry lessons lessons/term lessons/figure lessons/object
lessons/scene        : geometry eval lessons lessons/term lessons/figure lessons/object lessons/formula lessons/construction lessons/reading lessons/files : JSON
lessons/typed        : geometry lessons lessons/term lessons/figure lessons/object lessons/formula lessons/construction lessons/scene lessons/reading
lessons/fitting      : lessons lessons/object lessons/formula lessons/construction lessons/scene
lessons/discovery    : geometry lessons lessons/term lessons/figure lessons/object lessons/construction lessons/scene
lessons/lesson       : geometry lessons lessons/term lessons/figure lessons/object lessons/construction lessons/scene lessons/reading lessons/files
widgets/formula      : geometry lessons/* : HarfBuzz
widgets/picture      : geometry geometry/search lessons/* widgets/formula
widgets/scene        : geometry lessons/* widgets/formula widgets/picture : VTK OpenGL
widgets/carriers     : geometry lessons/* : Codes
widgets/exports      : geometry lessons/* widgets/formula widgets/picture widgets/carriers : HarfBuzz
widgets/handout      : geometry lessons/* widgets/formula widgets/picture widgets/exports
widgets/mesh_files   : geometry geometry/search lessons/*
widgets              : geometry geometry/search lessons/* widgets/formula widgets/picture widgets/mesh_files : Qt
widgets/view         : geometry lessons/* widgets/formula widgets/picture widgets/scene widgets : Qt VTK
widgets/animation    : geometry lessons/* widgets/formula widgets/picture widgets/scene widgets/view widgets : Qt VTK GIF
app                  : geometry eval lessons/* widgets/formula widgets/picture widgets/carriers widgets/exports widgets/handout widgets/scene widgets/mesh_files widgets/view widgets/animation widgets : Qt JSON CLI11
'

grep --recursive --only-matching --extended-regexp '^ *# *include *[<"][^>"]+' \
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
        split(parts[2] " " parts[3], others, " ")
        for (j in others)
          mayInclude[room, others[j]] = 1
      }
    }
    # The innermost room of a file; "" for what is generated or from elsewhere.
    function roomOf(path) {
      while (sub(/\/[^\/]*$/, "", path))
        if (path in isRoom)
          return path
      return ""
    }
    # The library of a header that is not everyone'"'"'s; "" for others.
    function libraryOf(header) {
      return header ~ /^(vtk|QVTK)/ ? "VTK" : header ~ /^Q/ ? "Qt" : header ~ /^embree/ ? "Embree" : \
        header ~ /gmp/ ? "GMP" : header ~ /^hb/ ? "HarfBuzz" : header ~ /^(EGL|GL)\// ? "OpenGL" : header ~ /^(ZXing\/|qrencode|png\.h|turbojpeg)/ ? "Codes" : \
        header ~ /^yaml-cpp/ ? "YAML" : header ~ /^gif_lib/ ? "GIF" : header ~ /^md4c/ ? "MD4C" : header ~ /^nlohmann/ ? "JSON" : header ~ /^CLI\// ? "CLI11" : ""
    }
    {
      split($0, parts, ":")
      included = parts[2]
      sub(/^[^<"]*[<"]/, "", included)
      room = roomOf(parts[1])
      other = roomOf(included)
      house = other
      sub(/(\/.*)?$/, "/*", house)
      library = libraryOf(included)
      if (included ~ /\.\./ || included ~ /^tests\// ||
          (other != "" && !((room, other) in mayInclude) && !((room, house) in mayInclude)) ||
          (other == "" && library != "" && !((room, library) in mayInclude))) {
        print parts[1] ": must not include " included
        failed = 1
      }
    }
    END { exit failed }' >&2
