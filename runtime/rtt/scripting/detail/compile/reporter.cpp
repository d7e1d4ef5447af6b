// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/reporter.hpp>

namespace RTT::scripting::detail {

void Reporter::warn(ast::Place at, const char* code, const std::string& message, const std::string& hint) const {
    if (alias_.declared || quiet_ != 0) return;
    auto& warning = where_.sink->warning(locate(at), code, message);
    if (!hint.empty()) warning.hint(hint);
}

void Reporter::warnOfConversion(ast::Place at, const std::string& from, const std::string& to) const {
    const bool textOfSize = from == "int" && (to == "string" || to == "rt_string");
    const bool fraction = (from == "double" || from == "float") && to == "int";
    warn(at, "OPS120",
         "a value of type " + from + " is converted to " + to +
             (textOfSize ? " and becomes a text of that many letters"
              : fraction ? " and loses its fraction"
                         : ""));
}

void Reporter::error(ast::Place at, const char* code, const std::string& message, const std::string& hint) const {
    auto& error = where_.sink->error(locate(at), code, message);
    if (!hint.empty()) error.hint(hint);
    if (alias_.declared)
        error.note({where_.file, alias_.used->at.line, alias_.used->at.column},
                   "alias '" + alias_.used->text + "' is used here");
    throw Unresolved();
}

}  // namespace RTT::scripting::detail
