# Installs the libraries, their headers, the program, and the files by which find_package(enfilade) finds them.
include(CMakePackageConfigHelpers)

set(installed enfilade_options)
foreach(folder IN LISTS folders)
  if(TARGET enfilade_${folder})
    list(APPEND installed enfilade_${folder})
    set_target_properties(enfilade_${folder} PROPERTIES EXPORT_NAME ${folder})
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/enfilade
      FILES_MATCHING PATTERN "*.h")
  endif()
endforeach()
list(APPEND installed enfilade_cuda)  # its users enable CUDA, where the package was built with it
set_target_properties(enfilade_cuda PROPERTIES EXPORT_NAME cuda)
set_target_properties(enfilade_options PROPERTIES EXPORT_NAME options)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/base DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/enfilade FILES_MATCHING PATTERN "*.h")
install(TARGETS ${installed} EXPORT enfilade
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TARGET enfilade)
  install(TARGETS enfilade RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

# Static libraries hand on what they link: whoever links ours needs these packages as well.
set(ENFILADE_DEPENDENCIES "")
get_property(found GLOBAL PROPERTY PACKAGES_FOUND)
foreach(package IN ITEMS Threads CGAL OpenMesh TBB PNG JPEG OpenEXR embree assimp pugixml glm nlohmann_json hwy)
  if(package IN_LIST found)
    if(package MATCHES "^(OpenMesh|OpenEXR)$")
      string(APPEND ENFILADE_DEPENDENCIES "find_dependency(${package} CONFIG)\n")  # OpenMesh: after CGAL the plain call fails
    else()
      string(APPEND ENFILADE_DEPENDENCIES "find_dependency(${package})\n")
    endif()
  endif()
endforeach()
# Where CMake's own files of a package ask for more than the library, it comes by pkg-config.
if(libzip_FOUND)
  string(APPEND ENFILADE_DEPENDENCIES "find_dependency(PkgConfig)\n"
    "pkg_check_modules(libzip REQUIRED QUIET IMPORTED_TARGET libzip)\n"
    "pkg_check_modules(dxflib REQUIRED QUIET IMPORTED_TARGET dxflib)\n")
endif()

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/enfilade)
install(EXPORT enfilade NAMESPACE enfilade:: FILE enfiladeTargets.cmake DESTINATION ${config_folder})
configure_package_config_file(cmake/enfiladeConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/enfiladeConfig.cmake
  INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/enfiladeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/enfiladeConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/enfiladeConfigVersion.cmake
  DESTINATION ${config_folder})
