# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Sourced by the package tests: a work folder, the environment of a user, small assertions.
set -euo pipefail
prefix=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OROCOS_TARGET=gnulinux PATH=$prefix/bin:$PATH
unset RTT_COMPONENT_PATH PKG_CONFIG_PATH CMAKE_PREFIX_PATH LD_LIBRARY_PATH

fail() { echo "FAILED: $*" >&2; exit 1; }
expect_file() { [ -e "$1" ] || fail "no file $1"; }
expect_text() { grep -qF -- "$2" "$1" || { cat "$1" >&2; fail "'$2' not in $1"; }; }
build_package() { # source build install [cmake option…]
  local source=$1 build=$2 install=$3
  shift 3
  cmake -S "$source" -B "$build" -Wno-dev -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$install" "$@" > "$build.log" 2>&1 ||
    { cat "$build.log" >&2; fail "cmake $source"; }
  cmake --build "$build" --parallel 2 > "$build.log" 2>&1 || { cat "$build.log" >&2; fail "build of $source"; }
  cmake --install "$build" > "$build.log" 2>&1 || { cat "$build.log" >&2; fail "install of $source"; }
  expect_resolved "$install"
}
# Every library and program finds the libraries it is linked to, by what is written in it.
expect_resolved() { # install
  local file
  while read -r file; do
    ! ldd "$file" | grep 'not found' >&2 || fail "$file does not find all it is linked to"
  done < <(find "$1" -name '*.so' -o -path '*/bin/*' -type f)
}
# Runs the deployer until its output holds a text, then interrupts it; it has to end with status 0.
deploy_until() { # text option…
  local text=$1 status=0
  shift
  rm -f "$work/deploy.in"
  mkfifo "$work/deploy.in"  # the deployer quits at the end of its input
  rm -f "$work/deploy.out"  # the text of the last time would end this one before it can be interrupted
  (cd "$work" && exec stdbuf -oL deployer-gnulinux "$@" <> deploy.in > deploy.out 2>&1) &
  local pid=$!
  for _ in $(seq 1 1200); do  # a minute: the machine may be busy
    grep -qF -- "$text" "$work/deploy.out" 2> /dev/null && break
    kill -0 $pid 2> /dev/null || break
    sleep 0.05
  done
  kill -INT $pid 2> /dev/null || true
  wait $pid || status=$?
  [ "$status" = 0 ] || { cat "$work/deploy.out" >&2; fail "the deployer ended with status $status"; }
  expect_text "$work/deploy.out" "$text"
}
