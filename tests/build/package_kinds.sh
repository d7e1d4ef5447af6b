#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Packages of each pair of kinds, under odd names, are built without a warning, tested, installed, deployed, and used by a
# second project. With --all, every subset of the kinds.
source "$(dirname "$0")/package_test.sh"
here=$(cd "$(dirname "$0")" && pwd)
cd "$work"
kinds=(component service plugin support typekit application)
strict='-Wall -Wextra -Wconversion -Werror'

identifier() { echo "${1//[-.]/_}"; }
upper_first() { local name; name=$(identifier "$1"); echo "${name^}"; }
has() { case " $chosen " in *" $1 "*) ;; *) return 1 ;; esac; }

# A component that takes from the package whatever others can use.
write_user() { # name namespace
  local name=$1 space=${2:+$2::}
  mkdir "$name-user"
  cat > "$name-user/CMakeLists.txt" <<TXT
cmake_minimum_required(VERSION 3.16)
project($name-user)
find_package(OROCOS-RTT REQUIRED)
include(\${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_use_package($name REQUIRED)
orocos_component($name-user user.cpp)
orocos_generate_package()
TXT
  {
    printf '#include <iostream>\n#include <rtt/Component.hpp>\n'
    ! has support || echo "#include <$name/$name-support.hpp>"
    ! has typekit || echo "#include <$name/$name-types.hpp>"
    ! has component || echo "#include <$name/$name-component.hpp>"
    echo '#include <rtt/RTT.hpp>'
    if has component; then
      echo "class User : public $space$(upper_first "$name") {"
      echo "public: explicit User(const std::string& n) : $space$(upper_first "$name")(n) {"
    else
      echo 'class User : public RTT::TaskContext {'
      echo 'public: explicit User(const std::string& n) : RTT::TaskContext(n) {'
    fi
    ! has support || echo "addAttribute(\"limited\", limited_);"
    ! has typekit || echo 'addPort(data_);'
    echo '}'
    echo 'bool startHook() override { std::cout << "the user started\n"; return true; }'
    ! has support || echo "double limited_ = ${2:-$(identifier "$name")}::limited(5, 0, 1);"
    ! has typekit || echo "RTT::OutputPort<$(upper_first "$name")Data> data_{\"data\"};"
    echo '};'
    echo 'ORO_CREATE_COMPONENT(User)'
  } > "$name-user/user.cpp"
}

# Loads what the package has into the user's component, which starts if all is as it should be.
write_script() { # name
  local name=$1 condition=true
  {
    echo "import(\"$name\")"
    echo "import(\"$name-user\")"
    echo 'loadComponent("user", "User")'
    ! has plugin || echo "loadService(\"user\", \"$name-plugin\")"
    if has service; then
      echo "loadService(\"user\", \"$(identifier "$name")_service\")"
      condition="user.$(identifier "$name")_service.getOwnerName() == \"user\""
    fi
    ! has support || condition="$condition && user.limited == 1.0"
    echo 'user.configure()'
    echo "if ($condition) then user.start()"
  } > app.ops
}

check_package() { # name namespace cmake-options kind…
  local name=$1 space=$2 options=$3
  shift 3
  chosen="$*"
  echo "== $name: $chosen"
  orocreate-pkg "$name" "$@" ${space:+--namespace "$space"} > "$name.log"
  # shellcheck disable=SC2086
  build_package "$name" "$name-b" "$work/inst" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="$strict" $options
  (cd "$name-b" && ctest --output-on-failure > ctest.log 2>&1) || { cat "$name-b/ctest.log" >&2; fail "tests of $name"; }
  write_user "$name" "$space"
  build_package "$name-user" "$name-user-b" "$work/inst" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="$strict" \
    -DCMAKE_PREFIX_PATH="$prefix;$work/inst"
  ! has application || timeout 20 "inst/bin/$name-application-gnulinux" 0.3 > app.out || { cat app.out >&2; fail "application of $name"; }
  export RTT_COMPONENT_PATH=$work/inst/lib/orocos
  if has component; then
    deploy_until "$(upper_first "$name") executes updateHook" -s "$work/$name/deploy/$name.xml"
    deploy_until "$(upper_first "$name") executes updateHook" -s "$work/$name/deploy/$name.ops"
  fi
  write_script "$name"
  deploy_until 'the user started' -s app.ops
  unset RTT_COMPONENT_PATH
}

if [ "${2:-}" = --all ]; then
  for subset in $(seq 0 $(((1 << ${#kinds[@]}) - 1))); do
    words=()
    for i in "${!kinds[@]}"; do
      ((subset >> i & 1)) && words+=("${kinds[$i]}")
    done
    check_package "p$subset" '' '' "${words[@]:-cmake}"
  done
  exit 0
fi

# Each pair of kinds is together in one of them, and each kind is missing in one.
check_package all-of.It robots::arm '' component service plugin support typekit application
check_package Only_types '' "-DCMAKE_CXX_COMPILER=clang++-19" typekit application
check_package a.b-c '' '' service support

# One that a manifest describes: services of a component, a service plugin and a plugin.
orocreate-pkg gripper --from "$here/../golden/component/service_plugins/gripper.xml" > gripper.log
build_package gripper gripper-b "$work/inst" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS="$strict"
(cd gripper-b && ctest --output-on-failure > ctest.log 2>&1) || { cat gripper-b/ctest.log >&2; fail "tests of gripper"; }
expect_file inst/share/doc/gripper/reference.md
# Operations are made to answer as the script below wants it, as a user would fill them in.
sed -i '/Hand::motion/,/^}/s/return.*/return true;/' gripper/src/Hand.cpp
sed -i 's/^void Hand::updateHook() {/&\n    RTT::log(RTT::Warning) << "the hand moves" << RTT::endlog();/; s/^#include "Hand.hpp"/&\n#include <rtt\/Logger.hpp>/' \
  gripper/src/Hand.cpp
build_package gripper gripper-b "$work/inst"
cat > gripper.ops <<'TXT'
import("gripper")
loadComponent("hand", "gripper::Hand")
loadService("hand", "recorder")
loadService("hand", "gripper-clock")
hand.recorder.size = 7
hand.motion.speed = 0.5
var bool outside = hand.configure()
hand.motion.speed = 0.05
var bool inside = hand.configure()
setActivity("hand", 0.1, 0, ORO_SCHED_OTHER)
hand.start()
if (!outside && inside && hand.recorder.size == 7 && hand.motion.open() && hand.motion.limits.isInside(0.1)) then hand.update()
TXT
export RTT_COMPONENT_PATH=$work/inst/lib/orocos
deploy_until 'the hand moves' -s gripper.ops
expect_text deploy.out "property 'motion.speed' is 0.5 m/s, expected at most 0.1"
