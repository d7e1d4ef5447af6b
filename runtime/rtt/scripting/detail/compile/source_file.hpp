// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A script that is being run, and the parts of its text that outlive it.
#ifndef ORO_SCRIPTING_DETAIL_SOURCE_FILE_HPP
#define ORO_SCRIPTING_DETAIL_SOURCE_FILE_HPP

#include <rtt/scripting/detail/syntax/ast.hpp>
#include <rtt/scripting/detail/compile/compiler.hpp>

#include <memory>
#include <string>
#include <utility>

namespace RTT::scripting::detail {

/**
 * A script with the variables of its top level. Functions and types of state machines need their tree later and share
 * the whole file; programs and state machines are compiled once and do not keep it.
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
    Scope scope;  ///< the variables between the items

    /** The source of an item. */
    std::string textOf(const ast::Item& item) const { return text.substr(item.begin, item.size); }

    struct Excerpt {
        std::string letters;
        ast::Place at;  ///< of the first of them
    };
    /** The source of an item of `tree`, with the comment before it. */
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
