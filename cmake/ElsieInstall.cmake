# `cmake --install`: program, library, plugins, headers, data, the CMake package, the manual page and shell completion. None of these knows
# its prefix. `cpack` makes a Debian package of the same files, and one of the window.
include(CMakePackageConfigHelpers)

install(TARGETS elsie RUNTIME)
install(TARGETS elsie_commands LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/elsie")

# All plugins in the build folder, so that a folder dropped into plugins/ is installed, too.
foreach(plugin IN LISTS ELSIE_SHIPPED_PLUGINS)
  install(TARGETS ${plugin} LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/elsie/plugins")
endforeach()

install(DIRECTORY experiments fuzzy_models robots templates training_sets worlds DESTINATION "${CMAKE_INSTALL_DATADIR}/elsie"
        PATTERN reproduction EXCLUDE)
install(DIRECTORY docs examples DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# The pages name worlds and other data by `../worlds/`, as in the source tree: links next to docs/ lead to the installed data.
file(RELATIVE_PATH data "${CMAKE_INSTALL_FULL_DOCDIR}" "${CMAKE_INSTALL_FULL_DATADIR}/elsie")
file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/doc-links")
foreach(folder IN ITEMS experiments fuzzy_models robots training_sets worlds)
  file(CREATE_LINK "${data}/${folder}" "${CMAKE_CURRENT_BINARY_DIR}/doc-links/${folder}" SYMBOLIC)
endforeach()
install(DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/doc-links/" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES tests/recording/official_reader/read.mjs DESTINATION "${CMAKE_INSTALL_DOCDIR}/tests/recording/official_reader")

# find_package(elsie): each storey is a component with its own targets. The package knows what each needs, from the ground up.
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/elsie")
get_property(storeys GLOBAL PROPERTY ELSIE_STOREYS)
set(components)
set(needs)
foreach(storey IN LISTS storeys)
  get_target_property(component ${storey} ELSIE_COMPONENT)
  get_target_property(file ${storey} OUTPUT_NAME)
  get_target_property(links ${storey} LINK_LIBRARIES)
  list(FILTER links INCLUDE REGEX "^elsie::")
  list(TRANSFORM links REPLACE "^elsie::(.*)" "elsie_\\1")
  set(needed)
  foreach(link IN LISTS links)
    get_target_property(below ${link} ELSIE_COMPONENT)
    list(APPEND needed ${below})
  endforeach()
  list(APPEND components ${component})
  string(APPEND needs "set(_elsie_${component}_needs ${needed})\nset(_elsie_${component}_file lib${file}.so.${PROJECT_VERSION})\n")
  install(TARGETS ${storey} EXPORT elsie-${component}-targets LIBRARY)
  install(EXPORT elsie-${component}-targets NAMESPACE elsie:: DESTINATION "${package}")
endforeach()
configure_package_config_file(cmake/package/elsie-config.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/package/elsie-config.cmake"
                              INSTALL_DESTINATION "${package}" NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/package/elsie-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/package/elsie-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/package/elsie-config-version.cmake" cmake/ElsiePlugin.cmake
        DESTINATION "${package}")

# Manual page and completion, from the program's own description of its subcommands and options.
set(help "${CMAKE_CURRENT_BINARY_DIR}/help")
file(MAKE_DIRECTORY "${help}")
add_custom_command(
  OUTPUT "${help}/elsie.1" "${help}/elsie.bash" "${help}/_elsie"
  COMMAND elsie manual > "${help}/elsie.1"
  COMMAND elsie completion bash > "${help}/elsie.bash"
  COMMAND elsie completion zsh > "${help}/_elsie"
  DEPENDS elsie_complete elsie_commands
  VERBATIM)
add_custom_target(elsie_help ALL DEPENDS "${help}/elsie.1")
install(FILES "${help}/elsie.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${help}/elsie.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME elsie)
install(FILES "${help}/_elsie" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Elsie developers <elsie@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_BINARY_DIR}/lib")
# Cameras draw through EGL, in software without a graphics card.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core")
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME elsie)
set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_RECOMMENDS "g++, cmake, catch2")
# A package for each component: the window needs Qt 6, all else does not.
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL Unspecified)
if(TARGET elsie_desktop)
  list(APPEND CPACK_COMPONENTS_ALL desktop)
endif()
if(TARGET elsie_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION
    "A physics-based, fixed-step simulator in which a robot is driven by several
small behaviours that run side by side, and a coordinator that turns their
wishes into one motor command. Behaviours, coordinators and sensors are shared
libraries found at run time; this package has what is needed to write them.")
set(CPACK_COMPONENT_DESKTOP_DESCRIPTION
    "The window of Elsie: worlds are built, watched and changed while they run, and
networks are trained, with the simulation in a process of its own.")
set(CPACK_DEBIAN_DESKTOP_PACKAGE_NAME elsie-desktop)
set(CPACK_DEBIAN_DESKTOP_PACKAGE_DEPENDS "elsie (= ${PROJECT_VERSION})")
# The texts of Qt's own dialogs in other languages.
set(CPACK_DEBIAN_DESKTOP_PACKAGE_RECOMMENDS "qt6-translations-l10n")
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "Elsie from Python: worlds, simulations, results, environments for learning; and
behaviours, coordinators and other plugins that are written in Python.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-elsie)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if(TARGET elsie_python)
  # The extension fits one version of Python: that of the Debian that it was built on.
  get_property(minor GLOBAL PROPERTY ELSIE_PYTHON_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "elsie (= ${PROJECT_VERSION}), python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy, libpython3.${minor}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-pandas")
endif()
include(CPack)
