// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A library whose types are listed in two files, one of them a template.
#include "listed.hpp"

ORO_CREATE_COMPONENT_TYPE()
ORO_LIST_COMPONENT_TYPE(loading_test::Pair<int, double>)
