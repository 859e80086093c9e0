# Writes a .cpp that holds page assets as strings: cmake -DOUTPUT=assets.cpp "-DASSETS=a.css;b.js" -P embed.cmake
# Run by the build whenever one of them is newer than the .cpp.
set(text "// Made by pages/embed.cmake from the files beside it.\n#include \"pages/assets.h\"\n\nnamespace rt {\n\n")
string(APPEND text "std::string_view page_asset(std::string_view name) {\n")
foreach(asset IN LISTS ASSETS)
  get_filename_component(name ${asset} NAME)
  file(READ ${asset} content)
  string(APPEND text "    if (name == \"${name}\") return R\"raytrace_asset(${content})raytrace_asset\";\n")
endforeach()
string(APPEND text "    return {};\n}\n\n}  // namespace rt\n")
file(WRITE ${OUTPUT} "${text}")
