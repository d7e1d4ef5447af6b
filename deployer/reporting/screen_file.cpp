// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "screen_file.hpp"

#include "text_target.hpp"

#include <rtt/Logger.hpp>

#include <sstream>

namespace OCL::reporting {

bool writeScreenFile(const std::string& component, const std::function<bool(std::ostream&)>& screen) {
    if (component.find('/') != std::string::npos) {
        RTT::log(RTT::Error) << "could not screen component '" << component
                             << "': a name with a '/' would write to another folder" << RTT::endlog();
        return false;
    }
    const std::string name = component + ".screen";
    std::string error;
    std::ostringstream text;
    if (!screen(text)) return false;
    if (const std::unique_ptr<TextTarget> file = openFile(name, error))
        error = file->write(text.str().data(), text.str().size());
    if (error.empty()) return true;
    RTT::log(RTT::Error) << "could not write file '" << name << "': " << error << RTT::endlog();
    return false;
}

}  // namespace OCL::reporting
