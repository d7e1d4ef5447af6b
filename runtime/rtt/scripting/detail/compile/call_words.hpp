// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Descriptions of calls for messages of the compiler.
#ifndef ORO_SCRIPTING_DETAIL_CALL_WORDS_HPP
#define ORO_SCRIPTING_DETAIL_CALL_WORDS_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/scripting/detail/syntax/ast.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace RTT {
class OperationInterfacePart;
namespace scripting {
namespace detail {

/** "a.b.c"; at most the first `most` parts. */
std::string joined(const std::vector<ast::Identifier>& parts, std::size_t most = std::string::npos);
/** "2 arguments" */
std::string counted(std::size_t count);
/** The attempted call: "array(int, int)". */
std::string signature(const std::string& name, const std::vector<base::DataSourceBase::shared_ptr>& arguments);
/** The type without a reference: "string" for "string const&". */
std::string plainType(const std::string& type);
/** The declaration of an operation: "bool moveTo(double position)". */
std::string declarationOf(const OperationInterfacePart& part);
/** What the elements of a sequence must be; empty for other types. */
std::string elementsOf(const types::TypeInfo& type);

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
