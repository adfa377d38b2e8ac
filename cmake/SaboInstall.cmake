# `cmake --install build/release` and, for a Debian package, `cpack --config
# build/release/CPackConfig.cmake`.
include(GNUInstallDirs)

install(TARGETS sabo RUNTIME)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md ARCHITECTURE.md CHANGELOG.md CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sabo)
set(CPACK_PACKAGE_VENDOR "sabo")
set(CPACK_PACKAGE_CONTACT "The sabo developers <developers@sabo.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# The packages of the shared libraries that the program links, with their versions, as
# dpkg-shlibdeps finds them (needs the packages dpkg-dev and file).
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)
