# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
oroforge_add_bench(deployment_bench SOURCES deployment_bench.cpp LIBS orocos-ocl-deployment DEPENDS rtt-typekit rtt-marshalling)
