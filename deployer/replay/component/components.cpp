// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component library `replay`.
#include <ocl/Component.hpp>
#include <ocl/McapReplay.hpp>

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::McapReplay)
