// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of the activities.
#ifndef ORO_RTT_EXTRAS_FWD_HPP
#define ORO_RTT_EXTRAS_FWD_HPP

namespace RTT {
namespace extras {
class FileDescriptorActivity;
class FileDescriptorActivityInterface;
class FileDescriptorSimulationActivity;
class PeriodicActivity;
class SequentialActivity;
class SimulationActivity;
class SimulationThread;
class SlaveActivity;
class TimerThread;
}  // namespace extras
}  // namespace RTT

#endif
