# The libraries of a release: headers of Debian's packages, seen apart from everything else in /usr/include, and zlib and oneTBB
# compiled from the sources of Debian's packages, which CROMER_SOURCES holds.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(library boost CLI fast_float fmt nlohmann toml++ xsimd)
  file(CREATE_LINK /usr/include/${library} ${headers}/${library} SYMBOLIC)
endforeach()
foreach(library Eigen unsupported)
  file(CREATE_LINK /usr/include/eigen3/${library} ${headers}/${library} SYMBOLIC)
endforeach()
foreach(target fmt::fmt Eigen3::Eigen Boost::headers nlohmann_json::nlohmann_json CLI11::CLI11)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${headers})
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
# Boost 1.74 asks for std::result_of where it does not know that there is std::invoke_result.
target_compile_definitions(Boost::headers INTERFACE BOOST_ASIO_HAS_STD_INVOKE_RESULT=1)
include_directories(SYSTEM ${headers})

file(GLOB zlib ${CROMER_SOURCES}/zlib-*)
enable_language(C)
add_library(cromer_zlib STATIC)
foreach(file adler32 compress crc32 deflate infback inffast inflate inftrees trees uncompr zutil)
  target_sources(cromer_zlib PRIVATE ${zlib}/${file}.c)
endforeach()
target_include_directories(cromer_zlib SYSTEM PUBLIC ${zlib})
set_target_properties(cromer_zlib PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden UNITY_BUILD OFF)
# zlib 1.2.13 takes every macOS for the old one, which had no fdopen.
target_compile_definitions(cromer_zlib PRIVATE $<$<PLATFORM_ID:Darwin>:fdopen=fdopen>)
target_compile_options(cromer_zlib PRIVATE -w)
add_library(ZLIB::ZLIB ALIAS cromer_zlib)

file(GLOB tbb ${CROMER_SOURCES}/onetbb-*/CMakeLists.txt)
cmake_path(GET tbb PARENT_PATH tbb)
set(BUILD_SHARED_LIBS OFF)
foreach(off TBB_TEST TBB_STRICT TBBMALLOC_BUILD TBB_ENABLE_IPO TBB_INSTALL)
  set(${off} OFF CACHE BOOL "" FORCE)
endforeach()
set(TBB_DISABLE_HWLOC_AUTOMATIC_SEARCH ON CACHE BOOL "" FORCE)
add_subdirectory(${tbb} ${CMAKE_BINARY_DIR}/tbb EXCLUDE_FROM_ALL SYSTEM)
set_target_properties(tbb PROPERTIES UNITY_BUILD OFF)
target_compile_options(tbb PRIVATE -fvisibility=hidden -fvisibility-inlines-hidden -w)

find_package(Threads REQUIRED)

# toml++ asks for FLT_RADIX, which zig's <cfloat> for macOS has not.
if(APPLE)
  cmake_language(DEFER CALL target_compile_definitions cromer_study PRIVATE FLT_RADIX=__FLT_RADIX__)
endif()
