# taylor_warnings(TARGET): the project's warnings and, where asked, sanitizers.
function(taylor_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow
    $<$<COMPILE_LANGUAGE:C>:-Wconversion -Wdouble-promotion -Wstrict-prototypes -Wvla>
    $<$<COMPILE_LANG_AND_ID:CXX,Clang>:-Wno-deprecated-declarations>) # what libstdc++ 12's own stable_sort calls
  if(TAYLOR_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  taylor_sanitize(${target})
endfunction()

# taylor_sanitize(TARGET..): sanitizers where asked, without warnings: for code of users.
function(taylor_sanitize)
  if(NOT TAYLOR_SANITIZE)
    return()
  endif()
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endforeach()
endfunction()
