#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Component libraries made without CMake, with the flags that the deployment manual gives: shared ones that are loaded, a
# static one that an executable is linked with.
source "$(dirname "$0")/package_test.sh"
sources=$(cd "$(dirname "$0")/../unit/manual" && pwd)
cd "$work"
source "$prefix/env.sh"
export ORO_LOGFILE=/dev/null

rtt=$(pkg-config --cflags orocos-rtt-$OROCOS_TARGET) libs=$(pkg-config --libs orocos-rtt-$OROCOS_TARGET)
ocl_libs=$(pkg-config --libs ocl-deployment-$OROCOS_TARGET)
say() { "$@" > log 2>&1 || { cat log >&2; fail "$*"; }; [ ! -s log ] || { cat log >&2; fail "not silent: $*"; }; }
# shellcheck disable=SC2086  # several words each
{
  CFLAGS="-O2 -Wall -fPIC -DRTT_COMPONENT" LDFLAGS=-fPIC
  say c++ $CFLAGS $rtt -shared $LDFLAGS -o libarm.so "$sources/components/robot/arm.cpp" $libs
  for file in controller diagnostics; do say c++ $CFLAGS $rtt -c "$sources/components/robot/$file.cpp"; done
  say c++ -shared $LDFLAGS -o librobot13.so controller.o diagnostics.o $libs
  CFLAGS="-O2 -Wall" LDFLAGS=
  for file in parts main; do say c++ $CFLAGS $rtt -c "$sources/linked/$file.cpp"; done
  say ar rcs libparts.a parts.o
  say c++ $LDFLAGS -o program main.o -Wl,--whole-archive libparts.a -Wl,--no-whole-archive $ocl_libs $libs
}

cat > app.xml <<'E2'
<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE properties SYSTEM "cpf.dtd">
<properties>
  <simple name="Import" type="string"><value>./librobot13.so</value></simple>
  <struct name="arm" type="libarm.so"></struct>
  <struct name="controller" type="Robot13::Controller"></struct>
  <struct name="diagnostics" type="Robot13::Diagnostics"></struct>
</properties>
E2
timeout 60 rttscript -s app.xml > out 2>&1 || { cat out >&2; fail "deploying the shared libraries"; }

cat > parts.xml <<'E2'
<properties>
  <struct name="x" type="linked::PartX"></struct>
  <struct name="z" type="linked::PartZ"></struct>
</properties>
E2
LD_LIBRARY_PATH=$prefix/lib timeout 60 ./program parts.xml > out 2>&1 || { cat out >&2; fail "deploying the static library"; }
[ "$(tail -n 2 out)" = $'x\nz' ] || { cat out >&2; fail "the components of the static library"; }
