// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The property, attribute or port that a path leads to.
#ifndef OROFORGE_LIVE_FOUND_VALUE_HPP
#define OROFORGE_LIVE_FOUND_VALUE_HPP

#include "interface_json.hpp"
#include "verbs.hpp"

#include <memory>

namespace OCL::live {

/** Everything that is needed to read and set a value once its component is no longer visited. */
struct FoundValue {
    nlohmann::json head;  ///< what is known beside the value, see propertyHead()
    std::string path;     ///< that of the request, in the common form
    std::string whole;    ///< of the property: "Arm.pose"
    std::string component;
    Gate gate;                       ///< null for a value of the process
    Source original;                 ///< of the property; used in the thread of the component. Null for a port
    Source sample;                   ///< of a port
    std::vector<std::string> parts;  ///< fields and elements behind the property
};

/** Throws Failure if the path leads to something else. */
FoundValue findValue(const Asked& asked, const std::string& path);
/** Reads it: a copy of the property, or the sample. Null if the port has none. */
Source read(const FoundValue& found, const Limit& limit);
/** Fills the copies in the thread of the component. A null gate is the process, whose values this thread may read. */
void fill(const Gate& gate, const std::string& component, const Limit& limit,
          const std::vector<std::shared_ptr<Copied>>& copies);
/** The answer to `get`: the value of a part of `whole`, with what is known of it. */
nlohmann::json described(const FoundValue& found, const Source& whole);

}  // namespace OCL::live

#endif
