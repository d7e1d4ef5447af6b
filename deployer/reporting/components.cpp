// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component library `reporting`.
#include <ocl/Component.hpp>
#include <ocl/ConsoleReporting.hpp>
#include <ocl/FileReporting.hpp>
#include <ocl/TcpReporting.hpp>

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::ConsoleReporting)
ORO_LIST_COMPONENT_TYPE(OCL::FileReporting)
ORO_LIST_COMPONENT_TYPE(OCL::TcpReporting)
