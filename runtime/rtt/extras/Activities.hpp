// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_ACTIVITIES_HPP
#define ORO_EXTRAS_ACTIVITIES_HPP

/** @file All activities. */
#include <rtt/Activity.hpp>
#include <rtt/extras/FileDescriptorActivity.hpp>
#include <rtt/extras/FileDescriptorSimulationActivity.hpp>
#include <rtt/extras/PeriodicActivity.hpp>
#include <rtt/extras/SequentialActivity.hpp>
#include <rtt/extras/SimulationActivity.hpp>
#include <rtt/extras/SimulationThread.hpp>
#include <rtt/extras/SlaveActivity.hpp>

#endif
