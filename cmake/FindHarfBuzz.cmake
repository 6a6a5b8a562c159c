# HarfBuzz, whose own CMake configuration distributions leave out: HarfBuzz::HarfBuzz.
find_path(HarfBuzz_INCLUDE_DIR hb-ot.h PATH_SUFFIXES harfbuzz)
find_library(HarfBuzz_LIBRARY harfbuzz)
mark_as_advanced(HarfBuzz_INCLUDE_DIR HarfBuzz_LIBRARY)

if(HarfBuzz_INCLUDE_DIR AND EXISTS ${HarfBuzz_INCLUDE_DIR}/hb-version.h)
  file(STRINGS ${HarfBuzz_INCLUDE_DIR}/hb-version.h line REGEX "define HB_VERSION_STRING ")
  string(REGEX MATCH "[0-9.]+" HarfBuzz_VERSION "${line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HarfBuzz REQUIRED_VARS HarfBuzz_LIBRARY HarfBuzz_INCLUDE_DIR
                                           VERSION_VAR HarfBuzz_VERSION)

if(HarfBuzz_FOUND AND NOT TARGET HarfBuzz::HarfBuzz)
  add_library(HarfBuzz::HarfBuzz UNKNOWN IMPORTED)
  set_target_properties(HarfBuzz::HarfBuzz PROPERTIES IMPORTED_LOCATION ${HarfBuzz_LIBRARY}
                                                      INTERFACE_INCLUDE_DIRECTORIES ${HarfBuzz_INCLUDE_DIR})
endif()
