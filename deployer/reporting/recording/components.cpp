// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component library `reporting-mcap`.
#include <ocl/Component.hpp>
#include <ocl/McapReporting.hpp>

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::McapReporting)
