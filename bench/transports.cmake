# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(mqueue_bench SOURCES mqueue_bench.cpp LIBS orocos-rtt DEPENDS rtt-typekit rtt-transport-mqueue)
if(TARGET orocos-rtt-corba)
  oroforge_add_bench(corba_bench
    SOURCES corba_bench.cpp
    LIBS orocos-rtt orocos-rtt-corba
    DEPENDS rtt-typekit rtt-transport-corba)
endif()
