# Adds to the installed files what Debian asks for beyond them, and gives all of them one date.
set(documents ${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/${CPACK_PACKAGE_NAME})
set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(COPY_FILE ${CPACK_HALFSPACE_SOURCE}/CHANGELOG.md ${documents}/changelog)
file(WRITE ${documents}/changelog.Debian
     "${CPACK_PACKAGE_NAME} (${version}) unstable; urgency=medium

  * What is new stands in changelog.gz.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(CHMOD ${documents}/changelog ${documents}/changelog.Debian FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ
     WORLD_READ)
file(GLOB_RECURSE pages ${CPACK_TEMPORARY_DIRECTORY}/usr/share/man/*.1)
execute_process(COMMAND gzip -9 --no-name --force ${pages} ${documents}/changelog ${documents}/changelog.Debian
                        COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -exec touch --no-dereference
                        --date=@$ENV{SOURCE_DATE_EPOCH} {} + COMMAND_ERROR_IS_FATAL ANY)
