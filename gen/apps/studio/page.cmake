# Writes a source that holds the files of the page, as far as it was built. Sets page_source.
set(page_dist ${CMAKE_CURRENT_LIST_DIR}/page/dist)
file(GLOB_RECURSE page_dist_files CONFIGURE_DEPENDS ${page_dist}/*)
set(page_source ${CMAKE_CURRENT_BINARY_DIR}/page_files.cpp)
set(types html "text/html; charset=utf-8" js "text/javascript" css "text/css" svg "image/svg+xml" png "image/png" ico "image/x-icon" woff2 "font/woff2")
set(bytes) # declarations
set(rows)
set(number 0)
foreach(file ${page_dist_files})
  file(RELATIVE_PATH path ${page_dist} ${file})
  cmake_path(GET file EXTENSION LAST_ONLY extension)
  string(SUBSTRING "${extension}" 1 -1 extension)
  list(FIND types "${extension}" at)
  set(type application/octet-stream)
  if(NOT at EQUAL -1)
    math(EXPR at "${at} + 1")
    list(GET types ${at} type)
  endif()
  string(APPEND bytes "asm(\".section .rodata\\n.global frond_page_${number}\\nfrond_page_${number}:\\n.incbin \\\"${file}\\\"\\n\"\n"
    "    \".global frond_page_${number}_end\\nfrond_page_${number}_end:\\n.byte 0\\n.previous\\n\");\n"
    "extern \"C\" const char frond_page_${number}[], frond_page_${number}_end[];\n")
  string(APPEND rows "      {\"/${path}\", \"${type}\", {frond_page_${number}, static_cast<std::size_t>(frond_page_${number}_end - frond_page_${number})}},\n")
  math(EXPR number "${number} + 1")
endforeach()
if(rows)
  set(body "  static const std::vector<PageFile> files{\n${rows}  };\n  return files;")
else()
  set(body "  return {};")
endif()
file(CONFIGURE OUTPUT ${page_source} @ONLY CONTENT [[
#include "studio/page.h"

#include <vector>

@bytes@
namespace frond {

std::span<const PageFile> page_files() {
@body@
}

}  // namespace frond
]])
# Apart from the others, so that it is compiled anew when the page is.
set_source_files_properties(${page_source} PROPERTIES OBJECT_DEPENDS "${page_dist_files}" SKIP_UNITY_BUILD_INCLUSION ON)
