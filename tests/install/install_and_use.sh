#!/usr/bin/env bash
# install_and_use.sh BUILD SOURCE WORK: installs the build to WORK, builds the examples on it and runs them, and looks at
# what the package shows.
set -euo pipefail
build=$1 source=$2 work=$3
rm -rf "$work"
cmake --install "$build" --prefix "$work/prefix" > /dev/null
cmake -S "$source/examples" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_BUILD_TYPE=Release ${CXX:+-DCMAKE_CXX_COMPILER="$CXX"} ${CXXFLAGS:+-DCMAKE_CXX_FLAGS="$CXXFLAGS"} \
  ${CXXFLAGS:+-DCMAKE_C_FLAGS="$CXXFLAGS"} > /dev/null
cmake --build "$work/build" > /dev/null
ran=0
for example in "$source"/examples/[0-9]*.c*; do
  lines=$(wc -l < "$example")
  [ "$lines" -le 25 ] || { echo "$example has $lines lines, more than 25" >&2; exit 1; }
  name=$(basename "${example%.*}")
  "$work/build/$name" "$source/data" > "$work/$name.txt" || { echo "$name ended with status $?" >&2; exit 1; }
  [ -s "$work/$name.txt" ] || { echo "$name printed nothing" >&2; exit 1; }
  ran=$((ran + 1))
done
[ "$ran" -eq 11 ] || { echo "$ran examples, not eleven" >&2; exit 1; }

# What docs/library.md says to a CMakeLists.txt is enough.
mkdir "$work/snippet"
{
  printf 'cmake_minimum_required(VERSION 3.16)\nproject(snippet LANGUAGES CXX)\nadd_executable(my_program "%s")\n' "$source/examples/01_two_methods.cpp"
  sed -n '/^```cmake/,/^```/{/^```/!p}' "$source/docs/library.md"
} > "$work/snippet/CMakeLists.txt"
grep -q target_link_libraries "$work/snippet/CMakeLists.txt"
cmake -S "$work/snippet" -B "$work/snippet/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" ${CXX:+-DCMAKE_CXX_COMPILER="$CXX"} > /dev/null

for file in man/man1/cromer.1 bash-completion/completions/cromer zsh/site-functions/_cromer fish/vendor_completions.d/cromer.fish; do
  [ -s "$work/prefix/share/$file" ] || { echo "share/$file is not installed" >&2; exit 1; }
done
if command -v man > /dev/null; then
  said=$(man --warnings -E UTF-8 -l "$work/prefix/share/man/man1/cromer.1" 2>&1 > /dev/null)
  [ -z "$said" ] || { echo "the manual page: $said" >&2; exit 1; }
fi

headers=$(find "$work/prefix/include" -name '*.h' | wc -l)
[ "$headers" -le 20 ] || { echo "$headers headers are installed, more than 20" >&2; exit 1; }
library=$(find "$work/prefix" -name 'libcromer.so')
nm -D --defined-only --demangle "$library" | sed 's/^[0-9a-f]* . //' > "$work/shown.txt"
if grep -vE '^cromer_|^cromer::[^(]*\(|^(vtable|typeinfo)' "$work/shown.txt" || grep 'cromer::core::' "$work/shown.txt" | grep -v '(.*cromer::core::'; then
  echo "libcromer.so shows more than the door" >&2
  exit 1
fi
for needed in cromer_call 'cromer::fit(' 'cromer::simulate(' 'cromer::read_file(' 'cromer::response_spectrum('; do
  grep -qF "$needed" "$work/shown.txt" || { echo "libcromer.so does not show $needed" >&2; exit 1; }
done
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name cromer.pc)"); export PKG_CONFIG_PATH
if command -v pkg-config > /dev/null; then pkg-config --cflags --libs cromer > /dev/null; fi
"$work/prefix/bin/cromer" --version
