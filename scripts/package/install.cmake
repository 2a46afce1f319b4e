# Where everything goes that is built: `cmake --install`, and `cpack -G DEB` with a package a component.
include(CMakePackageConfigHelpers)
set(doc ${CMAKE_INSTALL_DATADIR}/doc)
set(share ${CMAKE_INSTALL_DATADIR}/frond)

# The program and what it reads.
install(TARGETS frond RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT frond)
install(DIRECTORY presets povinc templates DESTINATION ${share} COMPONENT frond)
install(FILES scripts/povray.ini DESTINATION ${share}/scripts COMPONENT frond)
install(PROGRAMS scripts/farm_task.sh DESTINATION ${share}/scripts COMPONENT frond)

# The page of `frond try`, where it was built (scripts/setup.sh --try).
install(DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/try/page/ DESTINATION ${share}/try COMPONENT frond OPTIONAL)

# What the program says of itself, for man and for shells.
set(told ${CMAKE_CURRENT_BINARY_DIR}/told)
file(MAKE_DIRECTORY ${told})
add_custom_command(OUTPUT ${told}/frond.1.gz ${told}/frond ${told}/_frond ${told}/frond.fish ${told}/changelog.gz
  COMMAND frond man | gzip -9n >${told}/frond.1.gz
  COMMAND frond completion bash >${told}/frond
  COMMAND frond completion zsh >${told}/_frond
  COMMAND frond completion fish >${told}/frond.fish
  COMMAND gzip -9nc ${CMAKE_CURRENT_LIST_DIR}/changelog >${told}/changelog.gz
  DEPENDS frond ${CMAKE_CURRENT_LIST_DIR}/changelog)
add_custom_target(told ALL DEPENDS ${told}/frond.1.gz)
# All that is packaged.
add_custom_target(packaged DEPENDS told frond_library $<TARGET_NAME_IF_EXISTS:frond_python>)
install(FILES ${told}/frond.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT frond)
install(FILES ${told}/frond DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT frond)
install(FILES ${told}/_frond DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT frond)
install(FILES ${told}/frond.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT frond)

# The library.
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Frond)
install(TARGETS frond_library EXPORT FrondTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
  NAMELINK_COMPONENT development)
install(FILES gen/api/frond/frond.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/frond COMPONENT development)
install(EXPORT FrondTargets NAMESPACE Frond:: FILE FrondConfig.cmake DESTINATION ${package} COMPONENT development)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/FrondConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/FrondConfigVersion.cmake DESTINATION ${package} COMPONENT development)

# The studio, which is in the program, in the menu of a desktop.
install(FILES scripts/package/frond-studio.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT studio)
install(FILES scripts/package/frond.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps COMPONENT studio)

# The module for Python.
if(TARGET frond_python)
  install(TARGETS frond_python LIBRARY DESTINATION lib/python3/dist-packages/frond COMPONENT python)
  install(DIRECTORY gen/apps/python/frond DESTINATION lib/python3/dist-packages COMPONENT python
    PATTERN __pycache__ EXCLUDE)
endif()

install(FILES scripts/package/overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME frond COMPONENT frond)
foreach(component_package frond=frond library=libfrond0 development=libfrond-dev studio=frond-studio python=python3-frond)
  string(REPLACE "=" ";" pair ${component_package})
  list(GET pair 0 component)
  list(GET pair 1 name)
  install(FILES scripts/package/copyright ${told}/changelog.gz DESTINATION ${doc}/${name} COMPONENT ${component})
endforeach()
include(scripts/package/cpack.cmake)
