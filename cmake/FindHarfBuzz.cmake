# HarfBuzz, whose own CMake configuration distributions leave out: HarfBuzz::HarfBuzz, and HarfBuzz::HarfBuzz-subset,
# which takes fonts apart.
find_path(HarfBuzz_INCLUDE_DIR hb-ot.h PATH_SUFFIXES harfbuzz)
find_library(HarfBuzz_LIBRARY harfbuzz)
find_library(HarfBuzz_SUBSET_LIBRARY harfbuzz-subset)
mark_as_advanced(HarfBuzz_INCLUDE_DIR HarfBuzz_LIBRARY HarfBuzz_SUBSET_LIBRARY)

if(HarfBuzz_INCLUDE_DIR AND EXISTS ${HarfBuzz_INCLUDE_DIR}/hb-version.h)
  file(STRINGS ${HarfBuzz_INCLUDE_DIR}/hb-version.h line REGEX "define HB_VERSION_STRING ")
  string(REGEX MATCH "[0-9.]+" HarfBuzz_VERSION "${line}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(HarfBuzz REQUIRED_VARS HarfBuzz_LIBRARY HarfBuzz_SUBSET_LIBRARY HarfBuzz_INCLUDE_DIR
                                           VERSION_VAR HarfBuzz_VERSION)

if(HarfBuzz_FOUND AND NOT TARGET HarfBuzz::HarfBuzz)
  add_library(HarfBuzz::HarfBuzz UNKNOWN IMPORTED)
  set_target_properties(HarfBuzz::HarfBuzz PROPERTIES IMPORTED_LOCATION ${HarfBuzz_LIBRARY}
                                                      INTERFACE_INCLUDE_DIRECTORIES ${HarfBuzz_INCLUDE_DIR})
  add_library(HarfBuzz::HarfBuzz-subset UNKNOWN IMPORTED)
  set_target_properties(HarfBuzz::HarfBuzz-subset PROPERTIES IMPORTED_LOCATION ${HarfBuzz_SUBSET_LIBRARY}
                                                             INTERFACE_LINK_LIBRARIES HarfBuzz::HarfBuzz)
endif()
