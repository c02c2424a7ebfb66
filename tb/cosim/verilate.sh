#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# verilate.sh FOLDER CLASS TOP SOURCE [ARGUMENT]...: FOLDER/CLASS.h and FOLDER/all.cpp, the class that Verilator makes of
# module TOP. SOURCE is a Verilog file, or a folder whose *.v are read. ARGUMENTs are Verilator's. Verilator and its
# messages take a blank in a path for its end: links in FOLDER have none.
set -euo pipefail
folder=$1 class=$2 top=$3 source=$(readlink -f "$4")
mkdir -p "$folder"
cd "$folder"
rm -rf made rtl
mkdir made
if [ -d "$source" ]; then
  ln -s "$source" rtl
else
  mkdir rtl
  ln -s "$source" rtl
fi
"${VERILATOR:-verilator}" --cc -O3 --x-assign fast --x-initial fast --prefix "$class" --Mdir made --top-module "$top" \
  "${@:5}" rtl/*.v
LC_ALL=C # the order of the files
rm -f ./"$class"*.h
# What runs once, when a class is made and settles for the first time, is as long as the rest: it is not optimised. Of a large
# memory Verilator makes trees of conditions: g++ -O3 works at them five to ten times as long as -O1, and what it makes is no
# faster; FRE is a quarter of the rest. Small classes are a tenth to a fifth slower with -O1.
once=() often=()
for file in made/*.cpp; do
  case $file in
    *__Slow.cpp | *__Syms.cpp) once+=("$file") ;;
    *) often+=("$file") ;;
  esac
done
levels=()
if [ "$(cat "${often[@]}" | wc -c)" -gt 500000 ]; then levels=('"O1"' '"no-tree-fre"'); fi
{
  printf '#pragma GCC push_options\n'
  if [ ${#levels[@]} -gt 0 ]; then (IFS=, && printf '#pragma GCC optimize(%s)\n' "${levels[*]}"); fi
  cat "${often[@]}"
  printf '#pragma GCC pop_options\n#pragma GCC push_options\n#pragma GCC optimize("O0")\n'
  cat "${once[@]}"
  printf '#pragma GCC pop_options\n'
} >all.cpp
mv made/*.h .
rm -r made rtl
