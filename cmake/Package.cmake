# What `cpack` makes: a Debian package of the program, the same bytes each time.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME halfspace)
set(CPACK_PACKAGE_CONTACT "Halfspace contributors <contributors@halfspace.invalid>")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};${PROJECT_NAME};${CMAKE_INSTALL_DEFAULT_COMPONENT_NAME};/")
set(CPACK_STRIP_FILES ON)
# Whatever the umask of who makes it.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
                                                WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS ffmpeg) # for videos
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "exact geometry of planes, rays and triangles, to be dragged
Drag planes, points, rays and triangles, and read live and exactly what that
does to the algebra: implicit equation, signed distance, the foot of a point,
intersection parameters. For learners who work alone, and for teachers at the
projector, who can write lessons of their own in Markdown.
.
Every = on the screen is true: coordinates are fractions, lengths keep their
roots, and a rounded number stands after ≈.")

# Both run within cpack: the first before anything is installed, the second when everything is, and not yet packed.
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/PackageDate.cmake)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/FinishPackage.cmake)
set(CPACK_HALFSPACE_SOURCE ${PROJECT_SOURCE_DIR})
include(CPack)
