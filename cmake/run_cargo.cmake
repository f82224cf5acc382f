# Runs cargo, asks it where the libraries are, and copies them. Where they are depends on what the user has set:
# CARGO_BUILD_TARGET, `build.target` in one of cargo's configuration files, and others.
#
# Variables: cargo, target_dir, target (a triple or empty), linker (for that target; may be undefined), copies (a
# list of name=path: the file's name where cargo puts it, and the copy), place (a file that gets the folder's name).

set(target_option "")
if(target)
    set(target_option --target "${target}")
    string(TOUPPER "CARGO_TARGET_${target}_LINKER" linker_variable)
    string(REPLACE "-" "_" linker_variable "${linker_variable}")
    if(linker AND NOT DEFINED ENV{${linker_variable}})
        set(ENV{${linker_variable}} "${linker}")
    endif()
endif()

execute_process(
    COMMAND "${cargo}" build --release --locked --target-dir "${target_dir}" ${target_option}
        --message-format=json-render-diagnostics
    OUTPUT_VARIABLE messages
    COMMAND_ERROR_IS_FATAL ANY)

# One message a line; those of artefacts list their files.
set(built "")
while(messages MATCHES "\n")
    string(FIND "${messages}" "\n" end)
    string(SUBSTRING "${messages}" 0 ${end} message)
    math(EXPR end "${end} + 1")
    string(SUBSTRING "${messages}" ${end} -1 messages)
    if(NOT message MATCHES "\"staticlib\"")
        continue()
    endif()
    string(JSON count LENGTH "${message}" filenames)
    foreach(i RANGE 1 ${count})
        math(EXPR i "${i} - 1")
        string(JSON file GET "${message}" filenames ${i})
        list(APPEND built "${file}")
    endforeach()
endwhile()

foreach(copy IN LISTS copies)
    string(REGEX MATCH "^([^=]*)=(.*)$" copy "${copy}")
    set(name "${CMAKE_MATCH_1}")
    set(destination "${CMAKE_MATCH_2}")
    set(found "")
    foreach(file IN LISTS built)
        cmake_path(GET file FILENAME file_name)
        if(file_name STREQUAL name)
            list(APPEND found "${file}")
        endif()
    endforeach()
    list(LENGTH found count)
    if(NOT count EQUAL 1)
        message(FATAL_ERROR "cargo built ${count} files called ${name}, and one is needed: ${found}\n"
            "It built: ${built}\n"
            "PELLICLE_CARGO_TARGET names the target, which must be the C compiler's platform.")
    endif()
    execute_process(COMMAND "${CMAKE_COMMAND}" -E copy_if_different "${found}" "${destination}"
        COMMAND_ERROR_IS_FATAL ANY)
    cmake_path(GET found PARENT_PATH folder)
endforeach()
file(WRITE "${place}" "${folder}")
