// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CONSOLE_MACRO_HPP
#define OROFORGE_CONSOLE_MACRO_HPP

#include <string>

namespace OCL::console {

/** Records typed lines as a function. */
class Macro {
public:
    bool recording() const { return !name_.empty(); }
    const std::string& name() const { return name_; }
    void begin(const std::string& name);
    void add(const std::string& line) { lines_ += "    " + line + "\n"; }
    void cancel() { name_.clear(); }

    std::string head() const { return "export function " + name_ + " {"; }
    /** The first line of the script. */
    std::string title() const { return "/* TaskBrowser macro '" + name_ + "' */"; }
    /** The whole script. */
    std::string text() const { return title() + "\n\n" + head() + "\n" + lines_ + "}\n"; }
    std::string file() const { return name_ + ".ops"; }

private:
    std::string name_, lines_;
};

inline void Macro::begin(const std::string& name) {
    name_ = name;
    lines_.clear();
}

}  // namespace OCL::console

#endif
