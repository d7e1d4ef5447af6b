// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verb `set`.
#include "failure.hpp"
#include "fields.hpp"
#include "found_value.hpp"
#include "permissions.hpp"
#include "verbs.hpp"

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSource.hpp>

#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;
using RTT::PropertyBag;
using RTT::internal::DataSource;

constexpr std::size_t kLogged = 200;  // bytes of a value in the log

void checkWritable(const FoundValue& found) {
    if (!found.original) throw Failure(kReadOnly, "'" + found.whole + "' is a port, which a client cannot write to");
    if (!found.original->isAssignable())
        throw Failure(kReadOnly, "'" + found.whole + "' is a constant, or its type cannot be assigned");
}

/** In the thread of the component. */
void store(const FoundValue& found, const Source& value) {
    const Source target = found.parts.empty() ? found.original : partOf(found.original, found.parts, found.whole);
    const auto* const bag = DataSource<PropertyBag>::narrow(target.get());
    const auto* const from = DataSource<PropertyBag>::narrow(value.get());
    value->evaluate();
    const bool done = bag && from ? RTT::refreshProperties(bag->rvalue(), from->rvalue()) : target->update(value.get());
    if (!done) throw Failure(kReadOnly, "'" + found.path + "' cannot be set, because it is read-only");
    target->updated();
}

}  // namespace

json set(const Asked& asked) {
    const bool asText = asked.request.contains("text");
    if (asText == asked.request.contains("value"))
        throw Failure(kMalformed, "the request has " + std::string(asText ? "both 'value' and 'text'" : "no value") +
                                      ", expected either 'value' (JSON) or 'text'");
    const FoundValue found = findValue(asked, textField(asked.request, "path"));
    checkWritable(found);
    checkSet(asked, found);
    const Source whole = read(found, asked.limit);
    const Source part = partOf(whole, found.parts, found.whole);
    const std::string before = textOf(part, kLogged);
    if (asText)
        assign(part, textField(asked.request, "text"), found.path);
    else
        assign(part, asked.request["value"], found.path);
    const auto after = std::make_shared<Copied>(found.original);
    after->growFor(whole);
    const auto isFilled = std::make_shared<bool>(false);
    const auto work = [found, part, after, isFilled] {
        store(found, part);
        *isFilled = after->fill();
    };
    if (found.gate)
        inThreadOf(found.gate, found.component, asked.limit, work);
    else
        work();
    if (!*isFilled) fill(found.gate, found.component, asked.limit, {after});
    json made = described(found, after->value());
    RTT::log(RTT::Info) << asked.caller.name << " sets " << found.path << " = "
                        << cut(made["text"].get_ref<const std::string&>(), kLogged) << " (was " << before << ")"
                        << RTT::endlog();
    return made;
}

}  // namespace OCL::live
