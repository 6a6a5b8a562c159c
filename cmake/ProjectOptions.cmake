# What every target of this project is compiled with.
add_library(halfspace_options INTERFACE)
add_library(Halfspace::options ALIAS halfspace_options)
target_compile_features(halfspace_options INTERFACE cxx_std_20)

add_library(halfspace_warnings INTERFACE)
add_library(Halfspace::warnings ALIAS halfspace_warnings)
target_compile_options(
  halfspace_warnings
  INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wold-style-cast -Wnon-virtual-dtor
            -Woverloaded-virtual -Wnull-dereference $<$<BOOL:${HALFSPACE_WARNINGS_AS_ERRORS}>:-Werror>)

if(HALFSPACE_SANITIZE)
  target_compile_options(halfspace_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
                                                     -fno-sanitize-recover=undefined)
  target_link_options(halfspace_options INTERFACE -fsanitize=address,undefined)
endif()
