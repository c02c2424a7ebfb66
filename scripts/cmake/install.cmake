# SPDX-License-Identifier: Apache-2.0
# What is installed, and the package made of it. `cmake --install build --prefix DIR`; `cpack --config build/CPackConfig.cmake`
# writes a .deb. To uninstall: xargs rm < build/install_manifest.txt, or apt remove blysk.
include(CMakePackageConfigHelpers)

install(TARGETS blysk RUNTIME)
install(TARGETS blysk_golden blysk_rtl EXPORT blysk ARCHIVE)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/blysk)
install(EXPORT blysk NAMESPACE blysk:: FILE blyskTargets.cmake DESTINATION ${package})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/blyskConfig.cmake.in ${PROJECT_BINARY_DIR}/blyskConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/blyskConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/blyskConfig.cmake ${PROJECT_BINARY_DIR}/blyskConfigVersion.cmake DESTINATION ${package})

# Headers lie below a folder of the project's own: "rtl_sysc/..." and "tb/golden/..." there.
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/blysk)
install(DIRECTORY rtl_sysc DESTINATION ${headers} FILES_MATCHING PATTERN *.h)
install(DIRECTORY tb/golden DESTINATION ${headers}/tb FILES_MATCHING PATTERN *.h PATTERN test EXCLUDE
        PATTERN bench EXCLUDE PATTERN mutations EXCLUDE)

install(DIRECTORY rtl_verilog vcd DESTINATION ${CMAKE_INSTALL_DATADIR}/blysk PATTERN *.vcd EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# The man page and the completion are made from the program's own help.
set(made ${PROJECT_BINARY_DIR}/made)
add_custom_command(OUTPUT ${made}/blysk.1 ${made}/blysk.bash
                   COMMAND ${PROJECT_SOURCE_DIR}/scripts/describe-program $<TARGET_FILE:blysk> ${made}
                   DEPENDS blysk ${PROJECT_SOURCE_DIR}/scripts/describe-program VERBATIM)
add_custom_target(described ALL DEPENDS ${made}/blysk.1 ${made}/blysk.bash)
install(FILES ${made}/blysk.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${made}/blysk.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME blysk)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "blysk")
set(CPACK_PACKAGE_VENDOR "blysk")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION electronics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gtkwave, iverilog, verilator, yosys, libboost-dev")
include(CPack)
