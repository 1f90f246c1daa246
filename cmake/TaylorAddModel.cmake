# taylor_add_model(TARGET SOURCES file.. [MODEL name] [DOF n|member] [LAGRANGIAN f] [FORCE f] [HOLONOMIC f[:rows]..]
#                  [NONHOLONOMIC f[:rows]..] [ARGS role=name..] [RECURSION f:depth..] [RULES f:rule..]
#                  [INCLUDE_DIRECTORIES dir..] [COMPILE_DEFINITIONS def..])
#
# Runs tlgen over plain C sources and makes a static library TARGET of the result. Programs that link it include <MODEL>_tl.h, which
# declares <MODEL>_model; MODEL is TARGET's name where it is not given. A change in a source or a header that it includes runs tlgen again.
function(taylor_add_model target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "MODEL;DOF;LAGRANGIAN;FORCE"
    "SOURCES;HOLONOMIC;NONHOLONOMIC;ARGS;RECURSION;RULES;INCLUDE_DIRECTORIES;COMPILE_DEFINITIONS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "taylor_add_model(${target}): unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_SOURCES)
    message(FATAL_ERROR "taylor_add_model(${target}): SOURCES is missing")
  endif()
  if(NOT arg_MODEL)
    set(arg_MODEL ${target})
  endif()

  set(options --model ${arg_MODEL})
  foreach(key IN ITEMS DOF LAGRANGIAN FORCE HOLONOMIC NONHOLONOMIC RECURSION)
    string(TOLOWER ${key} name)
    foreach(value IN LISTS arg_${key})
      list(APPEND options --${name} ${value})
    endforeach()
  endforeach()
  foreach(value IN LISTS arg_ARGS)
    list(APPEND options --arg ${value})
  endforeach()
  foreach(value IN LISTS arg_RULES)
    list(APPEND options --rule ${value})
  endforeach()
  set(sources)
  foreach(source IN LISTS arg_SOURCES)
    get_filename_component(source ${source} ABSOLUTE)
    list(APPEND sources ${source})
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
  add_custom_command(OUTPUT ${output} ${folder}/${arg_MODEL}_tl.h
    COMMAND taylor::tlgen ${sources} ${options} -MD -o ${output} -- ${compiler}
    DEPENDS ${sources} taylor::tlgen
    DEPFILE ${output}.d
    COMMENT "tlgen ${arg_MODEL}_tl.c"
    COMMAND_EXPAND_LISTS VERBATIM)
  add_library(${target} STATIC ${output})
  target_include_directories(${target} PUBLIC ${folder} ${arg_INCLUDE_DIRECTORIES})
  target_link_libraries(${target} PUBLIC taylor::eom)
endfunction()
