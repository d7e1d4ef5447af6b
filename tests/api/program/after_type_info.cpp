// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/TemplateTypeInfo.hpp>
#define PART after_type_info
#include "use_usual.hpp"

int check_after_type_info() { return after_type_info::check(); }
