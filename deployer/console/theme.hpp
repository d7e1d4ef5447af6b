// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The colours of the console's output.
#ifndef OROFORGE_CONSOLE_THEME_HPP
#define OROFORGE_CONSOLE_THEME_HPP

#include <string>

namespace OCL::console {

enum class Style { Plain, Title, Name, Type, Value, Faint, Good, Bad };

class Theme {
public:
    enum Kind { NoColors, Dark, Light };
    explicit Theme(Kind kind = NoColors) : kind_(kind) {}

    Kind kind() const { return kind_; }
    /** The text between the escape sequences of the style, or the plain text if there are no colours. */
    std::string paint(Style style, const std::string& text) const;

private:
    Kind kind_;
};

}  // namespace OCL::console

#endif
