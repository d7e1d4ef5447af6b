// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "live_client.hpp"

#include "oro_messages.hpp"
#include "text_depth.hpp"

#include <algorithm>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::size_t kMostBytes = 1024 * 1024, kDeepest = 32;
constexpr unsigned kMostOutstanding = 64;

/** An id is sent back with each sample. */
bool isId(const json& id) {
    return id.is_number() || (id.is_string() && id.get_ref<const std::string&>().size() <= 64);
}

}  // namespace

LiveClient::LiveClient(Host& host, std::uint64_t number, Caller caller, Link& link, bool)
    : host_(host), number_(number), caller_(std::move(caller)), link_(link), queue_(kMostBytes), streams_(*this) {}

LiveClient::~LiveClient() = default;

bool LiveClient::isFull() const { return queue_.answerBytes() > kMostBytes || outstanding_ >= kMostOutstanding; }

void LiveClient::sendText(std::string text) {
    queue_.addAnswer({std::move(text), false});
    link_.wake();
}

void LiveClient::sendBinary(std::string bytes) {
    queue_.addAnswer({std::move(bytes), true});
    link_.wake();
}

void LiveClient::forwarded(std::string text) {
    --outstanding_;
    sendText(std::move(text));
}

void LiveClient::receive(std::string_view message, bool isBinary) {
    if (isBinary)
        sendText(oroError(nullptr, kMalformed, "messages of oro.v1 are texts"));
    else
        receiveText(message);
}

void LiveClient::receiveText(std::string_view text) {
    if (depthOf(text) > kDeepest)
        return sendText(oroError(nullptr, kMalformed, "the message nests deeper than 32 levels"));
    const json message = json::parse(text.begin(), text.end(), nullptr, /*allow_exceptions=*/false);
    if (!message.is_object()) return sendText(oroError(nullptr, kMalformed, "the message is not a JSON object"));
    const auto op = message.find("op");
    if (op == message.end() || !op->is_string())
        return sendText(oroError(nullptr, kMalformed, "the message has no text 'op'"));
    receiveOro(message, op->get<std::string>());
}

void LiveClient::receiveOro(const json& message, const std::string& op) {
    const json id = message.value("id", json());
    if (!isId(id))
        return sendText(oroError(nullptr, kMalformed, "the 'id' is not a number or a text of up to 64 bytes"));
    if (streams_.receive(message, id, op)) return;
    ++outstanding_;
    host_.forward(number_, message, caller_);
}

void LiveClient::onTick(std::int64_t now) {
    streams_.onTick(now);
    link_.wake();
}

void LiveClient::onLines(const std::vector<LogLine>& lines, std::uint64_t dropped) {
    streams_.onLines(lines, dropped);
    link_.wake();
}

unsigned LiveClient::wantedPeriod() const { return streams_.hasWatches() ? kWatchPeriod : 0; }
bool LiveClient::wantsLines() const { return streams_.wantsLines(); }

}  // namespace OCL::live
