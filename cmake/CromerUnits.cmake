# The kernel of the ensemble, once for each instruction set; which one runs is chosen when the program does.

# -O3 whatever the build type (the sanitizers' builds apart): nothing of a unit may be left that others could share. Products and sums
# are contracted by g++ alone: clang does so for some packs of a group and not for others, and a member's numbers would depend on its
# place.
set(CROMER_UNIT_OPTIONS -O3)
if(CROMER_SANITIZE)
  set(CROMER_UNIT_OPTIONS -O1)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND CROMER_UNIT_OPTIONS -ffp-contract=fast)
  if(NOT CROMER_SANITIZE)
    # A step that is called, not inlined, keeps its numbers in memory: 1.3 to 1.8 times as long.
    list(APPEND CROMER_UNIT_OPTIONS --param=max-inline-insns-single=4000 --param=max-inline-insns-auto=4000
         --param=large-function-growth=2000 --param=large-stack-frame-growth=20000 --param=inline-unit-growth=1000)
  endif()
endif()
set(CROMER_UNIT_avx2 -mavx2 -mfma)
set(CROMER_UNIT_avx512 -mavx512f -mavx512dq -mavx512bw -mavx512cd -mavx512vl -mfma)

# cromer_units(): the options of src/cromer/ensemble/units/*.cpp; off x86-64 only the baseline is built.
function(cromer_units)
  set(folder ${PROJECT_SOURCE_DIR}/src/cromer/ensemble/units)
  set_source_files_properties(${folder}/baseline.cpp ${folder}/walk_baseline.cpp PROPERTIES COMPILE_OPTIONS "${CROMER_UNIT_OPTIONS}"
                              SKIP_PRECOMPILE_HEADERS ON)
  foreach(unit avx2 avx512)
    set(options ${CROMER_UNIT_OPTIONS} ${CROMER_UNIT_${unit}})
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      list(APPEND options -Wno-uninitialized -Wno-maybe-uninitialized)  # false alarms of g++ 12 in its own avx512fintrin.h
    endif()
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
      set_source_files_properties(${folder}/${unit}.cpp ${folder}/walk_${unit}.cpp PROPERTIES COMPILE_OPTIONS "${options}"
                                  SKIP_PRECOMPILE_HEADERS ON)
    else()
      set_source_files_properties(${folder}/${unit}.cpp ${folder}/walk_${unit}.cpp PROPERTIES HEADER_FILE_ONLY ON)
    endif()
  endforeach()
endfunction()
