// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/TaskContext.hpp>
#define PART after_task_context
#include "use_everything.hpp"

int check_after_task_context() { return after_task_context::Component("after_task_context").check(); }
