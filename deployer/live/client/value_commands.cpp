// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// oro get, set and call
#include "session.hpp"

#include "value_text.hpp"

#include <cmath>

namespace oroforge::live_client {
namespace {

constexpr double kUsualWait = 1, kLongestWait = 3600;  // seconds that an operation may take

/** Text, which the deployment reads as the type of the argument. Texts may be quoted, too. */
Json argumentOf(const std::string& word) {
    Json value = parsed(word);
    return value.is_string() ? value : Json(word);
}

void writeValue(Session& session, const Json& result) {
    if (session.answeredAsJson(result)) return;
    session.out().line(session.out().paint(Style::Value, shownText(result)));
}

}  // namespace

void getValue(Session& session) { writeValue(session, session.deployment().ask("get", {{"path", session.word(0)}})); }

void setValue(Session& session) {
    const Json fields = {{"path", session.word(0)}, {"text", session.word(1)}};
    writeValue(session, session.deployment().ask("set", fields));
}

void callOperation(Session& session) {
    const auto& words = session.given().words;
    Json arguments = Json::array();
    for (std::size_t i = 1; i < words.size(); ++i) arguments.push_back(argumentOf(words[i]));
    const double wait = session.given().number("wait", kUsualWait, 0.001, kLongestWait);
    const Json fields = {{"path", session.word(0)}, {"arguments", arguments}, {"timeout", wait}};
    // The deployment reports that the operation takes too long; that answer has a way, too.
    const auto limit = std::chrono::milliseconds(std::llround(wait * 1000)) + session.deployment().limit();
    const Json result = session.deployment().ask("call", fields, limit);
    if (session.answeredAsJson(result)) return;
    Output& out = session.out();
    const std::string text = shownText(result);
    if (!text.empty() && textOf(result, "type") != "void") out.line(out.paint(Style::Value, text));
    // What the operation changed.
    for (const Json& changed : memberOf(result, "arguments")) {
        const std::string name = printable(textOf(changed, "name"));
        out.line((name.empty() ? "argument " + std::to_string(wholeOf(changed, "index") + 1) : name) + " = " +
                 out.paint(Style::Value, shownText(changed)));
    }
}

}  // namespace oroforge::live_client
