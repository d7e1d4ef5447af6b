// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "live_client.hpp"

#include "foxglove_session.hpp"
#include "foxglove_text.hpp"
#include "oro_messages.hpp"
#include "text_depth.hpp"

#include <algorithm>
#include <utility>

namespace OCL::live {
namespace {

using nlohmann::json;

constexpr std::size_t kMostBytes = 1024 * 1024;
constexpr unsigned kMostOutstanding = 64;
/** Of answers that the client does not read. More of them are under way when it is found full. */
constexpr std::size_t kMostAnswers = 8 * kMostBytes;
/** The output of its console, among channels of samples. */
constexpr std::uint64_t kConsole = std::uint64_t(1) << 63U;

/** An id is sent back with each sample. */
bool isId(const json& id) {
    return id.is_number() || (id.is_string() && id.get_ref<const std::string&>().size() <= 64);
}

}  // namespace

LiveClient::LiveClient(Host& host, std::uint64_t number, Caller caller, Link& link, bool speaksFoxglove)
    : host_(host), number_(number), caller_(std::move(caller)), link_(link), queue_(kMostBytes), streams_(*this) {
    if (speaksFoxglove) foxglove_ = std::make_unique<FoxgloveSession>(*this);
}

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

void LiveClient::forwarded(const json& id, std::string text, bool isLine) {
    --outstanding_;
    if (queue_.answerBytes() != 0 && queue_.answerBytes() + text.size() > kMostAnswers)
        text = oroError(id, kTooMany, "this client has not read 8 MiB of answers; this one is left out");
    if (!isLine) return sendText(std::move(text));
    if (const std::uint64_t dropped = queue_.dropped(kConsole); dropped != 0)
        output(textOf(
            {{"op", "oro.output"}, {"id", id}, {"text", "… (" + std::to_string(dropped) + " parts are left out)\n"}}));
    // Behind its output.
    queue_.addBehind(kConsole, {std::move(text), false});
    link_.wake();
}

void LiveClient::output(std::string text) {
    queue_.addSample(kConsole, {std::move(text), false});
    link_.wake();
}

void LiveClient::receive(std::string_view message, bool isBinary) {
    if (isBinary && foxglove_)
        foxglove_->receiveBinary(message);
    else if (isBinary)
        sendText(oroError(nullptr, kMalformed, "messages of oro.v1 are texts"));
    else
        receiveText(message);
}

void LiveClient::receiveText(std::string_view text) {
    const auto fail = [this](const char* what) {
        sendText(foxglove_ ? foxgloveStatus(2, what) : oroError(nullptr, kMalformed, what));
    };
    if (isTooDeep(text)) return fail("the message nests deeper than 32 levels");
    const json message = json::parse(text.begin(), text.end(), nullptr, /*allow_exceptions=*/false);
    if (!message.is_object()) return fail("the message is not a JSON object");
    const auto op = message.find("op");
    if (op == message.end() || !op->is_string()) return fail("the message has no text 'op'");
    const std::string verb = op->get<std::string>();
    if (foxglove_ && verb.compare(0, 4, "oro.") != 0)
        foxglove_->receive(message, verb);
    else
        receiveOro(message, verb);
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
    if (foxglove_) foxglove_->onTick(now);
    link_.wake();
}

void LiveClient::onLines(const std::vector<LogLine>& lines, std::uint64_t dropped) {
    streams_.onLines(lines, dropped);
    if (foxglove_) foxglove_->onLines(lines);
    link_.wake();
}

unsigned LiveClient::wantedPeriod() const {
    if (streams_.hasWatches()) return kWatchPeriod;
    return foxglove_ ? foxglove_->wantedPeriod() : 0;
}
bool LiveClient::wantsLines() const { return streams_.wantsLines() || (foxglove_ && foxglove_->wantsLines()); }

}  // namespace OCL::live
