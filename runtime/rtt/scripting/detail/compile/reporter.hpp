// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_REPORTER_HPP
#define ORO_SCRIPTING_DETAIL_REPORTER_HPP

#include <rtt/scripting/detail/compile/compiler.hpp>
#include <rtt/types/conversion_watch.hpp>
#include <rtt/types/refusal_watch.hpp>

#include <string>

namespace RTT::scripting::detail {

/** Thrown within the compiler after an error was reported. */
struct Unresolved {};

/** Reports errors and warnings of one piece of script. */
class Reporter {
public:
    /** Gives no warnings while `quiet` is not 0. */
    Reporter(const CompileContext& where, const unsigned& quiet) : where_(where), quiet_(quiet) {}

    /** Also throws Unresolved. */
    [[noreturn]] void error(ast::Place at, const char* code, const std::string& message,
                            const std::string& hint = "") const;
    void warn(ast::Place at, const char* code, const std::string& message, const std::string& hint = "") const;
    void warnOfConversion(ast::Place at, const std::string& from, const std::string& to) const;
    /** Calls `convert` and reports conversions that lose something or are impossible. */
    template <class Convert>
    auto watched(ast::Place at, Convert convert) const;
    oroforge::diag::Location locate(ast::Place at) const {
        return {alias_.declared ? alias_.declared->file : where_.file, at.line, at.column};
    }

    /** The alias that is compiled where it is used, if any. It gets no warnings, because its declaration got them. */
    struct Alias {
        const Scope::Entry* declared = nullptr;  ///< the innermost one
        const ast::Identifier* used = nullptr;   ///< the use of the outermost one
    };
    const Alias& alias() const { return alias_; }
    void setAlias(Alias alias) { alias_ = alias; }

private:
    const CompileContext& where_;
    const unsigned& quiet_;
    Alias alias_;
};

template <class Convert>
auto Reporter::watched(ast::Place at, Convert convert) const {
    const types::detail::ConversionWatch watch;
    const types::detail::RefusalWatch refusals;
    auto made = convert();
    for (const auto& conversion : watch.conversions()) warnOfConversion(at, conversion.from, conversion.to);
    if (!refusals.reason().empty()) error(at, "OPS154", refusals.reason());
    return made;
}

}  // namespace RTT::scripting::detail

#endif
