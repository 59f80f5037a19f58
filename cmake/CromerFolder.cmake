# One library target per folder of src/cromer, so that a folder cannot link what it may not see.

set(CROMER_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND CROMER_WARNINGS -Wno-restrict)  # false alarms of g++ 12 on "text" + std::string (GCC bug 105651)
endif()
if(CROMER_WERROR)
  list(APPEND CROMER_WARNINGS -Werror)
endif()

# What every unit of ours is compiled with: the same result to the last bit wherever it runs.
add_library(cromer_flags INTERFACE)
target_compile_options(cromer_flags INTERFACE -ffp-contract=off ${CROMER_WARNINGS})
if(CROMER_SANITIZE)
  target_compile_options(cromer_flags INTERFACE -fsanitize=${CROMER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(cromer_flags INTERFACE -fsanitize=${CROMER_SANITIZE})
endif()

set_property(GLOBAL PROPERTY CROMER_FOLDERS "")

# cromer_folder(<folder> DEPENDS <folders> LIBRARIES <targets>): the library cromer_<folder>, header-only where it has no sources.
function(cromer_folder folder)
  cmake_parse_arguments(ARG "" "" "DEPENDS;LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  set(root ${PROJECT_SOURCE_DIR}/src/cromer/${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/*.cpp)
  if(folder STREQUAL study)
    list(FILTER sources EXCLUDE REGEX "/study/task/")
  elseif(folder STREQUAL record)
    list(FILTER sources EXCLUDE REGEX "/record/live/")
  endif()
  list(FILTER sources EXCLUDE REGEX "/modules/")
  if(sources)
    add_library(cromer_${name} STATIC ${sources})
    set(visibility PUBLIC)
    target_compile_features(cromer_${name} PUBLIC cxx_std_20)
    set_target_properties(cromer_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(cromer_${name} PRIVATE $<BUILD_INTERFACE:cromer_flags> ${ARG_LIBRARIES})
  else()
    add_library(cromer_${name} INTERFACE)
    set(visibility INTERFACE)
    target_compile_features(cromer_${name} INTERFACE cxx_std_20)
    target_link_libraries(cromer_${name} INTERFACE ${ARG_LIBRARIES})
  endif()
  # Users instantiate the headers: they round as the library does.
  target_compile_options(cromer_${name} ${visibility} $<INSTALL_INTERFACE:-ffp-contract=off>)
  target_include_directories(cromer_${name} ${visibility} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                          $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  foreach(seen IN LISTS ARG_DEPENDS)
    string(REPLACE "/" "_" seen_name ${seen})
    target_link_libraries(cromer_${name} ${visibility} cromer_${seen_name})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY CROMER_FOLDERS cromer_${name})
endfunction()

# All folders together: cromer::cromer, installed with its headers and package files.
macro(cromer_library)
  get_property(folders GLOBAL PROPERTY CROMER_FOLDERS)
  add_library(cromer_cromer INTERFACE)
  target_link_libraries(cromer_cromer INTERFACE ${folders})
  set_target_properties(cromer_cromer PROPERTIES EXPORT_NAME cromer)
  add_library(cromer::cromer ALIAS cromer_cromer)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/version.h.in ${PROJECT_BINARY_DIR}/generated/cromer/version.h @ONLY)
  target_include_directories(cromer_cromer INTERFACE $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>)

  include(CMakePackageConfigHelpers)
  install(TARGETS cromer_cromer ${folders} EXPORT cromer)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/cromer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h"
          PATTERN "json/json.h" EXCLUDE PATTERN "json/recording.h" EXCLUDE PATTERN "toml_reader.h" EXCLUDE)
  install(FILES ${PROJECT_BINARY_DIR}/generated/cromer/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cromer)
  install(EXPORT cromer NAMESPACE cromer:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/cromer FILE cromer-targets.cmake)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/cromer-config.cmake.in ${PROJECT_BINARY_DIR}/cromer-config.cmake
                                INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/cromer)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/cromer-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/cromer-config.cmake ${PROJECT_BINARY_DIR}/cromer-config-version.cmake
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/cromer)
endmacro()
