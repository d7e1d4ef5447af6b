#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Messages of a user: in a package for catkin that defines them and makes their typekit, and in one that create_rtt_msgs makes
# for them, with plain CMake. Their fields from a script, what is built again, and what is said of faults.
source "$(dirname "$0")/package_test.sh"
[ -e /usr/share/catkin/cmake/catkinConfig.cmake ] && [ -e "$prefix/share/rtt_std_msgs/package.xml" ] || exit 77
export PATH=/usr/bin:$PATH ROS_LANG_DISABLE=genlisp:genpy ORO_LOGFILE=$work/orocos.log
unset ROS_PACKAGE_PATH
cd "$work"
mkdir -p probe_msgs/msg probe_msgs/srv
printf 'float64 x\nfloat64 y\n' > probe_msgs/msg/Spot.msg
cat > probe_msgs/msg/State.msg << 'TXT'
# Of a probe.
int8 IDLE=0
int8 BUSY=-3
string NAME= the probe
Header header
int8 mode        # IDLE or BUSY
Spot[] spots
Spot[2] ends
float64[4] gains
string[] words
duration left
bool good
TXT
printf '' > probe_msgs/msg/Nothing.msg
printf 'Spot goal\n---\nbool reached\n' > probe_msgs/srv/Reach.srv
cat > probe_msgs/package.xml << 'TXT'
<package format="2"><name>probe_msgs</name><version>1.0.0</version><description>probe</description>
<maintainer email="a@example.com">a</maintainer><license>none</license><buildtool_depend>catkin</buildtool_depend>
<build_depend>message_generation</build_depend><depend>std_msgs</depend><depend>rtt_roscomm</depend></package>
TXT
services=
nm -D "$prefix/lib/librtt_rostopic-gnulinux.so" | grep -q addServices && services='ros_generate_rtt_service_proxies(probe_msgs)'
cat > probe_msgs/CMakeLists.txt << TXT
cmake_minimum_required(VERSION 3.16)
project(probe_msgs)
find_package(catkin REQUIRED COMPONENTS message_generation std_msgs rtt_roscomm)
add_message_files(FILES Spot.msg State.msg Nothing.msg)
add_service_files(FILES Reach.srv)
generate_messages(DEPENDENCIES std_msgs)
ros_generate_rtt_typekit(probe_msgs)
$services
orocos_generate_package(DEPENDS_TARGETS rtt_roscomm rtt_std_msgs)
TXT
configure() { # source option…
  local source=$1
  shift
  cmake -S "$source" -B "b_$source" -G Ninja -Wno-dev -DCMAKE_PREFIX_PATH="$prefix;$work/b_bare_msgs/devel" -DPYTHON_EXECUTABLE=/usr/bin/python3 \
    -DCMAKE_INSTALL_PREFIX="$work/inst" -DCMAKE_CXX_FLAGS=-O0 "$@" > "$source.log" 2>&1
}
build() { cmake --build "b_$1" --parallel 2 > "$1.build.log" 2>&1 || { cat "$1.log" "$1.build.log" >&2; fail "build of $1"; }; }
configure probe_msgs || { cat probe_msgs.log >&2; fail "cmake probe_msgs"; }
build probe_msgs
devel=b_probe_msgs/devel
types=$devel/lib/orocos/gnulinux/probe_msgs/types
expect_file $types/librtt-probe_msgs-typekit-gnulinux.so
expect_file $types/librtt-probe_msgs-ros-transport-gnulinux.so

# Every kind of field, from a script.
cat > state.ops << 'TXT'
import("rtt_std_msgs")
import("probe_msgs")
var probe_msgs.State s
var bool all = true
s.header.frame_id = probe_msgs.State.NAME
s.mode = probe_msgs.State.BUSY
s.spots = probe_msgs.Spot[](2)
s.spots[1].y = 1.5
s.ends[1].x = 2.5
s.gains[3] = 3.5
s.words = string[](1)
s.words[0] = "word"
s.left = duration(4.5)
s.good = uint8(1)
all = all && s.header.frame_id == "the probe" && s.spots[1].y == 1.5 && s.ends[1].x == 2.5 && s.gains[3] == 3.5
all = all && s.words[0] == "word" && s.left.sec == 4 && s.ends.size == 2 && s.mode == probe_msgs.State.BUSY
var probe_msgs.Nothing empty
all
TXT
RTT_COMPONENT_PATH=$work/$devel/lib/orocos:$prefix/lib/orocos deployer-gnulinux < state.ops > deploy.out 2>&1 ||
  { cat deploy.out >&2; fail "the deployer"; }
[ "$(grep -v '^$' deploy.out | tail -1)" = ' = true' ] || { cat deploy.out >&2; fail "a field differs"; }

# Nothing is built again, and only what changed.
build probe_msgs
! grep -q 'Building' probe_msgs.build.log || { cat probe_msgs.build.log >&2; fail "built again without a change"; }
touch probe_msgs/msg/Nothing.msg
cmake --build b_probe_msgs > b.log
! grep -q 'Building CXX object.*Transport' b.log || { cat b.log >&2; fail "a table was compiled again that did not change"; }
sed -i 's/float64 y/float64 y # up/' probe_msgs/msg/Spot.msg
cmake --build b_probe_msgs --target rtt-probe_msgs-messages-generate > b.log 2>&1
grep -q 'float64 y # up' b_probe_msgs/rtt_probe_msgs/Transport.cpp || fail "the definition is of old"
# A header of another version is told from the right one.
cp -r $devel/include old_include
sed -i 's/float64 y/float32 y/' probe_msgs/msg/Spot.msg
cmake --build b_probe_msgs --target rtt-probe_msgs-messages-generate > b.log 2>&1
! g++ -fsyntax-only -I"$prefix/include/orocos" -I"$prefix/include" -Iold_include -std=c++17 \
  $(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags orocos-rtt-gnulinux) b_probe_msgs/rtt_probe_msgs/types_Spot.cpp 2> b.log ||
  fail "a header of another version was taken"
expect_text b.log '<probe_msgs/Spot.h> and the description of probe_msgs/Spot'
sed -i 's/float32 y/float64 y/' probe_msgs/msg/Spot.msg
# An error in a file has its place.
echo 'oops' >> probe_msgs/msg/Spot.msg
! cmake --build b_probe_msgs --target rtt-probe_msgs-messages-generate > b.log 2>&1 || fail "a faulty file was taken"
expect_text b.log "$work/probe_msgs/msg/Spot.msg:3:1: error: [RM002] 'oops' is not a field"
sed -i '/oops/d' probe_msgs/msg/Spot.msg

# A package for the messages of another, without catkin.
cp -r probe_msgs bare_msgs
sed -i 's/probe_msgs/bare_msgs/; /ros_generate/d; s/ rtt_roscomm)/)/; s/^orocos_generate_package.*/catkin_package()/' bare_msgs/CMakeLists.txt
sed -i 's/probe_msgs/bare_msgs/; s/<depend>rtt_roscomm<.depend>//' bare_msgs/package.xml
configure bare_msgs || { cat bare_msgs.log >&2; fail "cmake bare_msgs"; }
build bare_msgs
devel=$work/b_bare_msgs/devel
export CMAKE_PREFIX_PATH=$devel ROS_PACKAGE_PATH=$work/bare_msgs
"$prefix/lib/rtt_roscomm/create_rtt_msgs" bare_msgs > b.log 2>&1 || { cat b.log >&2; fail "create_rtt_msgs"; }
! grep -q warning b.log || { cat b.log >&2; fail "create_rtt_msgs warns"; }
! "$prefix/lib/rtt_roscomm/create_rtt_msgs" bare_msgs 2> b.log || fail "an existing folder was overwritten"
"$prefix/lib/rtt_roscomm/create_rtt_msgs" -f bare_msgs > b.log
for words in '' '-h' 'a b' 'no_such_package'; do
  # shellcheck disable=SC2086
  ! "$prefix/lib/rtt_roscomm/create_rtt_msgs" $words 2> b.log || fail "create_rtt_msgs $words"
done
expect_text rtt_bare_msgs/package.xml '<plugin_depend>rtt_std_msgs</plugin_depend>'
[ -n "$services" ] || sed -i '/service_proxies/d' rtt_bare_msgs/CMakeLists.txt
configure rtt_bare_msgs -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON || { cat rtt_bare_msgs.log >&2; fail "cmake rtt_bare_msgs"; }
build rtt_bare_msgs
cmake --install b_rtt_bare_msgs > b.log
expect_file inst/lib/orocos/gnulinux/rtt_bare_msgs/types/librtt-bare_msgs-typekit-gnulinux.so
expect_file inst/include/orocos/bare_msgs/typekit/State.h
expect_file inst/include/orocos/bare_msgs/boost/State.h
cat > use.cpp << 'TXT'
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <bare_msgs/typekit/Types.h>
#include <bare_msgs/boost/State.h>
#include <boost/archive/text_oarchive.hpp>
#include <boost/archive/text_iarchive.hpp>
#include <sstream>
int main() {
    bare_msgs::State a, b;
    a.words.push_back("one");
    a.ends[1].x = 2;
    std::stringstream text;
    boost::archive::text_oarchive(text) << static_cast<const bare_msgs::State&>(a);
    boost::archive::text_iarchive(text) >> b;
    RTT::OutputPort<bare_msgs::State> port("p");
    return a == b ? 0 : 1;
}
TXT
PKG_CONFIG_PATH=$prefix/lib/pkgconfig g++ -O0 -std=c++17 use.cpp -Iinst/include/orocos -I$devel/include -o use \
  $(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs orocos-rtt-gnulinux rtt_roscomm-gnulinux) \
  inst/lib/orocos/gnulinux/rtt_bare_msgs/types/librtt-bare_msgs-typekit-gnulinux.so -lboost_serialization
LD_LIBRARY_PATH=$prefix/lib:$work/inst/lib/orocos/gnulinux/rtt_bare_msgs/types:$prefix/lib/orocos/gnulinux/rtt_ros/types ./use || fail "serialization"

# What is missing is named.
mkdir -p faulty
faulty() { # line…
  printf 'cmake_minimum_required(VERSION 3.16)\nproject(faulty)\nfind_package(rtt_roscomm REQUIRED)\n%s\n' "$1" > faulty/CMakeLists.txt
  rm -rf b_faulty
  configure faulty -DCMAKE_DISABLE_FIND_PACKAGE_catkin=ON
}
! faulty 'ros_generate_rtt_typekit(no_such_msgs)' || fail "an unknown package was taken"
expect_text faulty.log "ros_generate_rtt_typekit(no_such_msgs): there is no package 'no_such_msgs'"
faulty 'ros_generate_rtt_typekit(std_srvs)' || fail "a package without messages"
expect_text faulty.log 'package std_srvs has none, nothing to do'
faulty 'ros_generate_rtt_service_proxies(bare_msgs EXTRA_INCLUDES vector)' || fail "services with a dependency"
! grep -q 'no package rtt_std_msgs' faulty.log || fail "a package that is there is called missing"
! faulty 'ros_generate_rtt_typekit(std_msgs ONE)' || fail "an unknown argument was taken"
