// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "listed.hpp"

ORO_LIST_COMPONENT_TYPE(loading_test::Pair<char, bool>)
ORO_LIST_COMPONENT_TYPE(loading_test::Pair<int, int>)
