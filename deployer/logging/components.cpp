// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The component library `logging`.
#include <ocl/Component.hpp>
#include <ocl/FileAppender.hpp>
#include <ocl/GenerationalFileAppender.hpp>
#include <ocl/LoggingService.hpp>
#include <ocl/OstreamAppender.hpp>
#include <ocl/RollingFileAppender.hpp>
#include <ocl/SyslogAppender.hpp>

ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(OCL::logging::FileAppender)
ORO_LIST_COMPONENT_TYPE(OCL::logging::GenerationalFileAppender)
ORO_LIST_COMPONENT_TYPE(OCL::logging::LoggingService)
ORO_LIST_COMPONENT_TYPE(OCL::logging::OstreamAppender)
ORO_LIST_COMPONENT_TYPE(OCL::logging::RollingFileAppender)
ORO_LIST_COMPONENT_TYPE(OCL::logging::SyslogAppender)
