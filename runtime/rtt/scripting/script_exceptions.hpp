// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Exceptions of the scripting service, for callers that ask for them.
#ifndef ORO_SCRIPT_EXCEPTIONS_HPP
#define ORO_SCRIPT_EXCEPTIONS_HPP

#include <rtt/rtt-config.h>

#include <stdexcept>

namespace RTT {
namespace scripting {

/** A script cannot be read or has errors; what() is the first one, with its place. */
struct RTT_API file_parse_exception : std::runtime_error {
    using std::runtime_error::runtime_error;
};
/** Programs or state machines were not loaded, for any reason. */
struct RTT_API program_load_exception : file_parse_exception {
    using file_parse_exception::file_parse_exception;
};
/** A program or state machine was not unloaded. */
struct RTT_API program_unload_exception : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace scripting
}  // namespace RTT

#endif
