# Packages for Debian: `cpack -G DEB` in the build. Each component is a package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Frond authors")
set(CPACK_PACKAGE_CONTACT "The Frond authors <authors@frond.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL frond library development studio)
if(TARGET frond_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
# The same bytes whenever it is built from the same commit.
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)

set(CPACK_DEBIAN_FROND_PACKAGE_NAME frond)
set(CPACK_DEBIAN_FROND_PACKAGE_DEPENDS "povray, ffmpeg, ninja-build")
set(CPACK_DEBIAN_FROND_PACKAGE_RECOMMENDS xdg-utils)
set(CPACK_DEBIAN_FROND_DESCRIPTION "grows plants and corals and films them with POV-Ray
A person edits a JSON preset, calls one command and gets an animation: a reef
that grows and sways, a forest whose trees fight for light, ivy that creeps
over any mesh. Scenes are also exported as OBJ, PLY, glTF and OpenVDB.")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libfrond${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "frond (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "grows plants and corals, as a shared library
The library that programs are linked to which grow plants with Frond.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfrond-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfrond${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "grows plants and corals, for programs in C++
Presets are read and changed, grown, exported and rendered: one header, and
what find_package(Frond) of CMake needs.")

set(CPACK_DEBIAN_STUDIO_PACKAGE_NAME frond-studio)
set(CPACK_DEBIAN_STUDIO_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_STUDIO_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_STUDIO_PACKAGE_DEPENDS "frond (>= ${PROJECT_VERSION}), xdg-utils")
set(CPACK_DEBIAN_STUDIO_DESCRIPTION "plants and corals with sliders and a live view
Puts the studio of Frond into the menu of the desktop: a page in the browser
on which presets are edited while they grow.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-frond)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "frond (>= ${PROJECT_VERSION}), python3 (>= 3.11), python3-numpy")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "grows plants and corals, as a module for Python
Presets, grammars, grown scenes as arrays of numpy, exports and renders.")
include(CPack)
