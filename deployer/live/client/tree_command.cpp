// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro tree
#include "session.hpp"
#include "state_text.hpp"

namespace oroforge::live_client {
namespace {

std::string countOf(const Json& counts, const char* what, const char* one, const char* more) {
    const long long count = wholeOf(counts, what);
    return count == 0 ? "" : std::to_string(count) + " " + (count == 1 ? one : more);
}

std::string countsOf(const Json& counts) {
    std::string text;
    for (const std::string& part :
         {countOf(counts, "properties", "property", "properties"),
          countOf(counts, "operations", "operation", "operations"), countOf(counts, "ports", "port", "ports")})
        if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
    return text;
}

/** The branches are those of tree(1). */
void writeServices(Session& session, const Json& services, const std::string& before) {
    for (std::size_t i = 0; i != services.size() && services.is_array(); ++i) {
        const bool last = i + 1 == services.size();
        const Json& service = services[i];
        const std::string name = service.is_string() ? service.get<std::string>() : textOf(service, "name");
        session.out().line(before + (last ? "└── " : "├── ") + session.out().paint(Style::Name, printable(name)));
        writeServices(session, memberOf(service, "services"), before + (last ? "    " : "│   "));
    }
}

}  // namespace

void showTree(Session& session) {
    Json fields = Json::object();
    if (!session.word(0).empty()) fields["path"] = session.word(0);
    const Json tree = session.deployment().ask("tree", std::move(fields));
    if (session.answeredAsJson(tree)) return;
    Output& out = session.out();
    for (const Json& component : memberOf(tree, "components")) {
        const std::string state = printable(textOf(component, "state"));
        const std::string counts = countsOf(memberOf(component, "counts"));
        out.line(out.paint(Style::Name, printable(textOf(component, "name"))) + "  " +
                 out.paint(Style::Type, printable(textOf(component, "type"))) + "  " +
                 out.paint(styleOfState(state), state) +
                 (counts.empty() ? "" : "  " + out.paint(Style::Faint, counts)));
        writeServices(session, memberOf(component, "services"), "");
    }
}

}  // namespace oroforge::live_client
