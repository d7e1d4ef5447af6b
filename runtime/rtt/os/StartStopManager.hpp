// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OS_START_STOP_MANAGER_HPP
#define ORO_OS_START_STOP_MANAGER_HPP

#include <rtt/rtt-config.h>

namespace RTT {
namespace os {

typedef int (*start_fun)(void);
typedef void (*stop_fun)(void);

/** Phases run in ascending order; functions of one phase in the order of registration (start) or its reverse (stop). */
enum StartPhase { StartLogging = -100, StartDefault = 0, StartPlugins = 100 };
enum StopPhase { StopEngines = -100, StopDefault = 0, StopTypes = 100, StopPlugins = 200, StopLogging = 300 };

/**
 * Keeps the functions that __os_init() and __os_exit() call. Parts of the runtime and plugins register with static
 * InitFunction and CleanupFunction objects. Thread-safe; not real-time.
 */
class RTT_API StartStopManager {
public:
    static StartStopManager* Instance();
    /** Nothing to release; kept for callers of the RTT API. */
    static void Release() {}

    /** Registers a function for start(); calls it at once if start() was called already, as for plugins. Returns 0 on
        success. */
    void startFunction(start_fun function, int phase = StartDefault);
    /** Registers a function for stop(). */
    void stopFunction(stop_fun function, int phase = StopDefault);
    void removeStartFunction(start_fun function);
    void removeStopFunction(stop_fun function);

    /** Calls the start functions until one returns non-zero, and returns that value or 0. A second call does
        nothing. */
    int start();
    /** Calls the stop functions; start() may be called again afterwards. */
    void stop();

private:
    StartStopManager();
    struct Registry;
    Registry* registry_;
};

/** Registers a start function for the life time of this object; make it static. */
class RTT_API InitFunction {
public:
    explicit InitFunction(start_fun function, int phase = StartDefault);
    ~InitFunction();
    InitFunction(const InitFunction&) = delete;
    InitFunction& operator=(const InitFunction&) = delete;

private:
    start_fun function_;
};

/** Registers a stop function for the life time of this object; make it static. */
class RTT_API CleanupFunction {
public:
    explicit CleanupFunction(stop_fun function, int phase = StopDefault);
    ~CleanupFunction();
    CleanupFunction(const CleanupFunction&) = delete;
    CleanupFunction& operator=(const CleanupFunction&) = delete;

private:
    stop_fun function_;
};

}  // namespace os
}  // namespace RTT
#endif
