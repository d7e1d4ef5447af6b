// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// `.watch` and `.hz`: what an output port writes, shown as it comes.
#include "commands.hpp"

#include "known_ports.hpp"
#include "line_source.hpp"
#include "port_probe.hpp"
#include "table.hpp"
#include "type_name.hpp"
#include "value_lines.hpp"
#include "value_text.hpp"

#include <rtt/internal/ConnectionManager.hpp>
#include <rtt/internal/engine/interruption.hpp>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <ostream>
#include <sstream>

#include <sys/ioctl.h>
#include <unistd.h>

namespace OCL::console {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kStep(10), kRefresh(100), kSecond(1000);
constexpr std::uint64_t kMostCount = 1000000;

/** The rows of the terminal that one value may take, so that all of it can be drawn again. */
std::size_t rowsOfTerminal() {
    winsize size = {};
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 4 ? size.ws_row - 3u : 20u;
}

/** Draws lines on a terminal in place of those before; without such a terminal, one after the other. */
class Drawn {
public:
    explicit Drawn(Screen& screen) : screen_(screen) {}

    void show(const std::vector<std::string>& lines) {
        if (screen_.erases && rows_ > 0) screen_.out << "\033[" << rows_ << "A\r";
        for (const std::string& line : lines)
            screen_.out << shortened(line, screen_.width() - 1) << (screen_.erases ? "\033[K\n" : "\n");
        if (screen_.erases && lines.size() < rows_) screen_.out << "\033[J";
        rows_ = lines.size();
        screen_.out.flush();
    }

private:
    Screen& screen_;
    std::size_t rows_ = 0;
};

/** True if the user ends the command: by Enter, which is taken, by typing the next line, which is left for the prompt,
    or by Ctrl-C. Otherwise waits a little. */
bool isEnded(const Screen& screen) {
    const auto* const interruption = RTT::internal::Interruption::ofThisThread();
    if (interruption && interruption->asked()) return true;
    const Wake woken = waitForInput(screen.live ? STDIN_FILENO : -1, -1, -1, static_cast<int>(kStep.count()));
    if (woken == Wake::Time || woken == Wake::Signal) return false;
    int size = 0;
    char key = 0;
    if (ioctl(STDIN_FILENO, FIONREAD, &size) == 0 && size == 1) (void)!read(STDIN_FILENO, &key, 1);
    return true;
}

/** The port to look at, which exists as long as the visits if it is known; null, with an error, if there is none. */
RTT::base::OutputPortInterface* outputPort(ConsoleState& state, const Input& input, const KnownPorts& known) {
    RTT::base::PortInterface* const port = findPort(state, input, input.words[1]);
    if (!port) return nullptr;
    if (auto* const output = port->asOutput()) return output;
    std::string writer;
    for (const auto& connection : port->getManager()->getConnections())
        if (const auto* const peer = connection.get<0>()->peer(); peer && writer.empty()) writer = known.nameOf(peer);
    complain(state.screen, input, input.words[1].begin,
             "'" + input.words[1].text + "' is an input port, expected an output port" +
                 (writer.empty() ? "" : ", as '" + writer + "', which writes to it"));
    return nullptr;
}

/** The number after the port, 0 if there is none; false, with an error, if it is no number or is missing and nobody
    could end the command. */
bool countIn(ConsoleState& state, const Input& input, std::uint64_t& count) {
    count = 0;
    if (input.words.size() < 3) {
        const bool canEnd = state.screen.live || state.screen.canBeStopped;
        if (!canEnd)
            complain(state.screen, input, input.text.size(), "expected a number, because no key ends the command here");
        return canEnd;
    }
    const Word& word = input.words[2];
    const bool digits = word.text.find_first_not_of("0123456789") == std::string::npos;
    count = digits ? std::strtoull(word.text.c_str(), nullptr, 10) : 0;
    const bool good = count >= 1 && count <= kMostCount;
    if (!good)
        complain(state.screen, input, word.begin,
                 "expected a number from 1 to " + std::to_string(kMostCount) + ", found '" + word.text + "'");
    return good;
}

/** Connects to the port of the command; null, with an error, if that cannot be. */
std::unique_ptr<PortProbe> probeFor(ConsoleState& state, const Input& input, PortProbe::From from,
                                    std::uint64_t& count) {
    if (!hasWords(state, input, 1, "the path of an output port") || !countIn(state, input, count)) return nullptr;
    Visits visits;
    const KnownPorts known(state.around(), visits);
    RTT::base::OutputPortInterface* const port = outputPort(state, input, known);
    if (!port) return nullptr;
    std::string why;
    auto probe = PortProbe::make(*port, from, why);
    if (!probe)
        complain(state.screen, input, input.words[1].begin, "'" + input.words[1].text + "' cannot be watched: " + why);
    return probe;
}

void complainGone(ConsoleState& state, const Input& input) {
    complain(state.screen, input, input.words[1].begin,
             "'" + input.words[1].text + "' is gone, or was disconnected from all ports");
}

std::vector<std::string> sampleLines(const Screen& screen, const std::string& name, const PortProbe& probe,
                                     std::uint64_t seen) {
    std::vector<std::string> lines{name + "  " + dotted(probe.value()->getTypeName()) + "  " +
                                   (seen == 0 ? "no sample yet" : "sample " + std::to_string(seen)) +
                                   "; Enter ends this"};
    if (seen == 0) return lines;
    const std::size_t width = screen.width(), indent = 4;
    const std::string text = std::string(indent, ' ') + valueOnOneLine(valueText(probe.value(), screen.hex));
    std::vector<std::string> parts;
    if (width > indent && widthOf(text) >= width)
        parts = valueLines(probe.value(), screen.hex, width - indent - 1, rowsOfTerminal());
    if (parts.empty()) parts.push_back(text.substr(indent));
    for (const std::string& part : parts) lines.push_back(std::string(indent, ' ') + part);
    return lines;
}

std::string inMilliseconds(std::int64_t ns) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(3) << static_cast<double>(ns) * 1e-6 << " ms";
    return text.str();
}

std::string rateText(const PortProbe::Intervals& seen) {
    if (seen.samples < 2 || seen.last <= seen.first)
        return std::to_string(seen.samples) + (seen.samples == 1 ? " sample" : " samples");
    std::ostringstream text;
    text << std::setprecision(5)
         << static_cast<double>(seen.samples - 1) * 1e9 / static_cast<double>(seen.last - seen.first)
         << " Hz, intervals " << inMilliseconds(seen.shortest) << " to " << inMilliseconds(seen.longest) << ", "
         << seen.samples << " samples";
    return text.str();
}

}  // namespace

void watchPort(ConsoleState& state, const Input& input) {
    std::uint64_t count = 0, seen = 0;
    const auto probe = probeFor(state, input, PortProbe::From::LastSample, count);
    if (!probe) return;
    Screen& screen = state.screen;
    Drawn drawn(screen);
    bool changed = true, ends = false;
    for (auto next = steady_clock::now(); !ends;) {
        while ((count == 0 || seen < count) && probe->read()) {
            ++seen;
            changed = true;
            if (!screen.live) screen.out << valueOnOneLine(valueText(probe->value(), screen.hex)) << std::endl;
        }
        const bool gone = !probe->isConnected();
        ends = gone || (count != 0 && seen == count) || isEnded(screen);
        const auto now = steady_clock::now();
        if (screen.live && changed && (ends || now >= next)) {
            drawn.show(sampleLines(screen, input.words[1].text, *probe, seen));
            changed = false;
            next = now + kRefresh;
        }
        if (gone) complainGone(state, input);
    }
    if (const std::uint64_t dropped = probe->dropped(); dropped > 0)
        screen.err << dropped << " samples came too fast to be shown\n";
}

void showRate(ConsoleState& state, const Input& input) {
    std::uint64_t count = 0, shown = 0;
    const auto probe = probeFor(state, input, PortProbe::From::NextSample, count);
    if (!probe) return;
    Screen& screen = state.screen;
    Drawn drawn(screen);
    if (screen.live) drawn.show({"counting; Enter ends this"});
    for (auto next = steady_clock::now() + kSecond; count == 0 || shown < count;) {
        while (probe->read()) {  // makes room; the times come from the thread that writes
        }
        const bool gone = !probe->isConnected(), ends = gone || isEnded(screen);
        if (ends || steady_clock::now() >= next) {
            next += kSecond;
            ++shown;
            const std::string text = rateText(probe->intervals());
            if (screen.live)
                drawn.show({text});
            else if (!ends)
                screen.out << text << std::endl;
        }
        if (gone) complainGone(state, input);
        if (ends) return;
    }
}

}  // namespace OCL::console
