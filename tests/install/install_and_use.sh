#!/usr/bin/env bash
# install_and_use.sh BUILD SOURCE WORK: installs the build to WORK, builds the outside program on it, runs it.
set -euo pipefail
build=$1 source=$2 work=$3
rm -rf "$work"
cmake --install "$build" --prefix "$work/prefix" > /dev/null
cmake -S "$source/tests/install/outside" -B "$work/build" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" \
  -DCMAKE_BUILD_TYPE=Release ${CXX:+-DCMAKE_CXX_COMPILER="$CXX"} ${CXXFLAGS:+-DCMAKE_CXX_FLAGS="$CXXFLAGS"} > /dev/null
cmake --build "$work/build" > /dev/null
"$work/build/outside"
"$work/prefix/bin/cromer" --version
