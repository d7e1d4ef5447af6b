#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# What a package may say to orocos_typegen_headers(): transports, adapters, options of the compiler from a database. Nothing
# is compiled, only generated.
source "$(dirname "$0")/package_test.sh"
package="$work/options für typegen"
mkdir -p "$package/include/options"
cat > "$package/include/options/options-types.hpp" << 'TXT'
#pragma once
namespace options {
class Angle {
public:
    double degrees() const { return degrees_; }
    void setDegrees(double value) { degrees_ = value; }
private:
    double degrees_ = 0;
};
struct Arm { Angle elbow; };
}
TXT
cat > "$package/adapters.xml" << 'TXT'
<adapters>
  <struct class="options::Angle"><member name="bend" get="degrees()" set="setDegrees(value)"/></struct>
</adapters>
TXT
say() { # arguments of the macro
  cat > "$package/CMakeLists.txt" << TXT
cmake_minimum_required(VERSION 3.16)
project(options LANGUAGES CXX)
find_package(OROCOS-RTT REQUIRED)
include(\${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_typegen_headers($*)
TXT
}
configure() { cmake -S "$package" -B "$work/b" -Wno-dev -DCMAKE_PREFIX_PATH="$prefix" "$@" > "$work/b.log" 2>&1; }
generate() { cmake --build "$work/b" --target options-typekit-generate > "$work/b.log" 2>&1 || { cat "$work/b.log"; fail "generation $1"; }; }
expect_refused() { # text, with line breaks as single blanks
  ! configure || fail "configured in spite of: $1"
  tr -s ' \n' ' ' < "$work/b.log" > "$work/b.line"
  expect_text "$work/b.line" "$1"
}
header=include/options/options-types.hpp

say -t ros $header
expect_refused "[TK068] transport 'ros' is not part of this toolchain's installation; installed: corba, mqueue, known: corba, mqueue, ros, typelib"
say --transports=mqueu $header
expect_refused "[TK003] unknown transport 'mqueu', expected 'corba', 'mqueue', 'ros' or 'typelib'; did you mean 'mqueue'?"
say -o elsewhere $header
expect_refused "'-o' is not for a package to say"
say -p nowhere $header ADAPTERS adapters.xml
configure || { cat "$work/b.log"; fail "configuring asks for the database"; }
! cmake --build "$work/b" --target options-typekit-generate > "$work/b.log" 2>&1 || fail "generated without the database"
expect_text "$work/b.log" '[TK066] no such compile database'

for generator in Ninja "Unix Makefiles"; do
  rm -rf "$work/b"
  say -t corba,mqueue $header ADAPTERS adapters.xml
  configure -G "$generator" || { cat "$work/b.log"; fail "$generator: transports that are not wanted"; }
  generate "with an adapter"
  grep -rq '"bend"' "$work/b/typekit" || fail "$generator: the adapter was not used"
  generate "again"
  ! grep Generating "$work/b.log" || fail "$generator: generated without an edit"
  sleep 0.1
  sed -i 's/"bend"/"bending"/' "$package/adapters.xml"
  generate "after an edit of the adapters"
  grep -rq '"bending"' "$work/b/typekit" || fail "$generator: an edit of the adapters had no effect"
  sed -i 's/"bending"/"bend"/' "$package/adapters.xml"
done
