# cmake -D OUTPUT=FILE -D HEADER=FILE -D "TEXTS=kName=FILE;…" -P EmbedTexts.cmake: a source with each file's text as the
# std::string_view that HEADER declares. As numbers, for
# compilers need not take literals longer than 65,536 bytes.
set(source "// Made by cmake/EmbedTexts.cmake; change the files that it names.\n#include \"${HEADER}\"\n\nnamespace boxreel\n{\n")
foreach(text IN LISTS TEXTS)
  string(REPLACE "=" ";" text "${text}")
  list(GET text 0 name)
  list(GET text 1 file)
  file(READ "${file}" hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "(................................................................................)" "\\1\n" bytes "${bytes}")
  string(APPEND source "\n// ${size} bytes\nstatic const unsigned char ${name}Bytes[] = {\n${bytes}};\n"
    "const std::string_view ${name}{reinterpret_cast<const char*>(${name}Bytes), sizeof ${name}Bytes};\n")
endforeach()
file(WRITE "${OUTPUT}" "${source}\n} // namespace boxreel\n")
