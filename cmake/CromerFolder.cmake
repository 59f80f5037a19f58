# One library target per folder of src/cromer, so that a folder cannot link what it may not see.

set(CROMER_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # False alarms of g++ 12 on "text" + std::string (GCC bug 105651).
  list(APPEND CROMER_WARNINGS -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
if(CMAKE_UNITY_BUILD)
  # Several files in one unit: a local name may be that of another file's constant. The presets dev and clang look at each by itself.
  list(REMOVE_ITEM CROMER_WARNINGS -Wshadow)
endif()
if(CROMER_WERROR)
  list(APPEND CROMER_WARNINGS -Werror)
endif()

# What every unit of ours is compiled with: the same result to the last bit wherever it runs.
add_library(cromer_flags INTERFACE)
target_compile_options(cromer_flags INTERFACE -ffp-contract=off ${CROMER_WARNINGS})
if(CROMER_SANITIZE)
  # Null pointers stop the address sanitizer too, and nothing casts bytes to numbers: to look at each access for both would take a
  # third of the time.
  target_compile_options(cromer_flags INTERFACE -fsanitize=${CROMER_SANITIZE} -fno-sanitize=null,alignment -fno-omit-frame-pointer
                         -fno-sanitize-recover=all)
  target_compile_definitions(cromer_flags INTERFACE CROMER_SANITIZED)
  target_link_options(cromer_flags INTERFACE -fsanitize=${CROMER_SANITIZE})
endif()

# Headers of others that most files include: read once, not by each file again. The preset clang does without, and so sees
# which file includes less than it uses.
set(CROMER_COMMON_HEADERS <algorithm> <array> <cmath> <complex> <cstddef> <filesystem> <fstream> <functional> <limits> <map> <memory> <numbers>
    <optional> <set> <span> <sstream> <string> <string_view> <tuple> <utility> <variant> <vector>)

# cromer_objects(<target>): compiled as all that lies in libcromer, with the precompiled headers of cromer_base.
function(cromer_objects target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_compile_definitions(${target} PRIVATE CROMER_BUILDING $<TARGET_PROPERTY:fmt::fmt,INTERFACE_COMPILE_DEFINITIONS>)
  if(target STREQUAL cromer_base)
    target_precompile_headers(${target} PRIVATE ${CROMER_COMMON_HEADERS} <fmt/format.h>)
  else()
    target_precompile_headers(${target} REUSE_FROM cromer_base)
  endif()
endfunction()

set_property(GLOBAL PROPERTY CROMER_FOLDERS "")

# cromer_folder(<folder> [EXCEPT <room>] DEPENDS <folders> LIBRARIES <targets>): the library cromer_<folder>, header-only where it has
# no sources; without a room that is a library of its own.
function(cromer_folder folder)
  cmake_parse_arguments(ARG "" "EXCEPT" "DEPENDS;LIBRARIES" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  set(root ${PROJECT_SOURCE_DIR}/src/cromer/${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${root}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/modules/")
  if(WIN32)
    list(FILTER sources EXCLUDE REGEX "/posix/")
  else()
    list(FILTER sources EXCLUDE REGEX "/windows/")
  endif()
  if(ARG_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "/${folder}/${ARG_EXCEPT}/")
  endif()
  if(sources)
    add_library(cromer_${name} STATIC ${sources})
    set(visibility PUBLIC)
    target_compile_features(cromer_${name} PUBLIC cxx_std_20)
    cromer_objects(cromer_${name})
    target_link_libraries(cromer_${name} PRIVATE $<BUILD_INTERFACE:cromer_flags> ${ARG_LIBRARIES})
  else()
    add_library(cromer_${name} INTERFACE)
    set(visibility INTERFACE)
    target_compile_features(cromer_${name} INTERFACE cxx_std_20)
    target_link_libraries(cromer_${name} INTERFACE ${ARG_LIBRARIES})
  endif()
  target_include_directories(cromer_${name} ${visibility} ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include
                             ${PROJECT_BINARY_DIR}/generated)
  foreach(seen IN LISTS ARG_DEPENDS)
    string(REPLACE "/" "_" seen_name ${seen})
    target_link_libraries(cromer_${name} ${visibility} cromer_${seen_name})
  endforeach()
  set_property(GLOBAL APPEND PROPERTY CROMER_FOLDERS cromer_${name})
endfunction()

# What users get: cromer::cromer, one shared library that shows the door (include/cromer) alone, and cromer::static, the same to be
# linked in. Programs of this house link the folders themselves, as cromer_house.
function(cromer_library)
  get_property(folders GLOBAL PROPERTY CROMER_FOLDERS)
  add_library(cromer_house INTERFACE)
  set(rooms ${folders})
  list(REMOVE_ITEM rooms cromer_door)  # for strangers: the program does not wait for it
  target_link_libraries(cromer_house INTERFACE ${rooms})

  set(objects)
  foreach(folder IN LISTS folders)
    get_target_property(type ${folder} TYPE)
    if(type STREQUAL STATIC_LIBRARY)
      list(APPEND objects $<TARGET_OBJECTS:${folder}>)
    endif()
  endforeach()
  foreach(kind SHARED STATIC)
    string(TOLOWER ${kind} name)
    add_library(cromer_${name} ${kind} ${objects})
    set_target_properties(cromer_${name} PROPERTIES OUTPUT_NAME cromer LINKER_LANGUAGE CXX)
    target_compile_features(cromer_${name} INTERFACE cxx_std_20)
    target_include_directories(cromer_${name} INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(cromer_${name} PRIVATE $<BUILD_INTERFACE:cromer_flags> fmt::fmt ZLIB::ZLIB TBB::tbb Threads::Threads ${CMAKE_DL_LIBS} ${CROMER_SYSTEM_LIBRARIES})
  endforeach()
  set(shown ${PROJECT_SOURCE_DIR}/cmake/shown_symbols)
  set_target_properties(cromer_shared PROPERTIES EXPORT_NAME cromer VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
                        LINK_DEPENDS ${shown})
  if(NOT WIN32 AND NOT APPLE)
    target_link_options(cromer_shared PRIVATE -Wl,--version-script=${shown})
  endif()
  set_target_properties(cromer_static PROPERTIES EXPORT_NAME static)

  if(CROMER_LIBRARIES)
    return()  # a release carries the library alone
  endif()
  include(CMakePackageConfigHelpers)
  install(TARGETS cromer_shared cromer_static EXPORT cromer)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/cromer DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(FILES ${PROJECT_BINARY_DIR}/generated/cromer/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cromer)
  install(EXPORT cromer NAMESPACE cromer:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/cromer FILE cromer-targets.cmake)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/cromer-config.cmake.in ${PROJECT_BINARY_DIR}/cromer-config.cmake
                                INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/cromer)
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/cromer-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/cromer-config.cmake ${PROJECT_BINARY_DIR}/cromer-config-version.cmake
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/cromer)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/cromer.pc.in ${PROJECT_BINARY_DIR}/cromer.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/cromer.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
