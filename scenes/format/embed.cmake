# Writes text files into a C++ source.  One file becomes `const char* const VARIABLE`; the scenes of
# the gallery (INPUTS) and their MESHES become the lists of gallery_scenes.h.
function(quoted FILE RESULT)
  file(READ ${FILE} text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "\n" "\\n\"\n\"" text "${text}")
  set(${RESULT} "\"${text}\"" PARENT_SCOPE)
endfunction()

# Text files as the entries of a list: what each is called, and its text.
function(listed FILES NAME RESULT)
  set(entries "")
  foreach(file IN LISTS FILES)
    if(NAME STREQUAL "scene")
      get_filename_component(name ${file} NAME_WE)
    else()
      get_filename_component(name ${file} NAME)
      set(name meshes/${name})
    endif()
    quoted(${file} text)
    string(APPEND entries "  {\"${name}\",\n${text}},\n")
  endforeach()
  set(${RESULT} "${entries}" PARENT_SCOPE)
endfunction()

if(VARIABLE STREQUAL "gallery_scenes")
  listed("${INPUTS}" scene scenes)
  listed("${MESHES}" mesh meshes)
  file(WRITE ${OUTPUT} "#include <iterator>\n\n#include \"scenes/gallery_scenes.h\"\n\nnamespace wander {\n"
    "const GalleryScene gallery_scenes[] = {\n${scenes}};\n"
    "const std::size_t gallery_scene_count = std::size(gallery_scenes);\n"
    "const GalleryMesh gallery_meshes[] = {\n${meshes}};\n"
    "const std::size_t gallery_mesh_count = std::size(gallery_meshes);\n}\n")
else()
  quoted(${INPUTS} text)
  file(WRITE ${OUTPUT} "namespace wander {\nextern const char* const ${VARIABLE};\n"
    "const char* const ${VARIABLE} =\n${text};\n}\n")
endif()
