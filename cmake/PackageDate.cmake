# The date of everything in a package: what the environment says, or else that of the last change of the source.
if(NOT DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(
    COMMAND git log -1 --format=%ct
    WORKING_DIRECTORY ${CPACK_HALFSPACE_SOURCE}
    OUTPUT_VARIABLE seconds
    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT seconds) # no Git, or no repository
    file(TIMESTAMP ${CPACK_HALFSPACE_SOURCE}/CHANGELOG.md seconds %s UTC)
  endif()
  set(ENV{SOURCE_DATE_EPOCH} ${seconds})
endif()
