# Debian packages of what is installed: `cmake --build BUILD --target package`, or make_debs.sh beside
# this file. They are built with the prefix /usr, which decides where Debian looks for the rest.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME graze)
set(CPACK_PACKAGE_VENDOR "The Graze authors")
set(GRAZE_CONTACT "The Graze authors <graze@example.org>" CACHE STRING
    "Whom the packages name as their maintainer: a name and, in <>, an address")
set(CPACK_PACKAGE_CONTACT "${GRAZE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program library doc)
if(GRAZE_C)
  list(APPEND CPACK_COMPONENTS_ALL c)
endif()
if(GRAZE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
if(GRAZE_MPI)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(long "Graze simulates flexible structures that hit stops, through impact,
chatter, sticking and release, finds their periodic orbits, stable or
not, and traces these over parameters.")
# graze_package(<component> <package> <section> <what is in it>)
macro(graze_package component package section what)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${long}\n.\n${what}")
  # Each package has its licence and its history, as Debian's policy asks.
  set(doc ${CMAKE_INSTALL_DATADIR}/doc/${package})
  install(FILES ${PROJECT_BINARY_DIR}/packaging/copyright
                ${PROJECT_BINARY_DIR}/packaging/changelog.Debian.gz
          DESTINATION ${doc} COMPONENT ${component})
endmacro()
graze_package(program graze math
  "This package has the program, its manual pages and example scenes.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS graze-doc)
graze_package(library libgraze-dev libdevel
  "This package has the static libraries, the headers and the files of CMake.")
# What find_package(graze) looks for.
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS
    "libboost-dev, libceres-dev, libeigen3-dev (>= 3.4), libfmt-dev, libhwy-dev, libnlopt-dev, \
libspectra-dev, libsuitesparse-dev, libtbb-dev, libtomlplusplus-dev, libzip-dev, nettle-dev, \
nlohmann-json3-dev, pkg-config")
if(GRAZE_C)
  graze_package(c libgraze0 libs "This package has the shared library of the C interface.")
  set(CPACK_DEBIAN_C_PACKAGE_SHLIBDEPS ON)
  # Programs that link it depend on this package; the loader is told that it is there.
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/shlibs
       CONTENT "libgraze 0 libgraze0 (>= ${PROJECT_VERSION})\n")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/triggers
       CONTENT "activate-noawait ldconfig\n")
  set(CPACK_DEBIAN_C_PACKAGE_CONTROL_EXTRA
      "${PROJECT_BINARY_DIR}/packaging/shlibs;${PROJECT_BINARY_DIR}/packaging/triggers")
  string(APPEND CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS ", libgraze0 (= ${PROJECT_VERSION}-1)")
endif()
graze_package(doc graze-doc doc
  "This package has its pages, decisions and example programs.")
set(CPACK_DEBIAN_DOC_PACKAGE_ARCHITECTURE all)
if(GRAZE_PYTHON)
  set(Python_EXECUTABLE ${GRAZE_PYTHON_INTERPRETER})
  find_package(Python 3.9 REQUIRED COMPONENTS Interpreter)
  graze_package(python python3-graze python
    "This package has the module graze, whose results are arrays of NumPy.")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-matplotlib, python3-pandas")
  # Python compiles what it imports; Debian does so when the package comes, and clears it when it goes.
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/postinst CONTENT
"#!/bin/sh
set -e
if [ \"$1\" = configure ] && command -v py3compile > /dev/null; then
  py3compile -p python3-graze
fi
" @ONLY)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/prerm CONTENT
"#!/bin/sh
set -e
if command -v py3clean > /dev/null; then
  py3clean -p python3-graze
fi
" @ONLY)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
      "${PROJECT_BINARY_DIR}/packaging/postinst;${PROJECT_BINARY_DIR}/packaging/prerm")
endif()

if(GRAZE_MPI)
  graze_package(mpi graze-mpi math
    "This package has graze-mpi, whose ranks share long work.")
  set(CPACK_DEBIAN_MPI_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_MPI_PACKAGE_RECOMMENDS openmpi-bin)
endif()

# Below the name that policy has for them.
file(READ ${PROJECT_SOURCE_DIR}/LICENSE licence)
string(REGEX REPLACE "^MIT License\n\nCopyright[^\n]*\n\n" "" licence "${licence}")
string(REGEX REPLACE "\n\n" "\n.\n" licence "${licence}")
string(STRIP "${licence}" licence)
string(REGEX REPLACE "\n" "\n " licence " ${licence}")
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/copyright CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: graze

Files: *
Copyright: 2026 The Graze authors
License: Expat
${licence}

Files: pages written by --plot x.html
Copyright: 2017-2025 The Apache Software Foundation
License: Apache-2.0
 Pages contain Apache ECharts, whose notices and licences are at the head of each.
 .
 On Debian systems the Apache License 2.0 is in /usr/share/common-licenses/Apache-2.0.
" @ONLY)
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/packaging/changelog.Debian CONTENT
"graze (${PROJECT_VERSION}-1) unstable; urgency=medium

  * What changed stands in CHANGELOG.md of graze-doc.

 -- ${GRAZE_CONTACT}  Thu, 01 Jan 2026 00:00:00 +0000
" @ONLY)
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/packaging/changelog.Debian.gz
  COMMAND gzip -9nkf changelog.Debian WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/packaging
  DEPENDS ${PROJECT_BINARY_DIR}/packaging/changelog.Debian)
add_custom_target(graze_changelog ALL DEPENDS ${PROJECT_BINARY_DIR}/packaging/changelog.Debian.gz)

set(pages ${CMAKE_INSTALL_DATADIR}/doc/graze-doc)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${pages} COMPONENT doc
        PATTERN "*.sh" EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md
              ${PROJECT_SOURCE_DIR}/CONTRIBUTING.md
        DESTINATION ${pages} COMPONENT doc)

include(CPack)
