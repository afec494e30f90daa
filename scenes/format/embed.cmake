# Writes text files into a C++ source.  One file becomes `const char* const VARIABLE`; a list of
# files becomes `const GalleryScene VARIABLE[]` with its count, named after the files.
function(quoted FILE RESULT)
  file(READ ${FILE} text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\n" "\\n\"\n\"" text "${text}")
  set(${RESULT} "\"${text}\"" PARENT_SCOPE)
endfunction()

if(VARIABLE STREQUAL "gallery_scenes")
  set(entries "")
  set(count 0)
  foreach(input IN LISTS INPUTS)
    get_filename_component(name ${input} NAME_WE)
    quoted(${input} text)
    string(APPEND entries "  {\"${name}\",\n${text}},\n")
    math(EXPR count "${count} + 1")
  endforeach()
  file(WRITE ${OUTPUT} "#include \"scenes/gallery_scenes.h\"\n\nnamespace wander {\n"
    "const GalleryScene gallery_scenes[] = {\n${entries}};\n"
    "const std::size_t gallery_scene_count = ${count};\n}\n")
else()
  quoted(${INPUTS} text)
  file(WRITE ${OUTPUT} "namespace wander {\nextern const char* const ${VARIABLE};\n"
    "const char* const ${VARIABLE} =\n${text};\n}\n")
endif()
