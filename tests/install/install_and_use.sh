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
[ "$ran" -eq 10 ] || { echo "$ran examples, not ten" >&2; exit 1; }

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
