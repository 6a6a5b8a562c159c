# What every target of this project is compiled with.

# At -O3 the arithmetic of fractions is inlined into several times the code, without being faster.
string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
add_library(halfspace_options INTERFACE)
add_library(Halfspace::options ALIAS halfspace_options)
target_compile_features(halfspace_options INTERFACE cxx_std_20)

# Errors only with the compilers that the project is checked with: what newer ones have learned to warn of shall not keep
# a user from building.
set(checked_compiler $<OR:$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>,$<AND:$<CXX_COMPILER_ID:Clang>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,15>>>)
add_library(halfspace_warnings INTERFACE)
add_library(Halfspace::warnings ALIAS halfspace_warnings)
# False alarms of GCC 12, which come and go with what it inlines: it takes the union in Boost's small integers for
# uninitialized, sees overlapping copies in "text" + std::string, and with -Wnull-dereference null pointers in every vector that
# grows. What it says of lengths is told, but keeps nobody from building.
target_compile_options(
  halfspace_warnings
  INTERFACE -Wall
            -Wextra
            -Wpedantic
            -Wshadow
            -Wconversion
            -Wsign-conversion
            -Wold-style-cast
            -Wnon-virtual-dtor
            -Woverloaded-virtual
            $<$<AND:$<BOOL:${HALFSPACE_WARNINGS_AS_ERRORS}>,${checked_compiler}>:-Werror>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-restrict>
            $<$<CXX_COMPILER_ID:GNU>:-Wno-error=stringop-overflow;-Wno-error=stringop-overread;-Wno-error=array-bounds;-Wno-error=dangling-pointer>)

if(HALFSPACE_SANITIZE)
  target_compile_options(halfspace_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                                                     -fno-sanitize-recover=undefined)
  target_link_options(halfspace_options INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(halfspace_options INTERFACE HALFSPACE_SANITIZE)
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

# Other people's headers that nearly every source reads, read once for each target: a source then takes a tenth to a third less
# to compile. Headers of ours are not among them, so that a file that forgets one does not compile. Not with ccache: for it
# every precompiled header is another one, and nothing that was compiled with it is found again.
option(HALFSPACE_PRECOMPILED_HEADERS "Read what is other people's once for each target; not with ccache" ON)
if(CMAKE_CXX_COMPILER_LAUNCHER OR NOT HALFSPACE_PRECOMPILED_HEADERS)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
set(HALFSPACE_STANDARD_HEADERS <algorithm> <array> <functional> <map> <memory> <optional> <set> <string> <string_view> <variant> <vector>
                               <glm/geometric.hpp>)
set(HALFSPACE_WIDGET_HEADERS ${HALFSPACE_STANDARD_HEADERS} <QAction> <QLabel> <QMenu> <QPainter> <QToolButton> <QVBoxLayout>)
