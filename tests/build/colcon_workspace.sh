#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Where colcon is installed: it builds what orocreate-pkg scaffolds, and in a shell that has read the workspace's setup file the
# deployer finds the packages, installed each into a folder of its own or all into one.
source "$(dirname "$0")/package_test.sh"
colcon build --help > /dev/null 2>&1 || { echo "there is no colcon"; exit 77; }
mkdir "$work/src"
cd "$work/src"
orocreate-pkg arm component
orocreate-pkg hand plugin
cd ..
for option in "" --merge-install; do
  rm -rf build install
  colcon build $option --cmake-args -DCMAKE_PREFIX_PATH="$prefix" -DBUILD_TESTING=OFF > colcon.log 2>&1 || { cat colcon.log; fail "colcon build $option"; }
  for shell in bash sh; do
    printf '%s\n' 'import("arm")' 'import("hand")' 'loadComponent("one", "Arm")' 'one.isRunning()' > commands
    $shell -c '. install/setup.$0; deployer < commands' $shell > deploy.log 2>&1 || { cat deploy.log; fail "deployer in $shell, $option"; }
    expect_text deploy.log ' = false'
    ! grep -i error deploy.log || fail "errors in $shell, $option"
  done
done
