# taylor_add_model(TARGET SOURCES file.. DOF n|member [LAGRANGIAN f] [MODEL name] [FORCE f] [DISSIPATION f] [HOLONOMIC f[:rows]..]
#                  [NONHOLONOMIC f[:rows]..] [ARGS role=name..] [RECURSION f:depth..] [RULES f:rule..]
#                  [NEEDS need..] [SIZES member=n..] [PARAMETERS member..] [FORM registers|rows|auto] [LANES]
#                  [INCLUDE_DIRECTORIES dir..] [COMPILE_DEFINITIONS def..] [SELFTEST] [SHARED])
#
# Runs tlgen over plain C sources and makes a static library TARGET of the result. Programs that link it include <MODEL>_tl.h, which
# declares <MODEL>_model; MODEL is TARGET's name where it is not given. NEEDS says which motion functions are printed
# (energy simulate residual linearise tangent parameters; all of these, or none; taylor), SIZES for which sizes, PARAMETERS which members of the parameter
# struct are differentiated by: tlgen --help has the defaults. LANES adds functions of several states at once. LAGRANGIAN is not needed
# where the source marks the function with TLGEN(lagrangian). A change in a source or a header that it includes runs tlgen again. SELFTEST
# also makes a program TARGET_selftest, which checks every derivative of the model at points that you name; `TARGET_selftest --help` says how.
# SHARED also makes the shared object MODEL.so (target TARGET_shared) for the program eom: `eom run MODEL.so`.

function(taylor_model_error target what)
  message(FATAL_ERROR "taylor_add_model(${target}): ${what}\nFor example:\n"
    "  taylor_add_model(pendulum SOURCES pendulum.c LAGRANGIAN lagrangian DOF 2)")
endfunction()

# Refuses what a call of taylor_add_model lacks, before tlgen runs.
function(taylor_check_model target model)
  set(libraries m c dl rt pthread util gcc stdc++ taylor eom tlgen tlgen_selftest quadmath lapack lapacke blas openblas)
  if(target IN_LIST libraries)
    taylor_model_error(${target} "a target of that name would take the place of the library -l${target} wherever one links that; choose another")
  endif()
  if(TARGET ${target})
    taylor_model_error(${target} "there is a target of that name already")
  endif()
  if(NOT model MATCHES "^[A-Za-z_][A-Za-z0-9_]*$")
    taylor_model_error(${target} "'${model}' cannot be a model's name in C; add MODEL name")
  endif()
  foreach(key IN ITEMS SOURCES DOF)
    if(NOT DEFINED arg_${key})
      taylor_model_error(${target} "${key} is missing")
    endif()
  endforeach()
  set(marked FALSE)
  foreach(source IN LISTS arg_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    get_source_file_property(generated ${source} GENERATED)
    if(generated)
      set(marked TRUE) # nobody knows yet
    elseif(NOT EXISTS ${source})
      taylor_model_error(${target} "there is no source file ${source}")
    else()
      file(STRINGS ${source} marks REGEX "TLGEN")
      if(marks)
        set(marked TRUE)
      endif()
    endif()
  endforeach()
  if(NOT DEFINED arg_LAGRANGIAN AND NOT marked)
    taylor_model_error(${target} "LAGRANGIAN is missing")
  endif()
  if(arg_SELFTEST AND NOT TARGET taylor::tlgen_selftest)
    taylor_model_error(${target} "SELFTEST needs a libtaylor that was built by a compiler with __float128 and libquadmath")
  endif()
endfunction()

# Motion functions are made for vectors along rows, and for values in registers otherwise: vectors of unrelated scalars are slower, and
# Clang 19 has been seen to get them wrong in long straight-line code.
function(taylor_model_options target)
  target_compile_options(${target} PRIVATE
    $<$<C_COMPILER_ID:GNU>:-fno-math-errno;-fno-tree-slp-vectorize> $<$<C_COMPILER_ID:Clang>:-fno-math-errno;-fno-slp-vectorize>)
endfunction()

function(taylor_add_model target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SELFTEST;LANES;SHARED" "MODEL;DOF;LAGRANGIAN;FORCE;DISSIPATION;FORM"
    "NEEDS;SIZES;PARAMETERS;SOURCES;HOLONOMIC;NONHOLONOMIC;ARGS;RECURSION;RULES;INCLUDE_DIRECTORIES;COMPILE_DEFINITIONS")
  if(arg_UNPARSED_ARGUMENTS)
    list(JOIN arg_UNPARSED_ARGUMENTS " " unknown)
    taylor_model_error(${target} "unknown arguments: ${unknown}")
  endif()
  foreach(key IN ITEMS MODEL DOF LAGRANGIAN FORCE DISSIPATION FORM)
    if(key IN_LIST arg_KEYWORDS_MISSING_VALUES)
      taylor_model_error(${target} "${key} wants a value")
    endif()
  endforeach()
  if(NOT arg_MODEL)
    set(arg_MODEL ${target})
  endif()
  taylor_check_model(${target} "${arg_MODEL}")

  set(options --cmake --model ${arg_MODEL})
  foreach(key IN ITEMS DOF LAGRANGIAN FORCE DISSIPATION HOLONOMIC NONHOLONOMIC RECURSION)
    string(TOLOWER ${key} name)
    foreach(value IN LISTS arg_${key})
      list(APPEND options --${name} ${value})
    endforeach()
  endforeach()
  foreach(value IN LISTS arg_ARGS)
    list(APPEND options --arg ${value})
  endforeach()
  if(arg_FORM)
    list(APPEND options --form ${arg_FORM})
  endif()
  if(arg_LANES)
    list(APPEND options --lanes)
  endif()
  foreach(value IN LISTS arg_NEEDS)
    list(APPEND options --need ${value})
  endforeach()
  foreach(value IN LISTS arg_SIZES)
    list(APPEND options --size ${value})
  endforeach()
  foreach(value IN LISTS arg_PARAMETERS)
    list(APPEND options --parameter ${value})
  endforeach()
  foreach(value IN LISTS arg_RULES)
    list(APPEND options --rule ${value})
  endforeach()
  set(sources)
  set(source_folders)
  foreach(source IN LISTS arg_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(source_folder ${source} DIRECTORY)
    list(APPEND sources ${source})
    list(APPEND source_folders ${source_folder})
  endforeach()
  set(compiler -std=gnu11)
  foreach(dir IN LISTS arg_INCLUDE_DIRECTORIES)
    get_filename_component(dir ${dir} ABSOLUTE)
    list(APPEND compiler -I${dir})
  endforeach()
  list(APPEND compiler "-I$<JOIN:$<TARGET_PROPERTY:taylor::taylor,INTERFACE_INCLUDE_DIRECTORIES>,$<SEMICOLON>-I>")
  foreach(definition IN LISTS arg_COMPILE_DEFINITIONS)
    list(APPEND compiler -D${definition})
  endforeach()

  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}.tlgen)
  set(output ${folder}/${arg_MODEL}_tl.c)
  file(MAKE_DIRECTORY ${folder})
  set(test)
  if(arg_SELFTEST)
    list(APPEND options --selftest)
    set(part "")
    foreach(source IN LISTS sources)
      list(APPEND test ${folder}/${arg_MODEL}_selftest${part}.c)
      list(LENGTH test count)
      math(EXPR count "${count} + 1")
      set(part "_${count}")
    endforeach()
  endif()
  add_custom_command(OUTPUT ${output} ${folder}/${arg_MODEL}_tl.h ${test}
    COMMAND taylor::tlgen ${sources} ${options} -MD -o ${output} -- ${compiler}
    DEPENDS ${sources} taylor::tlgen
    DEPFILE ${output}.d
    COMMENT "tlgen ${arg_MODEL}_tl.c"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_library(${target} STATIC ${output})
  taylor_model_options(${target})
  target_include_directories(${target} PUBLIC ${folder} ${arg_INCLUDE_DIRECTORIES})
  target_link_libraries(${target} PUBLIC taylor::eom)
  if(arg_SHARED)
    # Compiled once for both. What it calls of libtaylor is in the program that loads it.
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE $<$<C_COMPILER_ID:GNU>:-fno-semantic-interposition>)
    file(CONFIGURE OUTPUT ${folder}/${arg_MODEL}_shared.c @ONLY CONTENT [[
/* What the shared object @arg_MODEL@.so exports to the program eom. */
#include "@arg_MODEL@_tl.h"
const eom_description *eom_shared_model(void) { return &@arg_MODEL@_description; }
]])
    add_library(${target}_shared MODULE ${folder}/${arg_MODEL}_shared.c $<TARGET_OBJECTS:${target}>)
    set_target_properties(${target}_shared PROPERTIES PREFIX "" OUTPUT_NAME ${arg_MODEL})
    target_include_directories(${target}_shared PRIVATE ${folder} ${arg_INCLUDE_DIRECTORIES}
      $<TARGET_PROPERTY:taylor::eom,INTERFACE_INCLUDE_DIRECTORIES> $<TARGET_PROPERTY:taylor::taylor,INTERFACE_INCLUDE_DIRECTORIES>)
    target_link_libraries(${target}_shared PRIVATE m)
  endif()
  if(arg_SELFTEST)
    add_executable(${target}_selftest ${test})
    set_target_properties(${target}_selftest PROPERTIES C_EXTENSIONS ON)
    target_include_directories(${target}_selftest PRIVATE ${source_folders})
    target_compile_definitions(${target}_selftest PRIVATE ${arg_COMPILE_DEFINITIONS})
    target_compile_options(${target}_selftest PRIVATE -w) # the user's C under other types
    target_link_libraries(${target}_selftest PRIVATE ${target} taylor::tlgen_selftest)
  endif()
endfunction()
