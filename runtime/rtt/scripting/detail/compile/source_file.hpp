// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// One script while it is being run, and what outlives it of its text.
#ifndef ORO_SCRIPTING_DETAIL_SOURCE_FILE_HPP
#define ORO_SCRIPTING_DETAIL_SOURCE_FILE_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <memory>
#include <string>
#include <utility>

namespace RTT::scripting::detail {

/**
 * A script with the variables of its top level. Whatever a script defines and needs its tree later (functions, state machine
 * types) shares the whole file; what is compiled once and for all (programs, state machines) needs to keep neither.
 */
struct SourceFile {
    SourceFile(oroforge::diag::FileName name, std::string text, std::shared_ptr<const SourceFile> caller)
        : name(std::move(name)),
          text(std::move(text)),
          caller(std::move(caller)),
          scope("this script", this->caller ? &this->caller->scope : nullptr) {
        scope.belongsTo(tree);
    }

    const oroforge::diag::FileName name;
    const std::string text;
    const std::shared_ptr<const SourceFile> caller;  ///< the script of the same component that runs this one; or null
    ast::Script tree;
    Scope scope;  ///< of the variables between the items

    /** The letters of an item. */
    std::string textOf(const ast::Item& item) const { return text.substr(item.begin, item.size); }

    struct Excerpt {
        std::string letters;
        ast::Place at;  ///< of the first of them
    };
    /** The letters of an item of `tree`, with the comment before it. */
    Excerpt withComment(const ast::Item& item) const;
};
typedef std::shared_ptr<const SourceFile> SourceFilePtr;

/** A part of a file that keeps the file alive. */
template <class Part>
std::shared_ptr<const Part> partOf(const SourceFilePtr& file, const Part& part) {
    return std::shared_ptr<const Part>(file, &part);
}

}  // namespace RTT::scripting::detail

#endif
