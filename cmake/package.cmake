# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What `cmake --install` installs, and what `cpack -G DEB` makes a Debian package of.

# The Debian package's name. Debian wants a package's documents in a folder of that name, so they go there everywhere.
set(debian_name libcgal-dynamic-delaunay-triangulation-2-dev)
set(CMAKE_INSTALL_DOCDIR "share/doc/${debian_name}" CACHE PATH "Where README, CHANGELOG, licence, examples and manual go")
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# What is installed is not built: neither `make install` nor cpack has to wait for tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
# Whoever installs for all wants all to read it, whatever the umask is.
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS ${CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS})

foreach(name IN ITEMS copyright description.txt long_description.txt maintainer)
  set(file "${PROJECT_SOURCE_DIR}/package_info/${PROJECT_NAME}/${name}")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  get_filename_component(variable ${name} NAME_WE)
  file(STRINGS "${file}" ${variable})
  list(JOIN ${variable} "\n" ${variable})
endforeach()

# Nothing in here depends on the processor, so the CMake files go to share/ instead of lib/.
set(cmake_folder "${CMAKE_INSTALL_DATADIR}/cmake/${PROJECT_NAME}")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/${PROJECT_NAME}Config.cmake.in"
  "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake" INSTALL_DESTINATION "${cmake_folder}"
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian_copyright.in" "${PROJECT_BINARY_DIR}/copyright" @ONLY)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}"
  FILES_MATCHING PATTERN "*.h")
install(TARGETS ${PROJECT_NAME} EXPORT ${PROJECT_NAME}Targets INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(EXPORT ${PROJECT_NAME}Targets NAMESPACE ${PROJECT_NAME}:: DESTINATION "${cmake_folder}")
install(FILES "${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake"
  "${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake" "${CMAKE_CURRENT_LIST_DIR}/compiled_updates.cmake"
  DESTINATION "${cmake_folder}")
install(FILES "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md"
  "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_BINARY_DIR}/copyright" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

# The manual is installed where it has been made: `cmake --build DIRECTORY --target manual`.
find_program(DOXYGEN doxygen)
find_program(DOT dot)
if(DOXYGEN AND DOT)
  add_custom_target(manual COMMAND "${CMAKE_COMMAND}" -D "OUTPUT=${PROJECT_BINARY_DIR}/manual" -D "DOXYGEN=${DOXYGEN}"
    -P "${CMAKE_CURRENT_LIST_DIR}/write_manual.cmake" VERBATIM)
endif()
install(DIRECTORY "${PROJECT_BINARY_DIR}/manual/html" DESTINATION "${CMAKE_INSTALL_DOCDIR}" OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ${debian_name})
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${description}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= 5.5)")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libjs-mathjax, libtbb-dev")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libcgal-qt5-dev") # draw()
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/link_mathjax.cmake")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "${long_description}")
include(CPack)
