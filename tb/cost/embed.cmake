# SPDX-License-Identifier: Apache-2.0
# cmake -DOUTPUT=FILE.cpp -DFUNCTION=embedded_files -DROOT=FOLDER -DFILES=a:b -P embed.cmake: the files below the folder as
# strings of C++.
string(REPLACE ":" ";" FILES "${FILES}")
set(text "")
foreach(name IN LISTS FILES)
  file(READ ${ROOT}/${name} content)
  # Compilers take strings of 64 KiB at least; adjacent ones are one.
  string(LENGTH "${content}" left)
  set(strings "")
  set(first 0)
  while(first LESS left)
    string(SUBSTRING "${content}" ${first} 16000 part)
    string(APPEND strings " R\"=====(${part})=====\"")
    math(EXPR first "${first} + 16000")
  endwhile()
  # With sv no compiler has to count the characters.
  string(APPEND text "      {\"${name}\", ${strings}sv},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by CMake; do not edit.
#include \"tb/cost/measured.h\"

namespace blysk::cost {

std::span<const measured_file> ${FUNCTION}() {
  using namespace std::string_view_literals;
  static constexpr measured_file kFiles[] = {
      {\"\", \"\"sv},
${text}  };
  return std::span(kFiles).subspan(1);
}

}  // namespace blysk::cost
")
