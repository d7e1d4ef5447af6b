// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The state that all commands of a console share.
#ifndef OROFORGE_CONSOLE_CONSOLE_STATE_HPP
#define OROFORGE_CONSOLE_CONSOLE_STATE_HPP

#include "macro.hpp"
#include "place.hpp"
#include "program_listing.hpp"
#include "screen.hpp"
#include "visits.hpp"
#include "watch.hpp"

#include <rtt/scripting/typed_input.hpp>

#include <memory>
#include <string>
#include <vector>

namespace OCL::console {

struct ConsoleState {
    Screen screen;
    RTT::TaskContext& self;  ///< the console's own component
    Place place;
    std::string inputName;  ///< the name of the source of lines, for messages
    std::unique_ptr<Watch> watch = {};
    std::unique_ptr<RTT::scripting::TypedInput> typed = {};
    ProgramListing listing = {};
    Macro macro = {};
    bool quits = false;

    /** The component in which names are looked up: the visited one, or the console's own while that watches it. Null if
        the visited component is gone. */
    RTT::TaskContext* context() const { return watch ? &self : place.component(); }
    /** Components to begin with when the port at the other end of a connection is looked for. */
    std::vector<Gate> around() const;
    /** Must be called after each change of the context. */
    void forgetInput() { typed.reset(); }
    void goTo(bool watching);
};

}  // namespace OCL::console

#endif
